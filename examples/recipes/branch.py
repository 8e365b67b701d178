"""Builds a leafy branch: twigs of bark, and leaves that are cards with a picture of a leaf.

    rna-capture examples/recipes/branch.py --out branch.rays/ -- --leaves 500

A leaf's outline is the alpha of its picture, cut at 0.5; light passes through it, diffusely. Runs
inside Blender.
"""

import argparse
from dataclasses import dataclass

import numpy as np
import shading
import shapes

TILE = 512  # pixels a side of one leaf's picture; four make the image
LEAF_GREEN = np.array(
    [[0.13, 0.3, 0.035], [0.2, 0.36, 0.05], [0.08, 0.22, 0.03], [0.3, 0.33, 0.04]]
)
GOLDEN = 137.508  # degrees between one leaf and the next around a twig


def leaf_picture(colour, rng):
    """(TILE, TILE, 4): an oak's leaf, stalk below; linear colour, and alpha."""
    y, x = np.mgrid[0:TILE, 0:TILE] / (TILE - 1.0)
    x = x - 0.5 - 0.02 * np.sin(5.0 * y)
    side = abs(x)
    along = np.clip((y - 0.14) / 0.83, 0.0, 1.0)
    vein = (along - 0.75 * side) * 5.5 + rng.uniform(-0.15, 0.15)  # side veins point forwards
    lobes = 0.5 + 0.5 * np.cos(2.0 * np.pi * vein)
    width = 0.43 * np.sin(np.pi * along**1.25) ** 0.75
    wave = 0.006 * np.sin(71.0 * y + 40.0 * x)
    inside = np.minimum(width * (0.56 + 0.44 * lobes**0.7), width) - side + wave
    stalk = np.where((y < 0.2) & (y > 0.01), 0.011 - side, -1.0)
    alpha = np.clip(0.5 + 60.0 * np.maximum(inside, stalk), 0.0, 1.0)

    midrib = np.exp(-((side / (0.014 - 0.009 * along)) ** 2))
    ribs = np.exp(-((((vein + 0.5) % 1.0 - 0.5) / 0.05) ** 2)) * (side < 0.9 * width)
    fine = shading.smooth_noise((TILE, TILE), (64, 64), rng)
    blotch = shading.smooth_noise((TILE, TILE), (7, 7), rng)
    lightness = (0.7 + 0.3 * fine + 0.35 * (blotch - 0.5))[..., None]
    rgb = colour * lightness
    old = np.clip(3.0 * (blotch - 0.72), 0.0, 0.8)[..., None]
    rgb = rgb * (1.0 - old) + np.array([0.34, 0.2, 0.05]) * lightness * old
    pale = np.clip(0.75 * midrib + 0.4 * ribs, 0.0, 1.0)[..., None]
    rgb = rgb * (1.0 - pale) + (0.35 * colour + [0.3, 0.33, 0.13]) * pale
    return np.concatenate([rgb, alpha[..., None]], axis=-1)


def leaves_image(rng):
    """Four leaves in one image, 2 x 2."""
    a, b, c, d = (leaf_picture(colour, rng) for colour in LEAF_GREEN)
    pixels = np.concatenate([np.concatenate([a, b], axis=1), np.concatenate([c, d], axis=1)])
    pixels[..., :3] = shading.encoded(pixels[..., :3])
    return shading.image("leaves", pixels)


def leaf_material(rng):
    """Shine and diffuse light from the front, light that comes through, and holes."""
    picture = leaves_image(rng)
    material = shading.principled("leaf", picture, Roughness=0.42, IOR=1.4)
    tree = material.node_tree
    texture = next(node for node in tree.nodes if node.type == "TEX_IMAGE")
    shine = tree.nodes["Principled BSDF"].outputs[0]
    through = shading.add_shader(material, "Translucent", texture.outputs["Color"])
    leaf = shading.mix(material, 0.45, shine, through)
    cut = tree.nodes.new("ShaderNodeMath")
    cut.operation = "GREATER_THAN"
    cut.inputs[1].default_value = 0.5
    tree.links.new(texture.outputs["Alpha"], cut.inputs[0])
    hole = shading.add_shader(material, "Transparent", (1.0, 1.0, 1.0))
    return shading.finish(material, shading.mix(material, cut.outputs[0], hole, leaf))


def bark_material(rng):
    rough = shading.smooth_noise((512, 128), (64, 16), rng)
    patches = shading.smooth_noise((512, 128), (12, 4), rng)
    value = (0.5 + 0.6 * rough) * (0.7 + 0.5 * patches)
    pixels = shading.encoded(value[..., None] * np.array([0.17, 0.105, 0.06]))
    return shading.principled("bark", shading.image("bark", pixels), Roughness=0.8)


@dataclass(frozen=True)
class Twig:
    """A path (n, 3) and its radius at each point (n,)."""

    path: np.ndarray
    radius: np.ndarray

    @classmethod
    def grown(cls, start, towards, length, radius, rng, points=14):
        """A crooked twig from `start` that rises slightly."""
        heading = np.asarray(towards, float) / np.linalg.norm(towards)
        path = [np.asarray(start, float)]
        for _ in range(points - 1):
            heading = heading + rng.normal(0.0, 0.09, 3) + [0.0, 0.0, 0.03]
            heading /= np.linalg.norm(heading)
            path.append(path[-1] + heading * length / (points - 1))
        return cls(np.array(path), radius * np.linspace(1.0, 0.3, points))

    def at(self, t):
        """Place, direction and radius at the part t of the way."""
        k = min(int(t * (len(self.path) - 1)), len(self.path) - 2)
        part = t * (len(self.path) - 1) - k
        step = self.path[k + 1] - self.path[k]
        radius = self.radius[k] + part * (self.radius[k + 1] - self.radius[k])
        return self.path[k] + part * step, step / np.linalg.norm(step), radius

    def children(self, number, first, spread_deg, length, rng):
        """Twigs to both sides, the lower ones longer."""
        made = []
        for k, t in enumerate(np.linspace(first, 0.92, number)):
            place, heading, radius = self.at(t)
            across = np.cross(heading, [0.0, 0.0, 1.0]) * (1.0 if k % 2 else -1.0)
            across = across / np.linalg.norm(across) + rng.normal(0.0, 0.3, 3) * [1, 1, 1.3]
            spread = np.radians(spread_deg + rng.normal(0.0, 6.0))
            towards = np.cos(spread) * heading + np.sin(spread) * across
            size = length * (1.0 - 0.55 * t) * rng.uniform(0.85, 1.15)
            made.append(Twig.grown(place, towards, size, 0.62 * radius, rng))
        return made


def twigs(rng):
    """The stem, its twigs, and theirs, which bear the leaves."""
    stem = Twig.grown((-0.42, 0.0, 0.0), (1.0, 0.12, 0.12), 0.8, 0.0085, rng, points=26)
    sides = stem.children(11, 0.18, 48.0, 0.36, rng)
    ends = [end for side in sides for end in side.children(5, 0.25, 44.0, 0.13, rng)]
    return [stem], sides, ends


def leaf_card(place, heading, normal, size, tile, rng):
    """A card of 4 x 2 quads: folded along its rib, bent down towards its tip."""
    heading = heading / np.linalg.norm(heading)
    across = np.cross(heading, normal)
    across /= np.linalg.norm(across)
    up = np.cross(across, heading)
    v, u = np.meshgrid(np.linspace(0.0, 1.0, 5), [-0.5, 0.0, 0.5], indexing="ij")
    fold, bend = rng.uniform(0.1, 0.35), rng.uniform(0.05, 0.35)
    height = size * (fold * abs(u) - bend * v**2)
    points = (
        np.asarray(place)
        + size * (v[..., None] * heading + u[..., None] * across)
        + height[..., None] * up
    )
    card = shapes.grid(points)
    corner = np.array([tile % 2, tile // 2])
    inset = (0.5 * np.array(face) + 0.5 * corner for face in card.uvs)
    return shapes.Shape(card.points, card.faces, [face.tolist() for face in inset])


def leaves(bearers, count, rng):
    """Cards around the twigs, their faces upwards, evenly many for their length."""
    lengths = np.array([np.linalg.norm(np.diff(t.path, axis=0), axis=1).sum() for t in bearers])
    share = np.searchsorted(np.cumsum(lengths) / lengths.sum(), (np.arange(count) + 0.5) / count)
    cards = []
    for k, twig in enumerate(bearers):
        number = int((share == k).sum())
        for j in range(number):
            t = 1.0 if j == number - 1 else 0.12 + 0.86 * (j + rng.uniform(0.0, 0.5)) / number
            place, heading, _ = twig.at(min(t, 1.0))
            turned = shapes.rotation(heading, GOLDEN * j + rng.normal(0.0, 12.0))
            aside = turned @ np.cross(heading, [0.0, 0.0, 1.0])
            direction = heading * (0.7 + t) + aside * [1.0, 1.0, 0.45] + rng.normal(0.0, 0.15, 3)
            normal = np.array([0.0, 0.0, 1.0]) + rng.normal(0.0, 0.3, 3) + 0.35 * aside
            size = rng.uniform(0.055, 0.085)
            cards.append(leaf_card(place, direction, normal, size, rng.integers(4), rng))
    return cards


def build(count):
    rng = np.random.default_rng(5)
    stem, sides, ends = twigs(rng)
    wood = [
        shapes.tube(twig.path, twig.radius, around)
        for level, around in ((stem, 12), (sides, 8), (ends, 6))
        for twig in level
    ]
    shapes.add(shapes.joined(wood), "twigs", bark_material(rng))
    cards = leaves([*sides, *ends], count, rng)
    shapes.add(shapes.joined(cards), "leaves", leaf_material(rng), smooth_deg=180.0)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--leaves", type=int, default=500, help="cards")
build(parser.parse_args().leaves)
