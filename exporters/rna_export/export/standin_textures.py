"""Stand-in materials: estimated from samples, or textures of an analytic training."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import torch

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.validation_view import is_lit
from rna_export.pictures import png_bytes
from rna_export.training.checkpoint import Trained
from rna_export.training.model.analytic import gltf_material
from rna_export.training.model.neural_asset import NeuralAsset
from rna_render import encode_srgb
from rna_sdk.errors import ExportError
from rna_sdk.package import Mesh
from rna_sdk.package.manifest.extensions import StandinMaterial
from rna_sdk.runtime import mapped_normals
from rna_sdk.runtime.normal_maps import tangent_frames
from rna_trace import TriangleScene

_ROWS = 400_000
_ROUGHNESS = np.linspace(0.1, 1.0, 19)
_METAL = 4.0  # times as much light from the lobe as from the diffuse part
_OFF_HIGHLIGHT = 0.85  # n.h below which GGX of usual roughness adds little

TEXELS = 512
"""Along a side."""

_EDGE = 1e-3  # of the texture, that coordinates may be beyond it
_REPEATS = 3  # of the texture along a side, that charts may lie over
_OVERLAPPING = 0.02  # of the covered texels
_GROWN = 8  # texels about charts, for filters of readers


def standin_material(samples: Mapping[str, np.ndarray]) -> StandinMaterial:
    """The material for a part's captured samples, fields as in the dataset."""
    rows = np.random.default_rng(0).permutation(len(samples["radiance"]))[:_ROWS]
    picked = {name: values[rows].astype(np.float64) for name, values in samples.items()}
    if "normal" not in picked:
        return _material(_of_strands(picked), 1.0, metal=False)
    n, wo, wi = (picked[name] for name in ("normal", "wo", "wi"))
    cos_i, cos_o = _dots(n, wi), _dots(n, wo)
    lit = is_lit(picked["visible"]) & (cos_i > 0.1) & (cos_o > 0.1)
    halves = wi[lit] + wo[lit]
    halves /= np.maximum(np.linalg.norm(halves, axis=1, keepdims=True), 1e-9)
    cos_h, cos_i, cos_o = _dots(n[lit], halves), cos_i[lit], cos_o[lit]
    radiance = picked["radiance"][lit]
    away = cos_h < _OFF_HIGHLIGHT
    if not away.any():
        return _material(4.0 * np.pi * picked["radiance"].mean(axis=0), 1.0, metal=False)
    albedo = np.pi * _scale(cos_i[away], radiance[away])
    left = radiance - albedo / np.pi * cos_i[:, None]
    fits = [_fit(left, _ggx(cos_h, roughness) / (4.0 * cos_o)) for roughness in _ROUGHNESS]
    best = int(np.argmin([error for error, _ in fits]))
    reflectance = fits[best][1]
    # A lobe narrower than all of these would need to reflect more than 1.
    metal = np.minimum(reflectance, 1.0).mean() > _METAL * albedo.mean()
    return _material(reflectance if metal else albedo, float(_ROUGHNESS[best]), metal)


def _of_strands(picked: Mapping[str, np.ndarray]) -> np.ndarray:
    """Base colour of ribbons (3,) that are as bright as strands by light from the viewer's side.

    Not the mean over all light: most of that comes through hair from behind, and ribbons are dark
    there. Ribbons all around send albedo 5 / (12 pi), and shadow 0.7 of each other.
    """
    from_front = _dots(picked["wo"], picked["wi"]) > 0.0
    radiance = picked["radiance"][from_front]
    mean: np.ndarray = (radiance if len(radiance) else picked["radiance"]).mean(axis=0)
    return 8.0 * np.pi * mean


def _material(colour: np.ndarray, roughness: float, metal: bool) -> StandinMaterial:
    r, g, b = (round(float(c), 4) for c in np.clip(colour, 0.0, 1.0))
    return StandinMaterial(
        base_color=(r, g, b), roughness=round(roughness, 4), metallic=1.0 if metal else 0.0
    )


def _ggx(cos_h: np.ndarray, roughness: float) -> np.ndarray:
    """D of alpha = roughness^2, at the cosines n.h."""
    squared = roughness**4
    return squared / (np.pi * (1.0 + cos_h**2 * (squared - 1.0)) ** 2)


def _fit(left: np.ndarray, lobe: np.ndarray) -> tuple[float, np.ndarray]:
    """The squared error of the lobe's best colour, none of it negative, and that colour."""
    colour = np.maximum(_scale(lobe, left), 0.0)
    return float(np.mean((left - lobe[:, None] * colour) ** 2)), colour


def _scale(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """(3,) by which x (n,) is nearest to each column of y (n, 3)."""
    scale: np.ndarray = x @ y / np.maximum(x @ x, 1e-12)
    return scale


def _dots(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    dots: np.ndarray = np.einsum("ij,ij->i", a, b)
    return dots


@dataclass(frozen=True)
class UvPoints:
    """Points of a mesh at n texels of a square texture.

    texel: (n,) row * side + column. position, normal, tangent, bitangent: (n, 3) float32, the last
    two as in spec/RNA.md, 4.5.
    """

    texel: np.ndarray
    position: np.ndarray
    normal: np.ndarray
    tangent: np.ndarray
    bitangent: np.ndarray


def standin_textures(model: NeuralAsset, mesh: Mesh, side: int = TEXELS) -> dict[str, bytes]:
    """PNGs by member of RNA_standin_textures. model: with glTF's material.

    Raises `ExportError` for a mesh whose texture coordinates lay out no texture of its own.
    """
    at = uv_points(mesh, side)
    with torch.no_grad():
        position, n = torch.from_numpy(at.position), torch.from_numpy(at.normal)
        queries = model.queries({"position": position, "normal": n, "wo": n, "wi": n})
        material = gltf_material(model.decoder(queries))
        m = material.normal(n).numpy()
    base, roughness, metallic = (x.numpy() for x in material[:3])
    x, y, z = (_dots(m, axis) for axis in (at.tangent, at.bitangent, at.normal))
    images = {
        "base_color": encode_srgb(base),
        "metallic_roughness": np.concatenate([np.ones_like(roughness), roughness, metallic], 1),
        "normal": 0.5 + 0.5 * np.stack([x, y, np.maximum(z, 0.0)], axis=1),
    }
    filled = ((member, _filled(values, at.texel, side)) for member, values in images.items())
    return {member: png_bytes(_levels(image)) for member, image in filled}


def uv_points(mesh: Mesh, side: int) -> UvPoints:
    """The points whose texture coordinates are the middles of texels of a texture that repeats.

    Raises `ExportError` for coordinates that are missing, overlap or span many repeats.
    """
    if mesh.uvs is None:
        raise ExportError("the mesh has no texture coordinates")
    low, high = mesh.uvs.min(axis=0), mesh.uvs.max(axis=0)
    first, end = np.floor(low + _EDGE).astype(int), np.ceil(high - _EDGE).astype(int)
    if (end - first).max() > _REPEATS:
        found = f"{low.min():.3g} to {high.max():.3g}"
        raise ExportError(f"texture coordinates from {found}, expected a texture that repeats less")
    middle = (np.arange(side, dtype=np.float32) + 0.5) / side
    v, u = (values.reshape(-1) for values in np.meshgrid(middle, middle, indexing="ij"))
    repeats = [(i, j) for j in range(first[1], end[1]) for i in range(first[0], end[0])]
    parts = [np.stack([u + i, v + j], axis=1) for i, j in repeats]
    places = np.concatenate([*parts, np.empty((0, 2))])
    (last, *inside), first_triangle = _triangles_at(mesh.uvs[mesh.triangles], places)
    met = np.flatnonzero(last >= 0)
    if not len(met):
        raise ExportError("texture coordinates without an area")
    texel, once = np.unique(met % side**2, return_index=True)
    twice = len(met) - len(texel) + int((last[met] != first_triangle[met]).sum())
    if twice > _OVERLAPPING * len(met):
        share = min(100.0 * twice / len(met), 100.0)
        raise ExportError(f"texture coordinates overlap in {share:.0f}% of their texels")
    hit = met[once]
    return UvPoints(texel, *_points(mesh, last[hit], *(weight[hit] for weight in inside)))


def _triangles_at(
    corners: np.ndarray, places: np.ndarray
) -> tuple[tuple[np.ndarray, ...], np.ndarray]:
    """The last of the triangles (t, 3, 2) at places (n, 2), -1 for none, with the place's
    barycentrics u and v in it, and the first.
    """
    count, n = len(corners), len(places)
    number = np.arange(count, dtype=np.float32) / count
    height = np.broadcast_to(number[:, None, None], (count, 3, 1))  # a plane for each
    flat = np.concatenate([corners, height], axis=2).reshape(-1, 3)
    scene = TriangleScene([(flat, np.arange(3 * count, dtype=np.uint32).reshape(-1, 3))])
    result = []
    for z in (2.0, -2.0):
        start = np.column_stack([places, np.full(n, z)]).astype(np.float32)
        way = np.tile(np.array([0.0, 0.0, -z], np.float32), (n, 1))
        result.append(scene.intersect(start, way))
    above, below = result
    return (above.primitive, above.u, above.v), below.primitive


def _points(
    mesh: Mesh, triangle: np.ndarray, u: np.ndarray, v: np.ndarray
) -> tuple[np.ndarray, ...]:
    """Positions and frames of points in triangles, as spec/RNA.md, 4.5 has them."""
    corners = mesh.triangles[triangle]
    weights = np.stack([1.0 - u - v, u, v], axis=1)[..., None]
    position = (weights * mesh.positions[corners]).sum(axis=1)
    normal = mapped_normals(mesh, (), triangle, u, v)
    tangent, bitangent, _ = tangent_frames(mesh, corners, normal.astype(np.float64))
    return tuple(x.astype(np.float32) for x in (position, normal, tangent, bitangent))


def check_analytic(trained: Sequence[Trained], dataset: Dataset) -> None:
    """Raises `ExportError` unless these are analytic models of the dataset's capture."""
    for one in trained:
        if one.preset.model.material == "learned":
            raise ExportError(
                f"--standin: found a checkpoint of {one.preset_name}, expected one of "
                "rna-train --preset analytic"
            )
        if one.capture.source_sha256 != dataset.manifest.source_sha256 or one.cut != dataset.cut:
            raise ExportError(
                f"--standin: the checkpoint of {one.part} was trained on another capture or cut"
            )


def textures_of(
    trained: Sequence[Trained], dataset: Dataset
) -> tuple[list[dict[str, bytes] | None], list[str]]:
    """The textures of each part, None where there can be none, and a line for each of these.

    trained: see `check_analytic`.
    """
    check_analytic(trained, dataset)
    by_part = {one.part: one for one in trained}
    result: list[dict[str, bytes] | None] = []
    lines = []
    for part in dataset.parts:
        try:
            result.append(_of_part(part, by_part.get(part.name)))
        except ExportError as error:
            result.append(None)
            lines.append(f"{part.name}: a stand-in without textures: {error}")
    return result, lines


def _of_part(part: DatasetPart, trained: Trained | None) -> dict[str, bytes]:
    if trained is None:
        raise ExportError("no checkpoint of it is given")
    return standin_textures(trained.model, texture_mesh(part))


def texture_mesh(part: DatasetPart) -> Mesh:
    """The mesh of a part that may have textures; raises `ExportError` for another."""
    mesh = part.geometry()
    if not isinstance(mesh, Mesh):
        raise ExportError("strands have none")
    if part.captured.transmittance or part.captured.normal_maps:
        raise ExportError("it has holes or a normal map")
    return mesh


def _filled(values: np.ndarray, texel: np.ndarray, side: int) -> np.ndarray:
    """An image (side, side, 3) of values (n, 3) at texels: grown about them, else their mean."""
    image = np.zeros((side, side, 3), np.float32)
    known = np.zeros((side, side, 1), np.float32)
    image.reshape(-1, 3)[texel], known.reshape(-1)[texel] = values, 1.0
    for _ in range(_GROWN):
        shifts = [(step, axis) for axis in (0, 1) for step in (-1, 1)]
        weight = sum(np.roll(known, *shift) for shift in shifts)
        mean = sum(np.roll(image, *shift) for shift in shifts) / np.maximum(weight, 1.0)
        fresh = (known == 0.0) & (weight > 0.0)
        image, known = np.where(fresh, mean, image), np.where(fresh, 1.0, known)
    return np.where(known > 0.0, image, values.mean(axis=0))


def _levels(image: np.ndarray) -> np.ndarray:
    levels: np.ndarray = np.rint(255.0 * np.clip(image, 0.0, 1.0)).astype(np.uint8)
    return levels
