"""A ponytail, for `motion`: it hangs at rest, and swings.

    rna-capture tail.py --out tail.rays/ -- --strands 4000

Frame 1 is the rest pose. In frame f it swings by f - 1 degrees at its tip, half of it at its tie.
Segments keep their length. Runs inside Blender, where `rna_hair` is at hand.
"""

import argparse
import math

import bpy
import numpy as np
import rna_hair
from rna_hair.axes import y_up_to_z_up
from rna_hair.objects import add_curves, chiang_material

LAST = 121  # frame
LENGTH = 0.32  # metres
RADIUS = 0.0005  # metres
POINTS = 16
GUIDES = 240


def guides(rng):
    """Paths (s, n, 3), +Y up, from a small disk: out a little, then down, wavy."""
    turn = rng.uniform(0.0, 2.0 * math.pi, GUIDES)
    out = np.sqrt(rng.random(GUIDES))
    side = np.stack([np.cos(turn), np.zeros(GUIDES), np.sin(turn)], axis=1) * out[:, None]
    t = np.linspace(0.0, 1.0, POINTS)
    width = 0.016 + 0.05 * np.sin(math.pi * t**0.7) * (1.0 - 0.45 * t)
    wave = 0.012 * t * np.sin(2.0 * math.pi * 1.5 * t)
    paths = side[:, None] * width[:, None]
    paths[..., 1] -= LENGTH * t * (1.0 - 0.12 * out[:, None])
    paths[..., 0] += wave
    return paths


def swung(points, angle_deg):
    """Points (s, n, 3), +Y up, whose segments turn about z: by half of it at the tie."""
    t = np.linspace(0.5, 1.0, points.shape[1] - 1)
    c, s = np.cos(np.radians(angle_deg) * t), np.sin(np.radians(angle_deg) * t)
    step = np.diff(points, axis=1)
    x, y, z = np.moveaxis(step, -1, 0)
    turned = np.stack([c * x - s * y, s * x + c * y, z], axis=-1)
    ahead = np.cumsum(turned, axis=1)
    return np.concatenate([points[:, :1], points[:, :1] + ahead], axis=1)


def build(strands):
    rng = np.random.default_rng(5)
    grown = rna_hair.interpolate(
        rna_hair.of_equal_length(guides(rng), RADIUS),
        strands,
        points=POINTS,
        seed=1,
        clump=0.3,
        noise=0.03,
        shorten=0.15,
    )
    grown = rna_hair.taper(grown, RADIUS, tip=0.4, start=0.6)
    hair = chiang_material("hair", melanin=0.3, redness=0.6, roughness=0.3, radial_roughness=0.4)
    item = add_curves(grown, "tail", hair)
    rest = grown.points.reshape(-1, POINTS, 3).astype(np.float64)

    def show(scene, *_):
        points = swung(rest, scene.frame_current - 1.0)
        at = y_up_to_z_up(points.reshape(-1, 3)).astype(np.float32)
        item.data.position_data.foreach_set("vector", at.reshape(-1))
        item.data.update_tag()

    bpy.app.handlers.frame_change_pre.append(show)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, LAST
    scene.frame_set(1)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--strands", type=int, default=4000)
build(parser.parse_args().strands)
