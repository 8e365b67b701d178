"""Builds a lantern: a black frame, four panes of thin tinted glass, a candle of wax inside.

    rna-capture examples/recipes/lantern.py --out lantern.rays/ -- --lit

Panes are single sheets: they let light through without bending it, less what Fresnel's equations
reflect. Runs inside Blender.
"""

import argparse

import numpy as np
import shading
import shapes

HALF = 0.07  # from the axis to a pane
FLOOR, CEILING = 0.03, 0.215  # heights between which there is glass
POST = 0.012  # width of the frame's bars
FLAME = 150.0  # radiance, W/(m^2 sr)
TINTS = {
    "amber": (0.95, 0.72, 0.35),
    "clear": (0.93, 0.96, 0.94),
    "sea": (0.5, 0.85, 0.8),
    "rose": (0.95, 0.55, 0.55),
}


def glass(name, tint):
    """A pane: a mirror by as much as Fresnel's equations reflect, a filter for the rest."""
    material = shading.principled(name)
    tree = material.node_tree
    tree.nodes.remove(tree.nodes["Principled BSDF"])
    fresnel = tree.nodes.new("ShaderNodeFresnel")
    fresnel.inputs["IOR"].default_value = 1.45
    through = shading.add_shader(material, "Transparent", tint)
    mirror = shading.add_shader(material, "Glossy", (1.0, 1.0, 1.0), roughness=0.02)
    return shading.finish(material, shading.mix(material, fresnel.outputs[0], through, mirror))


def add_panes():
    half, height = HALF - 0.25 * POST, CEILING - FLOOR
    v, u = np.meshgrid(np.linspace(0.0, 1.0, 3), np.linspace(-1.0, 1.0, 3), indexing="ij")
    points = np.stack([half * u, 0.0 * u - HALF, FLOOR + height * v], axis=-1)
    for k, (name, tint) in enumerate(TINTS.items()):
        pane = shapes.grid(points).placed(turn=shapes.rotation((0, 0, 1), 90.0 * k))
        shapes.add(pane, f"{name} pane", glass(f"{name} glass", tint))


def roof():
    """Four-sided, with a chimney and a ring to carry it by."""
    profile = [(0.0, 0.0), (0.118, 0.0), (0.121, 0.004), (0.118, 0.009), (0.075, 0.033),
               (0.045, 0.055), (0.036, 0.07), (0.0, 0.07)]  # fmt: skip
    square = shapes.lathe(profile, 4).placed((0, 0, CEILING), shapes.rotation((0, 0, 1), 45.0))
    cap = [(0.0, 0.0), (0.022, 0.0), (0.022, 0.022), (0.034, 0.024), (0.034, 0.028), (0.012, 0.042),
           (0.007, 0.05), (0.0, 0.05)]  # fmt: skip
    chimney = shapes.lathe(cap, 40).placed((0, 0, CEILING + 0.069))
    angle = np.linspace(0.0, 2.0 * np.pi, 49)
    path = np.stack([0.03 * np.sin(angle), 0.0 * angle, 0.03 * np.cos(angle)], axis=1)
    ring = shapes.tube(path, 0.0032, 12, caps=False).placed((0, 0, CEILING + 0.147))
    return [square, chimney, ring]


def frame():
    """Posts, rails above and below the panes, bars across them, the foot."""
    height = CEILING - FLOOR
    parts = []
    for k in range(4):
        turn = shapes.rotation((0, 0, 1), 90.0 * k)
        middle = 0.5 * (FLOOR + CEILING)
        post = shapes.box((POST, POST, height + 0.01), 0.001).placed((HALF, HALF, middle))
        parts.append(post.placed(turn=turn))
        for z, size in ((FLOOR, POST), (CEILING - 0.002, POST), (middle + 0.03, 0.005)):
            bar = shapes.box((2 * HALF, size, size), 0.0008).placed((0, -HALF, z))
            parts.append(bar.placed(turn=turn))
        foot = shapes.ball((0.012, 0.012, 0.011), 20).placed((0.068, 0.068, 0.008))
        parts.append(foot.placed(turn=turn))
    parts.append(shapes.box((0.175, 0.175, 0.014), 0.003).placed((0, 0, 0.019)))
    return parts


def candle():
    """Wax with a hollow around its wick, and a drip down its side; wick; dish."""
    wax = [(0.0, 0.0), (0.027, 0.0), (0.0275, 0.004), (0.0272, 0.088), (0.0268, 0.093),
           (0.0255, 0.0955), (0.023, 0.095), (0.018, 0.0915), (0.01, 0.0895),
           (0.0, 0.089)]  # fmt: skip
    body = shapes.lathe(wax, 48)
    x, y, z = body.points.T
    angle, high = np.arctan2(y, x), np.clip(z / 0.09, 0.0, 1.0)
    lean = 1.0 + 0.05 * high**3 * np.sin(2.0 * angle + 0.5)
    points = np.stack([x * lean, y * lean, z + 0.004 * high**4 * np.sin(angle - 0.6)], axis=1)
    body = shapes.Shape(points, body.faces, body.uvs)
    t = np.linspace(0.0, 1.0, 7)
    drips = [
        shapes.tube(
            np.c_[0.0265 * np.cos(a) + 0 * t, 0.0265 * np.sin(a) + 0 * t, 0.093 - length * t],
            np.array([0.002, 0.003, 0.003, 0.0028, 0.003, 0.004, 0.003]),
            12,
        )
        for a, length in ((-1.2, 0.035), (-0.5, 0.05), (1.9, 0.028), (3.6, 0.042))
    ]
    wick = np.array([[0.0, 0.0, 0.086], [0.0002, 0.0, 0.096], [0.001, 0.0005, 0.101],
                     [0.003, 0.001, 0.105]])  # fmt: skip
    dish = [
        (0.0, 0.0),
        (0.036, 0.0),
        (0.044, 0.007),
        (0.0455, 0.0065),
        (0.037, -0.002),
        (0.0, -0.002),
    ]
    dish = [(r, z + 0.003) for r, z in dish][::-1]
    return shapes.joined([body, *drips]), shapes.tube(wick, 0.0011, 8), shapes.lathe(dish, 48)


def flame():
    t = np.linspace(0.0, 1.0, 13)
    radius = 0.0075 * np.sin(np.pi * t**0.6) * (1.0 - 0.35 * t)
    radius[[0, -1]] = 0.0
    return shapes.lathe(np.stack([radius, 0.036 * t], axis=1), 20)


def build(lit):
    iron = shading.principled("iron", (0.028, 0.028, 0.03), Metallic=0.6, Roughness=0.38)
    brass = shading.principled("brass", (0.75, 0.5, 0.2), Metallic=1.0, Roughness=0.25)
    shapes.add(shapes.joined([*frame(), *roof()]), "frame", iron, smooth_deg=35.0)
    add_panes()
    wax = shading.principled(
        "wax",
        (0.9, 0.82, 0.66),
        Roughness=0.45,
        Subsurface_Weight=1.0,
        Subsurface_Radius=(1.0, 0.55, 0.25),
        Subsurface_Scale=0.008,
    )
    black = shading.principled("wick", (0.02, 0.018, 0.015), Roughness=0.9)
    body, wick, dish = candle()
    shapes.add(dish.placed((0, 0, 0.026)), "dish", brass)
    shapes.add(body.placed((0, 0, 0.029)), "candle", wax)
    shapes.add(wick.placed((0, 0, 0.029)), "wick", black)
    if lit:
        burning = shading.principled(
            "flame", (0.0, 0.0, 0.0), Emission_Color=(1.0, 0.6, 0.2, 1.0), Emission_Strength=FLAME
        )
        shapes.add(flame().placed((0.002, 0.0007, 0.126)), "flame", burning)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--lit", action="store_true", help="light the candle (emission)")
build(parser.parse_args().lit)
