"""Builds a printed slab and a ball of checks, both under clear coat of roughness 0.03.

    rna-capture examples/recipes/print.py --out print.rays/

The print of 1,024 squared has letters of 20 to 120 texels, line pairs and a ramp; the ball has 64
x 64 checks. All of it is finer than the planes of a model. --words takes other words, and another
ink. Runs inside Blender.
"""

import argparse

import lettering
import numpy as np
import shading
import shapes

SIDE = 1024  # of both images, pixels
SLAB = (0.30, 0.024, 0.30)  # metres
BALL = 0.11  # radius
COAT = {"Roughness": 0.5, "Coat_Weight": 1.0, "Coat_Roughness": 0.03}

PAPER, INK, RED, BLUE = (
    np.array(c)
    for c in ((0.94, 0.93, 0.90), (0.07, 0.07, 0.08), (0.80, 0.10, 0.08), (0.1, 0.2, 0.6))
)
LINES = (  # height of a capital, height of the line's foot, words
    (120, 860, "Print 120", "Label 120"),
    (80, 740, "stays sharp 80", "in a tongue 80"),
    (56, 650, "down to letters of 56", "that others read 56"),
    (40, 584, "and the next line has 40", "and so does this one 40"),
    (28, 530, "where planes of 256 blur it, 28 texels", "with its own words and ink, 28 texels"),
    (
        20,
        486,
        "the smallest line that is to be legible: 20 texels",
        "nothing is smaller: 20 texels",
    ),
)
FOOT = "0123456789  RNA"


def sheet(other):
    """(1024, 1024, 3) encoded, row 0 is the lowest; other: with the second words and ink."""
    picture = np.tile(PAPER, (SIDE, SIDE, 1))

    def printed(mask, colour):
        picture[:] += mask[..., None] * (colour - picture)

    y, x = np.mgrid[0:SIDE, 0:SIDE]
    inks = (BLUE, RED) if other else (INK, RED)
    for k, (height, foot, *words) in enumerate(LINES):
        printed(lettering.text_mask(words[other], SIDE, 40, foot, height), inks[k % 2])
    band = (y > 330) & (y < 450)
    printed(band * 1.0, RED if other else BLUE)
    printed(lettering.text_mask(FOOT, SIDE, 60, 360, 64), PAPER)
    for k, period in enumerate((4, 6, 8, 12, 16)):  # two texels of ink, two of paper, and so on
        left = 40 + 190 * k
        inside = (x >= left) & (x < left + 170) & (y >= 200) & (y < 300)
        printed((inside & ((x - left) % period < period // 2)) * 1.0, INK)
    ramp = np.clip((x - 40) / (SIDE - 80), 0.0, 1.0)[..., None]
    inside = (x >= 40) & (x < SIDE - 40) & (y >= 40) & (y < 160)
    return np.where(inside[..., None], inks[0] + ramp * (PAPER - inks[0]), picture)


def slab(other):
    """The sheet on the side that faces -Y; the margin's paper on all others."""
    box = shapes.box(SLAB, 0.003)
    low, high = box.points.min(axis=0), box.points.max(axis=0)
    places = (box.points - low) / (high - low)
    uvs = []
    for face in box.faces:
        is_front = np.allclose(box.points[face, 1], low[1])
        uvs.append([tuple(places[k, [0, 2]]) if is_front else (0.01, 0.01) for k in face])
    paper = shading.principled("paper", shading.image("sheet", sheet(other)), **COAT)
    shape = shapes.Shape(box.points, box.faces, uvs).placed((-0.12, 0.0, 0.5 * SLAB[2]))
    shapes.add(shape, "slab", paper)


def ball():
    y, x = np.mgrid[0:SIDE, 0:SIDE] * 64 // SIDE
    checks = np.where(((x + y) % 2 == 0)[..., None], INK, PAPER)
    paint = shading.principled("checks", shading.image("checks", checks), **COAT)
    shape = shapes.ball((BALL,) * 3, 96).placed((0.17, -0.02, BALL))
    shapes.add(shape, "ball", paint, smooth_deg=180.0)


parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
parser.add_argument("--words", choices=("first", "other"), default="first", help="printed words")
slab(parser.parse_args().words == "other")
ball()
