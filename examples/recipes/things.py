"""Builds one of ten things of ten materials, with modifiers, text and Geometry Nodes.

    rna-make examples/recipes/things.py --out mug.rna --minutes 5 -- mug

Runs inside Blender.
"""

import argparse
import math

import bpy
import lettering
import numpy as np
import shading
import shapes

Z = (0.0, 0.0, 0.0)


def primitive(kind, material, at=Z, scale=(1.0, 1.0, 1.0), turn=Z, **values):
    """An object of bpy.ops.mesh.primitive_`kind`_add, smooth, its scale applied."""
    getattr(bpy.ops.mesh, f"primitive_{kind}_add")(location=at, rotation=turn, **values)
    item = bpy.context.object
    item.scale = scale
    bpy.ops.object.transform_apply(location=False, rotation=False, scale=True)
    item.data.shade_smooth()
    item.data.materials.append(material)
    return item


def modifier(item, kind, **values):
    made = item.modifiers.new(kind.lower(), kind)
    for name, value in values.items():
        setattr(made, name, value)
    return made


def rounded(item, width, segments=3):
    modifier(
        item,
        "BEVEL",
        width=width,
        segments=segments,
        limit_method="ANGLE",
        angle_limit=math.radians(40.0),
        harden_normals=True,
    )


def blocks():
    """Painted blocks in a heap, instances of Geometry Nodes; matte paint."""
    paint = shading.principled("matte paint", (0.75, 0.28, 0.12), Roughness=0.8)
    block = primitive("cube", paint, size=0.03)
    block.hide_render = True
    rounded(block, 0.002, 2)
    group = bpy.data.node_groups.new("heap", "GeometryNodeTree")
    group.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    grid = group.nodes.new("GeometryNodeMeshCube")
    for name, value in (
        ("Size", (0.12, 0.12, 0.08)),
        ("Vertices X", 4),
        ("Vertices Y", 4),
        ("Vertices Z", 3),
    ):
        grid.inputs[name].default_value = value
    info, place = (
        group.nodes.new(f"GeometryNode{kind}") for kind in ("ObjectInfo", "InstanceOnPoints")
    )
    info.inputs["Object"].default_value = block
    turn = group.nodes.new("FunctionNodeRandomValue")
    turn.data_type = "FLOAT_VECTOR"
    turn.inputs["Max"].default_value = (0.5, 0.5, 6.3)
    out = group.nodes.new("NodeGroupOutput")
    for output, socket in (
        (grid.outputs["Mesh"], place.inputs["Points"]),
        (info.outputs["Geometry"], place.inputs["Instance"]),
        (turn.outputs[0], place.inputs["Rotation"]),
        (place.outputs[0], out.inputs[0]),
    ):
        group.links.new(output, socket)
    mesh = bpy.data.meshes.new("heap")
    item = bpy.data.objects.new("heap", mesh)
    bpy.context.scene.collection.objects.link(item)
    modifier(item, "NODES", node_group=group)


def printed():
    """A sheet of print, (1024, 1024, 3) encoded, row 0 the lowest."""
    side = 1024
    sheet = np.tile(np.array([0.93, 0.90, 0.82]), (side, side, 1))
    ink = np.array([0.06, 0.06, 0.07])
    for height, foot, words in (
        (150, 760, "COFFEE COFFEE"),
        (64, 640, "roasted by hand, in small lots"),
        (40, 560, "net weight 250 g, best before see the lid of this tin"),
    ):
        mask = lettering.text_mask(words, side, 30, foot, height)[..., None]
        sheet += mask * (ink - sheet)
    sheet[120:420] = [0.55, 0.08, 0.06]
    return sheet


def tin():
    """A tin with a printed label under clear coat, and a lid of steel."""
    label = shading.principled(
        "label",
        shading.image("label", printed()),
        Roughness=0.5,
        Coat_Weight=1.0,
        Coat_Roughness=0.05,
    )
    steel = shading.principled("lid", (0.62, 0.61, 0.59), Metallic=1.0, Roughness=0.25)
    profile = [(0.04, 0.1 * t) for t in np.linspace(0.0, 1.0, 6)]
    shapes.add(shapes.lathe(profile, 96), "label", label, smooth_deg=180.0)
    for z in (0.105, -0.004):
        rounded(
            primitive("cylinder", steel, at=(0, 0, z), vertices=96, radius=0.041, depth=0.01), 0.002
        )


def mug():
    """A mug of steel that is brushed around, with thickness and a handle."""
    nodes = shading.Nodes(
        "brushed steel", (0.62, 0.6, 0.58), Metallic=1.0, Roughness=0.28, Anisotropic=0.7
    )
    tangent = nodes.add("Tangent")
    tangent.direction_type, tangent.axis = "RADIAL", "Z"
    nodes.link(tangent.outputs[0], "Tangent")
    profile = [(0.0, 0.0), (0.034, 0.0), (0.038, 0.004), (0.04, 0.03), (0.04, 0.095)]
    item = shapes.add(shapes.lathe(profile, 96), "mug", nodes.material, smooth_deg=60.0)
    modifier(item, "SOLIDIFY", thickness=0.002)
    rounded(item, 0.0008, 2)
    arc = np.linspace(-0.5 * math.pi, 0.5 * math.pi, 24)
    path = [(0.038 + 0.028 * math.cos(a), 0.0, 0.05 + 0.028 * math.sin(a)) for a in arc]
    shapes.add(shapes.tube(path, 0.004, 16), "handle", nodes.material, smooth_deg=180.0)


def blister():
    """A toy's ball under a hood of thin clear plastic, on a card."""
    nodes = shading.Nodes("clear plastic", (1.0, 1.0, 1.0), Roughness=0.06)
    clear = nodes.add("BsdfTransparent", Color=(0.93, 0.96, 0.97, 1.0))
    gloss = nodes.add("BsdfGlossy", Roughness=0.06)
    facing, mix = nodes.add("Fresnel", IOR=1.5), nodes.add("MixShader")
    nodes.link(facing.outputs[0], mix.inputs[0])
    nodes.link(clear.outputs[0], mix.inputs[1])
    nodes.link(gloss.outputs[0], mix.inputs[2])
    shading.finish(nodes.material, mix.outputs[0])
    card = shading.principled("card", (0.85, 0.75, 0.1), Roughness=0.6)
    ball = shading.principled("ball", (0.05, 0.2, 0.65), Roughness=0.3)
    rounded(primitive("cube", card, at=(0, 0.002, 0), scale=(0.12, 0.004, 0.16), size=1.0), 0.001)
    primitive("uv_sphere", ball, at=(0, -0.03, 0), radius=0.024, segments=48, ring_count=24)
    hood = primitive("cube", nodes.material, at=(0, -0.03, 0), scale=(0.08, 0.06, 0.1), size=1.0)
    modifier(hood, "BEVEL", width=0.015, segments=6)


def head():
    """A monkey's head of skin, with pores by object coordinates."""
    nodes = shading.Nodes(
        "skin",
        (0.75, 0.42, 0.32),
        Roughness=0.45,
        Subsurface_Weight=1.0,
        Subsurface_Radius=(0.012, 0.005, 0.003),
    )
    nodes.shader.inputs["Subsurface Scale"].default_value = 1.0
    pores = nodes.placed(nodes.add("TexNoise", Scale=220.0, Detail=2.0))
    nodes.bump(pores.outputs[0], Distance=0.0012)
    blotches = nodes.placed(nodes.add("TexNoise", Scale=25.0, Detail=2.0))
    nodes.link(
        nodes.ramp(blotches.outputs[0], (0.35, (0.62, 0.28, 0.2)), (0.65, (0.8, 0.5, 0.4))),
        "Base Color",
    )
    item = primitive("monkey", nodes.material, size=0.18)
    modifier(item, "SUBSURF", levels=2, render_levels=2)


def curtain():
    """A curtain of velvet, in folds of a Wave modifier."""
    velvet = shading.principled(
        "velvet",
        (0.10, 0.008, 0.03),
        Roughness=0.9,
        Sheen_Weight=1.0,
        Sheen_Roughness=0.35,
        Specular_IOR_Level=0.1,
    )
    item = primitive(
        "grid", velvet, x_subdivisions=120, y_subdivisions=40, size=0.6, turn=(0.5 * math.pi, 0, 0)
    )
    modifier(
        item,
        "WAVE",
        use_y=False,
        height=0.035,
        width=0.04,
        narrowness=25.0,
        speed=0.0,
        time_offset=-400.0,
    )
    modifier(item, "SIMPLE_DEFORM", deform_method="TAPER", deform_axis="Y", factor=0.4)
    modifier(item, "SOLIDIFY", thickness=0.004)


def letters():
    """Letters of wax: a text object."""
    wax = shading.principled(
        "wax",
        (0.8, 0.5, 0.22),
        Roughness=0.4,
        Subsurface_Weight=1.0,
        Subsurface_Radius=(0.02, 0.009, 0.004),
        Subsurface_Scale=1.0,
    )
    text = bpy.data.curves.new("letters", "FONT")
    text.body, text.size, text.extrude = "Wax", 0.12, 0.02
    text.bevel_depth, text.bevel_resolution, text.resolution_u = 0.004, 3, 8
    text.materials.append(wax)
    item = bpy.data.objects.new("letters", text)
    item.rotation_euler = (0.5 * math.pi, 0.0, 0.0)
    bpy.context.scene.collection.objects.link(item)


def bonnet():
    """A bonnet of car paint: flakes of 1.5 mm whose normals differ, under a clear coat."""
    nodes = shading.Nodes(
        "car paint",
        (0.02, 0.10, 0.30),
        Metallic=0.85,
        Roughness=0.3,
        Coat_Weight=1.0,
        Coat_Roughness=0.03,
    )
    flakes = nodes.placed(nodes.add("TexVoronoi", Scale=650.0))
    lean = nodes.add("VectorMath")
    lean.operation = "SUBTRACT"
    nodes.link(flakes.outputs["Color"], lean.inputs[0])
    lean.inputs[1].default_value = (0.5, 0.5, 0.5)
    small = nodes.add("VectorMath")
    small.operation = "SCALE"
    small.inputs["Scale"].default_value = 0.35
    nodes.link(lean.outputs[0], small.inputs[0])
    bent = nodes.add("VectorMath")
    nodes.link(nodes.add("NewGeometry").outputs["Normal"], bent.inputs[0])
    nodes.link(small.outputs[0], bent.inputs[1])
    unit = nodes.add("VectorMath")
    unit.operation = "NORMALIZE"
    nodes.link(bent.outputs[0], unit.inputs[0])
    nodes.link(unit.outputs[0], "Normal")
    item = primitive("cube", nodes.material, size=1.0, scale=(0.3, 0.22, 0.08))
    modifier(item, "SUBSURF", levels=4, render_levels=4)
    modifier(item, "CAST", factor=0.15)


def board():
    """A board of wood with a hole, rings and pores by object coordinates, under varnish."""
    nodes = shading.Nodes("wood", None, Roughness=0.5, Coat_Weight=0.6, Coat_Roughness=0.2)
    rings = nodes.placed(
        nodes.add("TexWave", Scale=1.0, Distortion=6.0, Detail=2.0),
        "Object",
        scale=(6.0, 45.0, 45.0),
    )
    rings.wave_type = "RINGS"
    rings.rings_direction = "X"
    fibres = nodes.placed(
        nodes.add("TexNoise", Scale=1.0, Detail=2.0), "Object", scale=(30.0, 700.0, 700.0)
    )
    colour = nodes.ramp(rings.outputs["Fac"], (0.1, (0.15, 0.06, 0.02)), (0.9, (0.42, 0.22, 0.09)))
    dark = nodes.add("MixRGB", Fac=1.0)
    dark.blend_type = "MULTIPLY"
    nodes.link(colour, dark.inputs["Color1"])
    nodes.link(
        nodes.ramp(fibres.outputs[0], (0.3, (0.55,) * 3), (0.6, (1.0,) * 3)), dark.inputs["Color2"]
    )
    nodes.link(dark.outputs[0], "Base Color")
    item = primitive("cube", nodes.material, size=1.0, scale=(0.3, 0.18, 0.02))
    item.data.shade_flat()
    cut = primitive(
        "cylinder", nodes.material, at=(0.11, 0.0, 0.0), vertices=48, radius=0.018, depth=0.1
    )
    cut.hide_render = cut.hide_viewport = True
    modifier(item, "BOOLEAN", operation="DIFFERENCE", object=cut, solver="EXACT")
    rounded(item, 0.004)


def lace():
    """A cloth with a pattern of holes by an image's alpha, hung over a bar of dark metal."""
    side = 256
    y, x = (np.mgrid[0:side, 0:side] / side - 0.5) * 2.0
    r, turn = np.hypot(x, y), np.arctan2(y, x)
    flower = np.abs(r - 0.55 - 0.18 * np.cos(6.0 * turn)) < 0.09
    solid = (flower | (r < 0.16) | (np.abs(x) > 0.9) | (np.abs(y) > 0.9)).astype(float)
    pixels = np.concatenate([np.tile([0.93, 0.91, 0.86], (side, side, 1)), solid[..., None]], 2)
    nodes = shading.Nodes("lace", None, Roughness=0.9, Sheen_Weight=0.3)
    cut = shading.add_image(nodes.material, shading.image("lace", pixels))
    nodes.placed(cut, "UV", scale=(12.0, 20.0, 1.0))
    nodes.link(cut.outputs["Color"], "Base Color")
    nodes.link(cut.outputs["Alpha"], "Alpha")
    s = np.linspace(-0.15, 0.15, 61)
    bend = 0.02
    y = np.where(np.abs(s) < bend * math.pi / 2, bend * np.sin(s / bend), bend * np.sign(s))
    z = np.where(
        np.abs(s) < bend * math.pi / 2, bend * np.cos(s / bend), bend * math.pi / 2 - np.abs(s)
    )
    x = np.linspace(-0.09, 0.09, 61)
    fall = np.clip(-z, 0.0, 1.0)[:, None]
    y = y[:, None] + 0.1 * fall * np.sin(70.0 * x)[None] * 0.6
    points = np.stack([np.broadcast_to(x, y.shape), y, np.broadcast_to(z[:, None], y.shape)], -1)
    shapes.add(shapes.grid(points), "lace", nodes.material, smooth_deg=180.0)
    iron = shading.principled("bar", (0.1, 0.1, 0.1), Metallic=1.0, Roughness=0.4)
    primitive("cylinder", iron, vertices=48, radius=0.018, depth=0.24, turn=(0, 0.5 * math.pi, 0))


THINGS = {
    "blocks": blocks,
    "tin": tin,
    "mug": mug,
    "blister": blister,
    "head": head,
    "curtain": curtain,
    "letters": letters,
    "bonnet": bonnet,
    "board": board,
    "lace": lace,
}


def main():
    parser = argparse.ArgumentParser(prog="rna-capture things.py --")
    parser.add_argument("thing", choices=[*THINGS], help="which one")
    THINGS[parser.parse_args().thing]()


main()
