"""Builds a bottle of green glass, solid and refractive, with a cork and a paper label.

    rna-capture examples/recipes/bottle.py --out bottle.rays/

Label and cork are captured; the glass becomes a mesh beside the package. Runs inside Blender.
"""

import bpy
import numpy as np
import shading
import shapes

RADIUS, WALL = 0.0385, 0.0028  # outside; and the glass's thickness, metres
LABEL = (0.055, 0.15)  # heights of its edges
LABEL_DEG = 150.0

# The rows of each letter, five pixels wide, as bits.
LETTERS = {
    "C": (14, 17, 16, 16, 16, 17, 14),
    "I": (14, 4, 4, 4, 4, 4, 14),
    "D": (30, 17, 17, 17, 17, 17, 30),
    "E": (31, 16, 16, 30, 16, 16, 31),
    "R": (30, 17, 17, 30, 20, 18, 17),
}

OUTSIDE = [
    (0.0, 0.008), (0.02, 0.0055), (0.029, 0.0008), (0.033, 0.0), (0.0365, 0.0016), (RADIUS, 0.006),
    (RADIUS, 0.02), (RADIUS, 0.06), (RADIUS, 0.11), (RADIUS, 0.165), (0.0378, 0.178),
    (0.0345, 0.192), (0.028, 0.205), (0.0205, 0.218), (0.0158, 0.231), (0.0145, 0.245),
    (0.014, 0.27), (0.0138, 0.283), (0.0138, 0.2845), (0.0162, 0.2855), (0.0168, 0.29),
    (0.0162, 0.2945), (0.0145, 0.3), (0.0138, 0.3015), (0.0122, 0.3015),
]  # fmt: skip
INSIDE = [
    (0.0112, 0.3), (0.0105, 0.296), (0.0105, 0.27), (0.0112, 0.245), (0.0125, 0.2315),
    (0.0175, 0.2175), (0.025, 0.2035), (0.0315, 0.1905), (0.0348, 0.1775), (0.0357, 0.165),
    (0.0357, 0.11), (0.0357, 0.06), (0.0357, 0.02), (0.035, 0.0105), (0.032, 0.0075),
    (0.028, 0.0085), (0.019, 0.0125), (0.0, 0.0145),
]  # fmt: skip


def smoothed(profile, steps=3):
    """Points between those of a profile, by Chaikin's corner cutting; both ends stay."""
    p = np.asarray(profile, float)
    for _ in range(steps - 1):
        cut = np.stack([0.75 * p[:-1] + 0.25 * p[1:], 0.25 * p[:-1] + 0.75 * p[1:]], axis=1)
        p = np.vstack([p[:1], cut.reshape(-1, 2), p[-1:]])
    return p


def word(text, height, width, left, bottom, size):
    """A mask (h, w) with a word in square pixels of `size`."""
    mask = np.zeros((height, width), bool)
    for k, letter in enumerate(text):
        for row, bits in enumerate(LETTERS[letter]):
            for column in range(5):
                if bits >> (4 - column) & 1:
                    x, y = left + (6 * k + column) * size, bottom + (6 - row) * size
                    mask[y : y + size, x : x + size] = True
    return mask


def label_picture(height=768, width=832):
    """(h, w, 3), encoded: a frame, a sun behind hills, a word, rules."""
    rng = np.random.default_rng(2)
    fibres = shading.smooth_noise((height, width), (192, 208), rng)
    paper = np.array([0.93, 0.89, 0.78]) * (0.96 + 0.05 * fibres[..., None])
    y, x = np.mgrid[0:height, 0:width]
    ink, red, green = np.array([0.12, 0.1, 0.1]), np.array([0.72, 0.2, 0.12]), [0.2, 0.36, 0.2]
    edge = np.minimum(np.minimum(x, width - 1 - x), np.minimum(y, height - 1 - y))
    layers = [((edge > 24) & (edge < 34), red), ((edge > 42) & (edge < 46), ink)]

    centre = width / 2, 0.52 * height
    radius = np.hypot(x - centre[0], y - centre[1])
    angle = np.arctan2(y - centre[1], x - centre[0])
    rays = (np.cos(24.0 * angle) > 0.2) & (radius > 118) & (radius < 210) & (y > centre[1])
    layers += [(rays, np.array([0.85, 0.6, 0.2])), ((radius < 105) & (y > centre[1] - 40), red)]
    for level, waves, colour in ((30, 1.7, np.array(green)), (0, 2.6, 0.7 * np.array(green))):
        ridge = centre[1] + level + 28 * np.sin(waves * 2 * np.pi * x / width + waves)
        layers.append(((y < ridge) & (y > centre[1] - 70) & (edge > 80), colour))
    size = 14
    left = (width - (6 * 5 - 1) * size) // 2
    layers.append((word("CIDER", height, width, left, 150, size), ink))
    for row, length in ((110, 0.5), (92, 0.36), (690, 0.3)):
        layers.append(((abs(y - row) < 4) & (abs(x - width / 2) < length * width / 2), ink))
    for mask, colour in layers:
        paper[mask] = colour * (0.9 + 0.1 * fibres[mask][:, None])
    return paper


def add_label():
    """A sheet just off the glass."""
    low, high = LABEL
    half = np.radians(0.5 * LABEL_DEG)
    v, turn = np.meshgrid(np.linspace(0.0, 1.0, 9), np.linspace(-half, half, 41), indexing="ij")
    radius = RADIUS + 0.0003
    points = [radius * np.sin(turn), -radius * np.cos(turn), low + (high - low) * v]
    paper = shading.principled("label", shading.image("label", label_picture()), Roughness=0.6)
    shapes.add(shapes.grid(np.stack(points, axis=-1)), "label", paper)


def add_cork():
    rng = np.random.default_rng(3)
    grain = shading.smooth_noise((256, 256), (40, 60), rng)
    pores = shading.smooth_noise((256, 256), (24, 36), rng) > 0.86
    colour = (0.75 + 0.35 * grain - 0.45 * pores)[..., None] * np.array([0.52, 0.33, 0.18])
    cork = shading.principled(
        "cork", shading.image("cork", shading.encoded(colour)), Roughness=0.85
    )
    profile = [(0.0, 0.274), (0.0096, 0.274), (0.0102, 0.275), (0.0103, 0.296), (0.0112, 0.303),
               (0.0118, 0.313), (0.0113, 0.3145), (0.0, 0.315)]  # fmt: skip
    shapes.add(shapes.lathe(profile, 40), "cork", cork)


def build():
    green = shading.principled(
        "glass", (0.5, 0.78, 0.45), Roughness=0.0, IOR=1.5, Transmission_Weight=1.0
    )
    profile = smoothed([*OUTSIDE, *INSIDE])
    shapes.add(shapes.lathe(profile, 72), "bottle", green, smooth_deg=180.0)
    add_label()
    add_cork()
    bpy.context.scene.cycles.blur_glossy = 0.0  # light through the glass as sharp as it is


build()
