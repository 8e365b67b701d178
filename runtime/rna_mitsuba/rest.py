"""The decoder's queries of a deformed part, in Dr.Jit: spec/RNA.md, 8.3."""

from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from rna_mitsuba.points import FiberGeometry, MeshGeometry, Points
from rna_mitsuba.vectors import length, unit
from rna_sdk.runtime import DeformedCurves

_FLAT = 1e-6
"""A triangle whose height is below this share of its longest edge has no frame."""


class RestMesh:
    """A mesh at rest, beside the deformed one that rays meet."""

    def __init__(self, rest: MeshGeometry, moved: MeshGeometry) -> None:
        self._rest, self._moved = rest, moved

    def query(self, hits: Any, points: Points, at: dict[str, Any], active: mi.Bool) -> Any:
        """Arguments of decoders at the rest points of hits. at: those of the deformed mesh."""
        origin, way = mi.Point3f(0), mi.Vector3f(0, 0, 1)
        rest = self._rest.points(hits.primitive, hits.u, hits.v, origin, way, active)
        turn = self._turn(hits.primitive, points.n, rest.n, active)
        return _turned({**at, "position": rest.x, "axis": rest.axis}, turn)

    def _turn(self, primitive: mi.UInt32, n1: mi.Vector3f, n: mi.Vector3f, active: mi.Bool) -> Any:
        """The rotation Q. n1, n: interpolated normals, deformed and at rest."""
        t, b, ng, size, known = _frame(self._rest.corners_of(primitive, active))
        t1, b1, ng1, size1, known1 = _frame(self._moved.corners_of(primitive, active))
        known &= known1
        size = [dr.select(known, s, 1) for s in size]
        along = size1[0] / size[0]
        shear = (size1[1] - along * size[1]) / size[2]
        c, s = along + size1[2] / size[2], -shear
        scale = dr.rsqrt(dr.maximum(c * c + s * s, 1e-30))
        x, y = (c * t1 + s * b1) * scale, (c * b1 - s * t1) * scale

        def back(d: mi.Vector3f) -> mi.Vector3f:
            turned = t * dr.dot(x, d) + b * dr.dot(y, d) + ng * dr.dot(ng1, d)
            return dr.select(known, turned, d)

        bent = back(n1)
        k, cosine = dr.cross(bent, n), dr.dot(bent, n)
        share = dr.select(cosine > -1 + 1e-6, 1 / dr.maximum(1 + cosine, 1e-6), 0)

        def turn(d: mi.Vector3f) -> mi.Vector3f:
            d = back(d)
            across = dr.cross(k, d)
            return d + across + dr.cross(k, across) * share

        return turn


class RestStrands:
    """Strands at rest, and the rotations of the deformed ones."""

    def __init__(self, rest: FiberGeometry, shape: DeformedCurves) -> None:
        self._rest = rest
        count = len(shape.curves.segments())
        number, zero = np.arange(count, dtype=np.int32), np.zeros(count, np.float32)
        rest_points = shape.rest_points(number, zero, np.tile(np.float32([1, 0, 0]), (count, 1)))
        self._rotations = mi.Float(rest_points.rotations.ravel())

    def query(self, hits: Any, points: Points, at: dict[str, Any], active: mi.Bool) -> Any:
        """As of `RestMesh`."""
        rows = [
            dr.gather(mi.Vector3f, self._rotations, 3 * hits.primitive + k, active)
            for k in range(3)
        ]

        def turn(d: mi.Vector3f) -> mi.Vector3f:
            return mi.Vector3f(*(dr.dot(row, d) for row in rows))

        x, tangent = self._rest.on_cone(hits.primitive, hits.u, turn(points.n), active)
        return _turned({**at, "position": x, "axis": tangent}, turn)


def _turned(at: dict[str, Any], turn: Any) -> dict[str, Any]:
    return {k: turn(v) if k in ("wo", "wi") else v for k, v in at.items()}


def _frame(p: list[mi.Point3f]) -> tuple[Any, Any, Any, list[mi.Float], mi.Bool]:
    """Unit axes of a triangle; lengths of its first edge, of the second along and across it."""
    e1, e2 = mi.Vector3f(p[1] - p[0]), mi.Vector3f(p[2] - p[0])
    t, n = unit(e1), unit(dr.cross(e1, e2))
    b = dr.cross(n, t)
    size = [length(e1), dr.dot(e2, t), dr.dot(e2, b)]
    longest = dr.maximum(dr.dot(e1, e1), dr.dot(e2, e2))
    return t, b, n, size, size[0] * size[2] > _FLAT * longest
