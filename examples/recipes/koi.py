"""Builds a carving of jade: a koi that leaps out of a lotus, on a stand of lacquered wood.

    rna-capture examples/recipes/koi.py --out koi.rays/

Light goes deep into white jade and comes out of thin fins and petals; its orange is in the stone.
Scales are a normal map. Runs inside Blender.
"""

import argparse

import numpy as np
import shading
import shapes

SPINE = [  # x, height, half height and half width of the body, from the tail to the mouth
    (0.006, 0.070, 0.009, 0.007), (0.018, 0.128, 0.013, 0.010), (0.056, 0.163, 0.021, 0.015),
    (0.071, 0.205, 0.032, 0.022), (0.060, 0.250, 0.041, 0.029), (0.031, 0.289, 0.044, 0.033),
    (-0.008, 0.314, 0.040, 0.032), (-0.044, 0.327, 0.031, 0.027), (-0.071, 0.333, 0.019, 0.019),
    (-0.084, 0.335, 0.009, 0.011), (-0.087, 0.3355, 0.0, 0.0),
]  # fmt: skip
SCALE_ROWS, SCALES_AROUND = 30, 22
PALE, ORANGE = np.array([0.80, 0.84, 0.74]), np.array([0.86, 0.24, 0.035])
PETAL_RINGS = [  # petals, how far they lean out in degrees, length, width
    (7, 28.0, 0.092, 0.052), (9, 50.0, 0.100, 0.052), (11, 74.0, 0.098, 0.050),
]  # fmt: skip


def spline(points, count):
    """`count` points along a Catmull-Rom spline through `points` (n, d), even in its parameter."""
    p = np.asarray(points, float)
    slope = np.gradient(p, axis=0)
    at = np.linspace(0.0, len(p) - 1.0, count)
    k = np.minimum(at.astype(int), len(p) - 2)
    t = (at - k)[:, None]
    start, end = (1 + 2 * t) * (1 - t) ** 2, t**2 * (3 - 2 * t)
    leave, arrive = t * (1 - t) ** 2, t**2 * (t - 1)
    return start * p[k] + end * p[k + 1] + leave * slope[k] + arrive * slope[k + 1]


def frames(path):
    """Directions along a path in the plane of x and z, and across it there, (n, 3) each."""
    along = np.gradient(path, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    return along, np.stack([-along[:, 2], 0.0 * along[:, 0], along[:, 0]], axis=1)


def body(rows=104, around=56):
    """u runs around the body, v along it. The back is where the curve bends outwards."""
    spine = spline(SPINE, rows)
    path = np.stack([spine[:, 0], 0.004 * np.sin(spine[:, 1] * 20.0), spine[:, 1]], axis=1)
    _, across = frames(path)
    angle = 2.0 * np.pi * np.arange(around) / around
    high, wide = np.maximum(spine[:, 2:], 0.0).T[..., None]
    up = high * np.sign(np.cos(angle)) * np.abs(np.cos(angle)) ** 0.92
    side = wide * np.sin(angle)
    points = path[:, None] + up[..., None] * -across[:, None] + side[..., None] * [0.0, 1.0, 0.0]
    points[-1] = path[-1]
    return shapes.grid(points, closed=True)


def scales(side=512):
    """Rows of overlapping scales as a tangent-space normal map; none on the head."""
    v, u = np.mgrid[0:side, 0:side] / side
    height = np.zeros((side, side))
    for row in range(-1, SCALE_ROWS + 1):
        centre = (row + 0.5) / SCALE_ROWS
        x = (u * SCALES_AROUND + 0.5 * (row % 2)) % 1.0 - 0.5
        y = (v - centre) * SCALE_ROWS
        radius = np.hypot(x / 0.56, y / 1.0)
        dome = np.where(radius < 1.0, 0.35 + 0.65 * np.sqrt(np.maximum(1.0 - radius**2, 0.0)), 0.0)
        height = np.maximum(height, dome * (1.0 - 0.3 * (y + 1.0)) * (np.abs(y) < 1.0))
    fade = np.clip((0.70 - v) / 0.05, 0.0, 1.0) * np.clip((v - 0.03) / 0.05, 0.0, 1.0)
    slope_v, slope_u = np.gradient(shading.blurred(height * fade, 3), 1.0 / side)
    normal = np.stack([-0.028 * slope_u, -0.028 * slope_v, np.ones_like(u)], axis=-1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    return shading.image("scales", 0.5 + 0.5 * normal, "Non-Color")


def stone(side=256):
    """Colours of the body: orange patches in pale jade, with soft edges and faint veins."""
    rng = np.random.default_rng(5)
    clouds = sum(
        shading.smooth_noise((side, side), (n, n), rng) / n**0.8 * 4.0**0.8 for n in (4, 8, 16)
    )
    v, u = np.mgrid[0:side, 0:side] / side
    on_back = np.cos(2.0 * np.pi * u)
    patch = np.clip((clouds - 1.02 + 0.38 * on_back + 0.2 * np.sin(v * 15.0)) * 6.0, 0.0, 1.0)
    veins = np.abs(shading.smooth_noise((side, side), (12, 12), rng) - 0.5)
    pale = PALE * (1.0 - 0.16 * np.exp(-((veins / 0.03) ** 2)))[..., None]
    colour = pale + (ORANGE - pale) * patch[..., None]
    return shading.image("stone", shading.encoded(colour))


def sheet(surface, thickness):
    """A closed sheet about `surface` (r, c, 3); `thickness` (r, c) is 0 at its rim, but one row."""
    over_r, over_c = np.gradient(surface, axis=0), np.gradient(surface, axis=1)
    normal = np.cross(over_c, over_r)
    normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-9)
    half = 0.5 * thickness[..., None] * normal
    return shapes.joined([shapes.grid(surface + half), shapes.grid((surface - half)[:, ::-1])])


def fin(root, tip, bend=0.0, ribs=9, thick=0.0045, rows=13, columns=40):
    """A fan between the curves `root` and `tip` (n, 3), with ribs and a wavy rim."""
    a, b = spline(root, columns), spline(tip, columns)
    t = np.linspace(0.0, 1.0, rows)[:, None, None]
    s = np.linspace(0.0, 1.0, columns)
    wave = np.cos(2.0 * np.pi * ribs * s)
    surface = a + (b - a) * t * (1.0 + 0.05 * t * wave[None, :, None])
    surface[..., 1] += (bend * t**2)[..., 0] + 0.0035 * t[..., 0] ** 1.5 * np.sin(9.0 * s)
    rim = np.sqrt(np.clip(np.minimum(s, 1.0 - s) * 12.0, 0.0, 1.0))
    taper = np.sqrt(np.clip((1.0 - t[..., 0]) * 5.0, 0.0, 1.0)) * (1.0 - 0.55 * t[..., 0])
    return sheet(surface, thick * taper * rim * (1.0 + 0.3 * wave))


def petal(length, width, lean_deg, turn_deg, rows=15, columns=12):
    """A petal that cups upwards, from the middle of the flower outwards."""
    t = np.linspace(0.0, 1.0, rows)[:, None]
    s = np.linspace(-1.0, 1.0, columns)[None]
    outline = width * np.sin(np.pi * t**0.62) ** 0.75 * 0.5 + 0.004 * (1.0 - t)
    cup = 0.35 * width * s**2 * np.sin(np.pi * t**0.7)
    lean = np.radians(lean_deg) * (1.0 - 0.55 * t**1.5)
    out, up = length * t * np.sin(lean), length * t * np.cos(lean)
    surface = np.stack(
        [0.012 + out - cup * np.cos(lean), outline * s, up + cup * np.sin(lean)], axis=-1
    )
    rim = np.sqrt(np.clip((1.0 - np.abs(s)) * 4.0, 0.0, 1.0))
    end = np.sqrt(np.clip((1.0 - t) * 6.0, 0.0, 1.0))
    shape = sheet(surface, 0.0055 * rim * end * (1.0 - 0.5 * t))
    return shape.placed((0.0, 0.0, 0.045), shapes.rotation((0, 0, 1), turn_deg))


def lotus():
    petals = []
    for ring, (count, lean, length, width) in enumerate(PETAL_RINGS):
        for k in range(count):
            turn = 360.0 * (k + 0.5 * (ring % 2)) / count
            petals.append(petal(length, width, lean + 2.0 * (k % 2), turn))
    return shapes.joined(petals)


def fins():
    """Tail, back, belly and two pairs."""
    tail = fin(
        [(0.018, 0, 0.128), (0.010, 0, 0.136), (0.004, 0, 0.146)],
        [(0.006, 0, 0.112), (-0.040, 0, 0.124), (-0.062, 0, 0.152), (-0.092, 0, 0.178),
         (-0.052, 0, 0.196), (-0.024, 0, 0.184)],
        bend=0.014, ribs=12,
    )  # fmt: skip
    back = fin(
        [(0.083, 0, 0.190), (0.098, 0, 0.225), (0.091, 0, 0.272), (0.064, 0, 0.312)],
        [(0.118, 0, 0.168), (0.140, 0, 0.222), (0.128, 0, 0.292), (0.076, 0, 0.326)],
    )
    belly = fin(
        [(0.050, 0, 0.170), (0.042, 0, 0.158), (0.034, 0, 0.146)],
        [(0.018, 0, 0.192), (0.008, 0, 0.170), (0.012, 0, 0.146)],
        ribs=6, thick=0.004,
    )  # fmt: skip
    pairs = []
    for side in (-1.0, 1.0):
        pairs += [
            fin(
                [(-0.020, side * 0.026, 0.296), (-0.008, side * 0.028, 0.288),
                 (0.004, side * 0.028, 0.282)],
                [(-0.062, side * 0.066, 0.268), (-0.040, side * 0.078, 0.238),
                 (0.002, side * 0.066, 0.232)],
                bend=side * 0.01, ribs=8, thick=0.004,
            ),
            fin(
                [(0.030, side * 0.016, 0.224), (0.033, side * 0.017, 0.214),
                 (0.036, side * 0.017, 0.204)],
                [(-0.006, side * 0.042, 0.212), (-0.004, side * 0.046, 0.190),
                 (0.014, side * 0.038, 0.178)],
                bend=side * 0.006, ribs=6, thick=0.004,
            ),
        ]  # fmt: skip
    return shapes.joined([tail, back, belly, *pairs])


def barbels():
    made = []
    for side in (-1.0, 1.0):
        for start, middle, end in (
            ((-0.079, 0.008, 0.327), (-0.090, 0.020, 0.318), (-0.086, 0.028, 0.306)),
            ((-0.083, 0.006, 0.332), (-0.098, 0.014, 0.332), (-0.106, 0.022, 0.325)),
        ):
            path = spline([np.array(p) * [1.0, side, 1.0] for p in (start, middle, end)], 12)
            made.append(shapes.tube(path, np.linspace(0.0022, 0.0008, 12), 8))
    return shapes.joined(made)


def add_eyes(gold, black):
    for side in (-1.0, 1.0):
        at = np.array([-0.052, side * 0.0245, 0.337])
        shapes.add(shapes.ball((0.0072, 0.0045, 0.0072), 24).placed(at), "iris", gold)
        at += [-0.0008, side * 0.0026, 0.0006]
        shapes.add(shapes.ball((0.0045, 0.0028, 0.0045), 24).placed(at), "pupil", black)


def jade(name, base, radius, **values):
    """Random-walk subsurface scattering under polish; `radius`: red, green and blue, metres."""
    return shading.principled(
        name,
        base,
        Roughness=0.18,
        IOR=1.6,
        Subsurface_Weight=1.0,
        Subsurface_Radius=radius,
        Subsurface_Scale=1.0,
        **values,
    )


def build(depth):
    white = jade("white jade", stone(), (0.026 * depth, 0.019 * depth, 0.012 * depth))
    shading.add_normal_map(white, scales())
    thin = jade("orange jade", (0.86, 0.42, 0.14), (0.020 * depth, 0.011 * depth, 0.005 * depth))
    green = jade("green jade", (0.34, 0.62, 0.36), (0.011 * depth, 0.020 * depth, 0.010 * depth))
    shapes.add(body(), "koi", white)
    shapes.add(fins(), "fins", thin, smooth_deg=60.0)
    shapes.add(barbels(), "barbels", thin)
    shapes.add(lotus(), "lotus", green, smooth_deg=60.0)
    gold = shading.principled("gold", (0.83, 0.58, 0.2), Metallic=1.0, Roughness=0.25)
    black = shading.principled("pupil", (0.01, 0.01, 0.012), Roughness=0.08)
    add_eyes(gold, black)
    profile = spline(
        [(0.0, 0.0), (0.092, 0.0), (0.098, 0.006), (0.094, 0.013), (0.078, 0.017), (0.066, 0.024),
         (0.064, 0.032), (0.072, 0.039), (0.074, 0.045), (0.068, 0.050), (0.030, 0.052),
         (0.0, 0.052)],
        56,
    )  # fmt: skip
    profile[[0, -1], 0] = 0.0
    wood = shading.principled(
        "lacquer", (0.075, 0.017, 0.010), Roughness=0.4, Coat_Weight=1.0, Coat_Roughness=0.08
    )
    shapes.add(shapes.lathe(np.maximum(profile, 0.0), 64), "stand", wood)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--depth", type=float, default=1.0, help="scale factor of the mean free path")
build(parser.parse_args().depth)
