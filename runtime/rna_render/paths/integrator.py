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

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from rna_render.image.film import Layers
from rna_render.lights import InfiniteLight, Light
from rna_render.paths.bands import BAND
from rna_render.paths.light_sampling import LightChoice, LightSampling, caught_light
from rna_render.paths.path_arrays import (
    KINDS,
    STRAND,
    Paths,
    Rays,
    WeightedSamples,
    point_kinds,
)
from rna_render.paths.sampling import (
    BRANCHES,
    LENS_DIMENSION,
    PIXEL_DIMENSION,
    ROULETTE,
    STRAND_BRANCHES,
    STRAND_SAMPLES,
    PathNumbers,
    Sampler,
)
from rna_render.paths.solid_glass import SolidGlass
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
from rna_trace.points import Role

# Paths are ended at random from this many points on.
FIRST_ROULETTE = 2

Strategy = Literal["both", "lights", "rays"]


class Integrator:
    """Renders bands of pixels; several threads may each render one at once.

    lights: those of the world first, in its order. max_depth: how many points of a path may
    scatter. clamp: clamp on per-path indirect radiance; None disables it. Each of the rays that go
    on from the point that the camera sees counts for that part of a path, with its clamp.
    strategy: how light is found; anything but "both" is for tests, since each way alone misses some
    lights or is slow. next_camera: where the camera is a frame later; None for a still one.
    """

    at_once, band, samples = None, BAND, 1

    def __init__(
        self,
        world: World,
        camera: Camera,
        lights: Sequence[Light],
        *,
        max_depth: int,
        clamp: float | None = None,
        strategy: Strategy = "both",
        next_camera: Camera | None = None,
    ) -> None:
        self._world = world
        self._camera, self._next_camera = camera, next_camera or camera
        self._glass = SolidGlass(world)
        both = strategy == "both"
        self._lights = [light.mis_compensated() for light in lights] if both else lights
        self._max_depth = max_depth
        self._branches = np.full(KINDS, BRANCHES)
        self._branches[STRAND] = STRAND_BRANCHES
        if not world.scatters:
            self._branches[:] = 1
        self._clamp = None if clamp is None else np.float32(clamp)
        self._strategy = strategy
        most = (None, STRAND_SAMPLES)
        self._samplings = [LightSampling(world, self._lights, n) for n in most]
        self._sampling = self._samplings[0]
        self._sampling_alone = LightSampling(world, lights)
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
            paths = self._paths(vertices, rays, pixels, sampler, depth)
            path = paths.path
            choices, probability = self._choose(paths)
            for choice, shares in choices if self._strategy != "rays" else ():
                samples = self._sample_lights(vertices, choice, shares, paths.beta)
                self._add(
                    band,
                    path=path[samples.row],
                    light=samples.light,
                    radiance=samples.radiance,
                    share=paths.share[samples.row],
                    depth=depth,
                )
                if depth == 1:
                    band.light_samples[path, 0] += np.bincount(samples.tried, minlength=len(path))
                    arrived = np.bincount(samples.row, samples.seen, len(path))
                    band.light_samples[path, 1] += arrived
            last = depth == self._max_depth or not self._world.scatters
            if last and not self._rays_meet_lights:
                break
            rays = self._scatter(vertices, paths, probability)
            self._collect(band, rays, depth)
            if last:
                break
            vertices = self._vertices(Role.SCATTER, rays)
        band.squares = np.square(band.beauty[:, :3], dtype=np.float64)
        return band

    def _camera_rays(self, pixels: np.ndarray, sampler: Sampler) -> Rays:
        direction = self._camera.directions(pixels, sampler.square(pixels, PIXEL_DIMENSION))
        origin = np.tile(self._camera.position, (len(pixels), 1))
        if self._camera.has_lens:
            on_lens = sampler.square(pixels, LENS_DIMENSION)
            origin, direction = self._camera.through_lens(direction, on_lens)
        hits = self._world.scene.intersect(origin, direction, rays=CAMERA_RAY)
        number, bent = np.full(len(pixels), sampler.sample, np.int64), None
        if self._glass:
            origin, direction, hits, bent = self._glass.follow(
                origin, direction, hits, sampler, pixels, number, 0
            )
        beta = np.ones((len(pixels), 3), np.float32) if hits.weight is None else hits.weight
        return Rays(
            path=np.arange(len(pixels)),
            origin=origin,
            direction=direction,
            hits=hits,
            beta=beta,
            pdf=None,
            kind=np.zeros(len(pixels), np.int8),
            probability=np.zeros((KINDS, len(self._lights))),
            share=np.ones(len(pixels), np.float32),
            number=number,
            bent=bent,
        )

    def _paths(
        self, vertices: Vertices, rays: Rays, pixels: np.ndarray, sampler: Sampler, depth: int
    ) -> Paths:
        path, kind = rays.path[vertices.ray], np.zeros(len(vertices), np.int8)
        if depth == 1:
            kind = point_kinds(vertices)
        numbers = PathNumbers(sampler, pixels[path], depth, rays.number[vertices.ray])
        beta, share = rays.beta.take(vertices.ray, axis=0), rays.share[vertices.ray]
        return Paths(path, beta, share, kind, numbers)

    def _vertices(self, role: Role, rays: Rays) -> Vertices:
        spread = self._camera.spread
        return self._world.vertices(
            role,
            hits=rays.hits,
            origin=rays.origin,
            d_world=rays.direction,
            seen=rays.pdf is None,
            spread=spread,
        )

    def _describe(self, band: Layers, vertices: Vertices) -> None:
        """Write the AOVs of the first hits."""
        band.beauty[vertices.ray, 3] = band.hit[vertices.ray] = 1.0
        band.normal_world[vertices.ray] = vertices.n_world
        band.position_world[vertices.ray] = vertices.x_world + self._world.origin
        x_world, after = vertices.x_world, vertices.next_world
        if self._next_camera is not self._camera or x_world is not after:
            motion = self._camera.motion_to(self._next_camera, x_world, after)
            band.motion[vertices.ray] = motion
        band.asset[vertices.ray] = self._world.number[vertices.instance]

    def _collect(self, band: Layers, rays: Rays, depth: int) -> None:
        """Add the light that rays meet which have left a point of that depth, 0 for the camera."""
        owner = rays.hits.instance
        from_camera = rays.pdf is None
        escaped = np.flatnonzero(owner < 0)
        if from_camera:
            covers = (owner >= 0) & (self._world.light[owner] >= 0)
            if rays.bent is not None:
                covers |= rays.bent
            band.beauty[rays.path[covers], 3] = 1.0
        elif not self._rays_meet_lights:
            return
        for k, light in self._infinite:
            row = escaped
            if from_camera and not light.visible_to_camera:
                if rays.bent is None:
                    continue
                row = escaped[rays.bent[escaped]]
            radiance, pdf = light.eval_environment(rays.direction.take(row, axis=0))
            self._add_hit(band, rays, depth, row, k, radiance, pdf)
            if from_camera:
                band.beauty[rays.path[row], 3] = 1.0
        of_light = np.where(owner >= 0, self._world.light[owner], -1)
        for k in np.flatnonzero(np.bincount(of_light + 1)[1:]).tolist():
            hit = np.flatnonzero(of_light == k)
            hits = rays.hits.take(hit)
            ng_world = self._world.to_world_directions(hits.instance, hits.ng)
            radiance, pdf = self._world.lights[k].eval_hit(
                rays.origin[hit], rays.direction[hit], hits, ng_world
            )
            self._add_hit(band, rays, depth, hit, k, radiance, pdf)

    def _add_hit(
        self,
        band: Layers,
        rays: Rays,
        depth: int,
        row: np.ndarray,
        light: int,
        radiance: np.ndarray,
        pdf: np.ndarray,
    ) -> None:
        light_pdf = rays.pdf if self._strategy == "both" else None
        samples = rays.probability[rays.kind[row], light]
        brought = weigh_hit(radiance, pdf, samples, light_pdf, row, rays.beta)
        of_light = np.full(len(row), light)
        self._add(band, rays.path[row], of_light, brought, rays.share[row], depth)

    def _add(
        self,
        band: Layers,
        path: np.ndarray,
        light: np.ndarray,
        radiance: np.ndarray,
        share: np.ndarray,
        depth: int,
    ) -> None:
        """Add radiance of lights to paths; not above the clamp if it left more than one object."""
        if self._clamp is not None and depth >= 2:
            clamp_paths(radiance, self._clamp * share, path, band.clamped)
        add_rows(band.beauty, path, radiance)
        for k, group in enumerate(self._group):
            if group is not None:
                of_light = light == k
                add_rows(band.groups[:, group], path[of_light], radiance[of_light])

    def _choose(self, paths: Paths) -> tuple[list[tuple[LightChoice, np.ndarray]], np.ndarray]:
        """Samples of lights at points, each with how many each light gets, (k,) float64.

        The second is (KINDS, k), how many at points of each kind.
        """
        chosen, of_kind = [], np.zeros((KINDS, len(self._lights)))
        for kind in np.flatnonzero(np.bincount(paths.kind)).tolist():
            row = np.flatnonzero(paths.kind == kind)
            choices, of_kind[kind] = self._samplings[kind].choose(paths.numbers.take(row))
            chosen += [(replace(choice, row=row[choice.row]), of_kind[kind]) for choice in choices]
        return chosen, of_kind

    def _sample_lights(
        self, vertices: Vertices, choice: LightChoice, probability: np.ndarray, beta: np.ndarray
    ) -> WeightedSamples:
        """Light from samples of lights, and which of them arrive. beta: of the vertices' paths."""
        world = self._world
        samples = self._sampling.sample(choice, vertices.x_world.take(choice.row, axis=0))
        tried = worth_tracing(samples, choice, vertices, world)
        visibility = self._sampling.visibility(
            vertices, tried.row, tried.wi_world, tried.distance, tried.start_instance
        )
        free, visibility = tried.where_visible(visibility)
        row, instance = free.row, vertices.instance.take(free.row)
        wi = world.to_object_directions(instance, free.wi_world)
        distance = free.distance / world.scale.take(instance)
        radiance, seen = np.empty((len(row), 3), np.float32), np.empty(len(row), np.float32)
        light_pdf = np.zeros(len(row), np.float32)
        u = None if choice.nearby is None else choice.nearby.take(free.sample, axis=0)
        for part, place, points in vertices.local_rows(row):
            near = None if u is None else u[part]
            if self._rays_meet_lights:
                radiance[part], seen[part], light_pdf[part] = points.transport_and_pdf(
                    place, wi[part], distance[part], near
                )
            else:
                radiance[part], seen[part] = points.transport(place, wi[part], distance[part], near)
        weigh_samples(
            radiance,
            seen,
            samples,
            free,
            visibility,
            light_pdf,
            probability,
            self._sampling.delta,
            beta,
        )
        return WeightedSamples(tried.row, row, free.light, radiance, seen)

    def _scatter(self, vertices: Vertices, paths: Paths, probability: np.ndarray) -> Rays:
        """Continue the paths, with rays in directions of their bodies' choice."""
        world, numbers, beta, share = self._world, paths.numbers, paths.beta, paths.share
        row, branches = np.arange(len(vertices)), np.ones(len(vertices), np.int64)
        if numbers.depth == 1:
            branches = self._branches[paths.kind]
            share = (share / branches).astype(np.float32)
            beta = beta * share[:, None]
        if numbers.depth >= FIRST_ROULETTE:
            # As often as if the path had not been split.
            largest = np.maximum(np.maximum(beta[:, 0], beta[:, 1]), beta[:, 2])
            survival = np.minimum(largest / share, 1.0)
            row = np.flatnonzero(numbers.square(ROULETTE)[:, 0] < survival)
            beta = beta / np.maximum(survival, np.float32(1e-30))[:, None]
        drawn = numbers.take(row).of_branches(branches[row], world.counts_nearby)
        u, number, of_nearby = drawn
        row = np.repeat(row, branches[row])
        wi, pdf = np.zeros((len(row), 3), np.float32), np.zeros(len(row), np.float32)
        for part, place, points in vertices.local_rows(row):
            wi[part], pdf[part] = points.sample_and_pdf(place, u[part])
        instance = vertices.instance[row]
        direction = world.to_world_directions(instance, wi)
        origin = world.origins(vertices, row, direction)
        hits = world.scene.intersect(origin, direction, vertices.start_instance[row], INDIRECT_RAY)
        transport, distance = np.zeros_like(wi), hits.t / world.scale[instance]
        bent = None
        if self._glass:
            pixels, depth = numbers.pixels[row], numbers.depth
            behind = self._glass.follow(
                origin, direction.copy(), hits, numbers.sampler, pixels, number, depth
            )
            origin, direction, hits, bent = behind
        # A ray into a black sky brings nothing, whatever T is.
        lit = slice(None) if self._infinite else np.flatnonzero(hits.instance >= 0)
        for part, place, points in vertices.local_rows(row[lit]):
            at = part if isinstance(lit, slice) else lit[part]
            near = None if of_nearby is None else of_nearby[at]
            transport[at], _ = points.transport(place, wi[at], distance[at], near)
        weigh_rays(transport, pdf, hits.weight, row, beta)
        if bent is not None:
            pdf[bent] = np.inf  # no sample of a light finds what they find
        return Rays(
            path=paths.path[row],
            origin=origin,
            direction=direction,
            hits=hits,
            beta=transport,
            pdf=pdf,
            kind=paths.kind[row],
            probability=probability,
            share=share[row],
            number=number,
            bent=bent,
        )

    def _catch_shadows(
        self, band: Layers, rays: Rays, pixels: np.ndarray, sampler: Sampler
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
