"""Builds a table lamp: a shade of painted paper that glows, on a stand of polished brass.

    rna-capture examples/recipes/lamp.py --out lamp.rays/

The bulb and the shade emit light, which the stand reflects. Runs inside Blender.
"""

import argparse

import numpy as np
import shading
import shapes

BULB, SHADE = 30.0, 9.0  # radiance, W/(m^2 sr), of the brightest channel
BASE, TOP = 0.215, 0.44  # heights of the shade's rims
WIDE, NARROW = 0.155, 0.1  # and their radii
WALL = 0.0015  # of the shade
WARM = np.array([1.0, 0.72, 0.42])

# Turned from the foot upwards: radius and height, metres.
STAND = [
    (0.0, 0.0), (0.085, 0.0), (0.088, 0.003), (0.088, 0.009), (0.084, 0.014), (0.06, 0.02),
    (0.034, 0.027), (0.02, 0.038), (0.013, 0.052), (0.0115, 0.066), (0.018, 0.074),
    (0.021, 0.08), (0.018, 0.086), (0.012, 0.092), (0.014, 0.11), (0.0235, 0.135),
    (0.0275, 0.155), (0.0255, 0.175), (0.018, 0.193), (0.0105, 0.206), (0.009, 0.215),
    (0.009, 0.235), (0.0155, 0.239), (0.0155, 0.262), (0.013, 0.266), (0.0, 0.266),
]  # fmt: skip


def rounded(profile, steps=4):
    """A profile (n, 2) by `steps` points between two, on a Catmull-Rom spline."""
    p = np.asarray(profile)
    before, after = np.vstack([p[:1], p[:-2]]), np.vstack([p[2:], p[-1:]])
    t = np.linspace(0.0, 1.0, steps, endpoint=False)[None, :, None]
    a, b, slope_a, slope_b = (x[:, None] for x in (p[:-1], p[1:], p[1:] - before, after - p[:-1]))
    cubic = (
        (1 + 2 * t) * (1 - t) ** 2 * a
        + t**2 * (3 - 2 * t) * b
        + 0.5 * t * (1 - t) ** 2 * slope_a
        - 0.5 * t**2 * (1 - t) * slope_b
    )
    points = np.vstack([cubic.reshape(-1, 2), p[-1:]])
    points[:, 0] = np.maximum(points[:, 0], 0.0)
    return points


def painted_paper(width=1024, height=512):
    """Light that passes the paper: fibres, ribs, painted hills; (h, w) in [0, 1]."""
    rng = np.random.default_rng(11)
    fibres = 0.85 + 0.15 * shading.smooth_noise((height, width), (64, 512), rng)
    clouds = 0.85 + 0.15 * shading.smooth_noise((height, width), (8, 16), rng)
    v, u = np.mgrid[0:height, 0:width] / np.array([height, width]).reshape(2, 1, 1)
    paint = np.ones((height, width))
    for row, (level, size, waves) in enumerate(((0.42, 0.1, 3), (0.3, 0.09, 5), (0.17, 0.07, 8))):
        turn = 2.0 * np.pi * (u + 0.31 * row)
        ridge = level + size * (0.6 * np.sin(waves * turn) + 0.4 * np.sin((waves + 2) * turn + 1.0))
        below = np.clip((ridge - v) * 60.0, 0.0, 1.0)
        mist = np.clip(1.0 - (ridge - v) / 0.22, 0.0, 1.0)
        paint *= 1.0 - below * (0.28 + 0.3 * mist)
    ribs = 1.0 - 0.35 * np.exp(-((((u * 12.0 + 0.5) % 1.0) - 0.5) ** 2) / 0.0004)
    near_bulb = 0.45 + 0.55 * np.exp(-(((v - 0.38) / 0.42) ** 2))
    return fibres * clouds * paint * ribs * near_bulb


def paper(strength):
    """White paper whose emission has the colours of a lit painting."""
    light = painted_paper()[..., None] ** np.array([1.0, 1.15, 1.4])  # thick paint is redder
    glow = shading.image("lit paper", shading.encoded(light * WARM))
    material = shading.principled("paper", (0.8, 0.74, 0.64), Roughness=0.8)
    shader = material.node_tree.nodes["Principled BSDF"]
    texture = shading.add_image(material, glow)
    material.node_tree.links.new(texture.outputs["Color"], shader.inputs["Emission Color"])
    shader.inputs["Emission Strength"].default_value = strength
    return material


def wall():
    """Radius and height of the shade's surface: up outside, down inside; v runs along it."""
    t = np.linspace(0.0, 1.0, 17)
    side = np.stack([WIDE + (NARROW - WIDE) * t - 0.012 * np.sin(np.pi * t), 0 * t], axis=1)
    side[:, 1] = BASE + (TOP - BASE) * t
    return side, (side - [WALL, 0.0])[::-1]


def add_shade(strength, brass):
    glowing = paper(strength)
    outside, inside = wall()
    shapes.add(shapes.lathe(outside, 96), "shade outside", glowing)
    shape = shapes.lathe(inside, 96)  # its picture is the same, seen through
    through = [[(u, 1.0 - v) for u, v in face] for face in shape.uvs]
    shapes.add(shapes.Shape(shape.points, shape.faces, through), "shade inside", glowing)
    angle = np.linspace(0.0, 2.0 * np.pi, 97)
    for radius, height in ((WIDE, BASE), (NARROW, TOP)):
        ring = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)
        path = np.c_[ring - [[0.5 * WALL, 0.0]], np.full(97, height)]
        shapes.add(shapes.tube(path, 0.0022, 8, caps=False), "rim", brass)
    holder, spokes = 0.0155, []
    for turn in (0.0, 120.0, 240.0):
        along = np.linspace([holder - 0.002, 0.0, 0.25], [WIDE - 0.002, 0.0, BASE], 5)
        spokes.append(shapes.tube(along, 0.0016, 8).placed(turn=shapes.rotation((0, 0, 1), turn)))
    shapes.add(shapes.joined(spokes), "spokes", brass)


def add_chain(brass):
    """A switch: beads on a string below the holder, and a drop at their end."""
    heights = 0.25 - 0.0052 * np.arange(18)
    beads = [shapes.ball((0.0021,) * 3, 10).placed((0.045, -0.03, h)) for h in heights]
    drop = rounded([(0.0, 0.0), (0.005, 0.004), (0.0045, 0.011), (0.0, 0.02)], 5)
    end = shapes.lathe(drop, 16).placed((0.045, -0.03, heights[-1] - 0.021))
    arm = shapes.tube(np.linspace([0.008, -0.006, 0.25], [0.046, -0.03, 0.252], 4), 0.0014, 8)
    shapes.add(shapes.joined([*beads, end, arm]), "chain", brass)


def build(strength):
    brass = shading.principled(
        "brass", (0.78, 0.52, 0.2), Metallic=1.0, Roughness=0.18, Coat_Weight=0.15
    )
    shapes.add(shapes.lathe(rounded(STAND), 64), "stand", brass)
    glass = shading.principled(
        "bulb",
        (0.9, 0.9, 0.9),
        Roughness=0.4,
        Emission_Color=(*WARM, 1.0),
        Emission_Strength=strength * BULB,
    )
    bulb = rounded([(0.0, 0.262), (0.012, 0.266), (0.014, 0.28), (0.027, 0.305), (0.03, 0.325),
                    (0.022, 0.346), (0.0, 0.354)], 5)  # fmt: skip
    shapes.add(shapes.lathe(bulb, 32), "bulb", glass)
    add_shade(strength * SHADE, brass)
    add_chain(brass)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--strength", type=float, default=1.0, help="scale factor of the emission")
build(parser.parse_args().strength)
