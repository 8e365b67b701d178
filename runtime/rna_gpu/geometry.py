"""Meshes and curves for `wgsl/geometry.wgsl`: bodies with a tree each, and instances of them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.bvh import build_tree
from rna_gpu.records.geometry import (
    HAS_AFTER,
    HAS_BEFORE,
    INSTANCE,
    IS_SEGMENT,
    NODE,
    PRIMITIVE,
    SURFACE_SHIFT,
)
from rna_sdk.package import Curves


@dataclass(frozen=True, eq=False)
class Triangles:
    """A mesh whose triangles are of surfaces of the scene.

    Attributes:
        positions, normals: (v, 3) float32.
        triangles: (t, 3) corners.
        surface: (t,) number of each triangle's surface.
        uvs: (v, 2) float32, or None.
    """

    positions: NDArray[np.float32]
    normals: NDArray[np.float32]
    triangles: NDArray[Any]
    surface: NDArray[Any]
    uvs: NDArray[np.float32] | None = None


@dataclass(frozen=True, eq=False)
class Strands:
    """Curves of one surface of the scene."""

    curves: Curves
    surface: int


Shape = Triangles | Strands


@dataclass(frozen=True, eq=False)
class Placed:
    """An instance. world_from_object: (4, 4), a similarity; rays: bits of those that meet it."""

    body: int
    world_from_object: NDArray[np.float64]
    rays: int


@dataclass(frozen=True, eq=False)
class Geometry:
    """Contents of the bindings of group 2, and the points' normals.

    Attributes:
        nodes, primitives: of dtypes NODE and PRIMITIVE. points, normals: (v, 4) float32; their
            last numbers are the radius of curves' points, and u and v of meshes'.
        instances: (k,) of dtype INSTANCE.
        order: (k,) number of each stored instance in what was given.
        places: of each body the place in `primitives` of each of its primitives, (m,), in the order
            of its shapes.
        first_points: of each body, in `points`.
    """

    nodes: NDArray[Any]
    primitives: NDArray[Any]
    points: NDArray[np.float32]
    normals: NDArray[np.float32]
    instances: NDArray[Any]
    order: NDArray[np.int64]
    places: list[NDArray[np.int64]]
    first_points: list[int]


def build_geometry(bodies: Sequence[Sequence[Shape]], placed: Sequence[Placed]) -> Geometry:
    """All bodies, each of one or more shapes, and their instances."""
    pieces = [_Body(shapes) for shapes in bodies]
    boxes = np.array([_world_box(pieces[p.body], p.world_from_object) for p in placed], np.float32)
    top, order = build_tree(boxes)
    roots, nodes, at = [], [top], len(top)
    first_point, first_primitive, primitives = 0, 0, []
    places, first_points = [], []
    for piece in pieces:
        roots.append(at)
        leaf = piece.nodes["count"] > 0
        moved = piece.nodes.copy()
        moved["child"] += np.where(leaf, first_primitive, at).astype(np.uint32)
        nodes.append(moved)
        primitives.append(piece.primitives_at(first_point))
        places.append(first_primitive + np.argsort(piece.order))
        first_points.append(first_point)
        at += len(moved)
        first_point += len(piece.points)
        first_primitive += len(piece.primitives)
    instances = np.zeros(len(order), INSTANCE.dtype)
    for row, k in zip(instances, order, strict=True):
        _fill_instance(row, placed[k], roots[placed[k].body], pieces[placed[k].body])
    return Geometry(
        np.concatenate(nodes).astype(NODE.dtype),
        np.concatenate(primitives),
        np.concatenate([piece.points for piece in pieces]),
        np.concatenate([piece.normals for piece in pieces]),
        instances,
        order,
        places,
        first_points,
    )


class _Body:
    """Shapes in one space, with a tree."""

    def __init__(self, shapes: Sequence[Shape]) -> None:
        made = []
        start = strand = 0
        for shape in shapes:
            if isinstance(shape, Strands):
                made.append(_segments(shape, start, strand))
                strand += len(shape.curves.offsets) - 1
            else:
                made.append(_triangles(shape, start))
            start += len(made[-1][0])
        self.points, self.normals, primitives, boxes = map(np.concatenate, zip(*made, strict=True))
        self.nodes, self.order = build_tree(boxes)
        self.primitives = primitives[self.order]
        self.extent = max(map(_extent, shapes))
        self.box = self.nodes["low"][0], self.nodes["high"][0]

    def primitives_at(self, first_point: int) -> NDArray[Any]:
        """The primitives, where the body's points begin at that place."""
        moved = self.primitives.copy()
        is_triangle = (moved["tag"] & IS_SEGMENT) == 0
        moved["a"] += np.uint32(first_point)
        moved["b"][is_triangle] += np.uint32(first_point)
        moved["c"][is_triangle] += np.uint32(first_point)
        return moved


def _extent(shape: Shape) -> float:
    """Largest absolute coordinate; of a point of curves, with its radius."""
    if isinstance(shape, Strands):
        return float((np.abs(shape.curves.points).max(axis=1) + shape.curves.radii).max())
    return float(np.abs(shape.positions).max())


def _triangles(shape: Triangles, start: int) -> tuple[NDArray[Any], ...]:
    count = len(shape.positions)
    points, normals = np.zeros((2, count, 4), np.float32)
    points[:, :3], normals[:, :3] = shape.positions, shape.normals
    if shape.uvs is not None:
        points[:, 3], normals[:, 3] = shape.uvs.T
    primitives = np.empty(len(shape.triangles), PRIMITIVE.dtype)
    for column, name in enumerate("abc"):
        primitives[name] = shape.triangles[:, column] + np.uint32(start)
    primitives["tag"] = np.asarray(shape.surface, np.uint32) << SURFACE_SHIFT
    corners = shape.positions[shape.triangles]
    return points, normals, primitives, np.stack([corners.min(axis=1), corners.max(axis=1)], axis=1)


def _segments(shape: Strands, start: int, strand: int) -> tuple[NDArray[Any], ...]:
    curves = shape.curves
    points, normals = np.zeros((2, len(curves.points), 4), np.float32)
    points[:, :3], points[:, 3] = curves.points, curves.radii
    first = curves.segments().astype(np.int64)
    number = np.searchsorted(curves.offsets, first, side="right") - 1
    primitives = np.empty(len(first), PRIMITIVE.dtype)
    primitives["a"] = first + start
    has_before = first > curves.offsets[number]
    has_after = first + 2 < curves.offsets[number + 1]
    primitives["b"] = HAS_BEFORE * has_before + HAS_AFTER * has_after
    primitives["c"] = number + strand
    primitives["tag"] = shape.surface << SURFACE_SHIFT | IS_SEGMENT
    ends = np.stack([curves.points[first], curves.points[first + 1]])
    radii = np.stack([curves.radii[first], curves.radii[first + 1]])[..., None]
    boxes = np.stack([(ends - radii).min(axis=0), (ends + radii).max(axis=0)], axis=1)
    return points, normals, primitives, boxes


def _world_box(body: _Body, matrix: NDArray[np.float64]) -> NDArray[np.float64]:
    low, high = (corner.astype(np.float64) for corner in body.box)
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    world = (low + corners * (high - low)) @ matrix[:3, :3].T + matrix[:3, 3]
    margin = 1e-5 * np.abs(world).max()
    return np.stack([world.min(axis=0) - margin, world.max(axis=0) + margin])


def _fill_instance(row: Any, placed: Placed, root: int, body: _Body) -> None:
    matrix = placed.world_from_object
    scale = float(np.cbrt(abs(np.linalg.det(matrix[:3, :3]))))
    row["to_object"] = np.linalg.inv(matrix)[:3]
    row["rotation"][:, :3] = matrix[:3, :3] / scale
    row["place"], row["scale"] = matrix[:3, 3], scale
    row["root"], row["rays"], row["extent"] = root, placed.rays, body.extent
