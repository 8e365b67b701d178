"""A package's geometry, bound to a mesh that moves: the place of each vertex on it at rest.

Welding, cuts and unwrapping lose the order of a source's vertices. A package may say which vertex
of the source each of its own is; else that is found by its rest position: the nearest triangle of
the source, and the barycentric place on it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.errors import MotionError
from rna_sdk.motion.motion_file import rest_positions
from rna_sdk.package import Curves, Mesh, SourceVertices

Float32 = NDArray[np.float32]
Float64 = NDArray[np.float64]

TOLERANCE = 2e-3
"""How far a vertex may be from the source's surface, as a share of the package's diagonal."""


@dataclass(frozen=True, eq=False)
class Binding:
    """A part bound to a source mesh.

    corners: (v, 3) int64, vertices of the source. weights: (v, 3) float64. residual: (v, 3)
    float64, from the place on the source to the vertex, at rest. root: for strands, (p,) int64,
    the row of each point's root in the other arrays, of one row a strand, with `frames` (s, 3, 3)
    of its triangles at rest; None for meshes. by_number: whether the package said which vertices
    of the source its own are.

    Examples:
        >>> mesh = load("toy.rna").mesh
        >>> (binding,) = bind([mesh], mesh.positions, mesh.triangles)
        >>> bool(np.allclose(binding.positions(2 * mesh.positions), 2 * mesh.positions, atol=1e-5))
        True
    """

    corners: NDArray[np.int64]
    weights: Float64
    residual: Float64
    root: NDArray[np.int64] | None = None
    frames: Float64 | None = None
    by_number: bool = False

    def positions(self, source: NDArray[np.floating[Any]]) -> Float32:
        """The part's positions where the source's vertices are at `source`: (w, 3).

        A mesh follows the surface. Strands are carried with the triangle of their root: its
        shift, and the rotation of its edge and normal.
        """
        at = np.asarray(source, np.float64)[self.corners]
        places = np.einsum("nk,nkc->nc", self.weights, at)
        if self.root is None or self.frames is None:
            return np.asarray(places + self.residual, np.float32)
        turn = np.einsum("nij,nkj->nik", _frames(at), self.frames)[self.root]
        carried = np.einsum("nij,nj->ni", turn, self.residual)
        return np.asarray(places[self.root] + carried, np.float32)


def bind(
    geometries: Sequence[Mesh | Curves],
    source: NDArray[np.floating[Any]],
    triangles: NDArray[np.integer[Any]],
    names: tuple[str, str] = ("the source", "the package"),
    numbers: Sequence[SourceVertices | None] = (),
) -> list[Binding]:
    """Bind the parts of a package to a source mesh in the pose that the package was made from.

    source: (w, 3), metres, the package's axes. triangles: (t, 3). names: of the source and of the
    package, for errors. numbers: `Package.source_vertices` of each part, which are followed where
    the source has as many vertices and these are where the package's are; all is found by its place
    if left out. Strands are bound by their roots, which have to be near the surface.

    Raises:
        MotionError: the source is not the package's shape; the message says how far it is away, or
            how many times as large.

    Examples:
        >>> mesh = load("toy.rna").mesh
        >>> bind([mesh], 100 * mesh.positions, mesh.triangles)  # in centimetres
        Traceback (most recent call last):
        ...
        rna_sdk.errors.MotionError: the source has not the rest shape of the package: ...
    """
    positions = np.asarray(source, np.float64)
    corners = np.ascontiguousarray(triangles, np.int64)
    box = np.array(
        [[rest_positions(g).min(axis=0), rest_positions(g).max(axis=0)] for g in geometries]
    )
    size = float(np.linalg.norm(box[:, 1].max(axis=0) - box[:, 0].min(axis=0)))
    known = numbers or [None] * len(geometries)
    pairs = zip(geometries, known, strict=True)
    return [
        _by_number(g, n, positions, size) or _bound(g, positions, corners, size, names, n)
        for g, n in pairs
    ]


def _by_number(
    geometry: Mesh | Curves, known: SourceVertices | None, source: Float64, size: float
) -> Binding | None:
    """None where the numbers are of another source, or of another shape of it."""
    points = rest_positions(geometry)
    if known is None or known.count != len(source) or len(known.numbers) != len(points):
        return None
    row = known.numbers.astype(np.int64)
    residual = points - source[row]
    if np.linalg.norm(residual, axis=1).max() > TOLERANCE * size:
        return None
    weights = np.tile([1.0, 0.0, 0.0], (len(row), 1))
    return Binding(np.repeat(row[:, None], 3, axis=1), weights, residual, by_number=True)


def _bound(
    geometry: Mesh | Curves,
    source: Float64,
    triangles: NDArray[np.int64],
    size: float,
    names: tuple[str, str],
    known: SourceVertices | None,
) -> Binding:
    from rna_sdk.motion.nearest import nearest_places  # numba loads when it is used

    points, normals, reach = rest_positions(geometry), None, TOLERANCE * size
    if isinstance(geometry, Curves):
        points, reach = points[geometry.offsets[:-1]], 10 * reach
    else:
        normals = geometry.normals
    triangle, weights, distance = nearest_places(points, normals, source, triangles, reach)
    if not (triangle >= 0).all():
        text = _mismatch(points, triangle < 0, distance, source, triangles, size, names)
        if known is not None and known.count != len(source):
            text += f"; it has {len(source):,} vertices where the package's had {known.count:,}"
        raise MotionError(text)
    corners = triangles[triangle]
    places = np.einsum("nk,nkc->nc", weights, source[corners])
    if not isinstance(geometry, Curves):
        return Binding(corners, weights, points - places)
    offsets = geometry.offsets.astype(np.int64)
    counts = offsets[1:] - offsets[:-1]
    root = np.repeat(np.arange(len(counts)), counts)
    residual = geometry.points - places[root]
    return Binding(corners, weights, residual, root, _frames(source[corners]))


def _frames(corners: Float64) -> Float64:
    """(n, 3, 3): columns along the first edge, across it, and the normal, of triangles."""
    e1, e2 = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    n = _unit(np.cross(e1, e2))
    t = _unit(e1)
    return np.stack([t, np.cross(n, t), n], axis=2)


def _unit(v: Float64) -> Float64:
    length = np.linalg.norm(v, axis=1, keepdims=True)
    return np.asarray(v / np.where(length > 0, length, 1))


def _mismatch(
    points: Float32,
    missing: NDArray[np.bool_],
    distance: Float64,
    source: Float64,
    triangles: NDArray[np.int64],
    size: float,
    names: tuple[str, str],
) -> str:
    """The differences between a source and a package, in one line."""
    used = source[np.unique(triangles)]
    other = float(np.linalg.norm(np.ptp(used, axis=0)))
    whole = float(np.linalg.norm(np.ptp(points, axis=0)))
    ratio = other / whole if whole else np.inf
    text = (
        f"{names[0]} has not the rest shape of {names[1]}: {missing.sum():,} of {len(points):,} "
        f"vertices are off its surface, up to {distance[missing].max():.3g} m where "
        f"{TOLERANCE * size:.2g} m is allowed"
    )
    if not 0.5 < ratio < 2.0:
        return f"{text}; it is {ratio:.3g} times as large: in another unit, expected metres?"
    shift = used.min(axis=0) + used.max(axis=0) - points.min(axis=0) - points.max(axis=0)
    if np.linalg.norm(shift) / 2 > TOLERANCE * size:
        return f"{text}; its middle is off by {np.round(shift / 2, 3).tolist()} m"
    return text
