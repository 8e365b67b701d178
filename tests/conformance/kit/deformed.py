"""Hits on deformed shapes, and their rest points and rotations: spec/RNA.md, 8.3, in float64."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from rna_sdk.package import Curves, Mesh
from tests.conformance.kit.blocks import dot, unit

TOLERANCE = 1e-4
LARGEST = 1e-3
"""Tolerance of a hit that is kept."""
TRIALS = 32
COLUMNS = 15
_ROWS = 40
_FLAT = 1e-6
_FAR = 1e-3

Ranges = list[tuple[str, int, int]]
Move = Callable[[np.ndarray], np.ndarray]
"""What rounding does to vectors, or nothing."""


@dataclass(frozen=True)
class DeformedHits:
    """shape: (p, 3) float32; records of n hits; expected, tolerance: (n, 15) float64, of rest
    position, normal or tangent, and Q by rows."""

    shape: np.ndarray
    records: bytes
    expected: np.ndarray
    tolerance: np.ndarray
    classes: Ranges


@dataclass(frozen=True)
class Hits:
    """primitive (n,); place (n, 5) float32: b1, b2 of triangles, or u and n of segments, then 0."""

    primitive: np.ndarray
    place: np.ndarray


def twisted(points: np.ndarray) -> np.ndarray:
    """Stretched along x, turned about it the more the further, and moved."""
    x, y, z = points.astype(np.float64).T
    a = 2.2 * x + 0.7
    turned = [1.5 * x, np.cos(a) * y - np.sin(a) * z, np.sin(a) * y + np.cos(a) * z]
    return (np.stack(turned, axis=1) + np.array([0.2, -0.1, 0.4])).astype(np.float32)


def mirrored(points: np.ndarray) -> np.ndarray:
    """Turned inside out, sheared and twisted."""
    x, y, z = twisted(points).astype(np.float64).T
    return np.stack([-x, y + 0.6 * z, z], axis=1).astype(np.float32)


def collapsed(points: np.ndarray) -> np.ndarray:
    """Twisted, with some neighbours in one place."""
    shape = twisted(points)
    shape[20:23] = shape[20]
    return shape


def unfolded(points: np.ndarray) -> np.ndarray:
    """Twisted; triangles of the last two points, flat at rest, get an area."""
    shape = twisted(points)
    shape[-2:] += np.float32([[0.1, 0.2, 0.3], [-0.2, 0.1, 0.3]])
    return shape


def pinched(points: np.ndarray) -> np.ndarray:
    """Twisted, with two points of a strand in one place."""
    shape = twisted(points)
    shape[3] = shape[2]
    return shape


SHAPES: dict[tuple[str, int], Callable[[np.ndarray], np.ndarray]] = {
    ("surface-float32", 0): twisted,
    ("surface-clip", 0): mirrored,
    ("surface-quantised", 0): collapsed,
    ("surface-relief", 0): twisted,
    ("surface-tiny", 0): twisted,
    ("fiber-float16", 0): twisted,
    ("fiber-int8", 0): mirrored,
    ("fiber-one-channel", 0): twisted,
    ("parts-head", 1): twisted,
    ("surface-folds", 0): unfolded,
    ("fiber-lone", 0): pinched,
    ("fiber-straight", 0): twisted,
}
"""Package and part -> how it is deformed."""


def at_rest(geometry: Mesh | Curves, shape: np.ndarray, hits: Hits, move: Move) -> np.ndarray:
    """(n, 15) float64."""
    if isinstance(geometry, Mesh):
        return _of_mesh(geometry, shape, hits, move)
    return _of_strands(geometry, shape, hits, move)


def _of_mesh(mesh: Mesh, shape: np.ndarray, hits: Hits, move: Move) -> np.ndarray:
    rest, deformed = (p.astype(np.float64)[mesh.triangles] for p in (mesh.positions, shape))
    rotations, whole = _triangle_rotations(rest, deformed, move)
    normals = mesh.normals.astype(np.float64)
    moved = _deformed_normals(mesh, rest, rotations, whole)
    corners, (b1, b2) = mesh.triangles[hits.primitive], hits.place.astype(np.float64).T[:2]
    b = np.stack([1 - b1 - b2, b1, b2], axis=1)[:, :, None]
    back = rotations[hits.primitive].transpose(0, 2, 1)
    n, bent = (unit(move(np.sum(b * of[corners], axis=1))) for of in (normals, moved))
    q = _smallest(np.einsum("nij,nj->ni", back, bent), n) @ back
    x = np.sum(b * rest[hits.primitive], axis=1)
    return np.hstack([x, n, q.reshape(-1, 9)])


def _triangle_rotations(
    rest: np.ndarray, deformed: np.ndarray, move: Move
) -> tuple[np.ndarray, np.ndarray]:
    """(t, 3, 3) polar factors of the gradients, and whether each triangle has area, both times."""
    frames, whole = [], np.ones(len(rest), bool)
    for p in (rest, deformed):
        e1, e2 = move(p[:, 1] - p[:, 0]), move(p[:, 2] - p[:, 0])
        across = np.cross(e1, e2)
        size = np.linalg.norm(across, axis=1)
        whole &= size > _FLAT * np.maximum(dot(e1, e1), dot(e2, e2))
        n = across / np.where(size > 0, size, 1)[:, None]
        frames.append(np.stack([e1, e2, n], axis=2))
    rotations = np.tile(np.eye(3), (len(rest), 1, 1))
    left, _, right = np.linalg.svd(frames[1][whole] @ np.linalg.inv(frames[0][whole]))
    rotations[whole] = left @ right
    return rotations, whole


def _deformed_normals(
    mesh: Mesh, rest: np.ndarray, rotations: np.ndarray, whole: np.ndarray
) -> np.ndarray:
    """(v, 3): the mean of R n about each vertex, by the angles at rest."""
    alike = np.hstack([mesh.positions, mesh.normals]) + np.float32(0)
    _, number = np.unique(alike.view(np.uint32), axis=0, return_inverse=True)
    number = number.ravel()  # numpy 2.0 has it as a column
    at = rest[whole]
    edges = [unit((np.roll(at, -s, axis=1) - at).reshape(-1, 3)) for s in (1, 2)]
    angles = np.arccos(np.clip(dot(*edges), -1, 1)).reshape(-1, 3)
    normals, corners = mesh.normals.astype(np.float64), mesh.triangles[whole]
    turned = np.einsum("tij,tkj->tki", rotations[whole], normals[corners])
    sums, seen = np.zeros_like(normals), np.zeros(len(normals), bool)
    np.add.at(sums, number[corners], angles[..., None] * turned)
    seen[number[corners]] = True
    return unit(np.where(seen[number][:, None], sums[number], normals))


def _smallest(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """(n, 3, 3) rotations that take unit a to unit b, by Rodrigues."""
    v, zero = np.cross(a, b).T, np.zeros(len(a))
    k = np.array([[zero, -v[2], v[1]], [v[2], zero, -v[0]], [-v[1], v[0], zero]])
    k = k.transpose(2, 0, 1)
    return np.eye(3) + k + k @ k / (1 + dot(a, b))[:, None, None]


def _of_strands(curves: Curves, shape: np.ndarray, hits: Hits, move: Move) -> np.ndarray:
    p, p1 = curves.points.astype(np.float64), shape.astype(np.float64)
    offsets = curves.offsets.astype(int)
    back = np.concatenate([_along(p, p1, offsets, k, move) for k in range(len(offsets) - 1)])
    q = back[hits.primitive]
    first = curves.segments()[hits.primitive].astype(int)
    u = hits.place[:, :1].astype(np.float64)
    n = np.einsum("nij,nj->ni", q, hits.place[:, 1:4].astype(np.float64))
    r = curves.radii.astype(np.float64)[:, None]
    x = (1 - u) * (p[first] + r[first] * n) + u * (p[first + 1] + r[first + 1] * n)
    return np.hstack([x, unit(move(p[first + 1] - p[first])), q.reshape(-1, 9)])


def _along(
    p: np.ndarray, p1: np.ndarray, offsets: np.ndarray, strand: int, move: Move
) -> np.ndarray:
    """(m, 3, 3) Q of the segments of a strand."""
    rotation = _root(p, p1, offsets, strand, move)
    result = []
    for k in range(offsets[strand], offsets[strand + 1] - 1):
        if (p1[k + 1] != p1[k]).any():
            t, t1 = unit(move(np.stack([a[k + 1] - a[k] for a in (p, p1)])))
            rotation = _smallest((rotation @ t)[None], t1[None])[0] @ rotation
        result.append(rotation.T)
    return np.array(result)


def _root(
    p: np.ndarray, p1: np.ndarray, offsets: np.ndarray, strand: int, move: Move
) -> np.ndarray:
    """The rotation of the strand's root, all strands near: at most seven in the kit."""
    roots, root = offsets[:-1], offsets[strand]
    assert len(roots) <= 7
    far = np.linalg.norm(p[roots] - p[root], axis=1)
    nearest = far[far > 0].min(initial=np.inf)
    ways = [(root, root + (offsets[strand + 1] - root) // 2, _FAR)]
    ways.append((root, offsets[strand + 1] - 1, _FAR))
    for other, distance in zip(roots, far, strict=True):
        w = (nearest / distance) ** 2 if distance > 0 else 1.0
        ways += [(other, other + 1, w), (root, other, w)]
    lines = np.array([[p[b] - p[a], p1[b] - p1[a]] for a, b, _ in ways])
    if all(np.linalg.matrix_rank(vectors, 1e-5) == 1 for vectors in lines.transpose(1, 0, 2)):
        t, t1 = unit(move(lines[1]))  # of a straight strand alone: the smallest of all that fit
        return _smallest(t[None], t1[None])[0]
    total = np.zeros((3, 3))
    for a, b, w in ways:
        d, d1 = p[b] - p[a], p1[b] - p1[a]
        if d.any():
            total += w * np.outer(d1, d) / (d @ d)
    left, _, right = np.linalg.svd(move(total.reshape(1, 9)).reshape(3, 3))
    return left @ np.diag([1, 1, np.linalg.det(left @ right)]) @ right


def make_deformed_hits(
    seed: int, part: int, geometry: Mesh | Curves, deform: Callable[[np.ndarray], np.ndarray]
) -> DeformedHits:
    """Hits of two classes, on a shape, with what they are answered."""
    rng, is_mesh = np.random.default_rng(seed), isinstance(geometry, Mesh)
    shape = deform(geometry.positions if is_mesh else geometry.points)
    made: list[list[np.ndarray]] = []
    classes: Ranges = []
    for name, hits in (_on_mesh if is_mesh else _on_strands)(rng, geometry, shape):
        exact = at_rest(geometry, shape, hits, lambda v: v)
        change = np.zeros_like(exact)
        for _ in range(TRIALS):
            moved = at_rest(geometry, shape, hits, lambda v: _rounded(v, rng))
            change = np.maximum(change, np.abs(moved - exact))
        is_stable = (TOLERANCE + change).max(axis=1) <= LARGEST
        made.append([a[is_stable] for a in (hits.primitive, hits.place, exact, TOLERANCE + change)])
        classes.append((name, sum(c[2] for c in classes), int(is_stable.sum())))
    primitive, place, expected, tolerance = map(np.concatenate, zip(*made, strict=True))
    words = np.zeros((len(primitive), 8), np.uint32)
    words[:, 0], words[:, 7] = primitive, part
    words[:, 1:6] = place.view(np.uint32)
    return DeformedHits(shape, words.astype("<u4").tobytes(), expected, tolerance, classes)


def _rounded(values: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Each row by two units in the last place of its largest component, each up or down."""
    largest = np.abs(values).max(axis=-1, keepdims=True)
    return values + 2.0**-22 * largest * rng.choice([-1.0, 1.0], values.shape)


def _on_mesh(rng: np.random.Generator, mesh: Mesh, shape: np.ndarray) -> list[tuple[str, Hits]]:
    rest, deformed = (p.astype(np.float64)[mesh.triangles] for p in (mesh.positions, shape))
    _, whole = _triangle_rotations(rest, deformed, lambda v: v)
    place = np.zeros((_ROWS, 5), np.float32)
    place[:, :2] = rng.dirichlet((1, 1, 1), _ROWS)[:, 1:]
    edges = place.copy()
    edges[::2, 0], edges[1::4, 1], edges[1::4, 0] = 0, 0, 1
    triangles = [np.resize(rng.permutation(np.flatnonzero(whole)), _ROWS) for _ in range(2)]
    names = zip(("inside triangles", "edges and corners"), triangles, (place, edges), strict=True)
    made = [(name, Hits(triangle, rows)) for name, triangle, rows in names]
    _, moved = _triangle_rotations(deformed, deformed, lambda v: v)
    if (unfolded := np.flatnonzero(moved & ~whole)).size:
        made.append(("flat at rest alone", Hits(np.resize(unfolded, _ROWS), place)))
    return made


def _on_strands(
    rng: np.random.Generator, curves: Curves, shape: np.ndarray
) -> list[tuple[str, Hits]]:
    first = curves.segments().astype(int)
    is_root, made = np.isin(first, curves.offsets), []
    is_long = (shape[first + 1] != shape[first]).any(axis=1)
    for name, segments in (("first segments", is_root), ("other segments", ~is_root & is_long)):
        if not segments.any():
            continue
        segment = np.resize(np.flatnonzero(segments), _ROWS)
        t = shape[first[segment] + 1] - shape[first[segment]].astype(np.float64)
        place = np.zeros((_ROWS, 5), np.float32)
        place[:, 0] = rng.uniform(0, 1, _ROWS)
        place[:8, 0], place[8:16, 0] = 0, 1
        place[:, 1:4] = unit(np.cross(t, rng.normal(size=(_ROWS, 3))))
        made.append((name, Hits(segment, place)))
    return made
