"""Builds a ball on a foot of one of ten materials that artists use: what does the pre-flight say?

    rna-capture examples/recipes/materials.py --estimate -- paint

`-- all` puts the ten side by side, without the volume, which no capture takes. Runs inside Blender.
"""

import argparse

import bpy
import numpy as np
import shading
import shapes

RADIUS = 0.05  # metres
FOOT = [(0.0, -0.056), (0.034, -0.056), (0.036, -0.054), (0.036, -0.05), (0.026, -0.044)]
APART = 0.13


def paint():
    """Car paint: a metallic base whose flakes tilt the normal, under a clear coat."""
    nodes = shading.Nodes(
        "paint", (0.25, 0.01, 0.015), Metallic=0.8, Roughness=0.35, Coat_Weight=1.0
    )
    nodes.shader.inputs["Coat Roughness"].default_value = 0.03
    flakes = nodes.placed(nodes.add("TexVoronoi", "Flakes", Scale=3000.0))
    nodes.bump(flakes.outputs["Distance"], Strength=0.4, Distance=0.0002)
    return nodes.material


def wax():
    return shading.principled("wax", (0.85, 0.62, 0.35), Roughness=0.45, Subsurface_Weight=1.0,
                              Subsurface_Radius=(0.02, 0.008, 0.003))  # fmt: skip


def glass():
    return shading.principled("glass", (1.0, 1.0, 1.0), Roughness=0.0, IOR=1.5,
                              Transmission_Weight=1.0)  # fmt: skip


def velvet():
    return shading.principled("velvet", (0.12, 0.01, 0.05), Roughness=1.0, Sheen_Weight=1.0,
                              Sheen_Roughness=0.3, Specular_IOR_Level=0.0)  # fmt: skip


def leaf():
    """A thin leaf: half of the light goes through, and holes are cut out by an image."""
    nodes = shading.Nodes("leaf", (0.1, 0.3, 0.03), Roughness=0.5)
    thin = nodes.add("BsdfTranslucent", Color=(0.2, 0.5, 0.04, 1.0))
    mix = nodes.add("MixShader")
    nodes.tree.links.new(nodes.shader.outputs[0], mix.inputs[1])
    nodes.tree.links.new(thin.outputs[0], mix.inputs[2])
    y, x = np.mgrid[0:128, 0:128] / 127.0 - 0.5
    wide = 0.42 * np.sqrt(np.clip(1.0 - (2.0 * y) ** 2, 0.0, 1.0))
    bites = np.hypot(x - 0.25, y + 0.1) < 0.1
    shape = ((np.abs(x) < wide) & ~bites).astype(float)
    cut = nodes.add("TexImage")
    cut.image = shading.image("leaf", np.repeat(shape[..., None], 3, axis=2), "Non-Color")
    clear, holes = nodes.add("BsdfTransparent"), nodes.add("MixShader")
    nodes.tree.links.new(cut.outputs["Color"], holes.inputs[0])
    nodes.tree.links.new(clear.outputs[0], holes.inputs[1])
    nodes.tree.links.new(mix.outputs[0], holes.inputs[2])
    nodes.tree.links.new(holes.outputs[0], nodes.tree.nodes["Material Output"].inputs["Surface"])
    return nodes.material


def brushed():
    """Steel, brushed around: grain of a tenth of a millimetre in the roughness."""
    nodes = shading.Nodes(
        "brushed", (0.6, 0.58, 0.55), Metallic=1.0, Roughness=0.3, Anisotropic=0.8
    )
    grain = nodes.add("TexNoise", "Grain", Scale=1.0, Detail=2.0)
    nodes.placed(grain, scale=(100.0, 100.0, 5000.0))
    spread = nodes.add("MapRange")
    spread.inputs["To Min"].default_value, spread.inputs["To Max"].default_value = 0.15, 0.45
    nodes.tree.links.new(grain.outputs[0], spread.inputs["Value"])
    nodes.link(spread.outputs[0], "Roughness")
    return nodes.material


def marble():
    nodes = shading.Nodes("marble", None, Roughness=0.2, Subsurface_Weight=0.3,
                  Subsurface_Radius=(0.004, 0.003, 0.002))  # fmt: skip
    veins = nodes.placed(nodes.add("TexNoise", "Veins", Scale=25.0, Detail=4.0, Distortion=2.0))
    colour = nodes.ramp(veins.outputs[0], (0.42, (0.12, 0.12, 0.15)), (0.52, (0.85, 0.83, 0.8)))
    nodes.link(colour, "Base Color")
    return nodes.material


def volume():
    """A cloud: a volume without a surface."""
    nodes = shading.Nodes("volume", None)
    output = nodes.tree.nodes["Material Output"]
    nodes.tree.nodes.remove(nodes.shader)
    cloud = nodes.add("VolumePrincipled", Density=60.0)
    nodes.tree.links.new(cloud.outputs[0], output.inputs["Volume"])
    return nodes.material


def neon():
    return shading.principled("neon", (0.05, 0.05, 0.05), Roughness=0.3, Emission_Strength=6.0,
                              Emission_Color=(1.0, 0.12, 0.4, 1.0))  # fmt: skip


def fur(x):
    """Short strands all over the ball."""
    import rna_hair
    from rna_hair.objects import add_curves, chiang_material

    rng = np.random.default_rng(3)
    out = rng.normal(size=(6000, 1, 3))
    out /= np.linalg.norm(out, axis=2, keepdims=True)
    comb = 0.012 * np.array([0.0, 0.0, -1.0]) + 0.003 * rng.normal(size=(6000, 1, 3))
    along = np.linspace(0.0, 1.0, 6)[:, None]
    points = [x, 0.0, 0.0] + RADIUS * out + 0.014 * out * along + comb * along**2
    strands = rna_hair.of_equal_length(points, np.linspace(1.2e-4, 3e-5, 6))
    add_curves(strands, "fur", chiang_material(melanin=0.35))


MATERIALS = {
    "paint": paint,
    "wax": wax,
    "glass": glass,
    "velvet": velvet,
    "leaf": leaf,
    "brushed": brushed,
    "marble": marble,
    "volume": volume,
    "neon": neon,
    "fur": lambda: shading.principled("skin", (0.2, 0.1, 0.06), Roughness=0.7),
}


def card():
    """A curved leaf's card, upright."""
    v, u = np.meshgrid(np.linspace(0.0, 1.0, 17), np.linspace(0.0, 1.0, 17), indexing="ij")
    bend = 0.03 * (v - 0.5) ** 2 + 0.02 * (u - 0.5) ** 2
    points = [0.1 * (u - 0.5), 0.4 * bend, 0.1 * (v - 0.5)]
    return shapes.grid(np.stack(points, axis=-1))


def build(name, x=0.0):
    made = MATERIALS[name]()
    shape = card() if name == "leaf" else shapes.ball((RADIUS, RADIUS, RADIUS), 64)
    shapes.add(shape.placed((x, 0.0, 0.0)), name, made, smooth_deg=180.0)
    foot = shading.principled(f"foot of {name}", (0.1, 0.1, 0.1), Roughness=0.5)
    shapes.add(shapes.lathe(FOOT, 48).placed((x, 0.0, 0.0)), f"foot of {name}", foot)
    if name == "fur":
        fur(x)


def main():
    parser = argparse.ArgumentParser(prog="rna-capture materials.py --")
    parser.add_argument("material", choices=[*MATERIALS, "all"], help="which one")
    name = parser.parse_args().material
    chosen = [n for n in MATERIALS if n != "volume"] if name == "all" else [name]
    for k, each in enumerate(chosen):
        build(each, APART * k)
    bpy.context.view_layer.update()


main()
