"""Masks and normal maps on whatever UV map, transform and image extension: as Cycles shows them."""

import pytest

from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.geometry.exported_parts import exported_parts
from tests.exporters.cycles import assert_same_cards

pytestmark = pytest.mark.blender

# `card(k, layers, build)` is a square at x = k; `build(tree)` returns the alpha's socket.
CARDS = """
import os, tempfile
import numpy as np

def letter(n=64, name="letter"):
    pixels = np.zeros((n, n, 4), np.float32)
    pixels[n // 8: -n // 8, n // 8: 3 * n // 8, 3] = 1.0
    pixels[5 * n // 8: -n // 8, n // 8: -n // 8, 3] = 1.0
    image = bpy.data.images.new(name, n, n, alpha=True)
    image.pixels.foreach_set(pixels.ravel())
    image.pack()
    return image

LETTER = letter()
UPRIGHT = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float)

def card(k, layers, build, active=0, threshold=0.5):
    material = principled()
    item = add(*square(0.3, x=k), material)
    for number, uvs in enumerate(layers):
        layer = item.data.uv_layers.new(name=f"UV{number}")
        layer.uv.foreach_set("vector", np.float32(uvs).ravel())
        layer.active_render = number == active
    tree = material.node_tree
    alpha = build(tree)
    compare = tree.nodes.new("ShaderNodeMath")
    compare.operation, compare.inputs[1].default_value = "LESS_THAN", threshold
    flip = tree.nodes.new("ShaderNodeMath")
    flip.operation, flip.inputs[0].default_value = "SUBTRACT", 1.0
    tree.links.new(alpha, compare.inputs[0])
    tree.links.new(compare.outputs[0], flip.inputs[1])
    tree.links.new(flip.outputs[0], tree.nodes["Principled BSDF"].inputs["Alpha"])
    return item

def image(tree, vector=None, extension="REPEAT", picture=None, interpolation="Linear"):
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image, node.extension = picture or LETTER, extension
    node.interpolation = interpolation
    if vector is not None:
        tree.links.new(vector, node.inputs["Vector"])
    return node.outputs["Alpha"]

def uv(tree, name):
    node = tree.nodes.new("ShaderNodeUVMap")
    node.uv_map = name
    return node.outputs[0]

def mapping(tree, vector, kind="POINT", scale=(1, 1, 1), turn=0.0, shift=(0, 0, 0)):
    node = tree.nodes.new("ShaderNodeMapping")
    node.vector_type = kind
    node.inputs["Scale"].default_value = scale
    node.inputs["Rotation"].default_value = (0, 0, turn)
    if kind != "VECTOR":
        node.inputs["Location"].default_value = shift
    tree.links.new(vector, node.inputs["Vector"])
    return node.outputs[0]

def multiplied(tree, a, b):
    node = tree.nodes.new("ShaderNodeMath")
    node.operation = "MULTIPLY"
    tree.links.new(a, node.inputs[0])
    tree.links.new(b, node.inputs[1])
    return node.outputs[0]
"""

WRAPPED = (
    CARDS
    + """
wide = 3.0 * UPRIGHT - 1.0
card(0, [2 * UPRIGHT], lambda t: image(t, mapping(t, uv(t, "UV0"), scale=(0.5, 0.5, 1))))
card(1, [wide], lambda t: image(t, mapping(t, uv(t, ""), "TEXTURE", (2, 1, 1), 0.4, (0.3, 0, 0))))
for k, extension in enumerate(("EXTEND", "CLIP", "MIRROR")):
    card(2 + k, [wide], lambda t: image(t, extension=extension))
card(5, [UPRIGHT], lambda t: image(t, extension="EXTEND"))
card(6, [UPRIGHT], lambda t: image(t, picture=letter(8, "coarse"), interpolation="Closest"))
def pingpong(t):
    parts, back = t.nodes.new("ShaderNodeSeparateXYZ"), t.nodes.new("ShaderNodeCombineXYZ")
    t.links.new(uv(t, ""), parts.inputs[0])
    for axis in (0, 1):
        fold = t.nodes.new("ShaderNodeMath")
        fold.operation, fold.inputs[1].default_value = "PINGPONG", 1.0
        t.links.new(parts.outputs[axis], fold.inputs[0])
        t.links.new(fold.outputs[0], back.inputs[axis])
    return image(t, back.outputs[0])
card(7, [wide], pingpong)
folder = tempfile.mkdtemp()
for tile, alpha in ((1001, 1.0), (1002, 0.0)):
    part = bpy.data.images.new(f"tile{tile}", 16, 16, alpha=True)
    part.pixels.foreach_set(np.tile(np.float32([1, 1, 1, alpha]), 256))
    part.filepath_raw, part.file_format = os.path.join(folder, f"a.{tile}.png"), "PNG"
    part.save()
tiled = bpy.data.images.load(os.path.join(folder, "a.1001.png"))
tiled.source = "TILED"
tiled.tiles.new(1002)
tiled.filepath = os.path.join(folder, "a.<UDIM>.png")
tiled.reload()
card(8, [UPRIGHT * [2, 1]], lambda t: image(t, picture=tiled))
"""
)

NAMED = (
    CARDS
    + """
point = np.full((4, 2), 0.02)
card(0, [point, UPRIGHT], lambda t: image(t, uv(t, "UV1")))
def by_attribute(t):
    node = t.nodes.new("ShaderNodeAttribute")
    node.attribute_name = "UV1"
    return image(t, node.outputs["Vector"])
card(1, [point, UPRIGHT], by_attribute)
card(2, [point, UPRIGHT], lambda t: image(t), active=1)
card(3, [], lambda t: image(t))  # Cycles looks it up at 0
def coloured(t):
    return multiplied(t, image(t), t.nodes.new("ShaderNodeVertexColor").outputs["Alpha"])
item = card(4, [UPRIGHT], coloured)
colours = item.data.color_attributes.new("Wind", "BYTE_COLOR", "CORNER")
colours.data.foreach_set("color", np.float32([(k / 4, 0, 1, 1) for k in range(4)]).ravel())
def in_groups(t):
    inner = bpy.data.node_groups.new("inner", "ShaderNodeTree")
    inner.interface.new_socket("at", in_out="INPUT", socket_type="NodeSocketVector")
    inner.interface.new_socket("alpha", in_out="OUTPUT", socket_type="NodeSocketFloat")
    start, end = inner.nodes.new("NodeGroupInput"), inner.nodes.new("NodeGroupOutput")
    at = mapping(inner, start.outputs[0], scale=(-2, 1, 1))
    inner.links.new(image(inner, at), end.inputs[0])
    outer = bpy.data.node_groups.new("outer", "ShaderNodeTree")
    outer.interface.new_socket("alpha", in_out="OUTPUT", socket_type="NodeSocketFloat")
    node, end = outer.nodes.new("ShaderNodeGroup"), outer.nodes.new("NodeGroupOutput")
    node.node_tree = inner
    outer.links.new(uv(outer, "UV1"), node.inputs[0])
    outer.links.new(node.outputs[0], end.inputs[0])
    whole = t.nodes.new("ShaderNodeGroup")
    whole.node_tree = outer
    return whole.outputs[0]
card(5, [point, UPRIGHT], in_groups)
def muted(t):
    step = t.nodes.new("ShaderNodeMath")
    step.operation = "MULTIPLY"
    step.inputs[1].default_value, step.mute = 0.0, True
    t.links.new(image(t), step.inputs[0])
    return step.outputs[0]
card(6, [UPRIGHT], muted)
half = bpy.data.images.new("half", 8, 8, alpha=True)
half.pixels.foreach_set(np.tile(np.float32([1, 1, 1, 128 / 255]), 64))
half.pack()
card(7, [UPRIGHT], lambda t: image(t, picture=half), threshold=127.9 / 255)
# Two libraries whose materials have one name.
folder = tempfile.mkdtemp()
for number, alpha in enumerate((0.0, 1.0)):
    material = principled(Alpha=alpha)
    material.name = "Mat"
    item = add(*square(0.3, x=8 + number), material)
    item.name = f"linked{number}"
    path = os.path.join(folder, f"library{number}.blend")
    bpy.data.libraries.write(path, {item})
    bpy.data.objects.remove(item)
    bpy.data.materials.remove(material)
    with bpy.data.libraries.load(path, link=True) as (there, here):
        here.objects = there.objects
    bpy.context.scene.collection.objects.link(here.objects[0])
"""
)

REFUSED = (
    CARDS
    + """
card(0, [UPRIGHT, UPRIGHT[::-1]],
     lambda t: multiplied(t, image(t, uv(t, "UV0")), image(t, uv(t, "UV1"))))
card(1, [UPRIGHT], lambda t: t.nodes.new("ShaderNodeTexNoise").outputs[0])
item = card(2, [UPRIGHT], lambda t: t.nodes.new("ShaderNodeVertexColor").outputs["Alpha"])
colours = item.data.color_attributes.new("Fade", "FLOAT_COLOR", "CORNER")
colours.data.foreach_set("color", np.float32([(1, 1, 1, k / 4) for k in range(4)]).ravel())
for k, item in enumerate(bpy.context.scene.objects):
    item.data.materials[0].name = f"m{k}"
"""
)


@pytest.mark.parametrize(("scene", "cards"), [(WRAPPED, 9), (NAMED, 10)], ids=["wraps", "names"])
def test_holes_are_where_cycles_has_them(open_worker, scene, cards):
    worker = open_worker(scene)
    exported = exported_parts(worker, CaptureSettings())
    assert exported.notes == []
    assert_same_cards(worker, exported, cards)


def test_what_no_texture_holds_is_named(open_worker):
    worker = open_worker(REFUSED)
    exported = exported_parts(worker, CaptureSettings())
    assert exported.has_opaque_cutouts and exported.records == {}
    for name, reason in (
        ("m0", "the UV maps 'UV0' and 'UV1' at once"),
        ("m1", "'Noise Texture' without texture coordinates"),
        ("m2", "the colour attribute"),
    ):
        (note,) = (each for each in exported.notes if repr(name) in each)
        assert reason in note and "no function of its UV coordinates" in note
