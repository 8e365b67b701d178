"""Builds a bob of hair cards on a mannequin's head: strips with a picture of strands, part clear.

    rna-capture examples/recipes/hair_card.py --out hair_card.rays/

Alpha is fractional, glTF's BLEND: rays pass through a strip by what its picture says. Runs inside
Blender.
"""

import numpy as np
import shading
import shapes

SKULL = np.array([0.075, 0.095, 0.105])  # half of its width, depth, height
HEAD = np.array([0.0, 0.0, 0.24])  # its middle; the face looks along -y
CARDS, ROWS = 260, 9
HEIGHT, WIDTH, STRANDS = 512, 256, 70  # of the picture


def strands_picture(rng):
    """(HEIGHT, WIDTH, 4): strands side by side, root below; the rest is clear; encoded."""
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH] / np.array([HEIGHT, WIDTH]).reshape(2, 1, 1)
    shade, clear = np.full((HEIGHT, WIDTH), 0.3), np.ones((HEIGHT, WIDTH))
    for _ in range(STRANDS):
        middle = rng.uniform(0.06, 0.94) + 0.04 * np.sin(rng.uniform(1, 4) * y + rng.uniform(0, 6))
        middle = 0.5 + (middle - 0.5) * (1.0 - rng.uniform(0.0, 0.5) * y**2)
        tip = rng.uniform(0.7, 1.0)
        width = rng.uniform(0.007, 0.014) * np.clip((tip - y) / 0.25, 0.0, 1.0) ** 0.5
        cover = rng.uniform(0.6, 1.0) * np.exp(-(((x - middle) / np.maximum(width, 1e-4)) ** 2))
        shade = shade * (1.0 - cover) + cover * rng.uniform(0.25, 1.0)
        clear = clear * (1.0 - cover)
    rgb = shading.encoded(shade[..., None] * np.array([0.32, 0.15, 0.06]))
    return np.concatenate([rgb, (1.0 - clear)[..., None]], axis=-1)


def hair_material(rng):
    picture = shading.image("strands", strands_picture(rng))
    material = shading.principled("hair", picture, Roughness=0.38, Specular_IOR_Level=0.6)
    tree = material.node_tree
    texture = next(node for node in tree.nodes if node.type == "TEX_IMAGE")
    tree.links.new(texture.outputs["Alpha"], tree.nodes["Principled BSDF"].inputs["Alpha"])
    return material


def card(turn, level, rng):
    """A strip from the crown down: (ROWS, 3, 3) points; it leaves the head where that narrows."""
    along = np.linspace(0.0, 1.0, ROWS)
    pole = 0.12 + level + along * rng.uniform(1.5, 1.75)  # angle from the crown
    bow = 1.03 + 0.1 * (1.0 - level) * along
    half = rng.uniform(0.013, 0.02) / SKULL[0]
    spread = half / np.maximum(np.sin(pole), 0.35)
    angles = turn + np.array([-1.0, 0.0, 1.0]) * spread[:, None]
    pole = np.repeat(pole[:, None], 3, axis=1)
    low = np.maximum(pole - 0.5 * np.pi, 0.0)  # below the widest place it hangs straight
    ring = np.where(low > 0.0, 1.0, np.sin(pole))
    height = np.where(low > 0.0, -1.3 * low, np.cos(pole))
    arch = np.array([0.0, 0.03, 0.0])  # across the strip
    unit = np.stack([ring * np.cos(angles), ring * np.sin(angles), height], axis=-1)
    return HEAD + SKULL * unit * (bow[:, None, None] + arch[None, :, None])


def cards(rng):
    """Layers of strips around the head, but not before the face."""
    made = []
    for k in range(CARDS):
        level = 0.55 * (1.0 - k / CARDS)  # lower ones first, the crown last
        turn = np.radians(-90.0 + 52.0 + (360.0 - 104.0) * ((k * 0.618034) % 1.0))
        made.append(shapes.grid(card(turn, level, rng)))
    return shapes.joined(made)


def mannequin():
    """Head, neck and foot, turned."""
    skull = shapes.ball(SKULL, 56).placed(HEAD)
    jaw = shapes.ball((0.055, 0.065, 0.07), 40).placed(np.add(HEAD, (0, -0.022, -0.065)))
    nose = shapes.ball((0.011, 0.018, 0.024), 24).placed(np.add(HEAD, (0, -0.094, -0.03)))
    neck = [(0.0, 0.0), (0.078, 0.0), (0.08, 0.006), (0.074, 0.012), (0.05, 0.022), (0.042, 0.05),
            (0.042, 0.12), (0.046, 0.19), (0.0, 0.19)]  # fmt: skip
    return shapes.joined([skull, jaw, nose, shapes.lathe(neck, 56)])


def build():
    rng = np.random.default_rng(29)
    clay = shading.principled("mannequin", (0.72, 0.6, 0.5), Roughness=0.5)
    shapes.add(mannequin(), "mannequin", clay)
    shapes.add(cards(rng), "cards", hair_material(rng), smooth_deg=180.0)


build()
