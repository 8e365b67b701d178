"""One sample of a band of pixels, as a wavefront: every step handles all paths of the band.

At each point where a path scatters, light is found in two ways: by samples of lights, and by the
ray that continues the path. At the first points of a path, if lights are few, each of them has
samples; else there is one, of a light chosen by its power. Where both ways can find the same
light, they share it by the power heuristic of Veach (Robust Monte Carlo Methods for Light Transport
Simulation, 1997, section 9.2). The radiance towards the viewer is the integral of L T over all
directions, where T of a neural asset is the `visible` output if the asset itself leaves the
direction free, else the `shadowed` one; so both sorts of rays pass through the instance that they
start on, and are stopped by every other.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from rna_render.image.film import Layers
from rna_render.lights import InfiniteLight, Light
from rna_render.paths.light_sampling import LightChoice, LightSampling, caught_light
from rna_render.paths.lobe_lighting import LobeLighting, lobed_rows
from rna_render.paths.sampling import (
    BRANCHES,
    CHOICES,
    DIRECTION,
    PIXEL_DIMENSION,
    ROULETTE,
    PathNumbers,
    Sampler,
)
from rna_render.paths.weighing import (
    add_rows,
    clamp_paths,
    weigh_hit,
    weigh_rays,
    weigh_samples,
    worth_tracing,
)
from rna_render.world.camera import Camera
from rna_render.world.world import Vertices, World
from rna_trace.embree.instances import CAMERA_RAY, INDIRECT_RAY
from rna_trace.embree.tracing import ClosestHits
from rna_trace.points import Role

# Paths are ended at random from this many points on.
FIRST_ROULETTE = 2

Strategy = Literal["both", "lights", "rays"]


@dataclass(frozen=True, slots=True)
class _Rays:
    """Rays of a band and what they met.

    path: (n,) place of their path in the band. origin, direction: (n, 3) float32, world space.
    beta: (n, 3) float32, throughput of their path so far. pdf: (n,) float32, density of the
    direction; None for camera rays. probability: (2, k) of each light to be sampled where the rays
    start, without lobes and with them. number: (n,) int64, see PathNumbers, for the points that
    they meet. lobed: (n,) bool, which start where lobes carry the environment; None for none.
    unweakened: (n, 3) float32, beta if the rays had not passed through anything; None without
    lobes.
    """

    path: np.ndarray
    origin: np.ndarray
    direction: np.ndarray
    hits: ClosestHits
    beta: np.ndarray
    pdf: np.ndarray | None
    probability: np.ndarray
    number: np.ndarray
    lobed: np.ndarray | None = None
    unweakened: np.ndarray | None = None


class Integrator:
    """Renders bands of pixels; several threads may each render one at once.

    lights: those of the world first, in its order. max_depth: how many points of a path may
    scatter. clamp: clamp on per-path indirect radiance; None disables it. Each of the BRANCHES
    that go on from the point that the camera sees counts for that part of a path, with its clamp.
    strategy: how light is found; anything but "both" is for tests, since each way alone misses some
    lights or is slow. next_camera: where the camera is a frame later; None for a still one. lobes:
    of these lights, to use the lobes of assets; None for rays alone.
    """

    at_once = None

    def __init__(
        self,
        world: World,
        camera: Camera,
        lights: Sequence[Light],
        max_depth: int,
        clamp: float | None = None,
        strategy: Strategy = "both",
        next_camera: Camera | None = None,
        lobes: LobeLighting | None = None,
    ) -> None:
        self._world = world
        self._camera, self._next_camera = camera, next_camera or camera
        self._lobes, own = lobes, range(len(lights))
        self._carried = set() if lobes is None else {k for k, _ in lobes.environments}
        lights = [*lights, *(() if lobes is None else lobes.bright)]
        both = strategy == "both"
        self._lights = [light.mis_compensated() for light in lights] if both else lights
        self._max_depth = max_depth
        self._branches = BRANCHES if world.scatters else 1
        self._clamp = None if clamp is None else np.float32(clamp / self._branches)
        self._strategy = strategy
        self._sampling = LightSampling(world, self._lights, own)
        self._sampling_lobed = None if lobes is None else lobes.sampling(world, self._lights)
        self._sampling_alone = LightSampling(world, lights, own)
        self.groups = sorted({light.group for light in lights} - {""})
        self._group = [self.groups.index(x.group) if x.group else None for x in lights]
        self._infinite = [
            (k, light) for k, light in enumerate(self._lights) if isinstance(light, InfiniteLight)
        ]
        self._rays_meet_lights = strategy != "lights" and not all(light.delta for light in lights)

    def render(self, pixels: np.ndarray, sampler: Sampler) -> Layers:
        """One sample of the given pixels, (n,) uint32."""
        band = Layers.empty(len(pixels), len(self.groups), np.float32)
        rays = self._camera_rays(pixels, sampler)
        self._collect(band, rays, 0)
        self._catch_shadows(band, rays, pixels, sampler)
        vertices = self._vertices(Role.SCATTER, rays)
        self._describe(band, vertices)
        for depth in range(1, self._max_depth + 1):
            if not len(vertices):
                break
            path, beta = rays.path[vertices.ray], rays.beta.take(vertices.ray, axis=0)
            numbers = PathNumbers(sampler, pixels[path], depth, rays.number[vertices.ray])
            lobed = self._add_lobes(band, vertices, path, beta) if depth == 1 else None
            choices, probability = self._choose(numbers, lobed)
            for choice, shares in choices if self._strategy != "rays" else ():
                found = self._sample_lights(vertices, choice, shares, beta)
                self._add(band, path[found.row], found.light, found.radiance, depth)
                if depth == 1:
                    band.light_samples[path, 0] += np.bincount(found.tried, minlength=len(path))
                    arrived = np.bincount(found.row, found.seen, len(path))
                    band.light_samples[path, 1] += arrived
            last = depth == self._max_depth or not self._world.scatters
            if last and not self._rays_meet_lights:
                break
            rays = self._scatter(vertices, path, beta, numbers, probability, lobed)
            self._collect(band, rays, depth)
            if last:
                break
            vertices = self._vertices(Role.SCATTER, rays)
        return band

    def _camera_rays(self, pixels: np.ndarray, sampler: Sampler) -> _Rays:
        direction = self._camera.directions(pixels, sampler.square(pixels, PIXEL_DIMENSION))
        origin = np.tile(self._camera.position, (len(pixels), 1))
        hits = self._world.scene.intersect(origin, direction, rays=CAMERA_RAY)
        beta = np.ones((len(pixels), 3), np.float32) if hits.weight is None else hits.weight
        path, never = np.arange(len(pixels)), np.zeros((2, len(self._lights)))
        number = np.full(len(pixels), sampler.sample, np.int64)
        return _Rays(path, origin, direction, hits, beta, None, never, number)

    def _vertices(self, role: Role, rays: _Rays) -> Vertices:
        return self._world.vertices(role, rays.hits, rays.direction, seen=rays.pdf is None)

    def _describe(self, band: Layers, vertices: Vertices) -> None:
        """Write the AOVs of the first hits."""
        band.beauty[vertices.ray, 3] = band.hit[vertices.ray] = 1.0
        band.normal_world[vertices.ray] = vertices.n_world
        band.position_world[vertices.ray] = vertices.x_world
        at = vertices.x_world, vertices.next_world
        if self._next_camera is not self._camera or at[0] is not at[1]:
            band.motion[vertices.ray] = self._camera.motion_to(self._next_camera, *at)
        band.asset[vertices.ray] = self._world.number[vertices.instance]

    def _collect(self, band: Layers, rays: _Rays, depth: int) -> None:
        """Add the light that rays meet which have left a point of that depth, 0 for the camera."""
        owner = rays.hits.instance
        from_camera = rays.pdf is None
        escaped = np.flatnonzero(owner < 0)
        if from_camera:
            hit_light = np.flatnonzero((owner >= 0) & (self._world.light[owner] >= 0))
            band.beauty[rays.path[hit_light], 3] = 1.0
        elif not self._rays_meet_lights:
            return
        for k, light in self._infinite:
            if from_camera and not light.visible_to_camera:
                continue
            row = escaped
            if rays.lobed is not None and k in self._carried:
                row = escaped[~rays.lobed[escaped]]
            radiance, pdf = light.eval_environment(rays.direction.take(row, axis=0))
            self._add_hit(band, rays, depth, row, k, radiance, pdf)
            if from_camera:
                band.beauty[rays.path[row], 3] = 1.0
        self._subtract_lobes(band, rays, depth)
        of_light = np.where(owner >= 0, self._world.light[owner], -1)
        for k in np.flatnonzero(np.bincount(of_light + 1)[1:]).tolist():
            hit = np.flatnonzero(of_light == k)
            radiance, pdf = self._world.lights[k].eval_hit(*self._meeting(rays, hit))
            self._add_hit(band, rays, depth, hit, k, radiance, pdf)

    def _subtract_lobes(self, band: Layers, rays: _Rays, depth: int) -> None:
        """Take away what lobes carry from directions in which rays did not find the environment."""
        if rays.lobed is None or rays.unweakened is None or self._lobes is None:
            return
        kept = (rays.hits.instance < 0).astype(np.float32)[:, None]
        if rays.hits.weight is not None:
            kept = kept * rays.hits.weight
        row = np.flatnonzero(rays.lobed & (kept != 1.0).any(axis=1))
        scale = (kept[row] - 1.0) * rays.unweakened[row]
        for k, split in self._lobes.environments:
            missing = scale * split.rest(rays.direction.take(row, axis=0))
            self._add(band, rays.path[row], np.full(len(row), k), missing, depth)

    def _meeting(
        self, rays: _Rays, hit: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, ClosestHits, np.ndarray]:
        """The arguments of ShapeLight.eval_hit."""
        hits, lines = rays.hits.take(hit), (rays.origin[hit], rays.direction[hit])
        return (*lines, hits, self._world.to_world_directions(hits.instance, hits.ng))

    def _add_hit(
        self,
        band: Layers,
        rays: _Rays,
        depth: int,
        row: np.ndarray,
        light: int,
        radiance: np.ndarray,
        pdf: np.ndarray,
    ) -> None:
        own_pdf = rays.pdf if self._strategy == "both" else None
        lobed = np.zeros(len(row), np.int8) if rays.lobed is None else rays.lobed[row].view(np.int8)
        samples = rays.probability[lobed, light]
        brought = weigh_hit(radiance, pdf, samples, own_pdf, row, rays.beta)
        self._add(band, rays.path[row], np.full(len(row), light), brought, depth)

    def _add(
        self, band: Layers, path: np.ndarray, light: np.ndarray, radiance: np.ndarray, depth: int
    ) -> None:
        """Add radiance of lights to paths; not above the clamp if it left more than one object."""
        if self._clamp is not None and depth >= 2:
            clamp_paths(radiance, self._clamp)
        add_rows(band.beauty, path, radiance)
        for k, group in enumerate(self._group):
            if group is not None:
                of_light = light == k
                add_rows(band.groups[:, group], path[of_light], radiance[of_light])

    def _add_lobes(
        self, band: Layers, vertices: Vertices, path: np.ndarray, beta: np.ndarray
    ) -> np.ndarray | None:
        """Add what lobes carry, and tell which vertices have them, (m,) bool; None if none has."""
        if self._lobes is None or not (lobed := lobed_rows(vertices)).any():
            return None
        for rows, free, lights in self._lobes.light(self._world, vertices):
            for k, radiance in lights:
                self._add(band, path[rows], np.full(len(radiance), k), beta[rows] * radiance, 1)
            band.light_samples[path[rows]] += np.column_stack([np.ones_like(free), free])
        return lobed

    def _choose(
        self, numbers: PathNumbers, lobed: np.ndarray | None
    ) -> tuple[list[tuple[LightChoice, np.ndarray]], np.ndarray]:
        """Samples of lights at points, each with how many each light gets, (k,) float64.

        lobed: (n,) bool, which points have lobes; None for none. The second is (2, k), how many
        without and with lobes.
        """
        if lobed is None or self._sampling_lobed is None:
            choices, shares = self._sampling.choose(numbers)
            return [(choice, shares) for choice in choices], np.stack([shares, shares])
        found, of_kind = [], []
        for which, sampling in enumerate((self._sampling, self._sampling_lobed)):
            row = np.flatnonzero(lobed == bool(which))
            choices, shares = sampling.choose(numbers.take(row))
            found += [(replace(x, row=row[x.row]), shares) for x in choices if len(row)]
            of_kind.append(shares)
        return found, np.stack(of_kind)

    def _sample_lights(
        self,
        vertices: Vertices,
        choice: LightChoice,
        probability: np.ndarray,
        beta: np.ndarray,
    ) -> _Found:
        """Light from samples of lights, and which of them arrive. beta: of the vertices' paths."""
        world = self._world
        samples = self._sampling.sample(choice, vertices.x_world.take(choice.row, axis=0))
        tried = worth_tracing(samples, choice, vertices, world)
        kept = self._sampling.kept(vertices, tried.row, tried.wi_world, tried.distance, tried.own)
        free, kept = tried.where_kept(kept)
        row, instance = free.row, vertices.instance.take(free.row)
        wi = world.to_object_directions(instance, free.wi_world)
        distance = free.distance / world.scale.take(instance)
        radiance, seen = np.empty((len(row), 3), np.float32), np.empty(len(row), np.float32)
        own_pdf = np.zeros(len(row), np.float32)
        for part, place, points in vertices.local_rows(row):
            at = place, wi[part], distance[part]
            if self._rays_meet_lights:
                radiance[part], seen[part], own_pdf[part] = points.transport_and_pdf(*at)
            else:
                radiance[part], seen[part] = points.transport(*at)
        weigh_samples(
            radiance,
            seen,
            (samples.radiance, samples.pdf),
            (free.sample, row, free.light),
            kept,
            own_pdf,
            (probability, self._sampling.delta),
            beta,
        )
        return _Found(tried.row, row, free.light, radiance, seen)

    def _scatter(
        self,
        vertices: Vertices,
        path: np.ndarray,
        beta: np.ndarray,
        numbers: PathNumbers,
        probability: np.ndarray,
        lobed: np.ndarray | None,
    ) -> _Rays:
        """Continue the paths, with rays in directions of their bodies' choice.

        lobed: (m,) bool, which vertices have lobes; None for none.
        """
        world = self._world
        row, branches = np.arange(len(vertices)), 1
        if numbers.depth == 1:
            branches = self._branches
            beta = beta / np.float32(branches)
        if lobed is not None and not world.scatters:
            row = np.flatnonzero(~lobed)  # the lobes are all there is
        if numbers.depth >= FIRST_ROULETTE:
            # As often as if the path had not been split.
            largest = np.maximum(np.maximum(beta[:, 0], beta[:, 1]), beta[:, 2])
            survival = np.minimum(largest * self._branches, 1.0)
            row = np.flatnonzero(numbers.square(ROULETTE)[:, 0] < survival)
            beta = beta / np.maximum(survival, np.float32(1e-30))[:, None]
        numbers = numbers.take(row)
        u = np.column_stack(
            [numbers.square(DIRECTION, branches), numbers.square(CHOICES, branches)[:, 1]]
        )
        assert numbers.number is not None
        number = (numbers.number[:, None] * branches + np.arange(branches)).reshape(-1)
        row = np.repeat(row, branches)
        wi, pdf = np.zeros((len(row), 3), np.float32), np.zeros(len(row), np.float32)
        for part, place, points in vertices.local_rows(row):
            wi[part], pdf[part] = points.sample_and_pdf(place, u[part])
        instance = vertices.instance[row]
        direction = world.to_world_directions(instance, wi)
        origin = world.origins(vertices, row, direction)
        hits = world.scene.intersect(origin, direction, vertices.own[row], INDIRECT_RAY)
        transport, distance = np.zeros_like(wi), hits.t / world.scale[instance]
        of_lobed = None if lobed is None else lobed[row]
        # A ray into a black sky, or one that lobes carry, brings nothing, whatever T is.
        lit: np.ndarray | slice = slice(None)
        if not self._infinite or (of_lobed is not None and hits.weight is None):
            seeks = np.zeros(len(row), bool) if of_lobed is None else ~of_lobed
            lit = np.flatnonzero((hits.instance >= 0) | (seeks & bool(self._infinite)))
        for part, place, points in vertices.local_rows(row[lit]):
            at = part if isinstance(lit, slice) else lit[part]
            transport[at], _ = points.transport(place, wi[at], distance[at])
        unweakened = None
        if of_lobed is not None:
            unweakened = transport.copy()
            weigh_rays(unweakened, pdf, None, row, beta)
        weigh_rays(transport, pdf, hits.weight, row, beta)
        found = hits, transport, pdf, probability, number, of_lobed, unweakened
        return _Rays(path[row], origin, direction, *found)

    def _catch_shadows(
        self, band: Layers, rays: _Rays, pixels: np.ndarray, sampler: Sampler
    ) -> None:
        """Records the light that shadow catchers receive, and the radiance behind them."""
        vertices = self._vertices(Role.CATCH_SHADOWS, rays)
        if not len(vertices):
            return
        at = vertices.ray
        numbers = PathNumbers(sampler, pixels[at], 1)
        band.catcher[at] = 1.0
        band.caught[at] = caught_light(self._sampling_alone, vertices, rays.direction[at], numbers)
        for k, light in self._infinite:
            if light.visible_to_camera:
                radiance, _ = light.eval_environment(rays.direction[at])
                radiance = radiance * rays.beta.take(at, axis=0)
                band.behind_catcher[at, :3] += radiance
                band.behind_catcher[at, 3] = 1.0
                if (group := self._group[k]) is not None:
                    band.groups_behind[at, group] += radiance


@dataclass(frozen=True, slots=True)
class _Found:
    """Light that was found by sampling lights.

    tried: vertices for which there was light to be found. row: (k,) vertices that nothing else
    keeps it from; both may name a vertex more than once. light: (k,) which one it was. radiance:
    (k, 3) float32, along the path to the camera. seen: (k,) float32, from 0 to 1, how much of the
    light all that is in the way leaves in sight, the body itself included.
    """

    tried: np.ndarray
    row: np.ndarray
    light: np.ndarray
    radiance: np.ndarray
    seen: np.ndarray
