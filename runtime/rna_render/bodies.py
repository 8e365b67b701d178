"""Assets as bodies in the scene: what rays hit, and what the hits send to the viewer.

One class a kind of asset holds its geometry in Embree, and one holds points on it. The rest of
the renderer does not ask which kind it has.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Literal, Protocol

import numpy as np

from rna_render import fiber, surface
from rna_render.embree import CurveScene, TriangleScene
from rna_render.tracing import ClosestHits, GeometryScene
from rna_sdk.package import Curves
from rna_sdk.runtime import offset_across


class Mesh(Protocol):
    """What the renderer reads of a mesh; arrays as in rna_sdk.package.Mesh."""

    positions: np.ndarray
    normals: np.ndarray
    triangles: np.ndarray


class SurfaceAsset(Protocol):
    """What the renderer needs of a surface; rna_sdk.runtime.SurfaceAsset has it."""

    @property
    def kind(self) -> Literal["surface"]: ...

    @property
    def mesh(self) -> Mesh: ...

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


class Points(ABC):
    """Points of one asset that are seen, and the directions to the viewer; object space.

    x, n: (m, 3) float32, points and unit normals.
    """

    x: np.ndarray
    n: np.ndarray

    def transport(
        self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Radiance towards the viewer under irradiance 1 from wi, and whether wi is free.

        row: (k,) which points. wi: (k, 3) float32, unit. distance: (k,) float32, to the light.
        Returns (k, 3) float32, and (k,) bool: whether the asset itself leaves the light in sight.
        """
        seen = self._visible(row, wi, distance)
        return np.where(seen[:, None], *self._evaluate(row, wi)), seen

    @abstractmethod
    def _visible(self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray) -> np.ndarray: ...

    @abstractmethod
    def _evaluate(self, row: np.ndarray, wi: np.ndarray) -> tuple[np.ndarray, np.ndarray]: ...


class Body(Protocol):
    """An asset with its geometry in Embree."""

    @property
    def scene(self) -> GeometryScene: ...

    def points(self, hits: ClosestHits, ray: np.ndarray, wo: np.ndarray) -> Points:
        """The points that the given rays, (m,), have hit; wo: (m, 3) float32, object space."""
        ...


class SurfaceBody:
    """A mesh. Its normals are interpolated from the corners, and not turned to the viewer."""

    def __init__(self, asset: SurfaceAsset) -> None:
        self.asset = asset
        self.scene = TriangleScene([(asset.mesh.positions, asset.mesh.triangles)])

    def points(self, hits: ClosestHits, ray: np.ndarray, wo: np.ndarray) -> Points:
        return _SurfacePoints(self, hits.primitive[ray], hits.u[ray], hits.v[ray], wo)


class _SurfacePoints(Points):
    def __init__(
        self, body: SurfaceBody, triangle: np.ndarray, u: np.ndarray, v: np.ndarray, wo: np.ndarray
    ) -> None:
        mesh = body.asset.mesh
        at = mesh.triangles, triangle, u, v
        self._body, self._wo = body, wo
        self.x = surface.interpolate_positions(mesh.positions, *at)
        self.n = surface.interpolate_normals(mesh.normals, *at)
        self._ng = surface.geometric_normals(mesh.positions, mesh.triangles, triangle)

    def _visible(self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray) -> np.ndarray:
        return surface.visible(self._body.scene, self.x[row], self._ng[row], wi, distance)

    def _evaluate(self, row: np.ndarray, wi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return self._body.asset.evaluate(self.x[row], self.n[row], self._wo[row], wi)


class FiberBody:
    """Strands. Their normals are those of the round cones, outward."""

    def __init__(self, asset: FiberAsset) -> None:
        self.asset = asset
        self.scene = CurveScene(asset.curves.points, asset.curves.radii, asset.curves.offsets)
        self.first = asset.curves.segments()

    def points(self, hits: ClosestHits, ray: np.ndarray, wo: np.ndarray) -> Points:
        return _FiberPoints(self, hits.primitive[ray], hits.u[ray], hits.ng[ray], wo)


class _FiberPoints(Points):
    def __init__(
        self, body: FiberBody, segment: np.ndarray, u: np.ndarray, n: np.ndarray, wo: np.ndarray
    ) -> None:
        curves, at = body.asset.curves, (body.first, segment)
        self._body, self._segment, self._wo = body, segment, wo
        self.x = fiber.hit_points(curves.points, curves.radii, *at, u, n)
        self.n = n
        self._tangents = fiber.tangents(curves.points, *at)
        self._h = offset_across(n, self._tangents, wo)

    def _visible(self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray) -> np.ndarray:
        return fiber.visible(self._body.scene, self.x[row], self._segment[row], wi, distance)

    def _evaluate(self, row: np.ndarray, wi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        at = self.x[row], self._tangents[row], self._h[row]
        return self._body.asset.evaluate(*at, self._wo[row], wi)


def make_body(asset: Asset) -> Body:
    """The body of an asset, by its kind."""
    return FiberBody(asset) if asset.kind == "fiber" else SurfaceBody(asset)
