"""Builds a toy lion: a body of plastic, a mane and a tuft on its tail of hair.

    rna-capture examples/recipes/furry_toy.py --out furry_toy.rays/ -- --strands 9000

Runs inside Blender, where `rna_hair` is at hand.
"""

import argparse

import numpy as np
import rna_hair
import shading
import shapes
from rna_hair.objects import add_curves, chiang_material

HEAD = np.array([0.0, -0.045, 0.235])  # its middle; the face looks along -y
SKULL = np.array([0.078, 0.07, 0.072])  # half its width, depth, height
TAIL = np.array([[0.0, 0.085, 0.06], [0.0, 0.125, 0.055], [0.01, 0.155, 0.075],
                 [0.02, 0.165, 0.115], [0.02, 0.155, 0.155], [0.012, 0.142, 0.178]])  # fmt: skip
RADIUS = 0.00042  # of a strand
POINTS = 14


def plastic(name, colour, roughness=0.35):
    """Soft plastic that light goes into."""
    return shading.principled(
        name,
        colour,
        Roughness=roughness,
        Subsurface_Weight=1.0,
        Subsurface_Radius=tuple(0.3 + 0.7 * c for c in colour),
        Subsurface_Scale=0.01,
    )


def body():
    """Seen from the side a pear; legs, feet, tail, ears and head of the same plastic."""
    ellipsoids = [
        ((0.0, 0.015, 0.105), (0.066, 0.07, 0.085)),
        (HEAD, SKULL),
        ((0.052, -0.05, 0.05), (0.024, 0.026, 0.055)),
        ((-0.052, -0.05, 0.05), (0.024, 0.026, 0.055)),
        ((0.058, -0.066, 0.016), (0.027, 0.036, 0.018)),
        ((-0.058, -0.066, 0.016), (0.027, 0.036, 0.018)),
        ((0.06, 0.03, 0.04), (0.04, 0.05, 0.044)),
        ((-0.06, 0.03, 0.04), (0.04, 0.05, 0.044)),
        ((0.075, -0.01, 0.016), (0.026, 0.038, 0.017)),
        ((-0.075, -0.01, 0.016), (0.026, 0.038, 0.017)),
    ]
    parts = [shapes.ball(radii, 40).placed(place) for place, radii in ellipsoids]
    ears = [shapes.ball((0.024, 0.012, 0.024), 28).placed((x, -0.06, 0.3)) for x in (-0.058, 0.058)]
    return shapes.joined([*parts, *ears, shapes.tube(along(TAIL, 24), 0.0085, 14)])


def along(path, n):
    """n points on a smooth curve through a path."""
    strand = rna_hair.of_equal_length(np.asarray(path)[None], 1.0)
    return rna_hair.resample(strand, n).points.astype(float)


def add_face():
    cream = plastic("cream", (0.85, 0.68, 0.45))
    cheeks = [((0.021, -0.108, 0.218), (0.028, 0.024, 0.022)),
              ((-0.021, -0.108, 0.218), (0.028, 0.024, 0.022)),
              ((0.0, -0.1, 0.198), (0.02, 0.02, 0.015))]  # fmt: skip
    inner = [((x, -0.0715, 0.3), (0.015, 0.004, 0.015)) for x in (-0.058, 0.058)]
    belly = [((0.0, -0.012, 0.095), (0.047, 0.05, 0.062))]
    pale = [shapes.ball(radii, 32).placed(at) for at, radii in (*cheeks, *inner, *belly)]
    shapes.add(shapes.joined(pale), "cream parts", cream)
    black = shading.principled("eyes", (0.012, 0.01, 0.01), Roughness=0.06, Coat_Weight=0.5)
    eyes = [
        shapes.ball((0.0115, 0.008, 0.014), 28).placed((x, -0.108, 0.253)) for x in (-0.03, 0.03)
    ]
    shapes.add(shapes.joined(eyes), "eyes", black)
    brown = shading.principled("nose", (0.16, 0.05, 0.03), Roughness=0.22)
    shapes.add(shapes.ball((0.0145, 0.01, 0.0095), 28).placed((0.0, -0.131, 0.234)), "nose", brown)


def mane_guides(rng, count=700):
    """Guides from a band around the head, outwards and back, drooping; none over the face."""
    turn = rng.uniform(0.0, 2.0 * np.pi, count)
    back = rng.uniform(-0.42, 0.62, count)  # along y, of the skull's depth
    ring = np.sqrt(1.0 - back**2)
    unit = np.stack([ring * np.cos(turn), back, ring * np.sin(turn)], axis=1)
    roots = HEAD + 0.985 * SKULL * unit
    normal = unit / SKULL
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    lean = 0.55 + 0.5 * (back + 0.42)
    start = normal + lean[:, None] * [0.0, 0.5, 0.0] + rng.normal(0.0, 0.1, (count, 3))
    length = rng.uniform(0.055, 0.082, count) * (1.0 - 0.25 * np.maximum(unit[:, 2], 0.0))
    return drooping(roots, start, length, droop=0.75)


def tuft_guides(rng, count=160):
    """Around the tail's end, along it and apart."""
    path = along(TAIL, 24)
    heading = path[-1] - path[-3]
    heading /= np.linalg.norm(heading)
    spread = rng.normal(0.0, 1.0, (count, 3))
    spread -= (spread @ heading)[:, None] * heading
    spread /= np.linalg.norm(spread, axis=1, keepdims=True)
    back = rng.uniform(0.0, 0.016, count)
    roots = path[-1] - back[:, None] * heading + 0.0075 * spread
    start = heading + rng.uniform(0.25, 1.0, (count, 1)) * spread
    return drooping(roots, start, rng.uniform(0.035, 0.055, count), droop=0.35)


def drooping(roots, start, length, droop):
    """Paths (s, POINTS, 3) that set out along `start` and bend down by `droop` on their way."""
    heading = start / np.linalg.norm(start, axis=1, keepdims=True)
    points = [roots]
    for _ in range(POINTS - 1):
        heading = heading + np.array([0.0, 0.0, -droop / (POINTS - 1)])
        heading /= np.linalg.norm(heading, axis=1, keepdims=True)
        points.append(points[-1] + heading * (length / (POINTS - 1))[:, None])
    return np.stack(points, axis=1)


def turned_up(points):
    """Blender's axes to those of `rna_hair`, +Y up."""
    return points[..., [0, 2, 1]] * [1.0, 1.0, -1.0]


def fur(strands):
    """Mane and tuft, the tuft an eighth of all."""
    rng = np.random.default_rng(17)
    parts = []
    for seed, (paths, share) in enumerate(((mane_guides(rng), 7), (tuft_guides(rng), 1))):
        guides = rna_hair.of_equal_length(turned_up(paths), RADIUS)
        count = max(1, strands * share // 8)
        parts.append(
            rna_hair.interpolate(
                guides, count, points=POINTS, seed=seed, clump=0.55, noise=0.035, shorten=0.3
            )
        )
    return rna_hair.taper(rna_hair.join(parts), RADIUS, tip=0.25, start=0.5)


def build(strands):
    shapes.add(body(), "lion", plastic("yellow", (0.8, 0.45, 0.1)))
    add_face()
    hair = chiang_material("mane", melanin=0.45, redness=0.85, roughness=0.3, radial_roughness=0.5)
    add_curves(fur(strands), "mane", hair)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--strands", type=int, default=9000)
build(parser.parse_args().strands)
