"""Each kind of object that Cycles shows is exported once, with the material that it shows."""

from collections.abc import Iterator

import numpy as np
import pytest

from tests.exporters.cycles import unit

pytestmark = pytest.mark.blender

# Each object is in a square of its own, from (k, 0) to (k + 1, 1), and has a material of its own,
# whose name ends with the share of the light that it lets through: alpha tells how many layers of
# which materials there are.
TOOLS = """
link = bpy.context.scene.collection.objects.link
shares = iter([round(0.3 + 0.023 * k, 3) for k in range(30)])
places = iter(range(30))

def clear(name):
    share = next(shares)
    material = bpy.data.materials.new(f"{name} {share}")
    material.use_nodes = True
    tree = material.node_tree
    shader = tree.nodes.new("ShaderNodeBsdfTransparent")
    shader.inputs["Color"].default_value = (share, share, share, 1)
    tree.links.new(shader.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    return material

def put(name, data, has_material=True):
    item = bpy.data.objects.new(name, data)
    item.location = (next(places) + 0.5, 0.5, 0)
    link(item)
    if has_material:
        data.materials.append(clear(name))
    return item

def line(name, bevel=0.0):
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions, curve.bevel_depth = "3D", bevel
    spline = curve.splines.new("POLY")
    spline.points.add(1)
    spline.points[0].co, spline.points[1].co = (-0.3, 0, 0, 1), (0.3, 0, 0, 1)
    return curve

def text(name):
    data = bpy.data.curves.new(name, "FONT")
    data.body, data.size, data.align_x = "E", 0.9, "CENTER"
    return data

def cube(name="cube", half=0.3):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([tuple(half * c for c in corner) for corner in CUBE], [], SIDES)
    return mesh

def nodes(item, *kinds):
    # a chain of nodes on an object: from its geometry through the first socket of each
    tree = bpy.data.node_groups.new(item.name, "GeometryNodeTree")
    for way in ("INPUT", "OUTPUT"):
        tree.interface.new_socket("Geometry", in_out=way, socket_type="NodeSocketGeometry")
    start, end = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    made = [tree.nodes.new("GeometryNode" + kind) for kind in kinds]
    for first, second in zip([start, *made], [*made, end]):
        tree.links.new(first.outputs[0], second.inputs[0])
    item.modifiers.new("nodes", "NODES").node_group = tree
    return tree, made

def tube(item, material):
    tree, (_, paint) = nodes(item, "CurveToMesh", "SetMaterial")
    profile = tree.nodes.new("GeometryNodeCurvePrimitiveCircle")
    profile.inputs["Radius"].default_value = 0.1
    tree.links.new(profile.outputs[0], tree.nodes["Curve to Mesh"].inputs[1])
    paint.inputs["Material"].default_value = material

def on_points(item, what, as_instance=True):
    tree, (put_on,) = nodes(item, "InstanceOnPoints")
    info = tree.nodes.new("GeometryNodeObjectInfo")
    info.inputs["Object"].default_value = what
    info.inputs["As Instance"].default_value = as_instance
    tree.links.new(info.outputs["Geometry"], put_on.inputs["Instance"])

def hidden(name, data):
    item = bpy.data.objects.new(name, data)
    item.hide_render = True
    link(item)
    return item

def point(name):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([(0, 0, 0)], [], [])
    return mesh
"""
KINDS = """
put("mesh", cube())
put("text", text("text"))
thick = text("thick text")
thick.extrude = 0.1
put("thick text", thick)
put("curve", line("curve", 0.1))
flat = line("flat curve")
flat.dimensions, flat.fill_mode = "2D", "BOTH"
flat.splines[0].points.add(1)
flat.splines[0].points[2].co = (0, 0.3, 0, 1)
flat.splines[0].use_cyclic_u = True
put("flat curve", flat)
bpy.ops.surface.primitive_nurbs_surface_sphere_add(radius=0.35)
nurbs = bpy.context.object
nurbs.location = (next(places) + 0.5, 0.5, 0)
nurbs.data.materials.append(clear("nurbs"))
ball = bpy.data.metaballs.new("meta")
ball.render_resolution = 0.1
ball.elements.new().radius = 0.4
put("meta", ball)
twice = put("curve with a modifier", line("modified", 0.04)).modifiers.new("two", "ARRAY")
twice.use_relative_offset, twice.use_constant_offset = False, True
twice.constant_offset_displace = (0, 0.2, 0)
mirrored = put("mirrored", text("mirrored"))
mirrored.scale = (-1, 1, 1)
put("mirror", cube(half=0.1)).modifiers.new("mirror", "MIRROR")
for vertex in bpy.data.objects["mirror"].data.vertices:
    vertex.co.x += 0.2
put("two materials", cube("two")).data.materials.append(clear("second"))
bpy.data.objects["two materials"].data.polygons[4].material_index = 1
tube(put("lace", line("lace"), False), clear("painted lace"))
painted = hidden("painted", cube("painted", 0.2))
painted.data.materials.append(clear("painted"))
on_points(put("eyelets", point("eyelets")), painted)
on_points(put("realised", point("realised")), painted, as_instance=False)
on_points(put("letters", point("letters")), bpy.data.objects["text"])
group = bpy.data.collections.new("group")
for k, data in enumerate((text("in a collection"), line("curve in a collection", 0.05))):
    item = bpy.data.objects.new(data.name, data)
    item.location = (0, 0, 0.2 * k)
    data.materials.append(clear(data.name))
    group.objects.link(item)
empty = bpy.data.objects.new("empty", None)
empty.instance_type, empty.instance_collection = "COLLECTION", group
empty.location = (next(places) + 0.5, 0.5, 0)
link(empty)
verts = put("parent of vertices", point("vertices"), False)
verts.instance_type = "VERTS"
child = hidden("child", text("child"))
child.hide_render, child.parent = False, verts
child.data.materials.append(clear("child"))
emitter = put("emitter", cube(half=0.01))
emitter.show_instancer_for_render = False
emitter.modifiers.new("many", "PARTICLE_SYSTEM")
settings = emitter.particle_systems[0].settings
settings.type, settings.count, settings.render_type = "HAIR", 1, "OBJECT"
settings.use_advanced_hair, settings.instance_object, settings.particle_size = True, painted, 0.3
put("unseen in the viewport", text("eye")).hide_viewport = True
put("hidden by the eye", cube()).hide_set(True)
inner = bpy.data.objects.new("hidden in a collection", text("hidden in a collection"))
inner.hide_render = True
lone = bpy.data.collections.new("lone")
lone.objects.link(inner)
empty = bpy.data.objects.new("empty", None)
empty.instance_type, empty.instance_collection = "COLLECTION", lone
empty.location = (next(places) + 0.5, 0.5, 0)
link(empty)
verts = put("parent of vertices", point("vertices"), False)
verts.instance_type = "VERTS"
child = hidden("child", text("child"))
child.parent = verts
for name, hide in (
    ("camera icon", lambda item, home, layer: setattr(item, "hide_render", True)),
    ("collection's camera icon", lambda item, home, layer: setattr(home, "hide_render", True)),
    ("excluded collection", lambda item, home, layer: setattr(layer, "exclude", True)),
    ("rays of cameras", lambda item, home, layer: setattr(item, "visible_camera", False)),
):
    item = put(name, text(name))
    home = bpy.data.collections.new(name)
    bpy.context.scene.collection.children.link(home)
    home.objects.link(item)
    bpy.context.scene.collection.objects.unlink(item)
    hide(item, home, bpy.context.view_layer.layer_collection.children[name])
put("guide", line("guide"))
"""
SHOWN = 20  # places, before those of what is hidden
NO_SURFACE = """
put("mesh", cube())



put("smoke", bpy.data.volumes.new("smoke"))
bpy.ops.object.grease_pencil_add(type="STROKE")
strands = bpy.data.hair_curves.new("strands")
strands.add_curves([2, 2, 2])
for k, at in enumerate(strands.position_data):
    at.vector = (0.1 * (k // 2), 0, 0.2 * (k % 2))
put("strands", strands)
put("emitter", cube()).modifiers.new("hair", "PARTICLE_SYSTEM")
settings = bpy.data.objects["emitter"].particle_systems[0].settings
settings.type, settings.count, settings.hair_step = "HAIR", 5, 3
"""


def layers(positions: np.ndarray, x: np.ndarray, y: np.ndarray) -> Iterator[np.ndarray]:
    """For each triangle (3, 3) the points that lie under or over it, bool."""
    for a, b, c in positions:
        sides = [
            (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])
            for p, q in ((a, b), (b, c), (c, a))
        ]
        yield np.all(np.array(sides) > 0, axis=0) | np.all(np.array(sides) < 0, axis=0)


def test_cycles_and_the_export_have_the_same_layers_of_the_same_materials(
    open_worker,
):
    worker = open_worker(TOOLS + KINDS)
    corners = worker.export_corners()
    a_side, places = 24, SHOWN + 7
    across = (np.arange(places * a_side) + 0.513) / a_side
    x, y = (each.ravel() for each in np.meshgrid(across, across[:a_side] + 0.007))
    origins = np.stack([x, np.full_like(x, 2.0), -y], axis=1).astype(np.float32)
    down = np.tile(np.float32([0, -1, 0]), (len(x), 1))
    passed = np.ones(len(x))
    triangles = corners["positions"].reshape(-1, 3, 3)[:, :, [0, 2]] * [1, -1]
    for over, material in zip(layers(triangles, x, y), corners["material"], strict=True):
        passed[over] *= float(material.split()[-1])
    rendered = worker.render_rays(origins, down, unit(0, 1, 0), 1, seed=1)
    differs = np.abs(rendered.alpha - (1.0 - passed)) > 1e-3
    place = np.floor(x).astype(int)
    wrong = np.bincount(place[differs], minlength=places) / a_side**2
    assert wrong.max() < 0.02, np.flatnonzero(wrong > 0.02)
    seen = np.bincount(place, passed < 1.0) > 0
    assert list(np.flatnonzero(seen)) == list(range(SHOWN))
    said = " / ".join(worker.opened["notes"])
    assert "grey" not in said
    hidden = "'child.001', 'camera icon', \"collection's camera icon\" and 1 more"
    assert f"left out, since renders do not show them: {hidden}" in said


def test_what_has_no_surface_is_named_and_strands_come_once(open_worker):
    worker = open_worker(TOOLS + NO_SURFACE)
    assert worker.export_curves().offsets.size - 1 == 3 + 5
    assert len(worker.export_corners()["positions"]) == 2 * 36
    said = " / ".join(worker.opened["notes"])
    for name, kind in (("smoke", "a volume"), ("Stroke", "a grease pencil drawing")):
        assert f"object {name!r} is {kind}" in said, said
