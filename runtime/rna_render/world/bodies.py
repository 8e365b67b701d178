"""Bodies of a scene: their hits, and the radiance of hits to the viewer.

One class a kind of object holds its geometry in Embree, and one holds points on it. The rest of
the renderer does not ask which kind it has.
"""

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from rna_render.lights.base import PlacedLight
from rna_render.materials import MeshObject
from rna_render.world.neural_sampling import PartLobes, PlacedLobes
from rna_render.world.placements import SceneObject
from rna_sdk.runtime import (
    Asset,
    DeformedCurves,
    DeformedMesh,
    FiberAsset,
    RestPoints,
    SurfaceAsset,
    offset_across,
)
from rna_trace.asset_parts import (
    Shape,
    part_geometry,
    part_normal_maps,
    part_transmittance,
    shaped_parts,
)
from rna_trace.embree import TriangleScene
from rna_trace.embree.tracing import ClosestHits
from rna_trace.fiber import FiberPoints
from rna_trace.hit_points import hit_points
from rna_trace.nearby import nearby_estimate
from rna_trace.normal_maps import NormalMaps
from rna_trace.parts_scene import PartPoints, PartsScene
from rna_trace.points import Arrived, Body, Points, Role
from rna_trace.surface import SurfacePoints

RestMaps = Sequence[NormalMaps | None]
"""The relief of an asset's parts at rest; None of those without."""


class AssetBody:
    """All parts of an asset. Its transport holds all scattering inside it, among all parts.

    Normals of meshes are interpolated from the corners, and not turned to the viewer; those of
    strands are those of the round cones, outward.

    Scattered rays may come from inside a solid, as from the ground that a solid stands in. What
    they meet there is black: captures see assets from outside.

    indirect: the same asset with the tier for what the camera does not see directly. shapes: of its
    parts in motion, whose decoders are evaluated at rest points; None where it is at rest.
    rest_maps: normal maps of the parts at rest, by `rest_maps_of`, for callers that have them.
    """

    role = Role.SCATTER
    passes_through = True
    one_sided = False

    def __init__(
        self,
        asset: Asset,
        indirect: Asset | None,
        shapes: Sequence[Shape] | None = None,
        rest_maps: RestMaps | None = None,
    ) -> None:
        self._parts = asset.parts
        self._indirect = asset.parts if indirect is None else indirect.parts
        self.part_count = len(self._parts)
        every = *self._parts, *self._indirect
        self.counts_nearby = any(part.nearby_lengths is not None for part in every)
        self._lobes = [PartLobes.of(part.sampling) for part in self._parts]
        pairs = shaped_parts(asset, shapes)
        self._shapes = [shape for _, shape in pairs]
        tables = [part_transmittance(*pair) for pair in pairs]
        self._rest_maps = rest_maps or rest_maps_of(asset)
        placed = zip(self._rest_maps, self._shapes, strict=True)
        maps = [m.on(s.mesh) if m and isinstance(s, DeformedMesh) else m for m, s in placed]
        self.scene = PartsScene([part_geometry(*pair) for pair in pairs], tables, maps)

    def points(self, part: int, arrived: Arrived) -> Points:
        hits, ray, wo, seen, widths, _ = arrived
        primitive, u, v = hits.primitive[ray], hits.u[ray], hits.v[ray]
        points = self.scene.points(part, primitive, u, v, hits.ng[ray])
        asset = (self._parts if seen else self._indirect)[part]
        place = _Place(self.scene, part, points, wo, self._rest_points(part, hits, ray))
        if asset.kind == "fiber":
            result: _NeuralPoints = _StrandPoints(asset, place)
        else:
            result = _MeshPoints(asset, place)
            if asset.uses_base_color:
                result.base_color = asset.base_color_at(primitive, u, v, widths)
        result.leaving = self._lobes[part].at(primitive)
        if not seen and (side := self.scene.sides[part]):
            facing = np.sum(hits.ng.take(ray, axis=0) * wo, axis=1)
            result.inside = side * facing < 0.0
        return result

    def _rest_points(self, part: int, hits: ClosestHits, ray: np.ndarray) -> RestPoints | None:
        shape, maps = self._shapes[part], self._rest_maps[part]
        if shape is None:
            return None
        if isinstance(shape, DeformedCurves):
            return shape.rest_points(hits.primitive[ray], hits.u[ray], hits.ng.take(ray, axis=0))
        primitive, u, v = hits.primitive[ray], hits.u[ray], hits.v[ray]
        rest = shape.rest_points(primitive, u, v)
        return rest if maps is None else replace(rest, axes=maps.at(rest.axes, primitive, u, v))


def rest_maps_of(asset: Asset) -> RestMaps:
    """Normal maps of an asset's parts, at rest."""
    return [part_normal_maps(part) for part in asset.parts]


class _Place(NamedTuple):
    """Points of a part, and what its decoder takes instead where the part is in motion."""

    scene: PartsScene
    part: int
    at: PartPoints
    wo: np.ndarray
    rest: RestPoints | None


class _NeuralPoints(Points):
    """Points of a part of an asset: its decoder evaluates scattering, given visibility along wi.

    leaving: lobes of rays that leave the points. inside: (m,) bool, which points are seen from
    inside a solid and send nothing; None: none is.
    """

    leaving: PlacedLobes
    tangents: np.ndarray
    inside: np.ndarray | None = None

    def __init__(self, asset: SurfaceAsset | FiberAsset, place: _Place) -> None:
        self._scene, self._part, self._at, self._wo, self._rest = place
        self._lengths = asset.nearby_lengths
        self.x, self.n = self._at.x, self._at.n
        self._query_wo = self._wo if self._rest is None else self._rest.to_rest(self._wo)

    def transport(
        self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray, u: np.ndarray | None
    ) -> tuple[np.ndarray, np.ndarray]:
        v = self._scene.visible(self._part, self._at, wi, distance, row)
        nearby = None
        if u is not None and self._lengths is not None:
            x = self._at.x.take(row, axis=0)
            nearby = nearby_estimate(self._scene, self._lengths, x, wi, u, distance)
        sent = self._sent(row, wi, v, nearby)
        if self.inside is not None:
            sent[self.inside.take(row)] = 0.0
        return sent, v if v.ndim == 1 else v.mean(axis=1)

    def transport_and_pdf(
        self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray, u: np.ndarray | None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        return *self.transport(row, wi, distance, u), self.leaving.pdf(
            self.n, self.tangents, self._wo, wi, row
        )

    def sample_and_pdf(self, row: np.ndarray, u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        wi = self.leaving.sample(self.n, self.tangents, self._wo, u, row)
        return wi, self.leaving.pdf(self.n, self.tangents, self._wo, wi, row)

    def _arguments(
        self, axes: np.ndarray, row: np.ndarray, wi: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Positions, axes, wo and wi to ask the decoder with. axes: of all points, not at rest."""
        x, wo = self.x, self._query_wo.take(row, axis=0)
        if self._rest is not None:
            x, axes = self._rest.positions, self._rest.axes
            wi = self._rest.to_rest(wi, row)
        return x.take(row, axis=0), axes.take(row, axis=0), wo, wi

    @abstractmethod
    def _sent(
        self, row: np.ndarray, wi: np.ndarray, v: np.ndarray, nearby: np.ndarray | None
    ) -> np.ndarray:
        """Transport of rows along wi, (k, 3) float32, given visibility and nearby light."""


class _MeshPoints(_NeuralPoints):
    base_color: np.ndarray | None = None

    def __init__(self, asset: SurfaceAsset, place: _Place) -> None:
        super().__init__(asset, place)
        assert isinstance(place.at, SurfacePoints)
        self._asset, self.n = asset, place.at.mapped
        self.tangents = np.zeros_like(self.n)

    def _sent(
        self, row: np.ndarray, wi: np.ndarray, v: np.ndarray, nearby: np.ndarray | None
    ) -> np.ndarray:
        color = None if self.base_color is None else self.base_color.take(row, axis=0)
        more = {} if nearby is None else {"nearby": nearby}
        return self._asset.transport(*self._arguments(self.n, row, wi), v, color, **more)


class _StrandPoints(_NeuralPoints):
    on_strands = True

    def __init__(self, asset: FiberAsset, place: _Place) -> None:
        super().__init__(asset, place)
        assert isinstance(place.at, FiberPoints)
        self._asset, self.tangents = asset, place.at.tangent
        self._h = offset_across(place.at.n, place.at.tangent, place.wo)

    def _sent(
        self, row: np.ndarray, wi: np.ndarray, v: np.ndarray, nearby: np.ndarray | None
    ) -> np.ndarray:
        x, tangents, wo, wi = self._arguments(self.tangents, row, wi)
        more = {} if nearby is None else {"nearby": nearby}
        return self._asset.transport(x, tangents, self._h[row], wo, wi, v, **more)


class ObjectBody:
    """A mesh with materials. Rays that start on it can hit it again."""

    passes_through = False
    counts_nearby = False
    one_sided = True
    part_count = 1

    def __init__(self, mesh: MeshObject) -> None:
        self.mesh = mesh
        geometry = [(mesh.positions, mesh.triangles)]
        self.scene = TriangleScene(geometry, [mesh.transmittance])
        self.role = Role.CATCH_SHADOWS if mesh.catches_shadows else Role.SCATTER

    def points(self, part: int, arrived: Arrived) -> Points:
        return _ObjectPoints(self.mesh, arrived)


class _ObjectPoints(Points):
    def __init__(self, mesh: MeshObject, arrived: Arrived) -> None:
        hits, ray, wo, _, _, lines = arrived
        triangle = hits.primitive[ray]
        at = hit_points(mesh.positions, mesh.triangles, triangle, hits.u[ray], hits.v[ray], lines)
        self.x, self.found = at.x, at
        ng = hits.ng.take(ray, axis=0)
        self.n = mesh.shading_normals(triangle=triangle, u=at.u, v=at.v, ng=ng, wo=wo)
        self._directions = self.n, ng, wo
        self._scattering = mesh.scattering(triangle=triangle, u=at.u, v=at.v)
        self._share = mesh.base_share(triangle=triangle, u=at.u, v=at.v, ng=ng, wo=wo)

    def transport(
        self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray, u: np.ndarray | None
    ) -> tuple[np.ndarray, np.ndarray]:
        return self._sent(row, self._scattering.evaluate(*self._directions, wi, row))

    def transport_and_pdf(
        self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray, u: np.ndarray | None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        radiance, pdf = self._scattering.evaluate_and_pdf(*self._directions, wi, row)
        return *self._sent(row, radiance), pdf

    def sample_and_pdf(self, row: np.ndarray, u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return self._scattering.sample_and_pdf(*self._directions, u, row)

    def _sent(self, row: np.ndarray, radiance: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        if self._share is not None:
            radiance /= self._share.take(row, axis=0)
        return radiance, np.ones(len(row), bool)


class LightBody:
    """A light that rays meet: black."""

    role = Role.SHINE
    passes_through = False
    counts_nearby = False
    one_sided = True
    part_count = 1

    def __init__(self, light: PlacedLight) -> None:
        self.scene = light.scene

    def points(self, part: int, arrived: Arrived) -> Points:
        raise NotImplementedError("a light scatters nothing")


def make_body(
    scene_object: SceneObject,
    indirect: Asset | None = None,
    shapes: Sequence[Shape] | None = None,
    rest_maps: RestMaps | None = None,
) -> Body:
    """The body of an asset, an object or a light. indirect, shapes, rest_maps: see AssetBody."""
    if isinstance(scene_object, PlacedLight):
        return LightBody(scene_object)
    if isinstance(scene_object, MeshObject):
        return ObjectBody(scene_object)
    return AssetBody(scene_object, indirect, shapes, rest_maps)
