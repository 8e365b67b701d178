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

from rna_render.bodies import Points
from rna_render.camera import Camera
from rna_render.film import Layers
from rna_render.lights import Light, LightSamples
from rna_render.sampling import Sampler
from rna_render.world import World

# Dimensions of the sampler: the place in the pixel, then one for each light.
PIXEL_DIMENSION = 0
FIRST_LIGHT_DIMENSION = 1


@dataclass(frozen=True, slots=True)
class CameraHits:
    """What camera rays hit, m points sorted by instance (and so by asset).

    ray: (m,) place of the ray in its band. instance: (m,) int32.
    assets: for each asset that was hit its rows, and its points in object space.
    x_world, n_world: (m, 3) float32, points and normals.
    """

    ray: np.ndarray
    instance: np.ndarray
    assets: list[tuple[slice, Points]]
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
        hits = self._camera_hits(pixels, sampler)
        if self._background is not None:
            band.beauty[:] = (*self._background, 1.0)
        band.beauty[hits.ray] = (0.0, 0.0, 0.0, 1.0)
        band.hit[hits.ray] = 1.0
        band.normal_world[hits.ray] = hits.n_world
        band.position_world[hits.ray] = hits.x_world
        band.asset[hits.ray] = self._world.number[hits.instance]
        for index, light in enumerate(self._lights):
            dimension = FIRST_LIGHT_DIMENSION + index
            u = None if light.delta else sampler.square(pixels[hits.ray], dimension)
            samples = light.sample(hits.x_world, hits.n_world, u)
            radiance, seen = self._direct_light(hits, samples)
            band.beauty[hits.ray, :3] += radiance
            if index == self._shown_light:
                band.visibility[hits.ray] = seen
        return band

    def _camera_hits(self, pixels: np.ndarray, sampler: Sampler) -> CameraHits:
        world = self._world
        d_world = self._camera.directions(pixels, sampler.square(pixels, PIXEL_DIMENSION))
        hits = world.scene.intersect(np.tile(self._camera.position, (len(pixels), 1)), d_world)
        if self._on_first_hits is not None:
            self._on_first_hits()
            self._on_first_hits = None
        ray = np.flatnonzero(hits.owner >= 0)
        ray = ray[np.argsort(hits.owner[ray], kind="stable")]
        instance = hits.owner[ray]
        wo = world.to_object_directions(instance, -d_world[ray])
        x, n = (np.empty((len(ray), 3), np.float32) for _ in range(2))
        assets = []
        for asset, rows in world.asset_ranges(instance):
            points = world.bodies[asset].points(hits, ray[rows], wo[rows])
            x[rows], n[rows] = points.x, points.n
            assets.append((rows, points))
        x_world, n_world = world.to_world_points(instance, x), world.to_world_normals(instance, n)
        return CameraHits(ray, instance, assets, x_world, n_world)

    def _direct_light(self, hits: CameraHits, light: LightSamples) -> tuple[np.ndarray, np.ndarray]:
        """Radiance towards the viewer, (m, 3) float32, and whether the light is seen, (m,) bool."""
        world = self._world
        wi = world.to_object_directions(hits.instance, light.wi_world)
        distance = light.distance / world.scale[hits.instance]
        reached = ~world.scene.occluded_by_others(
            hits.instance, hits.x_world, light.wi_world, light.distance
        )
        transport = np.zeros_like(hits.x_world)
        seen = np.zeros(len(hits.ray), bool)
        for rows, points in hits.assets:
            local = np.flatnonzero(reached[rows])
            row = rows.start + local
            transport[row], seen[row] = points.transport(local, wi[row], distance[row])
        return light.weight * transport, seen
