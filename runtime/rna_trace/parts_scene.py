"""An asset as rays meet it: all its parts, meshes and strands, in one Embree scene."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from rna_sdk.arrays import check_numbers, vectors
from rna_sdk.package import Curves, Mesh
from rna_trace.embree.filters import start_strand_filter, strand_transmittance_filter
from rna_trace.embree.scenes import add_curves, add_mesh
from rna_trace.embree.tracing import (
    NO_START,
    ClosestHits,
    GeometryScene,
    any_hits,
    rays_of,
    transmitted,
)
from rna_trace.fiber import FiberPoints
from rna_trace.normal_maps import NormalMaps
from rna_trace.rays import per_ray
from rna_trace.surface import SurfacePoints, leaving_origins
from rna_trace.transmittance import Transmittance, geometry_table

PartPoints = SurfacePoints | FiberPoints

PASSED = 0.5
_MOST_LAYERS = 64
_RAYS_AROUND = 1 << 14  # that tell from which side parts are seen


class PartsScene(GeometryScene):
    """The parts of an asset in one space. Embree keeps a copy of their geometry.

    Triangles behind Embree's robust (watertight) intersection; strands as in `add_curves`.
    transmittance: of each part, None where it is opaque, as strands are; none at all if left out.
    `intersect` and `occluded` do not ask for it. normal_maps: of each part, None where it has
    none; none at all if left out.

    Attributes:
        geometries: of the parts, in order.
        extent: the largest absolute coordinate of all parts: of a vertex, or of a point of curves
            plus its radius.

    Raises PackageError and SceneError as `add_mesh` and `add_curves`.
    """

    def __init__(
        self,
        geometries: Sequence[Mesh | Curves],
        transmittance: Sequence[Transmittance | None] = (),
        normal_maps: Sequence[NormalMaps | None] = (),
    ) -> None:
        super().__init__()
        self.geometries = tuple(geometries)
        self._normal_maps = normal_maps or [None] * len(self.geometries)
        self._transmittance = transmittance or [None] * len(self.geometries)
        self.transmits = any(table is not None for table in self._transmittance)
        self.coloured = any(table is not None and table.coloured for table in self._transmittance)
        self._first = [g.segments() if isinstance(g, Curves) else None for g in self.geometries]
        self._strands = _strand_numbers(self.geometries)
        self._tables = [geometry_table(numbers.ctypes.data) for numbers in self._strands]
        self._has_strands = any(isinstance(g, Curves) for g in self.geometries)
        for part, geometry in enumerate(self.geometries):
            if isinstance(geometry, Curves):
                extent = add_curves(self._scene, part, geometry, self._tables[part])
            else:
                extent = add_mesh(
                    self._scene,
                    part,
                    positions=geometry.positions,
                    triangles=geometry.triangles,
                    transmittance=self._transmittance[part],
                )
            self.extent = max(self.extent, extent)
        self._scene.commit()

    def points(
        self, part: int, primitive: np.ndarray, u: np.ndarray, v: np.ndarray, normals: np.ndarray
    ) -> PartPoints:
        """The points of hits on one part; arrays are rows of ClosestHits.

        Raises QueryError for a primitive that is not there, or arrays of different length.
        """
        geometry, first = self.geometries[part], self._first[part]
        if first is not None and isinstance(geometry, Curves):
            return FiberPoints.of(geometry, first, primitive, u, normals)
        assert isinstance(geometry, Mesh)
        return SurfacePoints.of(geometry, primitive, u, v, self._normal_maps[part])

    def hit_transmittance(self, hits: ClosestHits, directions: np.ndarray) -> np.ndarray:
        """Transmittance of each hit along rays (n, 3) float32: (n, 3) float32; 1 for misses."""
        result = np.where(
            (hits.geometry < 0)[:, None], np.float32(1.0), np.zeros((1, 3), np.float32)
        )
        facing = np.sum(directions * hits.ng, axis=1) < 0.0
        for part, table in enumerate(self._transmittance):
            row = np.flatnonzero(hits.geometry == part)
            if table is not None and len(row):
                at = (a[row] for a in (hits.primitive, hits.u, hits.v, directions, facing))
                result[row] = table.at(*at)
        return result

    @cached_property
    def diagonal(self) -> float:
        """Diagonal of the box of all parts."""
        low, high = self._box
        return float(np.linalg.norm(high - low))

    @property
    def _box(self) -> tuple[np.ndarray, np.ndarray]:
        """Lowest and highest corner of the box of all parts."""
        low, high = zip(*(geometry.box() for geometry in self.geometries), strict=True)
        return np.min(low, axis=0), np.max(high, axis=0)

    @cached_property
    def sides(self) -> np.ndarray:
        """Side from which each part is seen from around the asset, (parts,) int8.

        1: the side of its geometric normals. -1: the other one. 0: both, as of a leaf, or unknown,
        as of strands and where triangles let light through.
        """
        result = np.zeros(len(self.geometries), np.int8)
        if self.transmits:
            return result
        (low, high), rng = self._box, np.random.default_rng(0)
        outwards = rng.normal(size=(_RAYS_AROUND, 3))
        outwards /= np.linalg.norm(outwards, axis=1, keepdims=True)
        start = (low + high) / 2 + self.diagonal * outwards
        towards = low + (high - low) * rng.random((_RAYS_AROUND, 3)) - start
        towards = np.ascontiguousarray(towards, np.float32)
        hits = self.intersect(np.ascontiguousarray(start, np.float32), towards)
        front = np.sum(hits.ng * towards, axis=1) < 0.0
        for part, geometry in enumerate(self.geometries):
            of_part = front[hits.geometry == part]
            if len(of_part) and not isinstance(geometry, Curves):
                result[part] = int(of_part.all()) - int(not of_part.any())
        return result

    def first_opaque(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """Distance of rays (n, 3) float32 to the hit that stops light: (n,) float32, inf for none.

        Rays pass triangles whose transmittance, the mean of its channels, is PASSED or more, and
        _MOST_LAYERS of them at most.
        """
        hits = self.intersect(origins, directions)
        left = np.flatnonzero(hits.geometry >= 0) if self.transmits else np.zeros(0, int)
        layer, at = 0, hits.take(left)
        while len(left) and layer < _MOST_LAYERS:
            passed = self.hit_transmittance(at, directions[left]).mean(axis=1) >= PASSED
            left, at = left[passed], at.take(np.flatnonzero(passed))
            beyond = np.nextafter(at.t, np.float32(np.inf)) * np.float32(1.0 + 1e-6)
            at = self.intersect(origins[left], directions[left], beyond)
            hits.t[left] = at.t
            met = at.geometry >= 0
            left, at, layer = left[met], at.take(np.flatnonzero(met)), layer + 1
        return hits.t

    def transmitted(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """The product of the transmittances that rays from outside meet, (n, 3) float32."""
        rays = rays_of(origins, directions)
        if self.transmits:
            return transmitted(self._scene, strand_transmittance_filter(), rays)
        free = ~any_hits(self._scene, rays)
        return np.repeat(free.astype(np.float32)[:, None], 3, axis=1)

    def visible(
        self,
        part: int,
        points: PartPoints,
        wi: np.ndarray,
        tfar: np.ndarray | float = np.inf,
        row: np.ndarray | None = None,
    ) -> np.ndarray:
        """The visibility of the transport contract, from points of a part along `wi`.

        Whether the rays meet nothing of the asset, (n,) bool: it picks the decoder's `visible` or
        `shadowed` output. Where the asset transmits, (n, 3) float32 instead, the product of what
        all that they meet lets through, 0 for what is opaque.

        Points of a mesh: the ray starts on the side of the smooth surface that `wi` is on (see
        surface.leaving_origins), so light from behind a closed surface is blocked, because it has
        to leave through the asset.

        Points of a strand: the ray starts at the point, and passes through all of that strand.
        Light that comes through its own strand is part of the strand's scattering, and joints and
        bends shade nothing. An offset along the normal, as on meshes, cannot do this: from inside a
        cone Embree reports the exit.

        All triangles block, and all other strands, where the ray enters them: a strand that it
        starts in does not count. This is the rule of Cycles, whose shadow rays skip all segments
        of the curve they start on and all hits from inside (kernel/device/cpu/bvh.h:
        kernel_embree_is_self_intersection compares curves, not segments;
        kernel_embree_filter_occluded_func_backface_cull).

        wi: (n, 3) float32, in the scene's space; n may be 0. tfar: one number or (n,), the distance
        to the light in units of wi's length. row: (n,) which points; None for all, in order. Raises
        QueryError for other dtypes or shapes, or a segment that is not there.
        """
        wi = vectors("wi", wi, len(points if row is None else row))
        start_strand = np.full(1, NO_START, np.uint32)
        if isinstance(points, FiberPoints):
            points = points if row is None else points.take(row)
            origins, strands = vectors("positions", points.x), self._strands[part]
            check_numbers("segment", points.segment, len(strands))
            start_strand = per_ray("strand", strands[points.segment], len(points), np.uint32)
        else:
            origins = leaving_origins(points.checked(), wi, self.extent, row)
        rays = rays_of(origins, wi, 0.0, tfar, start_strand)
        if self.transmits:
            return transmitted(self._scene, strand_transmittance_filter(), rays)
        passing = start_strand_filter().ctypes.data if self._has_strands else 0
        return ~any_hits(self._scene, rays, passing)


def _strand_numbers(geometries: Sequence[Mesh | Curves]) -> list[np.ndarray]:
    """Strand of each segment by part, (m,) uint32, numbered across all parts."""
    result, start = [], 0
    for geometry in geometries:
        offsets = geometry.offsets if isinstance(geometry, Curves) else np.zeros(1, np.uint32)
        points = offsets[1:].astype(np.int64) - offsets[:-1]
        numbers = np.arange(start, start + len(points), dtype=np.uint32)
        result.append(np.repeat(numbers, points - 1))
        start += len(points)
    return result
