"""Rays against one package, in its object space: closest hits and visibility."""

from __future__ import annotations

from typing import Any, ClassVar

import drjit as dr
import mitsuba as mi

from rna_mitsuba.points import FiberGeometry, MeshGeometry
from rna_sdk.package import Package

NO_STRAND = 0xFFFFFFFF
_STEP = 2.0**-18  # of the largest coordinate: how far beyond a hit a ray goes on


class Hits:
    """Closest hits: t (infinity for misses), part, primitive, u and v as Mitsuba has them."""

    DRJIT_STRUCT: ClassVar = {
        "t": mi.Float,
        "part": mi.UInt32,
        "primitive": mi.UInt32,
        "u": mi.Float,
        "v": mi.Float,
    }

    def __init__(
        self, t: Any = None, part: Any = None, primitive: Any = None, u: Any = None, v: Any = None
    ) -> None:
        self.t, self.part, self.primitive, self.u, self.v = t, part, primitive, u, v


class PackageScene:
    """All parts of a package as rays meet them.

    Attributes:
        geometries: of the parts.
        step: how far rays start off a surface, 2^-18 of the largest coordinate.
        is_plain: opaque meshes alone: a ray that meets one is blocked.
    """

    def __init__(self, package: Package) -> None:
        count = len(package.manifest.parts)
        self.geometries = [_geometry(package, part) for part in range(count)]
        shapes = {f"part{k}": g.shape() for k, g in enumerate(self.geometries)}
        self._scene = mi.load_dict(
            {"type": "scene", "embree_use_robust_intersections": True, **shapes}
        )
        self._pointers = [mi.ShapePtr(shape) for shape in shapes.values()]
        self.step = _STEP * max(g.extent for g in self.geometries)
        self.transmits = any(g.transmits for g in self.geometries)
        self.is_plain = not (self.transmits or any(g.is_fiber for g in self.geometries))

    def closest(self, o: mi.Point3f, d: mi.Vector3f, far: mi.Float, active: mi.Bool) -> Hits:
        """The first hit of o + t d, unit d, nearer than far."""
        ray = mi.Ray3f(mi.Point3f(o), d, far, 0, [])
        found = self._scene.ray_intersect_preliminary(ray, coherent=False, active=active)
        part = mi.UInt32(0)
        for k, pointer in enumerate(self._pointers[1:], start=1):
            part = dr.select(found.shape == pointer, mi.UInt32(k), part)
        t = dr.select(active & found.is_valid(), found.t, dr.inf)
        return Hits(t, part, found.prim_index, found.prim_uv.x, found.prim_uv.y)

    def visibility(
        self,
        o: mi.Point3f,
        d: mi.Vector3f,
        far: mi.Float,
        part: mi.UInt32,
        strand: mi.UInt32,
        active: mi.Bool,
    ) -> mi.Color3f:
        """The product of tau of all that the ray meets nearer than far.

        strand: of `part`, which is passed through; NO_STRAND for none.
        """
        if self.is_plain:
            ray = mi.Ray3f(mi.Point3f(o), d, far, 0, [])
            return dr.select(self._scene.ray_test(ray, active=active), mi.Color3f(0), 1)
        start = (mi.Color3f(1), mi.Float(0), mi.UInt32(NO_STRAND), mi.Bool(active), d, o)
        state = dr.while_loop(
            start,
            lambda v, near, last, going, d, o: going,
            lambda v, near, last, going, d, o: (
                *self._met(v, near, last, going, d, o, far, part, strand), d, o,
            ),
            label="visibility",
        )  # fmt: skip
        return state[0]

    def _met(self, v, near, last, going, d, o, far, part, strand):  # type: ignore[no-untyped-def]
        """Go on to the next hit."""
        hits = self.closest(o + near * d, d, far - near, going)
        going = going & dr.isfinite(hits.t)
        near = near + hits.t
        tau = self.hit_transmittance(hits, o + near * d, d, part, strand, going)
        # The same triangle again is the same hit, by rounding.
        number = hits.primitive * len(self.geometries) + hits.part
        v = dr.select(going & (number != last), v * tau, v)
        last = dr.select(going & ~self.is_fiber(hits.part), number, NO_STRAND)
        return v, near + self.step, last, going & (dr.max(v) > 0)

    def hit_transmittance(
        self,
        hits: Hits,
        x: mi.Point3f,
        d: mi.Vector3f,
        part: mi.UInt32,
        strand: mi.UInt32,
        active: mi.Bool,
    ) -> mi.Color3f:
        """tau of hits at x: 1 on the strand to be passed, and where rays do not enter one."""
        tau = mi.Color3f(0)
        for k, geometry in enumerate(self.geometries):
            here = active & (hits.part == k)
            if isinstance(geometry, FiberGeometry):
                own = (part == k) & (geometry.strand(hits.primitive, here) == strand)
                n = geometry.outward(hits.primitive, hits.u, x, here)
                passes = own | (dr.dot(n, d) >= 0) | geometry.is_between(hits.primitive, x, here)
                tau = dr.select(here & passes, mi.Color3f(1), tau)
            elif geometry.transmits:
                found = geometry.transmittance(hits.primitive, hits.u, hits.v, d, here)
                tau = dr.select(here, found, tau)
        return tau

    def is_fiber(self, part: mi.UInt32) -> mi.Bool:
        result = mi.Bool(False)
        for k, geometry in enumerate(self.geometries):
            if geometry.is_fiber:
                result |= part == k
        return result


def _geometry(package: Package, part: int) -> MeshGeometry | FiberGeometry:
    if package.manifest.parts[part].kind == "fiber":
        return FiberGeometry(package.curves(part))
    maps = package.normal_maps(part)
    return MeshGeometry(package.mesh(part), package.transmittance(part), maps)
