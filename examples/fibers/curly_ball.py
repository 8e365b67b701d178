"""Builds a ball of curly red-brown hair: the example asset of kind fiber.

    rna-capture examples/fibers/curly_ball.py --out curly_ball.rays/

The script runs inside Blender, where `rna_hair` is at hand; `-- --strands N` makes more or less of
it. 9,000 strands of 18 points are 2.7 MB as float32.
"""

import argparse

import numpy as np
import rna_hair
from rna_hair.objects import add_curves, chiang_material

CORE, BALL = 0.17, 0.35  # metres: where strands have their roots, and where the ball ends
RADIUS = 0.0011  # of a strand
LOCKS = 900  # curls that strands gather in
POINTS = 18


def sphere(n):
    """n directions, evenly spread (a Fibonacci lattice), (n, 3)."""
    k = np.arange(n) + 0.5
    z = 1.0 - 2.0 * k / n
    turn = np.pi * (1.0 + 5.0**0.5) * k
    ring = np.sqrt(1.0 - z**2)
    return np.stack([ring * np.cos(turn), z, ring * np.sin(turn)], axis=-1)


def frames(normals):
    """Two unit vectors across each normal, (n, 3) each."""
    helper = np.where(np.abs(normals[:, 1:2]) < 0.9, [[0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0]])
    first = np.cross(normals, helper)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    return first, np.cross(normals, first)


def locks(rng):
    """A helix outwards from each root, tilted and wound at random, (LOCKS, POINTS, 3)."""
    outwards = sphere(LOCKS)
    across = frames(outwards)
    lean = rng.normal(0.0, 0.35, (LOCKS, 1, 2))
    turns = rng.uniform(1.3, 1.9, (LOCKS, 1)) * rng.choice([-1.0, 1.0], (LOCKS, 1))
    phase = rng.uniform(0.0, 2.0 * np.pi, (LOCKS, 1))
    width = rng.uniform(0.016, 0.026, (LOCKS, 1))
    height = (BALL - CORE) * rng.uniform(0.8, 0.98, (LOCKS, 1))

    t = np.linspace(0.0, 1.0, POINTS)
    angle = phase + 2.0 * np.pi * turns * t
    widening = width * np.minimum(2.5 * t, 1.0)
    aside = [widening * np.cos(angle), widening * np.sin(angle)]
    points = (CORE + height * t)[..., None] * outwards[:, None]
    for axis, offset, slope in zip(across, aside, np.moveaxis(lean, 2, 0), strict=True):
        points += (offset + slope * height * t**1.5)[..., None] * axis[:, None]
    # A lock that leans is drawn back into the ball.
    distance = np.linalg.norm(points, axis=-1, keepdims=True)
    return points * np.minimum(1.0, (BALL - 0.01) / distance)


def build(strands):
    rng = np.random.default_rng(7)
    guides = rna_hair.of_equal_length(locks(rng), RADIUS)
    hair = rna_hair.interpolate(
        guides, strands, points=POINTS, seed=7, clump=0.45, noise=0.012, shorten=0.2
    )
    material = chiang_material(
        "curls", melanin=0.35, redness=0.9, roughness=0.25, radial_roughness=0.4
    )
    add_curves(rna_hair.taper(hair, RADIUS, tip=0.35, start=0.6), "curly ball", material)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--strands", type=int, default=9000)
build(parser.parse_args().strands)
