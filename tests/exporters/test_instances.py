"""Instances, hierarchies and linked files are captured as Cycles renders them."""

import numpy as np
import pytest
import trimesh

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.view_rays import sample_view_rays
from rna_sdk.errors import CaptureError
from tests.exporters.cycles import trace, unit

pytestmark = pytest.mark.blender

PIECE = {  # what is instanced: an object `item`, in no collection of the scene
    "surface": """
sides = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
item = add([(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)], sides)
bpy.context.scene.collection.objects.unlink(item)
""",
    "fiber": """
import numpy as np, rna_hair
from rna_hair.objects import add_curves, chiang_material
line = np.float32([[[0, 0, 0], [1, 0, 0], [1, 2, 0], [1, 2, 3]]])
item = add_curves(rna_hair.of_equal_length(line, 0.1), "hair", chiang_material(melanin=0.3))
bpy.context.scene.collection.objects.unlink(item)
""",
}
TOOLS = """
group = bpy.data.collections.new("group")
group.objects.link(item)

def place(of, x, scale=(1, 1, 1)):
    empty = bpy.data.objects.new("empty", None)
    empty.instance_type, empty.instance_collection = "COLLECTION", of
    empty.location, empty.scale, empty.rotation_euler = (x, 0, 1), scale, (0, 0.5, 0)
    return empty

link = bpy.context.scene.collection.objects.link
"""
INSTANCES = {
    "collection": "group.instance_offset = (0, 1, 0)\nlink(place(group, 0))\nlink(place(group, 5))",
    "nested": """
outer = bpy.data.collections.new("outer")
for x in (0, 5):
    outer.objects.link(place(group, x, (-1, 1, 1)))
link(place(outer, 0, (2, 2, 2)))
hidden = place(outer, 20)
hidden.hide_render = True
link(hidden)
""",
    "duplicates": """
link(item)
copy = bpy.data.objects.new("copy", item.data)
parent = bpy.data.objects.new("parent", None)
parent.scale, copy.parent, copy.location = (-2, 2, 2), parent, (3, 0, 0)
link(parent)
link(copy)
""",
    "vertices": """
points = add([(0, 0, 5), (6, 0, 5)], [])
points.instance_type = "VERTS"
item.parent = points
link(item)
""",
    "nodes": """
tree = bpy.data.node_groups.new("nodes", "GeometryNodeTree")
tree.interface.new_socket("Geometry", in_out="INPUT", socket_type="NodeSocketGeometry")
tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
source, info, on_points, end = (tree.nodes.new(kind) for kind in (
    "NodeGroupInput", "GeometryNodeObjectInfo", "GeometryNodeInstanceOnPoints", "NodeGroupOutput"))
info.inputs["Object"].default_value = item
info.inputs["As Instance"].default_value = True
tree.links.new(source.outputs[0], on_points.inputs["Points"])
tree.links.new(info.outputs["Geometry"], on_points.inputs["Instance"])
tree.links.new(on_points.outputs[0], end.inputs[0])
add([(0, 0, 5), (6, 0, 5)], []).modifiers.new("nodes", "NODES").node_group = tree
""",
    "particles": """
emitter = add(*square(4))
emitter.show_instancer_for_render = False
emitter.modifiers.new("many", "PARTICLE_SYSTEM")
settings = emitter.particle_systems[0].settings
settings.type, settings.count, settings.render_type = "HAIR", 2, "OBJECT"
settings.use_advanced_hair, settings.instance_object, settings.particle_size = True, item, 0.5
""",
}


def check_hits(worker: BlenderWorker) -> None:
    """Cycles meets what we meet, at the same places."""
    if worker.kind == "surface":
        traced = trace(worker, unit(1, 2, 3))
        apart = traced.cycles_position - traced.points.x
        missed = traced.missed
    else:
        ours, wi = AssetScene([worker.export_curves()]), unit(1, 2, 3)
        rays = sample_view_rays(ours, wi, 2048, "sphere", np.random.default_rng(0))
        points = ours.shade_points(rays.origins, rays.directions)
        rendered = worker.render_rays(rays.origins, rays.directions, wi, 1, 1)
        hit = rendered.alpha > 0.999
        apart, missed = (rendered.position - points.position)[hit], 1.0 - hit.mean()
    assert missed < 0.005
    assert np.quantile(np.linalg.norm(apart, axis=1), 0.99) < 1e-4


@pytest.mark.parametrize(
    ("way", "kind"),
    [*((way, "surface") for way in INSTANCES), ("nested", "fiber"), ("nodes", "fiber")],
)
def test_two_instances(way, kind, open_worker):
    worker = open_worker(PIECE[kind] + TOOLS + INSTANCES[way])
    assert worker.kind == kind
    if kind == "surface":
        assert len(worker.export_corners()["positions"]) == 2 * 4 * 3
    else:
        assert len(worker.export_curves().points) == 2 * 4
    check_hits(worker)


def test_hierarchies_of_gltf(open_worker, tmp_path):
    """Nodes below nodes: a turned parent, a mirrored child, one mesh in two places."""
    box = trimesh.creation.box((1, 2, 3))
    scene = trimesh.Scene()
    turned = trimesh.transformations.rotation_matrix(0.7, [1, 2, 3], [0, 1, 0])
    scene.graph.update("parent", scene.graph.base_frame, matrix=turned)
    scene.add_geometry(box, "one", "box", "parent", trimesh.transformations.scale_matrix(2.0))
    mirrored = np.diag([-1.0, 1.5, 1.0, 1.0])
    mirrored[:3, 3] = 5, 0, 1
    scene.graph.update("child", "parent", matrix=mirrored, geometry="box")
    (tmp_path / "a.glb").write_bytes(scene.export(file_type="glb"))
    corners = open_worker(tmp_path / "a.glb").export_corners()
    expected = scene.to_geometry()
    assert len(corners["positions"]) == 3 * len(expected.faces)
    actual = trimesh.Trimesh(
        corners["positions"], np.arange(len(corners["positions"])).reshape(-1, 3)
    )
    actual.merge_vertices(merge_norm=True, merge_tex=True)
    np.testing.assert_allclose(actual.bounds, expected.bounds, atol=1e-5)
    np.testing.assert_allclose(actual.area, expected.area, rtol=1e-5)
    assert actual.volume == pytest.approx(6 * (8 + 1.5), rel=1e-4)  # all sides face outwards


LINKED = """
with bpy.data.libraries.load("//library.blend", link=True, relative=True) as (_, wanted):
    wanted.collections = ["group"]
empty = bpy.data.objects.new("empty", None)
empty.instance_type, empty.instance_collection = "COLLECTION", wanted.collections[0]
empty.location = (3, 0, 0)
bpy.context.scene.collection.objects.link(empty)
"""
LIBRARY = """
item = add(*BALL)
item.name = "ball"
group = bpy.data.collections.new("group")
group.objects.link(item)
bpy.context.scene.collection.children.link(group)
"""
FUR = """
item.modifiers.new("fur", "PARTICLE_SYSTEM")
settings = item.particle_systems[0].settings
settings.type, settings.count, settings.hair_length = "HAIR", 30, 0.5
item.show_instancer_for_render = False
"""


def test_a_linked_library_moves_with_its_folder(open_worker, save_blend, tmp_path):
    save_blend(tmp_path / "a" / "library.blend", LIBRARY)
    save_blend(tmp_path / "a" / "scene.blend", LINKED)
    moved = (tmp_path / "a").rename(tmp_path / "b")
    positions = open_worker(moved / "scene.blend").export_corners()["positions"]
    np.testing.assert_allclose(positions.min(axis=0), [2, -1, -1], atol=0.02)


def test_a_material_of_a_library_is_judged(open_worker, save_blend, tmp_path):
    material = "item.data.materials.append(principled(Metallic=1.0))\n"
    save_blend(tmp_path / "library.blend", LIBRARY + material)
    (facts,) = open_worker(save_blend(tmp_path / "scene.blend", LINKED)).opened["materials"]
    assert facts["kinds"] == ["metal"] and "library.blend" in facts["fullName"]


def test_a_missing_library_is_named(open_worker, save_blend, tmp_path):
    library = save_blend(tmp_path / "library.blend", LIBRARY)
    path = save_blend(tmp_path / "scene.blend", LINKED)
    library.unlink()
    with pytest.raises(CaptureError, match=r"library .*/library\.blend is missing: use File"):
        open_worker(path)
    save_blend(library, "")
    with pytest.raises(CaptureError, match=r"library\.blend has no Collection 'group': use File"):
        open_worker(path)


def test_particle_hair_of_a_linked_collection(open_worker, save_blend, tmp_path):
    save_blend(tmp_path / "library.blend", LIBRARY + FUR)
    worker = open_worker(save_blend(tmp_path / "scene.blend", LINKED))
    curves = worker.export_curves()
    assert len(curves.offsets) == 31
    roots = curves.points[curves.offsets[:-1].astype(int)] - np.float32([3, 0, 0])
    np.testing.assert_allclose(np.linalg.norm(roots, axis=1), 1.0, atol=0.06)
    check_hits(worker)


def test_particle_hair_is_shown_by_every_instance(open_worker):
    """The emitter in the scene itself, too: its hair is in the collection as well."""
    body = (
        LIBRARY
        + FUR
        + TOOLS.replace('group = bpy.data.collections.new("group")', "").replace(
            "group.objects.link(item)\n", ""
        )
    )
    worker = open_worker(body + "link(place(group, 5))")
    assert len(worker.export_curves().offsets) == 61
    check_hits(worker)


def test_particle_hair_on_other_instances_is_refused(open_worker):
    body = PIECE["surface"] + FUR + TOOLS + INSTANCES["vertices"]
    with pytest.raises(CaptureError, match="has particle hair and is instanced by 'object"):
        open_worker(body)
