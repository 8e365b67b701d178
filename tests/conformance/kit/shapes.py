"""Geometry of the kit: small meshes and strands on which visibility can go wrong."""

from dataclasses import replace
from itertools import pairwise

import numpy as np

from rna_sdk.package import BaseColor, Curves, Mesh, NormalMap, Transmittance
from tests.conformance.kit.blocks import unit
from tests.conformance.kit.png import KINDS, fitting


def ball(rings: int = 6, sectors: int = 9, radius: float = 0.8) -> Mesh:
    """A sphere of few triangles, smooth shaded: convex, all terminator. Poles are degenerate."""
    theta = np.linspace(0, np.pi, rings + 1)[:, None]
    phi = np.linspace(0, 2 * np.pi, sectors, endpoint=False)[None]
    y = np.cos(theta) + 0 * phi
    points = np.stack([np.sin(theta) * np.cos(phi), y, np.sin(theta) * np.sin(phi)], axis=2)
    points[0], points[-1] = (0, 1, 0), (0, -1, 0)
    return smooth(radius * points, points, wrap=True)


def capped_ball() -> Mesh:
    """The ball under a piece of a shell, below which a lift at the terminator must end."""
    theta, phi = np.linspace(0.6, 1.5, 4)[:, None], np.linspace(0, 2.6, 6)[None]
    y = np.cos(theta) + 0 * phi
    points = np.stack([np.sin(theta) * np.cos(phi), y, np.sin(theta) * np.sin(phi)], axis=2)
    inner, outer = ball(), smooth(0.9 * points, points, wrap=False)
    count = np.uint32(len(inner.positions))
    return Mesh(
        np.concatenate([inner.positions, outer.positions]),
        np.concatenate([inner.normals, outer.normals]),
        None,
        np.concatenate([inner.triangles, outer.triangles + count]),
    )


def bowl(rings: int = 5, sectors: int = 10) -> Mesh:
    """An open bowl, smooth shaded, whose normals point inward: its inside sees the far rim."""
    theta = np.linspace(0.15, 1.6, rings + 1)[:, None]
    phi = np.linspace(0, 2 * np.pi, sectors, endpoint=False)[None]
    y = -np.cos(theta) + 0 * phi
    points = np.stack([np.sin(theta) * np.cos(phi), y, np.sin(theta) * np.sin(phi)], axis=2)
    return smooth(0.9 * points + (0, 0.3, 0), -points, wrap=True)


def smooth(points: np.ndarray, normals: np.ndarray, wrap: bool) -> Mesh:
    """A grid of (rows, columns, 3) points as triangles; wrap: the last column joins the first."""
    rows, columns = points.shape[:2]
    j, i = np.meshgrid(np.arange(rows - 1), np.arange(columns - (not wrap)), indexing="ij")
    at = lambda row, column: row * columns + column % columns  # noqa: E731
    a, b, c, d = at(j, i), at(j, i + 1), at(j + 1, i + 1), at(j + 1, i)
    triangles = np.stack([np.stack([a, b, c], -1), np.stack([a, c, d], -1)], axis=2)
    return Mesh(
        points.reshape(-1, 3).astype(np.float32),
        unit(normals.reshape(-1, 3)).astype(np.float32),
        None,
        triangles.reshape(-1, 3).astype(np.uint32),
    )


def flat(*quads: tuple[tuple[float, float, float], ...]) -> Mesh:
    """Squares of four corners each, counter-clockwise, flat shaded, and open: two sheets have no
    inside."""
    corners = np.float32(quads)
    normals = unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    first = 4 * np.arange(len(quads))[:, None]
    triangles = first + np.array([0, 1, 2, 0, 2, 3])
    return Mesh(
        corners.reshape(-1, 3),
        np.repeat(normals, 4, axis=0).astype(np.float32),
        None,
        triangles.reshape(-1, 3).astype(np.uint32),
    )


def steps() -> Mesh:
    """Two sheets at a right angle, and a small one that hovers over the floor."""
    return flat(
        ((-0.9, -0.5, -0.9), (-0.9, -0.5, 0.9), (0.9, -0.5, 0.9), (0.9, -0.5, -0.9)),
        ((-0.9, -0.5, -0.9), (0.9, -0.5, -0.9), (0.9, 0.9, -0.9), (-0.9, 0.9, -0.9)),
        ((-0.3, -0.45, -0.3), (-0.3, -0.45, 0.3), (0.3, -0.45, 0.3), (0.3, -0.45, -0.3)),
    )


def backwards(mesh: Mesh) -> Mesh:
    """Wound clockwise: geometric normals against those of the corners."""
    return Mesh(mesh.positions, mesh.normals, None, np.ascontiguousarray(mesh.triangles[:, ::-1]))


def with_uvs(mesh: Mesh) -> Mesh:
    return Mesh(mesh.positions, mesh.normals, np.abs(mesh.positions[:, :2]), mesh.triangles)


def placed(mesh: Mesh, scale: float, centre: tuple[float, float, float]) -> Mesh:
    positions = (mesh.positions * scale + np.array(centre)).astype(np.float32)
    return Mesh(positions, mesh.normals, None, mesh.triangles)


def curls(strands: int, seed: int, points: int = 9, radius: float = 0.05) -> Curves:
    """Random helices of two turns that taper to a third."""
    rng, t = np.random.default_rng(seed), np.linspace(0, 1, points)[None, :, None]
    axis = unit(rng.normal(size=(strands, 3)))[:, None]
    side = unit(np.cross(axis[:, 0], rng.normal(size=(strands, 3))))[:, None]
    turn = 4 * np.pi * t
    circle = np.cos(turn) * side + np.sin(turn) * np.cross(axis, side)
    path = rng.uniform(-0.3, 0.3, (strands, 1, 3)) + (t - 0.3) * 0.7 * axis + 0.12 * circle
    radii = radius * rng.uniform(0.5, 1.2, (strands, 1)) * (1 - 0.67 * t[:, :, 0])
    return joined(list(path), list(radii))


def crossings() -> Curves:
    """Strands that touch, cross and run through each other, and a hairpin: straight and bent."""
    paths = [
        [(-0.8, 0, 0), (-0.2, 0, 0), (0.3, 0, 0), (0.8, 0, 0)],  # through the next two
        [(0, -0.7, 0.05), (0, 0, 0.05), (0, 0.7, 0.05)],
        [(-0.5, 0.03, -0.7), (-0.5, 0.03, 0.0), (-0.4, 0.03, 0.7)],
        [(-0.7, -0.5, 0.4), (0.6, -0.5, 0.4), (0.6, -0.25, 0.4), (-0.7, -0.25, 0.4)],  # hairpin
        [(0.2, 0.6, -0.6), (0.5, 0.3, -0.3), (0.6, 0.0, -0.1)],
    ]
    radii = [[0.1] * 4, [0.1, 0.12, 0.06], [0.08, 0.08, 0.05], [0.07] * 4, [0.02, 0.15, 0.04]]
    return joined([np.array(path) for path in paths], [np.array(r) for r in radii])


def wick() -> Curves:
    """Strands that stand in the middle of the floor."""
    paths = [
        [(0.0, -0.49, 0.0), (0.05, -0.2, 0.02), (0.0, 0.1, 0.05)],
        [(-0.2, -0.49, 0.1), (-0.25, 0.0, 0.15), (-0.2, 0.4, 0.1), (0.0, 0.5, 0.0)],
    ]
    return joined(
        [np.array(path) for path in paths], [np.array([0.05, 0.06, 0.03]), 0.04 + np.zeros(4)]
    )


def floor() -> Mesh:
    return flat(((-0.9, -0.5, -0.9), (-0.9, -0.5, 0.9), (0.9, -0.5, 0.9), (0.9, -0.5, -0.9)))


def panes() -> Mesh:
    """Four upright sheets around the middle, and a slanted opaque one; u, v run over each. The
    coated pane is shaded as if it bulged."""
    x, y, z = 0.7, 0.8, 0.6
    mesh = flat(
        ((-x, -0.4, z), (x, -0.4, z), (x, y, z), (-x, y, z)),
        ((x, -0.4, z), (x, -0.4, -z), (x, y, -z), (x, y, z)),
        ((x, -0.4, -z), (-x, -0.4, -z), (-x, y, -z), (x, y, -z)),
        ((-x, -0.4, -z), (-x, -0.4, z), (-x, y, z), (-x, y, -z)),
        ((-0.5, 0.85, 0.3), (0.5, 0.85, 0.3), (0.5, 0.95, -0.3), (-0.5, 0.95, -0.3)),
    )
    uvs = np.tile(np.float32([[-0.25, 1.5], [1.75, 1.5], [1.75, -0.25], [-0.25, -0.25]]), (5, 1))
    coated, normals = slice(8, 12), mesh.normals.copy()
    outward = mesh.positions[coated] - mesh.positions[coated].mean(axis=0)
    normals[coated] = unit(normals[coated] + 0.3 * outward)
    return replace(mesh, uvs=uvs, normals=normals)


def pane_records() -> tuple[tuple[str, Transmittance], ...]:
    """A leaf with holes; coloured glass; a coated pane, seen through; half of the last, a dark
    inside. The other half of it and the slanted sheet are opaque."""
    rng = np.random.default_rng(5)
    leaf = rng.integers(0, 2, (4, 3, 1)).astype(np.uint8) * 255
    tint = rng.integers(60, 256, (3, 5, 3)).astype(np.uint8)
    clear, grey = np.full((1, 1, 1), 255, np.uint8), np.full((1, 1, 3), 128, np.uint8)
    return (
        ("leaf", Transmittance(0, 2, leaf, 0.5, None)),
        ("tint", Transmittance(2, 2, tint, None, None)),
        ("clear", Transmittance(4, 2, clear, None, (1.5, 1.5))),
        ("grey", Transmittance(6, 1, grey, None, (1.33, 1 / 1.33))),
    )


def close_sheets(size: float, centre: tuple[float, float, float] = (0, 0, 0)) -> Mesh:
    """Sheets that hover over a floor below and above the step off it, of an asset of a largest
    coordinate of `size`."""
    e, flats = 2.0**-18 * size, []
    for k, height in enumerate((0.0, 0.7 * e, 0.0, 1.45 * e)):
        z = -0.8 + 0.5 * (k // 2)
        flats.append(((-0.8, height, z), (-0.8, height, z + 0.4), (0.8, height, z + 0.4)))
        flats[-1] += ((0.8, height, z),)
    mesh = flat(*flats)
    moved = mesh.positions.astype(np.float64) + np.array(centre)
    return replace(mesh, positions=moved.astype(np.float32))


def room(bulge: float = 2.0, wall: float = 0.05) -> Mesh:
    """A floor of nine squares shaded as a dome, between walls lower than rays are lifted."""
    steps = list(pairwise((-0.6, -0.2, 0.2, 0.6)))
    floor = [
        ((x, 0.0, z), (x, 0.0, z1), (x1, 0.0, z1), (x1, 0.0, z))
        for x, x1 in steps
        for z, z1 in steps
    ]
    rim = [(-0.6, -0.6), (-0.6, 0.6), (0.6, 0.6), (0.6, -0.6), (-0.6, -0.6)]
    walls = [
        ((x, 0.0, z), (x, wall, z), (x1, wall, z1), (x1, 0.0, z1))
        for (x, z), (x1, z1) in pairwise(rim)
    ]
    mesh, domed = flat(*floor, *walls), slice(0, 4 * len(floor))
    normals = mesh.normals.copy()
    normals[domed] = unit(normals[domed] + bulge * mesh.positions[domed])
    return replace(mesh, normals=normals)


def pairs_of_strands(shift: float, thick: bool = False) -> Curves:
    """Three upright strands below the sheets; those of two parts stand side by side, number by
    number. One more is so thick that its radius counts in the asset's largest coordinate."""
    paths = [
        [(x + shift, -0.8, z), (x + shift, -0.5, z + 0.03), (x + shift, -0.2, z)]
        for x, z in ((-0.5, -0.5), (0.0, 0.4), (0.5, -0.2))
    ]
    radii = [[0.04, 0.05, 0.03]] * 3
    if thick:
        paths.append([(1.1, -2.6, 0.0), (1.2, -2.7, 0.1)])
        radii = [*radii, [1.5, 1.4]]
    return joined([np.array(path) for path in paths], [np.array(r) for r in radii])


def screens() -> tuple[tuple[str, Transmittance], ...]:
    """Holes in a picture of greys, and coated panes on which a normal map lies."""
    grey = np.random.default_rng(11).integers(0, 256, (5, 4, 1)).astype(np.uint8)
    clear = np.full((1, 1, 1), 255, np.uint8)
    return (
        ("greys", Transmittance(0, 4, grey, 0.5, None)),
        ("clear", Transmittance(4, 4, clear, None, (1.5, 1 / 1.5))),
    )


def screen_maps() -> tuple[tuple[str, NormalMap], ...]:
    """Far from flat."""
    texture = np.random.default_rng(12).choice(np.uint8([40, 70, 190, 210]), (4, 4, 2))
    return (("steep", NormalMap(4, 4, texture)),)


def folds() -> Mesh:
    """A bowl with two more triangles, flat at rest: each on an edge, with a corner of its own."""
    mesh = bowl()
    edges = mesh.triangles[[10, 40], :2]
    positions = np.concatenate([mesh.positions, mesh.positions[edges[:, 0]]])
    normals = np.concatenate([mesh.normals, np.float32([[0, 0, 1], [1, 0, 0]])])
    last = np.arange(len(mesh.positions), len(positions), dtype=np.uint32)[:, None]
    triangles = np.concatenate([mesh.triangles, np.hstack([edges, last])])
    return Mesh(positions, normals, None, np.ascontiguousarray(triangles))


def lone(points: int, bend: float) -> Curves:
    """One strand, a helix with an even number of points, or straight."""
    t = np.linspace(0, 1, points)
    line = np.stack([0.8 * t - 0.4, 0.5 * t - 0.2, 0.1 - 0.3 * t], axis=1)
    path = line + bend * np.stack([0 * t, np.cos(5 * t), np.sin(5 * t)], axis=1)
    return joined([path], [np.linspace(0.05, 0.02, points)])


def pictures() -> tuple[tuple[str, BaseColor], ...]:
    """An image for each way that a PNG may be written in; see `png.py`."""
    rng = np.random.default_rng(13)
    drawn = [rng.choice(np.uint8([0, 51, 102, 153, 204, 255]), (9, 7, 3)) for _ in KINDS]
    images = [fitting(*one) for one in zip(drawn, KINDS.values(), strict=True)]
    records = [
        (kind, BaseColor(6 * k, 6, image))
        for k, (kind, image) in enumerate(zip(KINDS, images, strict=True))
    ]
    return (*records, ("", BaseColor(6 * len(KINDS), 4, None, factor=(0.2, 0.6, 0.9))))


def relief() -> Mesh:
    """A bowl of single triangles, seen through the texture from below: u is mirrored where x < 0.
    Three triangles have no area in it, and of two more the normals lie along u."""
    whole = bowl()
    corners = whole.triangles.reshape(-1)
    positions, normals = whole.positions[corners], whole.normals[corners].copy()
    middle = positions.reshape(-1, 3, 3)[:, :, 0].mean(axis=1)
    side = np.repeat(np.where(middle < 0, -1.0, 1.0), 3)
    uvs = np.stack([1.7 * side * positions[:, 0] - 0.3, 1.1 - 1.3 * positions[:, 2]], axis=1)
    uvs[: 3 * 3] = uvs[::3][:3].repeat(3, axis=0)
    normals[3 * 90 : 3 * 92] = (1, 0, 0)
    positions[3 * 90 : 3 * 92, 1] = 0.5
    triangles = np.arange(len(corners), dtype=np.uint32).reshape(-1, 3)
    return Mesh(positions, normals, uvs.astype(np.float32), triangles)


def relief_maps() -> tuple[tuple[str, NormalMap], ...]:
    """Coarse, rough to the ends of its integers, one texel, and none on the rest."""
    rng = np.random.default_rng(6)
    fine = rng.integers(90, 165, (9, 7, 2)).astype(np.uint8)
    rough = rng.choice(np.uint8([0, 127, 255]), (3, 4, 2))
    dent = np.uint8([[[60, 150]]])
    return (
        ("fine", NormalMap(0, 50, fine)),
        ("rough", NormalMap(50, 25, rough)),
        ("dent", NormalMap(80, 15, dent)),
    )


def printed() -> Mesh:
    """A bowl seen through its images from below; they are repeated some times."""
    mesh = bowl()
    uvs = np.stack([2.1 * mesh.positions[:, 0] - 0.3, 0.4 - 1.9 * mesh.positions[:, 2]], axis=1)
    return replace(mesh, uvs=uvs.astype(np.float32))


def prints() -> tuple[tuple[str, BaseColor], ...]:
    """Contrasts from black to white, sides odd and even, one texel, no image, and no record."""
    rng = np.random.default_rng(9)
    label = rng.integers(0, 256, (7, 13, 3)).astype(np.uint8)
    poster = rng.choice(np.uint8([0, 60, 255]), (16, 8, 3))
    tape = rng.choice(np.uint8([0, 128, 255]), (3, 40, 3))
    dot = np.uint8([[[200, 120, 10]]])
    skewed, mirror = (0.9, 0.2, 0.3, -0.1, 1.2, 0.0), ("mirror", "clamp")
    return (
        ("label", BaseColor(0, 30, label)),
        ("poster", BaseColor(30, 25, poster, "linear", (0.9, 1.0, 0.6), ("clamp", "repeat"))),
        ("tape", BaseColor(55, 20, tape, wrap=mirror, transform=skewed)),
        ("dot", BaseColor(75, 5, dot, factor=(0.5, 1.0, 1.0), wrap=("clamp", "mirror"))),
        ("", BaseColor(80, 10, None, factor=(0.3, 0.0, 1.0))),
        ("label", BaseColor(92, 4, label, "linear", wrap=("mirror", "mirror"))),
    )


def joined(paths: list[np.ndarray], radii: list[np.ndarray]) -> Curves:
    counts = [len(path) for path in paths]
    return Curves(
        np.concatenate(paths).astype(np.float32),
        np.concatenate(radii).astype(np.float32),
        np.cumsum([0, *counts]).astype(np.uint32),
    )
