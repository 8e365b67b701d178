"""Scenes without neural assets, against Mitsuba 3: a statistical test of every pixel.

Both render independent batches, so each pixel has a mean with a known error on both sides.
Welch's t of every pixel, of every tile of 4 x 4 and of the whole image is tested, each at a level
that Sidak's correction makes 1% for all of a scene together.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
import yaml
from PIL import Image

from rna_render.image.images import write_exr
from rna_render.paths.bands import render
from rna_render.paths.integrator_factory import make_integrator
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import read_scene
from tests.render.stage import rgb
from tests.render.studio import one_thread

pytest.importorskip("mitsuba", reason="mitsuba is not installed: pip install mitsuba")
from tests.render import mitsuba_scenes as twin

SIZE, TILE, BATCHES = (24, 16), 4, 16
OURS_FINER, OUR_SAMPLES = 3, 2  # our pixels a side of one of the compared image; samples of each
LEVEL = 0.01 / 3  # for all pixels, for all tiles, and for the image

Scene = dict[str, Any]
Twin = dict[str, Any]


def compare(folder: Path, ours: Scene, theirs: Twin, spp: int = 64) -> None:
    """Render the scene file `ours` and Mitsuba's shapes `theirs`, and compare."""
    ours = {"max_depth": 5, "samples": OUR_SAMPLES, "clamp_indirect": None} | ours
    mine = our_batches(folder, ours)
    reference = twin.render(theirs, ours["camera"], ours["max_depth"], BATCHES, spp, SIZE)
    assert_same_mean(folder, mine, reference)


def our_batches(folder: Path, scene: Scene) -> np.ndarray:
    """(batches, height, width, 3): images of several seeds, finer, and then made coarser."""
    width, height = SIZE
    path = folder / "scene.yaml"
    resolution = [OURS_FINER * width, OURS_FINER * height]
    path.write_text(yaml.safe_dump(plain(scene | {"resolution": resolution})))
    file = read_scene(path)
    integrator = make_integrator(file.resolved, load_world(file))
    images = []
    with one_thread():
        for seed in range(BATCHES):
            film = render(file.scene.model_copy(update={"seed": seed}), integrator)
            fine = rgb(film.channels()).astype(np.float64)
            images.append(fine.reshape(height, OURS_FINER, width, OURS_FINER, 3).mean(axis=(1, 3)))
    return np.stack(images)


def assert_same_mean(folder: Path, ours: np.ndarray, reference: np.ndarray) -> None:
    scales = {"pixel": 1, "tile": TILE, "image": None}
    t = {
        name: welch(*(coarser(x, size) for x in (ours, reference))) for name, size in scales.items()
    }
    limit = {
        name: student_limit(1 - (1 - LEVEL) ** (1 / values.size), len(ours) - 1)
        for name, values in t.items()
    }
    whole = coarser(ours, None), coarser(reference, None)
    mean = [x.mean(axis=0).ravel() for x in whole]
    error = np.hypot(*(x.std(axis=0, ddof=1).ravel() for x in whole)) / len(ours) ** 0.5
    # The test of the mean has to see a difference of two percent at least.
    assert (error * limit["image"] < 0.02 * mean[1]).all(), f"too noisy: {error / mean[1]}"
    worst = {name: float(np.abs(values).max()) for name, values in t.items()}
    if any(worst[name] >= limit[name] for name in t):
        for name, image in (
            ("ours", ours.mean(axis=0)),
            ("mitsuba", reference.mean(axis=0)),
            ("difference", ours.mean(axis=0) - reference.mean(axis=0)),
            ("t", t["pixel"]),
        ):
            planes = dict(zip("RGB", np.moveaxis(image.astype(np.float32), 2, 0), strict=True))
            write_exr(folder / f"{name}.exr", {c: p.copy() for c, p in planes.items()}, {})
        pytest.fail(
            f"|t| is up to {worst}, the limits are {limit}; means {mean[0]} and Mitsuba's "
            f"{mean[1]}; images in {folder}"
        )


def coarser(images: np.ndarray, size: int | None) -> np.ndarray:
    """Means over square tiles, or over the whole image."""
    n, height, width, channels = images.shape
    rows, columns = (height, width) if size is None else (size, size)
    tiled = images.reshape(n, height // rows, rows, width // columns, columns, channels)
    return tiled.mean(axis=(2, 4))


def welch(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Welch's t; a difference below a thousandth counts as none, and so do float32's errors."""
    off = a.mean(axis=0) - b.mean(axis=0)
    off = np.sign(off) * np.maximum(np.abs(off) - 1e-3 * np.abs(b.mean(axis=0)), 0)
    error = np.sqrt(a.var(axis=0, ddof=1) / len(a) + b.var(axis=0, ddof=1) / len(b))
    return off / np.maximum(error, 1e-12)


def student_limit(level: float, degrees: int) -> float:
    """|t| of Student's law that is exceeded with that probability.

    With t = sqrt(degrees) tan(theta) its density is in proportion to cos(theta)^(degrees - 1).
    """
    theta = np.linspace(np.pi / 2, 0, 1_000_001)
    tail = np.cumsum(np.cos(theta) ** (degrees - 1))
    return float(np.sqrt(degrees) * np.tan(theta[np.searchsorted(tail / tail[-1], level)]))


def plain(value: Any) -> Any:
    """What YAML can write."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple | np.ndarray):
        return [plain(item) for item in value]
    if isinstance(value, Path):
        return str(value)
    return value.item() if isinstance(value, np.generic) else value


def obj(folder: Path, name: str, mesh: trimesh.Trimesh, uvs: np.ndarray | None = None) -> Path:
    """An OBJ file of flat triangles."""
    lines = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in mesh.vertices]
    lines += [f"vt {u:.9g} {v:.9g}" for u, v in (uvs if uvs is not None else [])]
    for face in mesh.faces + 1:
        lines.append("f " + " ".join(f"{k}/{k}" if uvs is not None else str(k) for k in face))
    path = folder / name
    path.write_text("\n".join(lines) + "\n")
    return path


def ball(folder: Path, radius: float = 1.0) -> Path:
    return obj(folder, "ball.obj", trimesh.creation.icosphere(subdivisions=3, radius=radius))


def at(x: float, y: float, z: float) -> Any:
    return twin.T().translate([x, y, z])


def test_the_test_sees_small_differences(tmp_path):
    rng = np.random.default_rng(1)
    shape = BATCHES, SIZE[1], SIZE[0], 3
    first, second, third = (1 + 0.05 * rng.normal(size=shape) for _ in range(3))
    assert_same_mean(tmp_path, first, second)
    with pytest.raises(pytest.fail.Exception, match="images in"):
        assert_same_mean(tmp_path, first, 1.01 * third)
    assert (tmp_path / "difference.exr").exists()
    third[:, 4:8, 8:12] *= 1.05  # one tile
    with pytest.raises(pytest.fail.Exception):
        assert_same_mean(tmp_path, first, third)


def test_student_limit():
    assert student_limit(0.05, 15) == pytest.approx(2.131, abs=1e-3)
    assert student_limit(0.001, 15) == pytest.approx(4.073, abs=1e-3)


CAMERA = {"position": (0, 1.5, 6), "look_at": (0, 0.6, 0), "vertical_fov_deg": 32}


def test_a_coloured_box_under_a_rectangle(tmp_path):
    square = obj(
        tmp_path,
        "square.obj",
        trimesh.Trimesh([[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], [[0, 1, 2], [0, 2, 3]]),
    )
    block = obj(tmp_path, "block.obj", trimesh.creation.box((0.6, 1.0, 0.6)))
    walls = {
        "floor": ((0, -1, 0), (0, 0, 0), (0.7, 0.7, 0.7)),
        "ceiling": ((0, 1, 0), (180, 0, 0), (0.7, 0.7, 0.7)),
        "back": ((0, 0, -1), (90, 0, 0), (0.7, 0.7, 0.7)),
        "left": ((-1, 0, 0), (0, 0, -90), (0.8, 0.1, 0.1)),
        "right": ((1, 0, 0), (0, 0, 90), (0.1, 0.7, 0.2)),
    }
    objects, shapes = [], {}
    for name, (place, turn, color) in walls.items():
        objects.append(
            {
                "path": "square.obj",
                "transform": {"translation": place, "rotation_deg": turn},
                "material": {"type": "diffuse", "color": color},
            }
        )
        x, _, z = turn
        to_world = at(*place).rotate([0, 0, 1], z).rotate([1, 0, 0], x)
        shapes[name] = twin.mesh(square, twin.diffuse(color), to_world)
    color = (0.6, 0.6, 0.2)
    objects.append(
        {
            "path": "block.obj",
            "transform": {"translation": (-0.3, -0.5, -0.2), "rotation_deg": (0, 20, 0)},
            "material": {"type": "diffuse", "color": color},
        }
    )
    turned = at(-0.3, -0.5, -0.2).rotate([0, 1, 0], 20)
    shapes["block"] = twin.mesh(block, twin.diffuse(color), turned)
    lamp = {"position": (0, 0.95, 0), "look_at": (0, 0, 0), "up": (0, 0, 1)}
    light = {"type": "rectangle", **lamp, "size": (0.8, 0.5), "radiance": (10, 9, 7)}
    shapes["light"] = {
        "type": "rectangle",
        "to_world": twin.facing(*lamp.values(), (0.4, 0.25, 1)),
        "emitter": twin.emitter((10, 9, 7)),
        "bsdf": twin.diffuse(0),
    }
    camera = {"position": (0, 0, 4), "look_at": (0, 0, 0), "vertical_fov_deg": 36}
    ours = {"objects": objects, "camera": camera, "lights": [light], "max_depth": 4}
    compare(tmp_path, ours, shapes)


def sky(d: np.ndarray) -> np.ndarray:
    """Smooth radiance of directions (..., 3): a gradient, and a warm spot towards +x."""
    spot = np.exp(12 * (d @ np.array([0.8, 0.6, 0.0]) - 1))
    gradient = 0.4 + 0.3 * d[..., 1] + 0.2 * d[..., 2]
    return gradient[..., None] * [0.6, 0.8, 1.0] + 4 * spot[..., None] * [1.0, 0.7, 0.4]


def write_sky(path: Path, function: Callable[[np.ndarray], np.ndarray]) -> Path:
    """As docs/scene.md lays it out: -z in the middle, +y at the top, +x in the right half."""
    h = 512
    theta = np.pi * (np.arange(h) + 0.5) / h
    phi = 2 * np.pi * ((np.arange(2 * h) + 0.5) / (2 * h) - 0.5)
    theta, phi = np.meshgrid(theta, phi, indexing="ij")
    d = np.stack(
        [np.sin(theta) * np.sin(phi), np.cos(theta), -np.sin(theta) * np.cos(phi)], axis=-1
    )
    planes = np.moveaxis(function(d).astype(np.float32), 2, 0)
    write_exr(path, {c: p.copy() for c, p in zip("RGB", planes, strict=True)}, {})
    return path


def balls(folder: Path, ours: list[Scene], theirs: list[Twin]) -> tuple[list[Scene], Twin]:
    """Two balls side by side, of the given materials."""
    path = ball(folder, 0.8)
    places = (-1.0, 0.8, 0.0), (1.0, 0.8, 0.0)
    objects = [
        {"path": "ball.obj", "transform": {"translation": place}, "material": material}
        for place, material in zip(places, ours, strict=True)
    ]
    shapes = {
        f"ball{k}": twin.mesh(path, bsdf, at(*place))
        for k, (place, bsdf) in enumerate(zip(places, theirs, strict=True))
    }
    return objects, shapes


def test_a_turned_environment_on_a_diffuse_and_a_metal_ball(tmp_path):
    write_sky(tmp_path / "sky.exr", sky)
    objects, shapes = balls(
        tmp_path,
        [
            {"type": "diffuse", "color": (0.8, 0.6, 0.4)},
            {"type": "conductor", "color": (0.9, 0.7, 0.5), "roughness": 0.6},
        ],
        [twin.diffuse((0.8, 0.6, 0.4)), twin.gltf((0.9, 0.7, 0.5), 1.0, 0.6)],
    )

    def turned(d: np.ndarray) -> np.ndarray:
        """Counter-clockwise by 70 degrees, seen from above: +x goes towards -z."""
        c, s = np.cos(np.radians(70)), np.sin(np.radians(70))
        x, y, z = np.moveaxis(d, -1, 0)
        return sky(np.stack([c * x - s * z, y, s * x + c * z], axis=-1))

    shapes["sky"] = twin.sampled_environment(turned)
    shapes["ground"] = twin.ground(20, 0, twin.diffuse(0.5))
    ours = {
        "objects": objects,
        "ground": {"size": 20, "material": {"type": "diffuse", "color": (0.5, 0.5, 0.5)}},
        "camera": CAMERA,
        "lights": [{"type": "environment", "path": "sky.exr", "rotation_deg": 70}],
    }
    compare(tmp_path, ours, shapes)


DISK = {"position": (-2, 3.5, 2), "look_at": (0, 0.5, 0)}


def disk(radius: float, radiance: Any) -> tuple[Scene, Twin]:
    shape = {
        "type": "disk",
        "to_world": twin.facing(*DISK.values(), (0, 0, 1), (radius, radius, 1)),
        "emitter": twin.emitter(radiance),
        "bsdf": twin.diffuse(0),
    }
    return {"type": "disk", **DISK, "radius": radius, "radiance": radiance}, shape


def test_coats_under_a_sphere_of_light(tmp_path):
    objects, shapes = balls(
        tmp_path,
        [
            {"type": "coated", "color": (0.8, 0.3, 0.2), "roughness": 0.4, "ior": 1.5},
            {"type": "coated", "color": (0.9, 0.9, 0.9), "roughness": 0.8, "ior": 2.0},
        ],
        [
            twin.gltf((0.8, 0.3, 0.2), 0.0, 0.4, 0.2**2),
            twin.gltf((0.9, 0.9, 0.9), 0.0, 0.8, (1 / 3) ** 2),
        ],
    )
    lamp = {"position": (0.5, 3, 2), "radius": 0.5}
    shapes["lamp"] = {
        "type": "sphere",
        "center": [0.5, 3, 2],
        "radius": 0.5,
        "emitter": twin.emitter((15, 14, 12)),
        "bsdf": twin.diffuse(0),
    }
    shapes["sky"] = {"type": "constant", "radiance": twin.rgb((0.2, 0.25, 0.3))}
    shapes["ground"] = twin.ground(20, 0, twin.diffuse((0.5, 0.5, 0.6)))
    ours = {
        "objects": objects,
        "ground": {"size": 20, "material": {"type": "diffuse", "color": (0.5, 0.5, 0.6)}},
        "camera": CAMERA,
        "lights": [
            {"type": "sphere", **lamp, "radiance": (15, 14, 12)},
            {"type": "environment", "radiance": (0.2, 0.25, 0.3)},
        ],
        "max_depth": 3,
    }
    compare(tmp_path, ours, shapes)


def test_a_textured_gltf_mesh(tmp_path):
    """A panel with a colour in each quarter, whose material is that of the file."""
    texels = np.full((8, 8, 3), 230, np.uint8)
    texels[:4, :4], texels[:4, 4:], texels[4:, :4] = (220, 60, 30), (40, 190, 60), (50, 60, 210)
    corners = np.array([[-1.5, 0, 0.3], [1.5, 0, 0.3], [1.5, 1.6, -0.5], [-1.5, 1.6, -0.5]])
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    upwards = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])  # v of OBJ and trimesh goes up
    material = trimesh.visual.material.PBRMaterial(
        baseColorTexture=Image.fromarray(texels), metallicFactor=0.3, roughnessFactor=0.6
    )
    visual = trimesh.visual.TextureVisuals(uv=upwards, material=material)
    panel = trimesh.Trimesh(corners, faces, visual=visual, process=False)
    panel.export(tmp_path / "panel.glb")
    path = obj(tmp_path, "panel.obj", panel, upwards)
    srgb = texels / 255.0
    linear = np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
    texture = {
        "type": "bitmap",
        "bitmap": twin.mi.Bitmap(linear.astype(np.float32)),
        "raw": True,
        "filter_type": "bilinear",
        "wrap_mode": "repeat",
    }
    lamp = {"position": (1.0, 2.5, 2.5), "radius": 0.6}
    shapes = {
        "panel": twin.mesh(path, twin.gltf(texture, 0.3, 0.6, 0.04)),
        "ground": twin.ground(20, 0, twin.diffuse(0.5)),
        "lamp": {
            "type": "sphere",
            "center": [1.0, 2.5, 2.5],
            "radius": 0.6,
            "emitter": twin.emitter((10, 10, 10)),
            "bsdf": twin.diffuse(0),
        },
    }
    ours = {
        "objects": [{"path": "panel.glb"}],
        "ground": {"size": 20, "material": {"type": "diffuse", "color": (0.5, 0.5, 0.5)}},
        "camera": CAMERA,
        "lights": [{"type": "sphere", **lamp, "radiance": (10, 10, 10)}],
        "max_depth": 3,
    }
    compare(tmp_path, ours, shapes)
