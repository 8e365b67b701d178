"""One sample of a band of pixels, as a wavefront: every step handles all paths of the band.

At each point where a path scatters, light is found in two ways: by samples of lights, and by the
ray that continues the path. Where the camera sees a point and lights are few, each of them has a
sample; else there is one, of a light chosen by its power. Where both ways can find the same
light, they share it by the power heuristic of Veach (Robust Monte Carlo Methods for Light Transport
Simulation, 1997, section 9.2). The radiance towards the viewer is the integral of L T over all
directions, where T of a neural asset is the `visible` output if the asset itself leaves the
direction free, else the `shadowed` one; so both sorts of rays pass through the instance that they
start on, and are stopped by every other.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from rna_render.camera import Camera
from rna_render.film import Layers
from rna_render.instances import CAMERA_RAY, INDIRECT_RAY
from rna_render.lights import InfiniteLight, Light, LightSamples, LightSelection
from rna_render.points import Role
from rna_render.sampling import Sampler
from rna_render.tracing import ClosestHits
from rna_render.world import Vertices, World

# So few lights that each of them has a sample at the first point of a path.
FEW_LIGHTS = 4

# Dimensions of the sampler: the place in the pixel, then these at each point of a path, with one
# for each light that has a sample there.
PIXEL_DIMENSION = 0
CHOICES, DIRECTION, ROULETTE, LIGHT = 1, 2, 3, 4
DIMENSIONS_A_VERTEX = 3 + FEW_LIGHTS

# Paths are ended at random from this many points on.
FIRST_ROULETTE = 3

# A shadow ray ends this part of its length before the light, which is a surface itself.
SHORTER = np.float32(1.0 - 2.0**-13)

Strategy = Literal["both", "lights", "rays"]


@dataclass(frozen=True, slots=True)
class _Rays:
    """Rays of a band and what they met.

    path: (n,) place of their path in the band. origin, direction: (n, 3) float32, world space.
    beta: (n, 3) float32, throughput of their path so far. pdf: (n,) float32, density of the
    direction; None for camera rays. probability: of each light to be sampled where the rays start.
    """

    path: np.ndarray
    origin: np.ndarray
    direction: np.ndarray
    hits: ClosestHits
    beta: np.ndarray
    pdf: np.ndarray | None
    probability: np.ndarray


class Integrator:
    """Renders bands of pixels.

    lights: those of the world first, in its order. max_depth: how many points of a path may
    scatter. on_first_hits: called once, when the first camera rays have been traced. strategy:
    how light is found; anything but "both" is for tests, since each way alone misses some lights
    or is slow.
    """

    def __init__(
        self,
        world: World,
        camera: Camera,
        lights: Sequence[Light],
        max_depth: int,
        on_first_hits: Callable[[], None] = lambda: None,
        strategy: Strategy = "both",
    ) -> None:
        self._world = world
        self._camera = camera
        self._lights = lights
        self._max_depth = max_depth
        self._on_first_hits: Callable[[], None] | None = on_first_hits
        self._strategy = strategy
        self._selection = LightSelection(lights, world.radius)
        self.groups = sorted({light.group for light in lights} - {""})
        self._group = [self.groups.index(x.group) if x.group else None for x in lights]
        self._infinite = [k for k, light in enumerate(lights) if isinstance(light, InfiniteLight)]
        self._rays_meet_lights = strategy != "lights" and not all(light.delta for light in lights)

    def render(self, pixels: np.ndarray, sampler: Sampler) -> Layers:
        """One sample of the given pixels, (n,) uint32."""
        band = Layers.empty(len(pixels), len(self.groups), np.float32)
        rays = self._camera_rays(pixels, sampler)
        self._collect(band, rays)
        self._catch_shadows(band, rays, pixels, sampler)
        vertices = self._vertices(Role.SCATTER, rays)
        self._describe(band, vertices)
        for depth in range(1, self._max_depth + 1):
            if not len(vertices):
                break
            path, beta = rays.path[vertices.ray], rays.beta[vertices.ray]
            numbers = _Numbers(sampler, pixels[path], depth)
            choices, probability = self._choose_lights(numbers, depth)
            for number, light in enumerate(choices):
                u = numbers.square(LIGHT + number)
                found = self._sample_lights(vertices, light, probability, u)
                self._add(band, path[found.row], found.light, beta[found.row] * found.radiance)
                if depth == 1:
                    band.light_samples[path[found.tried], 0] += 1.0
                    band.light_samples[path[found.row], 1] += found.seen
            last = depth == self._max_depth or not self._world.scatters
            if last and not self._rays_meet_lights:
                break
            rays = self._scatter(vertices, path, beta, numbers, probability)
            self._collect(band, rays)
            if last:
                break
            vertices = self._vertices(Role.SCATTER, rays)
        return band

    def _camera_rays(self, pixels: np.ndarray, sampler: Sampler) -> _Rays:
        direction = self._camera.directions(pixels, sampler.square(pixels, PIXEL_DIMENSION))
        origin = np.tile(self._camera.position, (len(pixels), 1))
        hits = self._world.scene.intersect(origin, direction, rays=CAMERA_RAY)
        if self._on_first_hits is not None:
            self._on_first_hits()
            self._on_first_hits = None
        beta = np.ones((len(pixels), 3), np.float32)
        path, never = np.arange(len(pixels)), np.zeros(len(self._lights))
        return _Rays(path, origin, direction, hits, beta, None, never)

    def _vertices(self, role: Role, rays: _Rays) -> Vertices:
        return self._world.vertices(role, rays.hits, rays.direction)

    def _describe(self, band: Layers, vertices: Vertices) -> None:
        """The AOVs of what the camera sees."""
        band.beauty[vertices.ray, 3] = band.hit[vertices.ray] = 1.0
        band.normal_world[vertices.ray] = vertices.n_world
        band.position_world[vertices.ray] = vertices.x_world
        band.asset[vertices.ray] = self._world.number[vertices.instance]

    def _collect(self, band: Layers, rays: _Rays) -> None:
        """Add the light that rays meet."""
        owner = rays.hits.owner
        from_camera = rays.pdf is None
        escaped = np.flatnonzero(owner < 0)
        if from_camera:
            hit_light = np.flatnonzero((owner >= 0) & (self._world.light[owner] >= 0))
            band.beauty[rays.path[hit_light], 3] = 1.0
        elif not self._rays_meet_lights:
            return
        for k in self._infinite:
            light = self._lights[k]
            if from_camera and not light.visible_to_camera:
                continue
            radiance, pdf = light.escaped(rays.direction[escaped])
            self._add_met(band, rays, escaped, k, radiance, pdf)
            if from_camera:
                band.beauty[rays.path[escaped], 3] = 1.0
        for k, light in enumerate(self._world.lights):
            met = np.flatnonzero((owner >= 0) & (self._world.light[owner] == k))
            if len(met):
                radiance, pdf = light.met(*self._meeting(rays, met))
                self._add_met(band, rays, met, k, radiance, pdf)

    def _meeting(self, rays: _Rays, met: np.ndarray) -> tuple[np.ndarray, ...]:
        """The arguments of ShapeLight.met."""
        hits, lines = rays.hits, (rays.origin[met], rays.direction[met])
        ng_world = self._world.to_world_directions(hits.owner[met], hits.ng[met])
        return (*lines, hits.t[met], hits.primitive[met], hits.u[met], hits.v[met], ng_world)

    def _add_met(
        self,
        band: Layers,
        rays: _Rays,
        row: np.ndarray,
        light: int,
        radiance: np.ndarray,
        pdf: np.ndarray,
    ) -> None:
        weight = rays.beta[row]
        if rays.pdf is not None and self._strategy == "both":
            weight = weight * _share(rays.pdf[row], rays.probability[light] * pdf)
        self._add(band, rays.path[row], np.full(len(row), light), weight * radiance)

    def _add(self, band: Layers, path: np.ndarray, light: np.ndarray, radiance: np.ndarray) -> None:
        """Add radiance from lights; a path is there once at most."""
        band.beauty[path, :3] += radiance
        for k, group in enumerate(self._group):
            if group is not None:
                of_light = light == k
                band.groups[path[of_light], group] += radiance[of_light]

    def _choose_lights(self, numbers: _Numbers, depth: int) -> tuple[list[np.ndarray], np.ndarray]:
        """Which lights get a sample at each point, (n,) each, and how likely each light is to."""
        if self._strategy == "rays" or not self._lights:
            return [], np.zeros(len(self._lights))
        count = len(numbers.pixels)
        if depth == 1 and len(self._lights) <= FEW_LIGHTS:
            every = [np.full(count, light) for light in range(len(self._lights))]
            return every, np.ones(len(self._lights))
        chosen = self._selection.choose(numbers.square(CHOICES)[:, 0])
        return [chosen], self._selection.probability

    def _sample_lights(
        self, vertices: Vertices, light: np.ndarray, probability: np.ndarray, u: np.ndarray
    ) -> _Found:
        """Light from one light a vertex, and which of it arrives."""
        world = self._world
        samples, delta = self._light_samples(light, vertices.x_world, u)
        row = np.flatnonzero((samples.pdf > 0.0) & samples.radiance.any(axis=1))
        tried = row
        row = row[~self._blocked(vertices, row, samples, vertices.own[row])]
        wi = world.to_object_directions(vertices.instance[row], samples.wi_world[row])
        local_distance = samples.distance[row] / world.scale[vertices.instance[row]]
        radiance, seen = np.zeros((len(row), 3), np.float32), np.zeros(len(row), bool)
        own_pdf = np.zeros(len(row), np.float32)
        for part, place, points in vertices.local_rows(row):
            radiance[part], seen[part] = points.transport(place, wi[part], local_distance[part])
            if self._rays_meet_lights:
                own_pdf[part] = points.pdf(place, wi[part])
        pdf = samples.pdf[row] * probability[light[row]]
        share = np.where(delta[row], 1.0, _share(pdf, own_pdf)[:, 0])
        weight = samples.radiance[row] * (share / pdf)[:, None].astype(np.float32)
        return _Found(tried, row, light[row], weight * radiance, seen)

    def _blocked(
        self, vertices: Vertices, row: np.ndarray, samples: LightSamples, own: np.ndarray | None
    ) -> np.ndarray:
        """Whether something stands between the given rows and their samples: (k,) bool."""
        wi_world, distance = samples.wi_world[row], samples.distance[row]
        origin = self._world.origins(vertices, row, wi_world)
        # The step off the surface may be longer than SHORTER leaves before the light, so rays go
        # to the point of the light from where they start, not from the vertex.
        near = np.flatnonzero(np.isfinite(distance))
        step = origin[near] - vertices.x_world[row[near]]
        aim = wi_world[near] * distance[near, None] - step
        length = np.linalg.norm(aim, axis=1)
        wi_world[near] = aim / np.maximum(length, np.float32(1e-30))[:, None]
        distance[near] = length
        return self._world.scene.occluded(origin, wi_world, distance * SHORTER, own)

    def _light_samples(
        self, light: np.ndarray, x_world: np.ndarray, u: np.ndarray
    ) -> tuple[LightSamples, np.ndarray]:
        """A sample of the given light for each point, and whether it is a delta light."""
        delta = np.array([light.delta for light in self._lights], bool)
        chosen = np.unique(light)
        if len(chosen) == 1:
            k = int(chosen[0])
            return self._lights[k].sample(x_world, u), np.full(len(x_world), delta[k])
        n = len(x_world)
        result = LightSamples(
            np.zeros((n, 3), np.float32),
            np.zeros(n, np.float32),
            np.zeros((n, 3), np.float32),
            np.zeros(n, np.float32),
        )
        for k in chosen:
            row = np.flatnonzero(light == k)
            samples = self._lights[k].sample(x_world[row], u[row])
            result.wi_world[row], result.distance[row] = samples.wi_world, samples.distance
            result.radiance[row], result.pdf[row] = samples.radiance, samples.pdf
        return result, delta[light]

    def _scatter(
        self,
        vertices: Vertices,
        path: np.ndarray,
        beta: np.ndarray,
        numbers: _Numbers,
        probability: np.ndarray,
    ) -> _Rays:
        """Continue the paths, each with a ray in a direction of its body's choice."""
        world = self._world
        row = np.arange(len(vertices))
        if numbers.depth >= FIRST_ROULETTE:
            survival = np.minimum(beta.max(axis=1), 1.0)
            row = np.flatnonzero(numbers.square(ROULETTE)[:, 0] < survival)
            beta = beta / np.maximum(survival, np.float32(1e-30))[:, None]
        u = np.column_stack([numbers.square(DIRECTION), numbers.square(CHOICES)[:, 1]])
        wi, pdf = np.zeros((len(row), 3), np.float32), np.zeros(len(row), np.float32)
        for part, place, points in vertices.local_rows(row):
            wi[part] = points.sample(place, u[row[part]])
            pdf[part] = points.pdf(place, wi[part])
        instance = vertices.instance[row]
        direction = world.to_world_directions(instance, wi)
        origin = world.origins(vertices, row, direction)
        hits = world.scene.intersect(origin, direction, vertices.own[row], INDIRECT_RAY)
        transport, distance = np.zeros_like(wi), hits.t / world.scale[instance]
        for part, place, points in vertices.local_rows(row):
            transport[part], _ = points.transport(place, wi[part], distance[part])
        scale = np.divide(1.0, pdf, out=np.zeros_like(pdf), where=pdf > 0.0)
        throughput = beta[row] * transport * scale[:, None]
        return _Rays(path[row], origin, direction, hits, throughput, pdf, probability)

    def _catch_shadows(
        self, band: Layers, rays: _Rays, pixels: np.ndarray, sampler: Sampler
    ) -> None:
        """What lights would bring to shadow catchers, and what of it arrives."""
        vertices = self._vertices(Role.CATCH_SHADOWS, rays)
        if not len(vertices):
            return
        at = vertices.ray
        band.catcher[at] = 1.0
        numbers = _Numbers(sampler, pixels[at], 1)
        choices, probability = self._choose_lights(numbers, 1)
        for number, light in enumerate(choices):
            u = numbers.square(LIGHT + number)
            arrives = self._irradiance(vertices, rays.direction[at], light, probability, u)
            band.caught[at] += arrives
        for k in self._infinite:
            if self._lights[k].visible_to_camera:
                radiance, _ = self._lights[k].escaped(rays.direction[at])
                band.behind_catcher[at, :3] += radiance
                band.behind_catcher[at, 3] = 1.0
                if (group := self._group[k]) is not None:
                    band.groups_behind[at, group] += radiance

    def _irradiance(
        self,
        vertices: Vertices,
        d_world: np.ndarray,
        light: np.ndarray,
        probability: np.ndarray,
        u: np.ndarray,
    ) -> np.ndarray:
        """Light that arrives at the vertices, and what would if nothing were in the way, (n, 2).

        It arrives on the side that rays along d hit: no sky shines up through a floor.
        """
        samples, _ = self._light_samples(light, vertices.x_world, u)
        every = np.arange(len(vertices))
        blocked = self._blocked(vertices, every, samples, None)
        cosine = np.abs(np.sum(vertices.n_world * samples.wi_world, axis=1))
        side = np.sum(vertices.ng_world * d_world, axis=1)
        side *= np.sum(vertices.ng_world * samples.wi_world, axis=1)
        cosine = np.where(side < 0.0, cosine, np.float32(0.0))
        pdf = samples.pdf * probability[light]
        weight = np.divide(cosine, pdf, out=np.zeros_like(cosine), where=pdf > 0.0)
        unblocked = samples.radiance.mean(axis=1) * weight
        return np.column_stack([unblocked * ~blocked, unblocked])


@dataclass(frozen=True, slots=True)
class _Numbers:
    """The random numbers at one depth of some paths."""

    sampler: Sampler
    pixels: np.ndarray
    depth: int

    def square(self, dimension: int) -> np.ndarray:
        """(n, 2) in [0, 1)."""
        number = (self.depth - 1) * DIMENSIONS_A_VERTEX + dimension
        return self.sampler.square(self.pixels, number)


@dataclass(frozen=True, slots=True)
class _Found:
    """Light that was found by sampling lights.

    tried: vertices for which there was light to be found. row: (k,) vertices that nothing else
    keeps it from. light: (k,) which one it was. radiance: (k, 3) float32, towards the viewer.
    seen: (k,) bool, whether the body itself leaves the light in sight.
    """

    tried: np.ndarray
    row: np.ndarray
    light: np.ndarray
    radiance: np.ndarray
    seen: np.ndarray


def _share(pdf: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Power heuristic: the part of the estimate that belongs to the first way, (n, 1) float32."""
    ratio = np.divide(other, pdf, out=np.full(len(pdf), np.inf), where=pdf > 0.0)
    return (1.0 / (1.0 + np.square(ratio))).astype(np.float32)[:, None]
