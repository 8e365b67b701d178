"""Rays against one package, in its object space: closest hits and visibility."""

from collections.abc import Sequence
from functools import cached_property
from typing import Any, ClassVar

import drjit as dr
import mitsuba as mi
import numpy as np

from rna_mitsuba.points import FiberGeometry, MeshGeometry, Points
from rna_mitsuba.rest import RestMesh, RestStrands
from rna_sdk.package import Curves, Mesh, Package
from rna_sdk.runtime import DeformedCurves, DeformedMesh

Shape = DeformedMesh | DeformedCurves

NO_STRAND = 0xFFFFFFFF
_RAYS_AROUND = 16_384  # that tell from which side a part is seen
_PASSED = 0.5  # transmittance, the mean of its channels, from which columns of light go on
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

    shapes: of the parts in motion; None at rest. variant: as for `Package.base_color`.

    Attributes:
        geometries: of the parts.
        diagonal: of the box of all parts.
        step: how far rays start off a surface, 2^-18 of the largest coordinate.
        is_plain: opaque meshes alone: a ray that meets one is blocked.
    """

    def __init__(
        self,
        package: Package,
        shapes: Sequence[Shape] | None = None,
        variant: str | None = None,
    ) -> None:
        count = len(package.manifest.parts)
        self.geometries = [_geometry(package, part, variant) for part in range(count)]
        self._rest: list[RestMesh | RestStrands | None] = [None] * count
        for k, shape in enumerate(shapes or ()):
            rest = self.geometries[k]
            self.geometries[k], self._rest[k] = _moved(package, k, rest, shape, variant)
        parts = {f"part{k}": g.shape() for k, g in enumerate(self.geometries)}
        self._scene = mi.load_dict(
            {"type": "scene", "embree_use_robust_intersections": True, **parts}
        )
        self._pointers = [mi.ShapePtr(part) for part in parts.values()]
        self.step = _STEP * max(g.extent for g in self.geometries)
        self.diagonal = float(dr.norm(self._scene.bbox().extents()))
        self.transmits = any(g.transmits for g in self.geometries)
        self.is_plain = not (self.transmits or any(g.is_fiber for g in self.geometries))

    @cached_property
    def sides(self) -> list[int]:
        """Side from which each part is seen from around the asset.

        1: the side of its geometric normals. -1: the other one. 0: both, as of a leaf, or unknown,
        as of strands and where triangles let light through.
        """
        if self.transmits:
            return [0] * len(self.geometries)
        rng, box = np.random.default_rng(0), self._scene.bbox()
        outwards = mi.Vector3f(rng.normal(size=(3, _RAYS_AROUND)))
        start = mi.Point3f(box.center()) + self.diagonal * dr.normalize(outwards)
        aim = mi.Point3f(box.min) + box.extents() * mi.Vector3f(rng.random((3, _RAYS_AROUND)))
        d = dr.normalize(aim - start)
        hits = self.closest(start, d, mi.Float(dr.inf), mi.Bool(True))
        return [self._side(part, hits, d) for part in range(len(self.geometries))]

    def _side(self, part: int, hits: Hits, d: mi.Vector3f) -> int:
        if self.geometries[part].is_fiber:
            return 0
        here = dr.isfinite(hits.t) & (hits.part == part)
        front = (self.facing(part, hits, d, here).numpy() < 0)[here.numpy()]
        return int(front.all()) - int(not front.any()) if len(front) else 0

    def facing(self, part: int, hits: Hits, d: mi.Vector3f, active: mi.Bool) -> mi.Float:
        """Product of d and of the geometric normals, not of unit length, of hits on a mesh."""
        a, b, c = self.geometries[part].corners_of(hits.primitive, active)
        return dr.dot(dr.cross(b - a, c - a), d)

    def query(
        self, part: int, hits: Hits, points: Points, at: dict[str, Any], active: mi.Bool
    ) -> dict[str, Any]:
        """Arguments `at` of a part's decoders; where it is in motion, at rest points."""
        rest = self._rest[part]
        return at if rest is None else rest.query(hits, points, at, active)

    def closest(self, o: mi.Point3f, d: mi.Vector3f, far: mi.Float, active: mi.Bool) -> Hits:
        """The first hit of o + t d, unit d, nearer than far."""
        ray = mi.Ray3f(mi.Point3f(o), d, far, 0, [])
        preliminary = self._scene.ray_intersect_preliminary(ray, coherent=False, active=active)
        part = mi.UInt32(0)
        for k, pointer in enumerate(self._pointers[1:], start=1):
            part = dr.select(preliminary.shape == pointer, mi.UInt32(k), part)
        t = dr.select(active & preliminary.is_valid(), preliminary.t, dr.inf)
        return Hits(t, part, preliminary.prim_index, preliminary.prim_uv.x, preliminary.prim_uv.y)

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

    def first_opaque(self, o: mi.Point3f, d: mi.Vector3f, active: mi.Bool) -> mi.Float:
        """Distance along rays to the hit that stops a column of light; infinity for none."""
        if not self.transmits:
            return self.closest(o, d, mi.Float(dr.inf), active).t
        state = dr.while_loop(
            (mi.Float(0), mi.Float(dr.inf), mi.Bool(active), d, o),
            lambda near, t, going, d, o: going,
            lambda near, t, going, d, o: (*self._passed(near, t, going, d, o), d, o),
            label="column",
        )
        return state[1]

    def _passed(self, near, t, going, d, o):  # type: ignore[no-untyped-def]
        """Go on to the next hit of a column."""
        hits = self.closest(o + near * d, d, mi.Float(dr.inf), going)
        going = going & dr.isfinite(hits.t)
        near = near + hits.t
        passes = (
            dr.mean(
                self.hit_transmittance(
                    hits,
                    o + near * d,
                    d,
                    part=mi.UInt32(NO_STRAND),
                    strand=mi.UInt32(NO_STRAND),
                    active=going,
                )
            )
            >= _PASSED
        )
        t = dr.select(going & ~passes, near, t)
        return near + self.step, t, going & passes

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
                same_strand = (part == k) & (geometry.strand(hits.primitive, here) == strand)
                n = geometry.outward(hits.primitive, hits.u, x, here)
                passes = (
                    same_strand | (dr.dot(n, d) >= 0) | geometry.is_between(hits.primitive, x, here)
                )
                tau = dr.select(here & passes, mi.Color3f(1), tau)
            elif geometry.transmits:
                through = geometry.transmittance(hits.primitive, hits.u, hits.v, d, here)
                tau = dr.select(here, through, tau)
        return tau

    def is_fiber(self, part: mi.UInt32) -> mi.Bool:
        result = mi.Bool(False)
        for k, geometry in enumerate(self.geometries):
            if geometry.is_fiber:
                result |= part == k
        return result


def _geometry(package: Package, part: int, variant: str | None) -> MeshGeometry | FiberGeometry:
    if package.manifest.parts[part].kind == "fiber":
        return FiberGeometry(package.curves(part))
    return _mesh_geometry(package, part, package.mesh(part), variant)


def _mesh_geometry(package: Package, part: int, mesh: Mesh, variant: str | None) -> MeshGeometry:
    return MeshGeometry(
        mesh,
        transmittance=package.transmittance(part),
        normal_maps=package.normal_maps(part),
        base_colors=package.base_color(part, variant),
    )


def geometry_of(shape: Shape) -> Mesh | Curves:
    """The geometry of a part in motion, for rays."""
    return shape.curves if isinstance(shape, DeformedCurves) else shape.mesh


def _moved(
    package: Package,
    part: int,
    rest: MeshGeometry | FiberGeometry,
    shape: Shape,
    variant: str | None,
) -> tuple[MeshGeometry | FiberGeometry, RestMesh | RestStrands]:
    if isinstance(shape, DeformedCurves):
        assert isinstance(rest, FiberGeometry)
        return FiberGeometry(shape.curves), RestStrands(rest, shape)
    assert isinstance(rest, MeshGeometry)
    moved = _mesh_geometry(package, part, shape.mesh, variant)
    return moved, RestMesh(rest, moved)
