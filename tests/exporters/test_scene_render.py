"""Cycles and our renderer on the same scenes of diffuse things: each is a check of the other."""

from pathlib import Path
from typing import Any

import numpy as np
import OpenEXR
import pytest

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.compare.cycles_scene import cycles_scene
from rna_render.paths.bands import render
from rna_render.paths.integrator_factory import make_integrator
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import Scene
from rna_render.world.camera import Camera
from rna_sdk.errors import SceneError
from tests.exporters.cycles import unit
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package

WIDTH, HEIGHT, BLOCK = 48, 36, 6
CAMERA = {"position": (1.5, 1.3, 2.5), "look_at": (-0.3, 0.6, 0.0)}
GROUND = {"size": 20.0, "material": {"type": "diffuse", "color": (0.5, 0.6, 0.7)}}
RED = {"type": "diffuse", "color": (0.8, 0.2, 0.1)}

LIGHTS: dict[str, dict[str, Any]] = {
    "sun": {"type": "directional", "direction": (0.5, 1, 0.3), "irradiance": (1, 2, 3)},
    "wide sun": {
        "type": "directional",
        "direction": (0.5, 1, 0.3),
        "irradiance": (1, 2, 3),
        "angular_diameter_deg": 20.0,
    },
    "point": {"type": "point", "position": (0.3, 1.2, 0.4), "intensity": (1, 2, 3)},
    "spot": {
        "type": "spot",
        "position": (0.9, 1.7, 0.4),
        "look_at": (-0.5, 0, 0.2),
        "intensity": (3, 2, 1),
        "outer_angle_deg": 40.0,
        "inner_angle_deg": 15.0,
    },
    "rectangle": {  # in the picture
        "type": "rectangle",
        "position": (0.2, 0.9, -1.0),
        "look_at": (0.1, 0.2, 0.0),
        "up": (0.3, 1.0, 0.0),
        "size": (0.3, 0.9),
        "radiance": (3, 2, 1),
    },
    "disk": {
        "type": "disk",
        "position": (0.5, 1.5, 0.2),
        "look_at": (-0.3, 0, 0),
        "radius": 0.5,
        "radiance": (3, 2, 1),
        "visible_to_camera": False,
    },
    "image": {
        "type": "environment",
        "path": "sky.exr",
        "radiance": (1.0, 0.8, 0.6),
        "rotation_deg": 35.0,
    },
    "sky": {"type": "environment", "radiance": (1, 2, 3), "visible_to_camera": False},
}


@pytest.mark.blender
def test_cycles_and_we_agree_on_every_light(open_worker, tmp_path):
    """Brightness, place and shadows of each light, and what ground and wall throw on each other."""
    _write_box(tmp_path / "wall.obj", (-1.2, 0.0, -1.0), (-1.0, 1.5, 1.0))
    _write_sky(tmp_path / "sky.exr")
    worker = open_worker("add(*BALL)")
    for name, light in LIGHTS.items():
        scene = _scene(light, objects=[{"path": "wall.obj", "material": RED}])
        ours, cycles = _both(worker, scene, scene, tmp_path)
        _assert_alike(name, ours, cycles)


INSTANCED = """
group = bpy.data.collections.new("group")
group.objects.link(item)
bpy.context.scene.collection.objects.unlink(item)
empty = bpy.data.objects.new("empty", None)
empty.instance_type, empty.instance_collection = "COLLECTION", group
bpy.context.scene.collection.objects.link(empty)
"""


@pytest.mark.blender
@pytest.mark.parametrize("instanced", ["", INSTANCED], ids=["itself", "instance"])
def test_the_original_stands_where_the_scene_puts_the_asset(instanced, open_worker, tmp_path):
    low, high = (-0.2, 0.0, -0.4), (0.3, 0.8, 0.1)
    _write_box(tmp_path / "box.obj", low, high)
    worker = open_worker(
        "item = add([(x, y, z) for x in (-0.2, 0.3) for y in (-0.1, 0.4) for z in (0.0, 0.8)],"
        f"SIDES, diffuse((0.8, 0.2, 0.1))){instanced}"
    )
    transforms = [
        {"translation": (-0.5, 0.1, 0.4), "rotation_deg": (10.0, 30.0, 0.0)},
        {"translation": (0.4, 0.05, -0.2), "rotation_deg": (-5.0, 70.0, 0.0)},
    ]
    for count in (1, 2):
        objects = [{"path": "box.obj", "transform": t, "material": RED} for t in transforms[:count]]
        assets = [{"path": "box.rna", "transform": t} for t in transforms[:count]]
        ours = _scene(LIGHTS["sun"], objects=objects)
        theirs = _scene(LIGHTS["sun"], assets=assets)
        _assert_alike(f"{count} placed", *_both(worker, ours, theirs, tmp_path))
    # Without the asset, nothing stands there, not even a shadow.
    empty = _scene(LIGHTS["sun"])
    _assert_alike("empty", *_both(worker, empty, empty, tmp_path))


@pytest.mark.blender
def test_a_scene_leaves_later_renders_as_they_were(open_worker, tmp_path):
    worker = open_worker("add(*BALL, diffuse((0.9, 0.5, 0.1)))")
    view = Camera(_scene(LIGHTS["sun"]).camera, (16, 12)), unit(0, 1, 0), 4, 1
    before = worker.render_view(*view)
    scene = _scene(LIGHTS["sun"])
    _cycles(worker, scene, tmp_path, seed=1)
    assert np.array_equal(worker.render_view(*view), before)


BULB = {"type": "sphere", "position": (0, 1, 0), "radius": 1, "radiance": (1, 1, 1)}


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ({"assets": [{"path": "a.rna"}, {"path": "b.rna"}]}, "2 packages"),
        ({"assets": [{"path": "a.rna", "transform": {"scale": 2.0}}]}, "asset scale 2"),
        ({"ground": {"material": {"type": "conductor"}}}, "diffuse"),
        ({"ground": {"material": {"type": "diffuse", "emission": (1, 0, 0)}}}, "without emission"),
        ({"objects": [{"path": "wall.obj"}]}, "diffuse"),
        ({"lights": [BULB]}, "sphere lights"),
    ],
)
def test_what_blender_has_no_twin_of_is_refused(wrong, says):
    scene = Scene(**{"camera": CAMERA, "ground": GROUND, **wrong})
    with pytest.raises(SceneError, match=says):
        cycles_scene(scene)


def test_a_ground_without_a_size_is_that_of_rna_run(tmp_path):
    package = write_lambert_package(tmp_path / "ball.rna", sphere(1))
    transform = {"translation": (9.0, 1.0, -30.0), "rotation_deg": (0.0, 30.0, 0.0)}
    asset = {"path": str(package), "transform": transform}
    scene = Scene(camera=CAMERA, ground={"material": RED}, assets=[asset])
    world = load_world(SceneFile(tmp_path / "scene.yaml", scene, {}))
    (described,) = cycles_scene(scene)["meshes"]
    assert np.abs(described["positions"]).max() > 100.0
    ours = world.placements[-1].object.positions + world.origin
    np.testing.assert_allclose(described["positions"], ours, rtol=1e-5)


def _scene(light: dict[str, Any], **scene_objects: Any) -> Scene:
    size = {"resolution": (WIDTH, HEIGHT), "samples": 64, "clamp_indirect": None}
    return Scene(camera=CAMERA, ground=GROUND, lights=[light], **size, **scene_objects)


def _both(
    worker: BlenderWorker, ours: Scene, theirs: Scene, folder: Path
) -> tuple[np.ndarray, np.ndarray]:
    """Our image, (h, w, 3), and two of Cycles, (2, h, w, 3)."""
    file = SceneFile(folder / "scene.yaml", ours, {})
    channels = render(ours, make_integrator(file.resolved, load_world(file))).channels()
    image = np.stack([channels[c] for c in "RGB"], axis=-1)
    return image, np.stack([_cycles(worker, theirs, folder, seed) for seed in (1, 2)])


def _cycles(worker: BlenderWorker, scene: Scene, folder: Path, seed: int) -> np.ndarray:
    actual = SceneFile(folder / "scene.yaml", scene, {}).resolved
    described = cycles_scene(actual, bounces=scene.max_depth - 1)
    camera = Camera(scene.camera, scene.resolution)
    image, _ = worker.render_scene(described, camera, 128, seed)
    return image[..., :3]


def _assert_alike(name: str, ours: np.ndarray, cycles: np.ndarray) -> None:
    """Blocks of pixels agree within 1% and noise, the mean within 0.5%."""
    mean = cycles.mean(axis=0)
    assert ours.mean() == pytest.approx(mean.mean(), rel=0.005), name
    noise = _blocks(np.abs(cycles[0] - cycles[1]))
    difference = np.abs(_blocks(ours) - _blocks(mean))
    # A block's mean has a sixth of its pixels' noise, and edges are sampled by few of them.
    allowed = 0.01 * _blocks(mean) + 0.003 * mean.mean() + noise
    assert np.all(difference < allowed), (name, (difference / allowed).max())


def _blocks(image: np.ndarray) -> np.ndarray:
    return image.reshape(HEIGHT // BLOCK, BLOCK, WIDTH // BLOCK, BLOCK, 3).mean(axis=(1, 3))


def _write_box(path: Path, low: tuple[float, ...], high: tuple[float, ...]) -> None:
    (x0, y0, z0), (x1, y1, z1) = low, high
    vertices = [(x, y, z) for x in (x0, x1) for y in (y0, y1) for z in (z0, z1)]
    faces = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"]
    lines = [f"v {x} {y} {z}" for x, y, z in vertices] + [f"f {face}" for face in faces]
    path.write_text("\n".join(lines) + "\n")


def _write_sky(path: Path) -> None:
    """Two small bright lights of different colours, and a brighter band around the seam."""
    image = np.full((16, 32, 3), 0.05, np.float32)
    image[3:5, 10:12] = 30.0, 10.0, 2.0
    image[5, 22] = 2.0, 20.0, 40.0
    image[2:4, 29:] = 5.0, 5.0, 1.0
    header = {"compression": OpenEXR.NO_COMPRESSION, "type": OpenEXR.scanlineimage}
    with OpenEXR.File(header, {"RGB": image}) as file:
        file.write(str(path))
