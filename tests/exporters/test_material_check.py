"""Materials that Cycles cannot show as meant are named, each in one line."""

import pytest

pytestmark = pytest.mark.blender

MATERIAL = """
material = principled()
tree = material.node_tree
new, join = tree.nodes.new, tree.links.new
shader, output = tree.nodes["Principled BSDF"], tree.nodes["Material Output"]
item = add(*square(1), material)
"""
IMAGE = """
texture = new("ShaderNodeTexImage")
join(texture.outputs[0], shader.inputs["Base Color"])
"""
FILE = (
    IMAGE
    + """
texture.image = bpy.data.images.new("x", 4, 4)
texture.image.source, texture.image.filepath = "FILE", PATH
"""
)
UNKNOWN = """
class Newer(bpy.types.ShaderNode):
    bl_idname, bl_label = "NewerNode", "Newer"
    def init(self, context):
        self.outputs.new("NodeSocketColor", "Color")

bpy.utils.register_class(Newer)
join(new("NewerNode").outputs[0], shader.inputs["Base Color"])
bpy.utils.unregister_class(Newer)
"""
SCRIPT = """
script = new("ShaderNodeScript")
closure = script.outputs.new("NodeSocketShader", "out")
join(closure, output.inputs["Surface"])
"""


@pytest.mark.parametrize(
    ("body", "named"),
    [
        (IMAGE, "an image texture has no image; renders show it pink"),
        (f"PATH = '/nowhere/x.png'\n{FILE}", "image '/nowhere/x.png' is missing; renders show"),
        (
            "join(new('ShaderNodeEeveeSpecular').outputs[0], output.inputs[0])",
            "the node 'Specular BSDF' is for EEVEE only",
        ),
        (UNKNOWN, "the node 'Newer' is of a kind that Blender 5.0.1 lacks"),
        ("output.target = 'EEVEE'", "it has no material output for Cycles; renders show it black"),
        ("tree.links.clear()", "nothing is connected to its output; renders show it black"),
        (SCRIPT, "the script of the node 'Script' is left out: Open Shading Language is off"),
        (
            "bpy.context.scene.cycles.shading_system = True\n" + SCRIPT,
            "the script of the node 'Script' was never compiled",
        ),
    ],
)
def test_what_cycles_cannot_show(body, named, open_worker):
    (note,) = open_worker(MATERIAL + body).opened["notes"]
    assert note.startswith(f"material 'principled': {named}")


def test_a_damaged_image(open_worker, tmp_path):
    path = tmp_path / "x.png"
    path.write_bytes(b"not a picture")
    (note,) = open_worker(f"{MATERIAL}PATH = {str(path)!r}\n{FILE}").opened["notes"]
    assert f"image {str(path)!r} cannot be read" in note


@pytest.mark.parametrize(
    "body",
    [
        IMAGE + "texture.mute = True",
        IMAGE + "item.hide_render = True\nadd(CUBE, SIDES, diffuse((1, 1, 1)))",
        IMAGE + "tree.links.remove(texture.outputs[0].links[0])",
        IMAGE + "texture.image = bpy.data.images.new('painted', 4, 4)",
    ],
)
def test_what_is_not_shown_is_not_named(body, open_worker):
    notes = open_worker(MATERIAL + body).opened["notes"]
    assert [note for note in notes if note.startswith("material ")] == []


def test_problems_inside_a_node_group(open_worker):
    body = """
inner = bpy.data.node_groups.new("inner", "ShaderNodeTree")
inner.interface.new_socket("colour", in_out="OUTPUT", socket_type="NodeSocketColor")
texture, end = inner.nodes.new("ShaderNodeTexImage"), inner.nodes.new("NodeGroupOutput")
inner.links.new(texture.outputs[0], end.inputs[0])
group = new("ShaderNodeGroup")
group.node_tree = inner
join(group.outputs[0], shader.inputs["Base Color"])
"""
    (note,) = open_worker(MATERIAL + body).opened["notes"]
    assert "an image texture has no image" in note


def test_objects_without_a_material(open_worker):
    body = "for k in range(5):\n    add(*square(1, z=k)).name = f'part{k}'"
    (note,) = open_worker(body).opened["notes"]
    assert note.endswith("usual grey: 'part0', 'part1', 'part2' and 2 more")
