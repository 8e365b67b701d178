"""Sets up the Lee Perry-Smith head scan (CC-BY 3.0, Infinite-Realities) with a bob of brown hair.

    rna-capture examples/recipes/haired_head.py --out haired_head.rays/ -- FOLDER

FOLDER is the one for `head.py`. The hair is grown here: guides fall over the head, are cut at one
height, and strands are spread among them. Runs inside Blender, where `rna_hair` is at hand.
"""

import argparse
from pathlib import Path

import head
import numpy as np
import rna_hair
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from rna_hair.objects import add_curves, chiang_material

# Space of the scan: +Y up, metres, the face looks along -z.
MIDDLE = np.array([0.0, 0.32, -0.07])  # of the skull
PARTING = 0.024  # its x; from the forehead to the crown
CUT = 0.205  # height of the tips at the nape; the hair is longer towards the face
GUIDES, POINTS = 1800, 20
RADIUS = 0.00017  # of a strand, three to four real ones: there are 25,000, not 100,000
COLOURS = {"brown": (0.55, 0.6), "auburn": (0.45, 0.95), "blonde": (0.14, 0.5)}  # melanin, redness

# The hairline: how far forwards of MIDDLE, and the height above which there is hair.
HAIRLINE = np.array([
    (-0.13, 0.245), (-0.07, 0.25), (-0.03, 0.272), (-0.012, 0.318), (0.012, 0.322), (0.02, 0.305),
    (0.032, 0.305), (0.042, 0.345), (0.06, 0.362), (0.075, 0.378), (0.1, 0.386), (0.2, 0.4),
])  # fmt: skip


class Skin:
    """The head, asked for its nearest point."""

    def __init__(self, item):
        mesh = item.data
        mesh.calc_loop_triangles()
        self.points = np.empty((len(mesh.vertices), 3), np.float32)
        mesh.vertices.foreach_get("co", self.points.reshape(-1))
        self.triangles = np.empty((len(mesh.loop_triangles), 3), np.int32)
        mesh.loop_triangles.foreach_get("vertices", self.triangles.reshape(-1))
        self._tree = BVHTree.FromPolygons(self.points.tolist(), self.triangles.tolist())

    def normals_and_heights(self, points):
        """The normal of the skin nearest to points (n, 3), and their distance outside it."""
        normal, height = np.empty((len(points), 3)), np.empty(len(points))
        for k, point in enumerate(points):
            near, facing, _, distance = self._tree.find_nearest(Vector(point))
            apart = Vector(point) - near
            outside = apart.dot(facing) >= 0.0
            away = apart if outside else -apart
            normal[k] = away / distance if distance > 1e-6 else facing
            height[k] = distance if outside else -distance
        return normal, height

    def roots(self, count, rng):
        """Points of the scalp, spread by area, (count, 3)."""
        corners = self.points[self.triangles].astype(float)
        a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        area = np.linalg.norm(np.cross(a, b), axis=1) * on_scalp(corners.mean(axis=1))
        pick = rng.choice(len(area), 4 * count, p=area / area.sum())
        u, v = rng.random((2, 4 * count, 1))
        u, v = np.where(u + v > 1.0, 1.0 - u, u), np.where(u + v > 1.0, 1.0 - v, v)
        points = corners[pick, 0] + u * a[pick] + v * b[pick]
        return apart(points[on_scalp(points)], count)


def on_scalp(points):
    """Whether hair grows at points of the skin, not on ears."""
    forwards = MIDDLE[2] - points[:, 2]
    height = np.interp(forwards, *HAIRLINE.T)
    ear = (abs(points[:, 0]) > 0.079) & (points[:, 1] < 0.322) & (abs(forwards) < 0.045)
    return (points[:, 1] > height) & ~ear


def apart(points, count):
    """`count` of the points, each far from those before it: no clumps, no bald spots."""
    chosen = [0]
    distance = np.linalg.norm(points - points[0], axis=1)
    for _ in range(min(count, len(points)) - 1):
        chosen.append(int(distance.argmax()))
        distance = np.minimum(distance, np.linalg.norm(points - points[chosen[-1]], axis=1))
    return points[chosen]


def combed(roots, normals):
    """Initial directions of strands: away from the parting and back, down behind the crown."""
    forwards = (MIDDLE[2] - roots[:, 2]) / 0.1
    side = np.clip((roots[:, 0] - PARTING) / 0.012, -1.0, 1.0)
    front = np.clip(forwards + 0.6, 0.0, 1.0)
    comb = np.stack([side * (0.25 + front), -0.9 * (1.0 - front), 0.45 * front + 0.3], axis=1)
    comb -= np.sum(comb * normals, axis=1, keepdims=True) * normals
    comb /= np.linalg.norm(comb, axis=1, keepdims=True)
    lift = 0.55 * np.exp(-(((roots[:, 0] - PARTING) / 0.03) ** 2)) + 0.25
    return comb + lift[:, None] * normals


def fall(skin, roots, rng, step=0.009, steps=44):
    """Paths (n, steps, 3) of strands that fall over the head, in layers above one another."""
    normals, _ = skin.normals_and_heights(roots)
    heading = combed(roots, normals)
    heading /= np.linalg.norm(heading, axis=1, keepdims=True)
    top = np.clip((roots[:, 1] - 0.25) / 0.16, 0.0, 1.0)  # upper roots lie over lower ones
    layer = 0.004 + 0.013 * top + rng.uniform(0.0, 0.004, len(roots))
    path = [roots - 0.001 * normals]
    for k in range(steps - 1):
        stiff = np.exp(-k / 5.0)
        pull = np.array([0.0, -0.34 + 0.2 * stiff, 0.0])
        heading = heading + pull + aside_of_face(path[-1])
        heading /= np.linalg.norm(heading, axis=1, keepdims=True)
        point = path[-1] + step * heading
        normal, height = skin.normals_and_heights(point)
        wanted = layer * min(1.0, (k + 1) / 5.0)
        push = np.clip(wanted - height, 0.0, None)[:, None] * normal
        heading = heading + push / step
        heading /= np.linalg.norm(heading, axis=1, keepdims=True)
        path.append(point + push)
    return np.stack(path, axis=1)


def aside_of_face(points):
    """Displacement that moves hair in front of the face outwards and back."""
    forwards = MIDDLE[2] - points[:, 2]
    before = np.clip((forwards - 0.035) / 0.05, 0.0, 1.0) * np.clip(
        (0.395 - points[:, 1]) / 0.04, 0, 1
    )
    side = np.where(points[:, 0] > PARTING, 1.0, -1.0)
    return before[:, None] * np.stack([0.45 * side, 0.0 * side, 0.6 + 0.0 * side], axis=1)


def cut(path, rng):
    """The paths down to the cut, by POINTS points each; tips turn in a little."""
    forwards = np.clip((MIDDLE[2] - path[..., 2]) / 0.07, -1.0, 1.0)
    level = CUT - 0.02 * forwards + rng.normal(0.0, 0.003, len(path))[:, None]
    below = path[..., 1] < level
    end = np.where(below.any(axis=1), below.argmax(axis=1), path.shape[1] - 1)
    strands = [points[: max(int(last), 3) + 1] for points, last in zip(path, end, strict=True)]
    counts = [len(points) for points in strands]
    offsets = np.concatenate([[0], np.cumsum(counts)])
    points = np.concatenate(strands).astype(np.float32)
    whole = rna_hair.Strands(points, np.full(len(points), RADIUS, np.float32), offsets)
    even = rna_hair.resample(whole, POINTS).points.reshape(-1, POINTS, 3).astype(float)
    along = np.linspace(0.0, 1.0, POINTS)[:, None]
    axis = np.array([0.0, 1.0, 0.0])
    inwards = (MIDDLE - even) * (1.0 - axis)
    inwards /= np.linalg.norm(inwards, axis=2, keepdims=True)
    return even + 0.012 * np.clip(along - 0.75, 0.0, 1.0) ** 2 / 0.0625 * inwards


def out_of_the_skin(strands, skin, least=0.0012):
    """The strands with all but their roots pushed out to where the skin is `least` away."""
    points = strands.points.reshape(len(strands), POINTS, 3).astype(float)
    flat = points[:, 2:].reshape(-1, 3)
    normal, height = skin.normals_and_heights(flat)
    flat += np.clip(least - height, 0.0, None)[:, None] * normal
    points[:, 2:] = flat.reshape(len(strands), -1, 3)
    return rna_hair.of_equal_length(points, RADIUS)


def hair(skin, count):
    """`count` strands."""
    rng = np.random.default_rng(23)
    paths = cut(fall(skin, skin.roots(GUIDES, rng), rng), rng)
    guides = rna_hair.of_equal_length(paths, RADIUS)
    grown = rna_hair.interpolate(
        guides, count, points=POINTS, seed=23, clump=0.3, noise=0.006, shorten=0.05
    )
    return rna_hair.taper(out_of_the_skin(grown, skin), RADIUS, tip=0.4, start=0.7)


def build(folder, strands, colour):
    melanin, redness = COLOURS[colour]
    skin = Skin(head.build(folder))
    material = chiang_material(
        colour, melanin=melanin, redness=redness, roughness=0.28, radial_roughness=0.4
    )
    add_curves(hair(skin, strands), "hair", material)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("folder", type=Path, help="folder of head.obj and its two images")
parser.add_argument("--strands", type=int, default=25000)
parser.add_argument("--colour", choices=sorted(COLOURS), default="brown")
args = parser.parse_args()
build(args.folder, args.strands, args.colour)
