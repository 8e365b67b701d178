"""What stands in the scene, as bodies: what rays hit, and what the hits send to the viewer.

One class a kind of thing holds its geometry in Embree, and one holds points on it. The rest of
the renderer does not ask which kind it has.
"""

from __future__ import annotations

from abc import abstractmethod
from typing import Literal, Protocol

import numpy as np

from rna_render import fiber, surface
from rna_render.embree import CurveScene, TriangleScene
from rna_render.lights.base import PlacedLight
from rna_render.materials import MeshObject
from rna_render.neural_sampling import LobeMixture
from rna_render.points import Body, Points, Role
from rna_render.tracing import ClosestHits
from rna_sdk.package import Curves
from rna_sdk.runtime import offset_across


class SurfaceAsset(Protocol):
    """What the renderer needs of a surface; rna_sdk.runtime.SurfaceAsset has it."""

    @property
    def kind(self) -> Literal["surface"]: ...

    @property
    def mesh(self) -> surface.Mesh: ...

    def evaluate(
        self, positions: np.ndarray, normals: np.ndarray, wo: np.ndarray, wi: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]: ...


class FiberAsset(Protocol):
    """What the renderer needs of fibers; rna_sdk.runtime.FiberAsset has it."""

    @property
    def kind(self) -> Literal["fiber"]: ...

    @property
    def curves(self) -> Curves: ...

    def evaluate(
        self,
        positions: np.ndarray,
        tangents: np.ndarray,
        h: np.ndarray,
        wo: np.ndarray,
        wi: np.ndarray,
    ) -> tuple[np.ndarray, np.ndarray]: ...


Asset = SurfaceAsset | FiberAsset


# The lobes that rays leave assets in, by kind; see benchmarks/importance.py.
SURFACE_LOBES = LobeMixture(uniform=0.2, cosine=0.35, mirror=0.45, mirror_kappa=20.0)
FIBER_LOBES = LobeMixture(uniform=0.3, cone=0.45, cone_scale=0.06, forward=0.25, forward_kappa=5.0)


class _NeuralPoints(Points):
    """Points of an asset: its decoder knows what scatters, and asks whether wi is free."""

    _lobes: LobeMixture
    _wo: np.ndarray
    tangents: np.ndarray

    def transport(
        self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        seen = self._visible(row, wi, distance)
        return np.where(seen[:, None], *self._evaluate(row, wi)), seen

    def sample(self, row: np.ndarray, u: np.ndarray) -> np.ndarray:
        return self._lobes.sample(
            self.n.take(row, axis=0), self.tangents.take(row, axis=0), self._wo.take(row, axis=0), u
        )

    def pdf(self, row: np.ndarray, wi: np.ndarray) -> np.ndarray:
        return self._lobes.pdf(
            self.n.take(row, axis=0),
            self.tangents.take(row, axis=0),
            self._wo.take(row, axis=0),
            wi,
        )

    @abstractmethod
    def _visible(self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray) -> np.ndarray: ...

    @abstractmethod
    def _evaluate(self, row: np.ndarray, wi: np.ndarray) -> tuple[np.ndarray, np.ndarray]: ...


class SurfaceBody:
    """A mesh. Its normals are interpolated from the corners, and not turned to the viewer."""

    role = Role.SCATTER
    passes_through = True

    def __init__(self, asset: SurfaceAsset) -> None:
        self.asset = asset
        self.scene = TriangleScene([(asset.mesh.positions, asset.mesh.triangles)])

    def points(self, hits: ClosestHits, ray: np.ndarray, wo: np.ndarray) -> Points:
        return _SurfacePoints(self, hits.primitive[ray], hits.u[ray], hits.v[ray], wo)


class _SurfacePoints(_NeuralPoints):
    _lobes = SURFACE_LOBES

    def __init__(
        self, body: SurfaceBody, triangle: np.ndarray, u: np.ndarray, v: np.ndarray, wo: np.ndarray
    ) -> None:
        self._body, self._wo = body, wo
        self._at = surface.SurfacePoints.of(body.asset.mesh, triangle, u, v)
        self.x, self.n = self._at.x, self._at.n
        self.tangents = np.zeros_like(self.n)

    def _visible(self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray) -> np.ndarray:
        return surface.visible(self._body.scene, self._at.take(row), wi, distance)

    def _evaluate(self, row: np.ndarray, wi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return self._body.asset.evaluate(
            self.x.take(row, axis=0), self.n.take(row, axis=0), self._wo.take(row, axis=0), wi
        )


class FiberBody:
    """Strands. Their normals are those of the round cones, outward."""

    role = Role.SCATTER
    passes_through = True

    def __init__(self, asset: FiberAsset) -> None:
        self.asset = asset
        self.scene = CurveScene(asset.curves.points, asset.curves.radii, asset.curves.offsets)
        self.first = asset.curves.segments()

    def points(self, hits: ClosestHits, ray: np.ndarray, wo: np.ndarray) -> Points:
        return _FiberPoints(self, hits.primitive[ray], hits.u[ray], hits.ng[ray], wo)


class _FiberPoints(_NeuralPoints):
    _lobes = FIBER_LOBES

    def __init__(
        self, body: FiberBody, segment: np.ndarray, u: np.ndarray, n: np.ndarray, wo: np.ndarray
    ) -> None:
        curves, at = body.asset.curves, (body.first, segment)
        self._body, self._segment, self._wo = body, segment, wo
        self.x = fiber.hit_points(curves.points, curves.radii, *at, u, n)
        self.n = n
        self.tangents = fiber.tangents(curves.points, *at)
        self._h = offset_across(n, self.tangents, wo)

    def _visible(self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray) -> np.ndarray:
        return fiber.visible(
            self._body.scene, self.x.take(row, axis=0), self._segment[row], wi, distance
        )

    def _evaluate(self, row: np.ndarray, wi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        at = self.x.take(row, axis=0), self.tangents.take(row, axis=0), self._h[row]
        return self._body.asset.evaluate(*at, self._wo.take(row, axis=0), wi)


class ObjectBody:
    """A mesh with materials. Rays that start on it can hit it again."""

    passes_through = False

    def __init__(self, mesh: MeshObject) -> None:
        self.mesh = mesh
        geometry = [(mesh.positions, mesh.triangles)]
        self.scene = TriangleScene(geometry, [mesh.transmittance])
        self.role = Role.CATCH_SHADOWS if mesh.catches_shadows else Role.SCATTER

    def points(self, hits: ClosestHits, ray: np.ndarray, wo: np.ndarray) -> Points:
        return _ObjectPoints(self.mesh, hits, ray, wo)


class _ObjectPoints(Points):
    def __init__(
        self, mesh: MeshObject, hits: ClosestHits, ray: np.ndarray, wo: np.ndarray
    ) -> None:
        where = hits.primitive[ray], hits.u[ray], hits.v[ray]
        self.x = surface.interpolate_positions(mesh.positions, mesh.triangles, *where)
        ng = hits.ng.take(ray, axis=0)
        self.n = mesh.shading_normals(*where, ng, wo)
        self._directions = self.n, ng, wo
        self._scattering = mesh.scattering(*where)
        self._share = mesh.own_share(*where, ng, wo)

    def transport(
        self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        radiance = self._scattering.evaluate(*self._directions, wi, row)
        if self._share is not None:
            radiance /= self._share.take(row, axis=0)
        return radiance, np.ones(len(row), bool)

    def sample(self, row: np.ndarray, u: np.ndarray) -> np.ndarray:
        return self._scattering.sample(*self._directions, u, row)

    def pdf(self, row: np.ndarray, wi: np.ndarray) -> np.ndarray:
        return self._scattering.pdf(*self._directions, wi, row)


class LightBody:
    """A light that rays meet: black."""

    role = Role.SHINE
    passes_through = False

    def __init__(self, light: PlacedLight) -> None:
        self.scene = light.scene

    def points(self, hits: ClosestHits, ray: np.ndarray, wo: np.ndarray) -> Points:
        raise NotImplementedError("a light scatters nothing")


Thing = Asset | MeshObject | PlacedLight


def make_body(thing: Thing) -> Body:
    """The body of an asset, by its kind, of an object or of a light."""
    if isinstance(thing, PlacedLight):
        return LightBody(thing)
    if isinstance(thing, MeshObject):
        return ObjectBody(thing)
    return FiberBody(thing) if thing.kind == "fiber" else SurfaceBody(thing)
