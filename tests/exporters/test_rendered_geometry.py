"""The exported geometry is that of renders for camera rays, not of a viewport."""

import json

import numpy as np
import pytest

from tests.exporters.cycles import trace, unit
from tests.exporters.in_blender import answer_of
from tests.exporters.scenes import ball

pytestmark = pytest.mark.blender

# A ball in renders, a box in the viewport; beside it all that camera rays do not see.
RENDERED = (
    ball()
    + """
material = diffuse((0.8, 0.3, 0.1))
item = add(*BALL, material, smooth=True)
tree = bpy.data.node_groups.new("stand-in", "GeometryNodeTree")
for way in ("INPUT", "OUTPUT"):
    tree.interface.new_socket("Geometry", in_out=way, socket_type="NodeSocketGeometry")
start, end, viewport, pick, box = (
    tree.nodes.new(kind) for kind in ("NodeGroupInput", "NodeGroupOutput",
    "GeometryNodeIsViewport", "GeometryNodeSwitch", "GeometryNodeMeshCube"))
pick.input_type = "GEOMETRY"
for source, target in ((viewport, 0), (start, 1), (box, 2)):
    tree.links.new(source.outputs[0], pick.inputs[target])
tree.links.new(pick.outputs[0], end.inputs[0])
item.modifiers.new("stand-in", "NODES").node_group = tree

def beside(name, x):
    made = add(CUBE, SIDES, material, matrix=Matrix.Translation((x, 0, 0)))
    made.name = name
    return made

def collected(name, item):
    home = bpy.data.collections.new(name)
    bpy.context.scene.collection.children.link(home)
    home.objects.link(item)
    bpy.context.scene.collection.objects.unlink(item)
    return bpy.context.view_layer.layer_collection.children[name]

beside("unseen", 4).visible_camera = False
beside("held out", 8).is_holdout = True
beside("catcher", 12).is_shadow_catcher = True
collected("bounce", beside("reflector", 16)).indirect_only = True
collected("masked", beside("mask", 20)).holdout = True
original = beside("original", 24)
original.hide_render = True
empty = bpy.data.objects.new("instances", None)
empty.instance_type, empty.instance_collection = "COLLECTION", bpy.data.collections.new("set")
empty.instance_collection.objects.link(beside("instanced", 28))
bpy.context.scene.collection.objects.unlink(bpy.data.objects["instanced"])
bpy.context.scene.collection.objects.link(empty)
empty.visible_camera = False
"""
)

SHAPED_BY_CYCLES = """
from rna_geometry import render_only
from rna_sources import source_scene

def refusal():
    try:
        render_only.refuse()
    except ValueError as error:
        return str(error)

bpy.ops.mesh.primitive_cube_add()
cube = bpy.context.object
material = bpy.data.materials.new("bark")
tree = material.node_tree
cube.data.materials.append(material)
found = {"plain": refusal()}
node = tree.nodes.new("ShaderNodeDisplacement")
tree.links.new(node.outputs[0], tree.nodes["Material Output"].inputs["Displacement"])
for method in ("BUMP", "DISPLACEMENT", "BOTH"):
    material.displacement_method = method
    found[method] = refusal()
cube.visible_camera = False
found["unseen"] = refusal()
cube.visible_camera = True
material.displacement_method = "BUMP"
modifier = cube.modifiers.new("smooth", "SUBSURF")
modifier.use_adaptive_subdivision = True
found["adaptive"] = refusal()
modifier.show_render = False
found["off"] = refusal()
bpy.ops.object.modifier_add(type="MULTIRES")
for _ in range(2):
    bpy.ops.object.multires_subdivide(modifier="Multires", mode="CATMULL_CLARK")
cube.modifiers["Multires"].levels = 0
found["multires"] = refusal()
source_scene._show_what_is_rendered()
found["faces"] = len(cube.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh().polygons)
answer(found)
"""

OVERRIDDEN = """
from rna_materials import object_materials
bpy.ops.mesh.primitive_cube_add()
leaf = bpy.data.materials.new("leaf")
bpy.context.object.data.materials.append(leaf)
bpy.ops.mesh.primitive_cube_add()
bpy.context.view_layer.material_override = bpy.data.materials.new("clay")
object_materials.override()
answer([[slot.material.name for slot in item.material_slots] for item in bpy.data.objects])
"""

HIDDEN_NODES = """
from rna_sources import gltf_import
notes = gltf_import.load(sys.argv[1])
answer({"notes": notes, "meshes": sorted(o.name for o in bpy.data.objects if o.type == "MESH")})
"""


def test_the_geometry_is_that_of_renders_and_of_camera_rays(open_worker):
    worker = open_worker(RENDERED)
    positions = worker.export_corners()["positions"]
    assert np.linalg.norm(positions, axis=1).max() == pytest.approx(1.0, abs=1e-5)
    assert len(positions) == 3 * 320
    said = " / ".join(worker.opened["notes"])
    for name in ("'unseen'", "'held out', 'mask'", "'catcher'", "'reflector'", "'instances'"):
        assert name in said, said
    traced = trace(worker, unit(0.3, 0.9, 0.3))
    assert traced.missed == 0.0
    assert np.abs(traced.points.x - traced.cycles_position).max() < 1e-4


def test_what_cycles_alone_shapes_is_refused_in_one_line(blender_python):
    actual = answer_of(blender_python, SHAPED_BY_CYCLES)
    fine = ("plain", "BUMP", "unseen", "off", "multires")
    assert [actual[name] for name in fine] == [None] * 5
    assert actual["faces"] == 6 * 4**2  # of the render level of Multires
    assert "'bark' displaces its surface" in actual["DISPLACEMENT"]
    assert actual["BOTH"] == actual["DISPLACEMENT"]
    assert "'Cube' has adaptive subdivision" in actual["adaptive"]


def test_the_material_of_a_view_layer_is_that_of_all_objects(blender_python):
    assert answer_of(blender_python, OVERRIDDEN) == [["clay"], ["clay"]]


def test_nodes_that_gltf_hides_stay_out_with_all_below_them(blender_python, tmp_path):
    corners = np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    (tmp_path / "corners.bin").write_bytes(corners.tobytes())
    hidden = {"KHR_node_visibility": {"visible": False}}
    nodes = [
        {"name": "seen", "mesh": 0},
        {"name": "hidden", "mesh": 0, "children": [2], "extensions": hidden},
        {"name": "below", "mesh": 0},
        {"name": "also", "mesh": 0, "extensions": {"KHR_node_visibility": {"visible": True}}},
    ]
    path = tmp_path / "nodes.gltf"
    path.write_text(
        json.dumps(
            {
                "asset": {"version": "2.0"},
                "extensionsUsed": ["KHR_node_visibility", "ACME_fog"],
                "extensionsRequired": ["KHR_node_visibility"],
                "scenes": [{"nodes": [0, 1, 3]}],
                "nodes": nodes,
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                "buffers": [{"uri": "corners.bin", "byteLength": 36}],
                "bufferViews": [{"buffer": 0, "byteLength": 36}],
                "accessors": [
                    {
                        "bufferView": 0,
                        "componentType": 5126,
                        "count": 3,
                        "type": "VEC3",
                        "min": [0, 0, 0],
                        "max": [1, 1, 0],
                    }
                ],
            }
        )
    )
    actual = answer_of(blender_python, HIDDEN_NODES, str(path))
    assert actual["meshes"] == ["also", "seen"]
    assert actual["notes"] == [
        "left out 2 nodes that the file hides (KHR_node_visibility)",
        "Blender's importer does not know ACME_fog, and passes over it",
    ]
