"""Our hit and Cycles' hit are the same point, whatever the scene is made of."""

import numpy as np
import pytest

from tests.conftest import REPOSITORY
from tests.exporters.cycles import Traced, trace, unit

pytestmark = pytest.mark.blender
WI = unit(0.3, 0.9, 0.3)

TRANSFORMED = """
turn = Matrix.Rotation(0.7, 4, (1, 2, 3))
stretch = Matrix.Diagonal((1, 2, 0.5, 1))
add(*BALL, smooth=True, matrix=Matrix.Translation((2, 0, 0)) @ turn @ stretch)
add(CUBE, SIDES, matrix=Matrix.Translation((-2, 1, 1)) @ turn)
add(*BALL, matrix=Matrix.Translation((0, 3, 0)) @ Matrix.Diagonal((-1, 1, 1, 1)))
"""

INSTANCED = """
part = add(CUBE, SIDES)
parts = bpy.data.collections.new("parts")
parts.objects.link(part)
bpy.context.scene.collection.objects.unlink(part)
for k in range(3):
    empty = bpy.data.objects.new("instance", None)
    empty.instance_type, empty.instance_collection = "COLLECTION", parts
    empty.location = (3 * k, 0, k)
    bpy.context.scene.collection.objects.link(empty)
copy = bpy.data.objects.new("linked", part.data)
copy.location = (0, 5, 0)
bpy.context.scene.collection.objects.link(copy)
"""

# What the viewport shows is not what is rendered.
RENDER_SETTINGS = """
smoothed = add(CUBE, SIDES).modifiers.new("finer in renders", "SUBSURF")
smoothed.levels, smoothed.render_levels = 1, 3
thick = add(*square(1, x=4)).modifiers.new("in the viewport only", "SOLIDIFY")
thick.thickness, thick.show_render = 1.0, False
late = add(*square(1, x=8)).modifiers.new("in renders only", "SOLIDIFY")
late.thickness, late.show_viewport = 1.0, False
"""

HIDDEN = """
add(CUBE, SIDES)
add(CUBE, SIDES, matrix=Matrix.Translation((4, 0, 0))).hide_viewport = True
add(CUBE, SIDES, matrix=Matrix.Translation((0, 4, 0))).hide_render = True
kept_out = bpy.data.collections.new("not rendered")
kept_out.hide_render = True
bpy.context.scene.collection.children.link(kept_out)
item = add(CUBE, SIDES, matrix=Matrix.Translation((0, 0, 4)))
bpy.context.scene.collection.objects.unlink(item)
kept_out.objects.link(item)
"""


def assert_same_points(traced: Traced, mesh_radius: float) -> None:
    distance = np.linalg.norm(traced.points.x - traced.cycles_position, axis=1) / mesh_radius
    assert len(distance) > 1000
    assert np.median(distance) < 1e-6
    assert np.percentile(distance, 99) < 1e-5
    assert traced.missed < 0.01


def radius(traced: Traced) -> float:
    low, high = traced.points.x.min(axis=0), traced.points.x.max(axis=0)
    return float(np.linalg.norm(high - low)) / 2.0


@pytest.mark.parametrize(
    "scene",
    [TRANSFORMED, INSTANCED, RENDER_SETTINGS, HIDDEN],
    ids=["transformed", "instanced", "render-settings", "hidden"],
)
def test_small_scenes(open_worker, scene):
    traced = trace(open_worker(scene), WI)
    assert_same_points(traced, radius(traced))


def test_what_is_hidden_in_renders_stays_out(open_worker):
    positions = open_worker(HIDDEN).export_corners()["positions"]
    assert np.allclose(positions.min(axis=0), [-1, -1, -1])
    assert np.allclose(positions.max(axis=0), [5, 1, 1])


def test_the_quickstart_toy(open_worker):
    traced = trace(open_worker(REPOSITORY / "examples" / "quickstart" / "toy.py"), WI, 4096)
    assert_same_points(traced, radius(traced))


@pytest.mark.data
def test_a_real_head(open_worker, data_folder):
    recipe = REPOSITORY / "examples" / "recipes" / "head.py"
    worker = open_worker(recipe, str(data_folder / "mesh" / "LeePerrySmith"))
    traced = trace(worker, WI, 4096)
    assert_same_points(traced, radius(traced))
