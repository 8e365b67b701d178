"""Normal maps of materials: read from their nodes, and on the samples as Cycles shades them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.capture_tasks import TrainingShard
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.geometry.exported_parts import exported_parts
from tests.exporters.conftest import OpenWorker
from tests.exporters.synthetic import manifest_of

pytestmark = pytest.mark.blender

LEAN = (0.5, -0.3)

RELIEF = f"""
x, y = {LEAN}
z = (1.0 - x * x - y * y) ** 0.5
image = bpy.data.images.new("relief", 16, 16, float_buffer=True)
image.colorspace_settings.name = "Non-Color"
image.pixels.foreach_set([(x + 1) / 2, (y + 1) / 2, (z + 1) / 2, 1.0] * 256)
image.pack()
material = bpy.data.materials.new("cloth")
material.use_nodes = True
tree = material.node_tree
shader = tree.nodes.new("ShaderNodeBsdfDiffuse")
shader.inputs["Color"].default_value = (0.5, 0.5, 0.5, 1.0)
tree.links.new(shader.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
picture, relief = tree.nodes.new("ShaderNodeTexImage"), tree.nodes.new("ShaderNodeNormalMap")
picture.image = image
tree.links.new(picture.outputs[0], relief.inputs["Color"])
tree.links.new(relief.outputs[0], shader.inputs["Normal"])
"""

SQUARES = (
    RELIEF
    + """
# Squares whose texture coordinates stand upright, lie on their side, and are mirrored.
upright = [(0, 0), (1, 0), (1, 1), (0, 1)]
for k, corners in enumerate((upright, upright[3:] + upright[:3], [(1 - u, v) for u, v in upright])):
    mesh = bpy.data.meshes.new(f"square{k}")
    points = [(u + 1.5 * k, v, 0.3 * u) for u, v in ((0, 0), (1, 0), (1, 1), (0, 1))]
    mesh.from_pydata(points, [], [(0, 1, 2, 3)])
    layer = mesh.uv_layers.new(name="UVMap")
    for place, uv in zip(layer.uv, corners):
        place.vector = uv
    mesh.materials.append(material)
    bpy.context.scene.collection.objects.link(bpy.data.objects.new(f"square{k}", mesh))
"""
)

SECOND_UV_MAP = (
    SQUARES
    + """
# The map leans both ways, lies on a UV map that renders do not use, and is stretched twofold.
lean = [((x + 1) / 2, (y + 1) / 2, (z + 1) / 2, 1.0), ((1 - x) / 2, (y + 1) / 2, (z + 1) / 2, 1.0)]
image.pixels.foreach_set([value for k in range(256) for value in lean[k % 16 >= 8]])
for item in bpy.context.scene.objects:
    other = item.data.uv_layers.new(name="Other")
    other.uv.foreach_set("vector", [0.1, 0.9, 0.1, 0.1, 0.9, 0.1, 0.9, 0.9])
    other.active_render = True
here, stretched = tree.nodes.new("ShaderNodeUVMap"), tree.nodes.new("ShaderNodeMapping")
here.uv_map = relief.uv_map = "UVMap"
stretched.inputs["Scale"].default_value = (0.5, 0.5, 1.0)
tree.links.new(here.outputs[0], stretched.inputs["Vector"])
tree.links.new(stretched.outputs[0], picture.inputs["Vector"])
add(*square(0.1, x=1.2, y=1.5), diffuse((0.5, 0.5, 0.5)))  # without a UV map
"""
)

IN_A_GROUP = (
    SQUARES
    + """
group = bpy.data.node_groups.new("cloth", "ShaderNodeTree")
group.interface.new_socket("shader", in_out="OUTPUT", socket_type="NodeSocketShader")
made = {}
for node in (picture, relief, shader):
    made[node] = group.nodes.new(node.bl_idname)
made[picture].image, end = image, group.nodes.new("NodeGroupOutput")
made[shader].inputs["Color"].default_value = (0.5, 0.5, 0.5, 1.0)
group.links.new(made[picture].outputs[0], made[relief].inputs["Color"])
group.links.new(made[relief].outputs[0], made[shader].inputs["Normal"])
group.links.new(made[shader].outputs[0], end.inputs[0])
node = tree.nodes.new("ShaderNodeGroup")
node.node_tree = group
tree.links.new(node.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
"""
)


def normal_maps(worker: BlenderWorker) -> tuple[dict[str, np.ndarray], list[str]]:
    """Maps of 8 texels a side by material, and the notes."""
    textures = worker.export_textures(8)
    return textures.normals, textures.notes


def test_the_map_is_that_of_the_texture(open_worker: OpenWorker) -> None:
    maps, notes = normal_maps(open_worker(SQUARES))
    assert list(maps) == ["cloth"]
    stored = "stored as 8 x 8: finer relief blurs (--normal-texels)"
    assert notes == [f"material 'cloth' has a normal map of 16 x 16 texels, {stored}"]
    assert maps["cloth"].shape == (8, 8, 2)
    expected = 127.0 + 127.0 * np.array(LEAN)
    assert np.abs(maps["cloth"].astype(float) - expected).max() <= 1.0


@pytest.mark.parametrize("scene", [SQUARES, SECOND_UV_MAP, IN_A_GROUP], ids=["", "uv", "group"])
def test_samples_have_the_normal_that_cycles_shades_with(
    open_worker: OpenWorker, tmp_path: Path, scene: str
) -> None:
    """A diffuse surface under a sun: its radiance tells n.wi of the shading normal."""
    worker = open_worker(scene)
    settings = CaptureSettings(lights=8, lights_per_shard=8, rays=512, samples=16)
    exported = exported_parts(worker, settings)
    assert exported.notes == [] and len(exported.maps["asset"]) == 1
    cutouts = exported.has_opaque_cutouts
    manifest = manifest_of(settings, parts=exported.captured(), opaque_cutouts=cutouts)
    dataset = Dataset.create(tmp_path / "rays", manifest, exported.geometries, exported.textures)
    TrainingShard(0).run(dataset, scene_of(dataset), worker)
    at = dataset.only.training_samples()
    cosine = np.sum(at["normal"] * at["wi"], axis=1)
    # Cycles weakens light that grazes the surface behind the relief.
    flat = np.float32([-0.287, 0.958, 0.0])
    seen = (at["wo"] @ flat > 0.1) & (np.sum(at["normal"] * at["wo"], axis=1) > 0.1)
    shown = (at["visible"] > 0) & (cosine > 0.3) & (at["wi"] @ flat > 0.5) & seen
    assert shown.sum() > 300
    expected = 0.5 / np.pi * cosine[shown]
    actual = at["radiance"][shown].mean(axis=1)
    assert np.median(np.abs(actual - expected)) < 3e-3
    assert np.percentile(np.abs(actual - expected), 90) < 0.01
    assert np.ptp(at["normal"] @ np.float32([0, 1, 0])) > 0.1  # the squares lean differently


def test_equal_maps_are_stored_once(open_worker: OpenWorker) -> None:
    second = (
        SQUARES
        + """
copy = material.copy()
bpy.context.scene.objects["square1"].data.materials[0] = copy
"""
    )
    exported = exported_parts(open_worker(second), CaptureSettings())
    (maps,) = exported.maps.values()
    assert len(maps) == 2 and len({record.texture for record in maps}) == 1
    assert list(exported.textures) == [maps[0].texture]


def test_relief_that_no_map_can_have_is_told(open_worker: OpenWorker) -> None:
    bump = (
        SQUARES
        + """
bump = tree.nodes.new("ShaderNodeBump")
tree.links.new(picture.outputs[0], bump.inputs["Height"])
tree.links.new(bump.outputs[0], shader.inputs["Normal"])
"""
    )
    maps, notes = normal_maps(open_worker(bump))
    assert maps == {} and len(notes) == 1 and "Bump" in notes[0]


def test_a_flat_map_is_none(open_worker: OpenWorker) -> None:
    maps, notes = normal_maps(open_worker(SQUARES.replace(str(LEAN), "0.0, 0.0")))
    assert maps == {} and notes == []
