"""Geometry of a part at a hit, in object space: spec/RNA.md, 4.1 to 4.6, 7.1."""

import os
import tempfile
from typing import Any, ClassVar

import drjit as dr
import mitsuba as mi
import numpy as np

from rna_mitsuba.base_colors import BaseColors
from rna_mitsuba.textures import NormalTextures, TransmittanceTextures
from rna_mitsuba.vectors import length, unit
from rna_sdk.package import BaseColor, Curves, Mesh, NormalMap, Transmittance

_ROUNDING = 1e-3
"""Rounding error of float32 coordinates, as a fraction of a strand's radius."""
_SMOOTH_BELOW = 0.1  # cosine of 7.1, where rays begin to start on the smooth surface


class Points:
    """Points of hits.

    x: positions. axis: mapped normals or tangents, what the decoder takes. h: offsets of
    fibers. color: base colour. n, ng, lift: normals that are interpolated and of triangles, and the
    way onto the smooth surface; of fibers n is outward, ng and lift are 0. strand: of fibers, its
    number.
    """

    DRJIT_STRUCT: ClassVar = {
        "x": mi.Point3f,
        "axis": mi.Vector3f,
        "h": mi.Float,
        "color": mi.Color3f,
        "n": mi.Vector3f,
        "ng": mi.Vector3f,
        "lift": mi.Vector3f,
        "strand": mi.UInt32,
    }

    def __init__(self, *values: Any) -> None:
        for (name, kind), value in zip(self.DRJIT_STRUCT.items(), values, strict=bool(values)):
            setattr(self, name, kind(value))

    def query(self, wo: mi.Vector3f) -> dict[str, Any]:
        """Arguments of decoders, except arguments of the light."""
        where = {"position": self.x, "axis": self.axis, "h": self.h}
        return {**where, "wo": wo, "base_color": self.color}

    def origin(self, wi: mi.Vector3f, step: float) -> mi.Point3f:
        """Origins of rays along wi; step: 2^-18 of the largest coordinate of the asset."""
        cosine = dr.dot(self.ng, wi)
        smooth = dr.dot(self.n, self.ng) > 0
        above = dr.select(smooth, dr.dot(self.n, wi), cosine)
        lifted = smooth & (above > 0) & (cosine < _SMOOTH_BELOW)
        share = dr.select(lifted, 1 - dr.maximum(cosine, 0) / _SMOOTH_BELOW, 0)
        side = dr.select(above >= 0, step, -step)
        return self.x + share * self.lift + side * self.ng


class MeshGeometry:
    """The mesh of a part as Dr.Jit arrays, with its holes and its relief."""

    is_fiber = False

    def __init__(
        self,
        mesh: Mesh,
        transmittance: list[Transmittance],
        normal_maps: list[NormalMap],
        base_colors: list[BaseColor],
    ) -> None:
        self.mesh = mesh
        self.extent = float(np.abs(mesh.positions).max())
        self._positions, self._normals = mi.Float(mesh.positions.ravel()), mesh.normals.ravel()
        self._normals = mi.Float(self._normals)
        self._triangles = mi.UInt32(mesh.triangles.ravel())
        uvs = np.zeros((len(mesh.positions), 2), np.float32) if mesh.uvs is None else mesh.uvs
        self._uvs = mi.Float(uvs.ravel())
        count = len(mesh.triangles)
        self._holes = TransmittanceTextures(transmittance, count) if transmittance else None
        self._relief = NormalTextures(normal_maps, count) if normal_maps else None
        self._colors = BaseColors(base_colors, count) if base_colors else None
        self.transmits = bool(transmittance)

    def shape(self) -> mi.Shape:
        """Shape for ray tracing, in object space."""
        shape = mi.Mesh("part", len(self.mesh.positions), len(self.mesh.triangles))
        parameters = mi.traverse(shape)
        parameters["vertex_positions"] = self._positions
        parameters["faces"] = self._triangles
        parameters.update()
        return shape

    def points(
        self,
        primitive: mi.UInt32,
        u: mi.Float,
        v: mi.Float,
        o: mi.Point3f,
        d: mi.Vector3f,
        active: mi.Bool,
    ) -> Points:
        """The points of hits by rays o + t d. u, v: barycentric coordinates."""
        corners = self._corners(primitive, active)
        p = self._at(mi.Point3f, self._positions, corners, active)
        n_k = self._at(mi.Vector3f, self._normals, corners, active)
        b1, b2 = _followed(u, v, p, o, d)
        weights = 1 - b1 - b2, b1, b2
        x = _mixed(weights, p)
        n = unit(_mixed(weights, n_k))
        ng = unit(dr.cross(p[1] - p[0], p[2] - p[0]))
        lift = mi.Vector3f(0)
        for weight, corner, normal in zip(weights, p, n_k, strict=True):
            lift += weight * dr.maximum(0, dr.dot(corner - x, normal)) * normal
        axis = n
        if self._relief is not None:
            uv = self._at(mi.Point2f, self._uvs, corners, active)
            axis = self._relief.mapped(primitive, n, p, uv, _mixed(weights, uv), active)
        color = mi.Color3f(1)
        if self._colors is not None:
            uv = self._at(mi.Point2f, self._uvs, corners, active)
            color = self._colors.at(primitive, _mixed(weights, uv), active)
        return Points(x, axis, mi.Float(0), color, n, ng, lift, mi.UInt32(0))

    def base_color(
        self, primitive: mi.UInt32, u: mi.Float, v: mi.Float, level: mi.Float
    ) -> mi.Color3f:
        """Base colour of hits in a level of the images."""
        if self._colors is None:
            return mi.Color3f(1)
        active = mi.Bool(True)
        corners = self._corners(primitive, active)
        uv = self._at(mi.Point2f, self._uvs, corners, active)
        return self._colors.at(primitive, _mixed((1 - u - v, u, v), uv), active, level)

    def transmittance(
        self, primitive: mi.UInt32, u: mi.Float, v: mi.Float, d: mi.Vector3f, active: mi.Bool
    ) -> mi.Color3f:
        """tau of hits by rays of unit direction d."""
        if self._holes is None:
            return mi.Color3f(0)
        corners = self._corners(primitive, active)
        weights = 1 - u - v, u, v
        uv = _mixed(weights, self._at(mi.Point2f, self._uvs, corners, active))
        n = unit(_mixed(weights, self._at(mi.Vector3f, self._normals, corners, active)))
        p = self._at(mi.Point3f, self._positions, corners, active)
        is_front = dr.dot(d, dr.cross(p[1] - p[0], p[2] - p[0])) < 0
        return self._holes.at(primitive, uv, dr.abs(dr.dot(n, d)), is_front, active)

    def corners_of(self, primitive: mi.UInt32, active: mi.Bool) -> list[mi.Point3f]:
        """Positions of the triangles' corners."""
        corners = self._corners(primitive, active)
        return self._at(mi.Point3f, self._positions, corners, active)

    def _corners(self, primitive: mi.UInt32, active: mi.Bool) -> list[mi.UInt32]:
        triangle = dr.gather(mi.Point3u, self._triangles, primitive, active)
        return [triangle.x, triangle.y, triangle.z]

    @staticmethod
    def _at(kind, values, corners, active):  # type: ignore[no-untyped-def]
        return [dr.gather(kind, values, corner, active) for corner in corners]


class FiberGeometry:
    """The strands of a part as Dr.Jit arrays."""

    is_fiber, transmits = True, False

    def __init__(self, curves: Curves) -> None:
        self.curves = curves
        reach = np.abs(curves.points).max(axis=1) + curves.radii
        self.extent = float(reach.max())
        self._points, self._radii = mi.Float(curves.points.ravel()), mi.Float(curves.radii)
        first = curves.segments()
        self._first, self._count = mi.UInt32(first), len(first)
        counts = np.diff(curves.offsets.astype(np.int64)) - 1
        self._strand = mi.UInt32(np.repeat(np.arange(len(counts)), counts).astype(np.uint32))

    def shape(self) -> mi.Shape:
        """Shape for ray tracing, in object space, through a file: Mitsuba reads no other curves."""
        ends = self.curves.offsets[1:-1].astype(np.int64)
        rows = np.column_stack([self.curves.points, self.curves.radii])
        strands = [
            "\n".join(" ".join(map(repr, row)) for row in strand.tolist())
            for strand in np.split(rows, ends)
        ]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "curves.txt")
            with open(path, "w") as file:
                file.write("\n\n".join(strands) + "\n")
            return mi.load_dict({"type": "linearcurve", "filename": path})

    def strand(self, segment: mi.UInt32, active: mi.Bool) -> mi.UInt32:
        """The number of the strand that a segment is of."""
        return dr.gather(mi.UInt32, self._strand, segment, active)

    def points(
        self,
        primitive: mi.UInt32,
        u: mi.Float,
        v: mi.Float,
        o: mi.Point3f,
        d: mi.Vector3f,
        active: mi.Bool,
    ) -> Points:
        """The points of hits by rays o + d. u: place along the segment; o + d is the hit."""
        c, r, t = self._sphere(primitive, u, active)
        n = unit(mi.Vector3f(o + d - c))
        wo = unit(-d)
        across = dr.cross(t, wo)
        size = length(across)
        h = dr.select(size <= 1e-6, 0, dr.dot(n, across) / dr.select(size <= 1e-6, 1, size))
        zero = mi.Vector3f(0)
        return Points(
            *(c + r * n, t, dr.clip(h, -1, 1), mi.Color3f(1)),
            *(n, zero, zero, self.strand(primitive, active)),
        )

    def on_cone(
        self, segment: mi.UInt32, u: mi.Float, n: mi.Vector3f, active: mi.Bool
    ) -> tuple[mi.Point3f, mi.Vector3f]:
        """The point at u with the outward normal n, and the tangent there."""
        c, r, t = self._sphere(segment, u, active)
        return c + r * n, t

    def outward(
        self, segment: mi.UInt32, u: mi.Float, x: mi.Point3f, active: mi.Bool
    ) -> mi.Vector3f:
        """The normal of a hit at x, at u along the segment; of some length."""
        return mi.Vector3f(x - self._sphere(segment, u, active)[0])

    def is_between(self, segment: mi.UInt32, x: mi.Point3f, active: mi.Bool) -> mi.Bool:
        """Whether x, on a segment, is inside the one before or after it on its strand."""
        strand, result = self.strand(segment, active), mi.Bool(False)
        for neighbour, exists in (
            (segment - 1, segment > 0),
            (segment + 1, segment + 1 < self._count),
        ):
            here = active & exists
            here &= self.strand(neighbour, here) == strand
            result |= here & self._holds(neighbour, x, here)
        return result

    def _holds(self, segment: mi.UInt32, x: mi.Point3f, active: mi.Bool) -> mi.Bool:
        """Whether one of a segment's spheres holds x, by more than rounding.

        At s along the axis from its first point, x is sqrt((a - s)^2 + b^2) - r - k s off; the
        least is where (s - a) / sqrt((a - s)^2 + b^2) = k.
        """
        first, r, t = self._sphere(segment, mi.Float(0), active)
        last, end, _ = self._sphere(segment, mi.Float(1), active)
        size = length(mi.Vector3f(last - first))
        k = (end - r) / dr.maximum(size, 1e-30)
        way = mi.Vector3f(x - first)
        a, b = dr.dot(way, t), length(dr.cross(way, t))
        least = a + k * b / dr.sqrt(dr.maximum(1 - k * k, 1e-12))
        s = dr.clip(dr.select(dr.abs(k) < 1, least, dr.select(k > 0, size, 0)), 0, size)
        off = dr.sqrt(dr.square(a - s) + b * b)
        return active & (off < (r + k * s) * (1 - _ROUNDING))

    def _sphere(
        self, segment: mi.UInt32, u: mi.Float, active: mi.Bool
    ) -> tuple[mi.Point3f, mi.Float, mi.Vector3f]:
        """Centre and radius of the sphere at u, and the segment's direction."""
        a = dr.gather(mi.UInt32, self._first, segment, active)
        p, q = (dr.gather(mi.Point3f, self._points, k, active) for k in (a, a + 1))
        r, s = (dr.gather(mi.Float, self._radii, k, active) for k in (a, a + 1))
        return p * (1 - u) + q * u, r * (1 - u) + s * u, unit(mi.Vector3f(q - p))


def _mixed(weights, values):  # type: ignore[no-untyped-def]
    return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2]


def _followed(
    u: mi.Float, v: mi.Float, p: list[mi.Point3f], o: mi.Point3f, d: mi.Vector3f
) -> tuple[mi.Float, mi.Float]:
    """u and v, with the derivatives of the place where the ray meets the triangle's plane."""
    if not (dr.grad_enabled(o) or dr.grad_enabled(d)):
        return u, v
    e1, e2 = p[1] - p[0], p[2] - p[0]
    across = dr.cross(d, e2)
    determinant = dr.dot(e1, across)
    inverse = dr.select(determinant == 0, 0, 1 / dr.select(determinant == 0, 1, determinant))
    start = o - p[0]
    b1 = dr.dot(start, across) * inverse
    b2 = dr.dot(d, dr.cross(start, e1)) * inverse
    return dr.replace_grad(u, b1), dr.replace_grad(v, b2)
