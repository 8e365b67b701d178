"""The sections of a scene's table: objects, surfaces, textures and lights, and their flags."""

from math import prod

from rna_gpu.records.record import Field, Record
from rna_render.lights import kinds_of_lights, number_places
from rna_sdk.package.manifest.extensions import USUAL_SAMPLING, Mixture

OBJECT = Record(
    "Object",
    Field("number", "<f4", (), "of the asset or object in the scene file"),
    Field("catches", "<u4", (), "1: a shadow catcher"),
    Field("passes", "<u4", (), "1: rays that leave it pass through it"),
    Field("free", "<u4", (), "0, to fill a row of the table"),
)

OF_MATERIAL, OF_NEURAL, OF_FIBERS = range(3)
EMITS, LETS_THROUGH, IS_GLASS, HAS_CUTOFF, HAS_SCHLICK, IS_SOLID = 1, 2, 4, 8, 16, 32
FRONT_ALONE, BACK_ALONE = 64, 128  # the side from which an asset's part is seen from around it

MATERIAL_TEXTURES = {
    "BASE": "base_color_texture",
    "METAL": "metallic_roughness_texture",
    "COAT": "coat_weight_texture",
    "GLOW": "emission_texture",
    "CLEAR": "clear_coat_texture",
    "CLEAR_ROUGH": "clear_coat_roughness_texture",
    "THROUGH": "transmission_texture",
    "RELIEF": "normal_texture",
}
"""Name in WGSL -> attribute of Material; the place here is that in `textures` of a surface."""

SURFACE = Record(
    "Surface",
    Field("kind", "<u4", (), "OF_MATERIAL, OF_NEURAL or OF_FIBERS"),
    Field("part", "<u4", (), "of assets: number among all parts of the scene"),
    Field("flags", "<u4", (), "of those above"),
    Field("normal_map", "<u4", (), "of an asset"),
    Field("base_color", "<f4", (3,), "of an asset the factor of its image, texture BASE"),
    Field("roughness", "<f4"),
    Field("metallic", "<f4"),
    Field("coat_f0", "<f4"),
    Field("coat_weight", "<f4"),
    Field("transmission", "<f4"),
    Field("emission", "<f4", (3,)),
    Field("normal_scale", "<f4"),
    Field("clear_coat", "<f4"),
    Field("clear_coat_roughness", "<f4"),
    Field("second_uvs", "<u4", (), "place in `images`"),
    Field("tangents", "<u4", (), "likewise"),
    Field("colors", "<u4", (), "likewise"),
    Field("textures", "<u4", (2, 4), "numbers, NONE for none"),
    Field("through", "<u4", (), "texture of what is let through"),
    Field("cutoff", "<f4"),
    Field("ior", "<f4", (2,), "of its pane, in front and behind; of solid glass, and 0"),
    Field("absorption", "<f4", (3,), "of solid glass, object space"),
    Field("f0", "<f4", (), "of its pane by Schlick"),
    Field("lobe_shares", "<f4", (4,), "of an asset, for rays: of the broad lobe and narrow ones"),
    Field("lobe_widths", "<f4", (4,), "likewise"),
)

TEXTURE = Record(
    "Texture",
    Field("place", "<u4", (), "in `images`"),
    Field("size", "<u4", (), "rows * 65536 + columns"),
    Field("form", "<u4", (), "wrap in u and in v (2 bits each), sRGB, uv set"),
    Field("row_u", "<f4", (3,), "of the transform"),
    Field("row_v", "<f4", (3,)),
)

LIGHT_KINDS = list(kinds_of_lights())
"""Names of the kinds, by their numbers."""
_MOST_NUMBERS = max(numbers.itemsize // 8 for numbers in kinds_of_lights().values())

LIGHT_SEEN, LIGHT_DELTA, LIGHT_INFINITE = 1, 2, 4

LIGHT = Record(
    "Light",
    Field("kind", "<u4"),
    Field("group", "<u4", (), "NONE for none"),
    Field("flags", "<u4", (), "LIGHT_SEEN: by the camera, LIGHT_DELTA, LIGHT_INFINITE"),
    Field("instance", "<u4", (), "of triangles"),
    Field("numbers", "<f4", (-(-_MOST_NUMBERS // 4), 4), "of its kind, see below"),
    Field("probability", "<f4", (3,), "samples at a point of depth 1, 2 and later, on average"),
    Field("places", "<u4", (4,), "of its kind, in `images`: see below"),
)

LIGHT_PLACES = {
    "image": ("texels", "heights", "row_sums", "column_sums"),
    "triangles": ("sums", "primitives", "densities", "count"),
}

VIEWER_LIGHTS = ("sun", "environment", "given", "aroundPoint", "mirror")
"""Lights of the viewer's passes: a sun; the environment, sampled by its brightness; directions of
the rows; the environment, sampled around the mirror direction and the normal; of lobes, along the
mirror direction, with what an even environment brings to the ground."""

TABLE_CONSTANTS = {
    "OF_MATERIAL": OF_MATERIAL,
    "OF_NEURAL": OF_NEURAL,
    "OF_FIBERS": OF_FIBERS,
    "EMITS": EMITS,
    "FRONT_ALONE": FRONT_ALONE,
    "BACK_ALONE": BACK_ALONE,
    "LETS_THROUGH": LETS_THROUGH,
    "IS_GLASS": IS_GLASS,
    "HAS_CUTOFF": HAS_CUTOFF,
    "HAS_SCHLICK": HAS_SCHLICK,
    "IS_SOLID": IS_SOLID,
    **{name: k for k, name in enumerate(MATERIAL_TEXTURES)},
    "LIGHT_SEEN": LIGHT_SEEN,
    "LIGHT_DELTA": LIGHT_DELTA,
    "LIGHT_INFINITE": LIGHT_INFINITE,
    **{kind.upper(): k for k, kind in enumerate(LIGHT_KINDS)},
}


def lobe_fields(mixture: Mixture) -> dict[str, tuple[float, ...]]:
    """Members of a surface: the mixture of rays that leave it."""
    shares, widths = zip(*mixture.lobes, strict=True)
    return {"lobe_shares": shares, "lobe_widths": widths}


USUAL_LOBES = {kind: lobe_fields(mixture) for kind, mixture in USUAL_SAMPLING.items()}
"""Lobes for packages without their own."""


def light_accessors() -> str:
    """Functions of WGSL that read the numbers of each kind of light."""
    text = (
        "fn light_colour(k: u32) -> vec3f {\n"
        f"    return vec3f({', '.join(f'light_numbers(k, {i}u)' for i in range(3))});\n}}\n"
    )
    for kind, numbers in kinds_of_lights().items():
        for name, first in list(number_places(numbers).items())[1:]:
            text += _light_accessor(f"{kind}_{name}", numbers[name].shape, first)
    for kind, names in LIGHT_PLACES.items():
        for name, column in zip(names, "xyzw", strict=True):
            text += (
                f"fn {kind}_{name}(k: u32) -> u32 {{\n    return light_places(k).{column};\n}}\n"
            )
    return text


def _light_accessor(name: str, shape: tuple[int, ...], first: int) -> str:
    """A matrix, (rows, columns), is a matCxRf, whose columns WGSL has one by one."""
    numbers = [f"light_numbers(k, {first + i}u)" for i in range(prod(shape))]
    kind = "f32"
    if len(shape) == 2:
        rows, columns = shape
        kind = f"mat{columns}x{rows}f"
        numbers = [numbers[r * columns + c] for c in range(columns) for r in range(rows)]
    elif shape:
        kind = f"vec{shape[0]}f"
    value = f"{kind}({', '.join(numbers)})" if shape else numbers[0]
    return f"fn {name}(k: u32) -> {kind} {{\n    return {value};\n}}\n"
