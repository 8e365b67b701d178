"""The strands we export are those that Cycles renders: the same rays give the same hits."""

import numpy as np
import pytest

from rna_export.capture.rays.asset_scene import AssetScene
from rna_sdk.errors import CaptureError

pytestmark = pytest.mark.blender

CURLS = """
import numpy as np, rna_hair
from rna_hair.objects import add_curves, chiang_material
steps = np.random.default_rng(1).normal(size=(30, 6, 3))
strands = rna_hair.of_equal_length(0.15 * np.cumsum(steps, axis=1), np.linspace(0.03, 0.01, 6))
hair = add_curves(strands, "h", chiang_material(melanin=0.3))
"""
SCENES = {
    "as it is": "",
    "scaled and turned": "hair.matrix_world = Matrix.Scale(2.5, 4) @ Matrix.Rotation(0.5, 4, 'X')",
    "shared by two objects": """
copy = bpy.data.objects.new("copy", hair.data)
copy.matrix_world = Matrix.Translation((3, 0, 0)) @ Matrix.Scale(0.5, 4)
bpy.context.scene.collection.objects.link(copy)
""",
    "Catmull-Rom": "hair.data.set_types(type='CATMULL_ROM')",
    "without radii": "hair.data.attributes.remove(hair.data.attributes['radius'])",
}


@pytest.mark.parametrize("scene", SCENES)
def test_cycles_hits_what_we_hit(scene, open_worker):
    worker = open_worker(CURLS + SCENES[scene])
    curves = worker.export_curves()
    ours = AssetScene([curves])
    rng = np.random.default_rng(2)
    around = rng.normal(size=(4000, 3))
    around *= 2.0 * ours.radius / np.linalg.norm(around, axis=1, keepdims=True)
    origins = (ours.centre + around).astype(np.float32)
    points, normals = ours.sample_points(len(origins), rng)
    beside = rng.uniform(-0.5, 1.0, (len(origins), 1)) * curves.radii.max()
    directions = points + beside * normals - origins  # many just miss
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    directions = directions.astype(np.float32)

    rendered = worker.render_rays(origins, directions, np.float32([0, 1, 0]), 1, seed=1)
    actual = ours.shade_points(origins, directions)
    hit = rendered.alpha > 0.999
    assert 0.2 < hit.mean() < 0.95
    assert np.mean(hit != actual.hit) < 0.002
    both = hit & actual.hit
    apart = np.linalg.norm(rendered.position[both] - actual.position[both], axis=1)
    assert np.percentile(apart, 99) < 2e-5


def test_strands_that_would_be_flat_are_refused(open_worker):
    worker = open_worker(CURLS + "hair.matrix_world = Matrix.Diagonal((1, 1, 3, 1))")
    with pytest.raises(CaptureError, match="has non-uniform scale, 1 to 3"):
        worker.export_curves()


def test_points_without_a_segment_are_left_out_and_no_radius_is_zero(
    open_worker,
):
    curves = open_worker("""
data = bpy.data.hair_curves.new("h")
data.add_curves([1, 2, 1, 5, 2])
at = [0, 1, 2, 3, 4, 4, 5, 5, 6, 9, 9]  # strand 3 stays where it is twice, strand 4 for good
data.position_data.foreach_set("vector", [3.0 * k + axis for k in at for axis in range(3)])
radius = data.attributes.new("radius", "FLOAT", "POINT")
radius.data.foreach_set("value", [9, 0.1, 0, 9, 0.2, 9, 0.1, 9, 0, 9, 9])
bpy.context.scene.collection.objects.link(bpy.data.objects.new("h", data))
""").export_curves()
    assert curves.offsets.tolist() == [0, 2, 5]
    assert curves.points[:, 0].tolist() == [3, 6, 12, 15, 18]
    assert np.allclose(curves.radii, [0.1, 0.0002, 0.2, 0.1, 0.0002])
