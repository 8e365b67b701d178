"""Normal maps of materials: read from their nodes, and on the samples as Cycles shades them."""

import numpy as np
import pytest

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_settings import SHARPEST, CaptureSettings
from rna_export.capture.capture_tasks import TrainingShard
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.geometry.exported_parts import exported_parts
from rna_export.capture.rays.asset_scene import AssetScene
from tests.exporters.cycles import unit
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
image.pack()
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


def test_the_map_is_that_of_the_texture(open_worker):
    maps, notes = normal_maps(open_worker(SQUARES))
    assert list(maps) == ["cloth"] and notes == []  # it blurs nothing
    assert maps["cloth"].shape == (8, 8, 2)
    expected = 127.0 + 127.0 * np.array(LEAN)
    assert np.abs(maps["cloth"].astype(float) - expected).max() <= 1.0


def test_relief_that_fewer_texels_blur_is_told(open_worker):
    stripes = """
image.pixels.foreach_set([v for k in range(256) for v in ((k % 3 + 1) / 4, 0.5, 0.9, 1.0)])
image.pack()
"""
    maps, notes = normal_maps(open_worker(SQUARES + stripes))
    assert list(maps) == ["cloth"]
    stored = "stored as 8 x 8: finer relief blurs (--normal-texels)"
    assert notes[0] == f"material 'cloth' has a normal map of 16 x 16 texels, {stored}"


@pytest.mark.parametrize("scene", [SQUARES, SECOND_UV_MAP, IN_A_GROUP], ids=["", "uv", "group"])
def test_samples_have_the_normal_that_cycles_shades_with(open_worker, tmp_path, scene):
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


def test_equal_maps_are_stored_once(open_worker):
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


BUMP = """
import math
side = 32
heights = [0.5 + 0.3 * math.sin(2 * math.pi * 3 * (k % side + 0.5) / side)
           + 0.2 * math.cos(2 * math.pi * 2 * (k // side + 0.5) / side) for k in range(side**2)]
image = bpy.data.images.new("height", side, side, float_buffer=True)
image.colorspace_settings.name = "Non-Color"
image.pixels.foreach_set([value for h in heights for value in (h, h, h, 1.0)])
image.pack()
material = bpy.data.materials.new("leather")
material.use_nodes = True
tree = material.node_tree
shader = tree.nodes.new("ShaderNodeBsdfDiffuse")
end = tree.nodes["Material Output"]
tree.links.new(shader.outputs[0], end.inputs["Surface"])
picture = tree.nodes.new("ShaderNodeTexImage")
picture.image = image

def bump(**values):
    node = tree.nodes.new("ShaderNodeBump")
    tree.links.new(picture.outputs[0], node.inputs["Height"])
    tree.links.new(node.outputs[0], shader.inputs["Normal"])
    for name, value in values.items():
        node.inputs[name].default_value = value
    return node

# A sheet of 4 x 2 units, half as large in the world, whose UV map is square.
mesh = bpy.data.meshes.new("sheet")
mesh.from_pydata([(0, 0, 0), (4, 0, 1), (4, 2, 1), (0, 2, 0)], [], [(0, 1, 2, 3)])
layer = mesh.uv_layers.new(name="UVMap")
layer.uv.foreach_set("vector", [0, 0, 1, 0, 1, 1, 0, 1])
mesh.materials.append(material)
item = bpy.data.objects.new("sheet", mesh)
item.scale = (0.5, 0.5, 0.5)
bpy.context.scene.collection.objects.link(item)
"""
DISPLACED = """
node = tree.nodes.new("ShaderNodeDisplacement")
node.inputs["Scale"].default_value = 0.06
tree.links.new(picture.outputs[0], node.inputs["Height"])
tree.links.new(node.outputs[0], end.inputs["Displacement"])
material.displacement_method = "BUMP"
"""
UPON_BUMP = """
coarse, upper = bump(Distance=0.06), bump(Distance=0.02, Strength=0.7)
tree.links.new(coarse.outputs[0], upper.inputs["Normal"])
"""
UPON_MAP = """
waves = [(0.5 + 0.2 * math.sin(2 * math.pi * k / side), 0.6, 0.95, 1.0) for k in range(side**2)]
leaning = bpy.data.images.new("leaning", side, side, float_buffer=True)
leaning.colorspace_settings.name = "Non-Color"
leaning.pixels.foreach_set([value for texel in waves for value in texel])
leaning.pack()
below, texels = tree.nodes.new("ShaderNodeNormalMap"), tree.nodes.new("ShaderNodeTexImage")
texels.image = leaning
tree.links.new(texels.outputs[0], below.inputs["Color"])
tree.links.new(below.outputs[0], bump(Distance=0.06).inputs["Normal"])
"""


@pytest.mark.parametrize(
    "relief",
    [
        "bump(Distance=0.06)",
        "bump(Distance=0.06, Strength=0.4).invert = True",
        "bump(Distance=0.03, Strength=1.0)",
        DISPLACED,
        UPON_BUMP,
        UPON_MAP,
    ],
)
def test_heights_become_the_normals_that_cycles_shades_with(open_worker, relief):
    worker = open_worker(BUMP + relief)
    exported = exported_parts(worker, CaptureSettings())
    assert exported.notes == [] and exported.mapped == ("leather",)
    place = np.random.default_rng(1).uniform([0.1, 0.1], [1.9, 0.9], (1024, 2))
    points = np.column_stack([place[:, 0], 0.25 * place[:, 0], -place[:, 1]])
    origins = np.tile(np.float32([1.0, 3.0, -0.5]), (1024, 1))
    directions = (points - origins) / np.linalg.norm(points - origins, axis=1, keepdims=True)
    rays = origins, directions.astype(np.float32)
    rendered = worker.render_rays(*rays, unit(0, 1, 0), 1, seed=1, normals=True)
    materials = exported.transmittances(), exported.normal_maps()
    scene = AssetScene(tuple(exported.geometries.values()), SHARPEST, *materials)
    hits = scene.shade_points(*rays)
    (on,) = hits.on
    mapped = on.fields["normal"]
    flat = unit(-0.25, 1, 0)
    assert hits.hit.all() and rendered.normal is not None
    bent, off = (
        np.degrees(np.arccos(np.clip(np.sum(rendered.normal * n, axis=1), -1, 1)))
        for n in (flat, mapped)
    )
    assert np.median(bent) > 3.0
    assert np.median(off) < 0.2 * np.median(bent)
    assert np.percentile(off, 95) < 0.5 * np.median(bent)


def test_steep_relief_may_be_off_by_a_share_of_itself(open_worker):
    """Grooves between cells of 13 texels: 0.04 off in the mean, and a flat surface 0.3."""
    grooves = """
cells, sides = tree.nodes.new("ShaderNodeTexVoronoi"), tree.nodes.new("ShaderNodeTexCoord")
cells.feature, cells.inputs["Scale"].default_value = "DISTANCE_TO_EDGE", 80.0
tree.links.new(sides.outputs["UV"], cells.inputs["Vector"])
node = bump(Distance=0.02)
tree.links.new(cells.outputs["Distance"], node.inputs["Height"])
"""
    textures = open_worker(BUMP + grooves).export_textures(1024)
    assert list(textures.normals) == ["leather"] and textures.obstacles == {}


def test_caps_of_another_scale_do_not_keep_a_cylinder_from_its_map(
    open_worker,
):
    """A third of the area has a unit of u that is a third shorter."""
    drum = """
bpy.data.objects.remove(item)
bpy.ops.mesh.primitive_cylinder_add()
bpy.context.object.data.materials.append(material)
bump(Distance=0.06)
"""
    textures = open_worker(BUMP + drum).export_textures(1024)
    assert list(textures.normals) == ["leather"] and textures.obstacles == {}


def test_relief_that_no_map_can_have_is_told(open_worker):
    bump = """
bump = tree.nodes.new("ShaderNodeBump")
tree.links.new(picture.outputs[0], bump.inputs["Height"])
tree.links.new(bump.outputs[0], shader.inputs["Normal"])
"""
    before = (
        SQUARES
        + bump
        + """
tree.links.new(bump.outputs[0], relief.inputs["Strength"])
tree.links.new(relief.outputs[0], shader.inputs["Normal"])
"""
    )
    stretched = SQUARES + bump + "bpy.data.objects['square0'].data.vertices[2].co.x += 9"
    for scene, why in ((before, "a Bump node before other nodes"), (stretched, "uneven scale")):
        worker = open_worker(scene)
        textures = worker.export_textures(8)
        assert textures.normals == {} and why in textures.obstacles["cloth"]
        assert len(textures.notes) == 1 and why in textures.notes[0]


def test_a_flat_map_is_none(open_worker):
    maps, notes = normal_maps(open_worker(SQUARES.replace(str(LEAN), "0.0, 0.0")))
    assert maps == {} and notes == []
