"""One sample of a band of pixels, as a wavefront: every step handles all rays of the band.

Camera rays are traced, their hits sorted by asset, and then each light in turn is sampled, its
shadow rays traced, and the asset's transport evaluated in one batch an asset:

    L_o(x, wo) = sum over lights of  weight * T(x, wo, wi),

where T is the `visible` output if the asset itself leaves wi free, else the `shadowed` one, and
nothing arrives if another instance is in the way.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from rna_render.camera import Camera
from rna_render.film import Layers
from rna_render.lights import Light, LightSamples
from rna_render.sampling import Sampler
from rna_render.surface import (
    geometric_normals,
    interpolate_normals,
    interpolate_positions,
    visible,
)
from rna_render.world import World

# Dimensions of the sampler: the place in the pixel, then one for each light.
PIXEL_DIMENSION = 0
FIRST_LIGHT_DIMENSION = 1


@dataclass(frozen=True, slots=True)
class SurfacePoints:
    """What camera rays hit, m points sorted by instance (and so by asset).

    ray: (m,) place of the ray in its band. instance: (m,) int32.
    x, ng, n, wo: (m, 3) float32 in object space: point, geometric normal, shading normal (corner
        normals interpolated, not turned to the viewer) and unit direction to the viewer.
    x_world, n_world: (m, 3) float32.
    """

    ray: np.ndarray
    instance: np.ndarray
    x: np.ndarray
    ng: np.ndarray
    n: np.ndarray
    wo: np.ndarray
    x_world: np.ndarray
    n_world: np.ndarray


class Integrator:
    """Renders bands of pixels.

    background: (3,) radiance of what is seen behind the assets, or None for a transparent one.
    on_first_hits: called once, when the first camera rays have been traced.
    """

    def __init__(
        self,
        world: World,
        camera: Camera,
        lights: Sequence[Light],
        background: np.ndarray | None,
        on_first_hits: Callable[[], None] = lambda: None,
    ) -> None:
        self._world = world
        self._camera = camera
        self._lights = lights
        self._background = background
        self._on_first_hits: Callable[[], None] | None = on_first_hits
        deltas = [index for index, light in enumerate(lights) if light.delta]
        self._shown_light = deltas[0] if deltas else None

    def render(self, pixels: np.ndarray, sampler: Sampler) -> Layers:
        """One sample of the given pixels, (n,) uint32."""
        band = Layers.empty(len(pixels), np.float32)
        points = self._camera_hits(pixels, sampler)
        if self._background is not None:
            band.beauty[:] = (*self._background, 1.0)
        band.beauty[points.ray] = (0.0, 0.0, 0.0, 1.0)
        band.hit[points.ray] = 1.0
        band.normal_world[points.ray] = points.n_world
        band.position_world[points.ray] = points.x_world
        band.asset[points.ray] = self._world.number[points.instance]
        for index, light in enumerate(self._lights):
            dimension = FIRST_LIGHT_DIMENSION + index
            u = None if light.delta else sampler.square(pixels[points.ray], dimension)
            samples = light.sample(points.x_world, points.n_world, u)
            radiance, seen = self._direct_light(points, samples)
            band.beauty[points.ray, :3] += radiance
            if index == self._shown_light:
                band.visibility[points.ray] = seen
        return band

    def _camera_hits(self, pixels: np.ndarray, sampler: Sampler) -> SurfacePoints:
        world = self._world
        d_world = self._camera.directions(pixels, sampler.square(pixels, PIXEL_DIMENSION))
        hits = world.scene.intersect(np.tile(self._camera.position, (len(pixels), 1)), d_world)
        if self._on_first_hits is not None:
            self._on_first_hits()
            self._on_first_hits = None
        ray = np.flatnonzero(hits.instance >= 0)
        ray = ray[np.argsort(hits.instance[ray], kind="stable")]
        instance = hits.instance[ray]
        x, ng, n = (np.empty((len(ray), 3), np.float32) for _ in range(3))
        for asset, rows in world.asset_ranges(instance):
            mesh, hit = world.assets[asset].mesh, ray[rows]
            at = mesh.triangles, hits.triangle[hit], hits.u[hit], hits.v[hit]
            x[rows] = interpolate_positions(mesh.positions, *at)
            n[rows] = interpolate_normals(mesh.normals, *at)
            ng[rows] = geometric_normals(mesh.positions, mesh.triangles, hits.triangle[hit])
        wo = world.to_object_directions(instance, -d_world[ray])
        x_world, n_world = world.to_world_points(instance, x), world.to_world_normals(instance, n)
        return SurfacePoints(ray, instance, x, ng, n, wo, x_world, n_world)

    def _direct_light(
        self, points: SurfacePoints, light: LightSamples
    ) -> tuple[np.ndarray, np.ndarray]:
        """Radiance towards the viewer, (m, 3) float32, and whether the light is seen, (m,) bool."""
        world = self._world
        wi = world.to_object_directions(points.instance, light.wi_world)
        distance = light.distance / world.scale[points.instance]
        reached = ~world.scene.occluded_by_others(
            points.instance, points.x_world, light.wi_world, light.distance
        )
        transport = np.zeros_like(points.x)
        seen = np.zeros(len(points.ray), bool)
        for asset, rows in world.asset_ranges(points.instance):
            row = np.arange(rows.start, rows.stop)[reached[rows]]
            x, wi_row = points.x[row], wi[row]
            own = world.triangle_scenes[asset]
            seen[row] = visible(own, x, points.ng[row], wi_row, distance[row])
            outputs = world.assets[asset].evaluate(x, points.n[row], points.wo[row], wi_row)
            transport[row] = np.where(seen[row, None], *outputs)
        return light.weight * transport, seen
