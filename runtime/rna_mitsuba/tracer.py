"""One step of a path: light at a vertex, and the ray to the next one."""

from typing import Any, ClassVar

import drjit as dr
import mitsuba as mi

from rna_mitsuba.lobes import Lobes
from rna_mitsuba.points import Points
from rna_mitsuba.world import NOBODY, AssetHits, World

_SHADOW_END = 1 - 1e-3
"""Shadow rays end so far before the emitter; Mitsuba's own do at 1 - 8.9e-4."""


class Path:
    """The state of paths.

    ray, pi, hits: the last ray and what it met, of Mitsuba's shapes and of assets. beta:
    throughput. L: radiance so far. eta: product of relative indices. depth: vertices before this
    one. before, pdf, is_delta: where the ray started, its density, and whether it was the only one
    to be found. active: whether the path goes on.
    """

    DRJIT_STRUCT: ClassVar = {
        "active": mi.Bool,
        "sampler": mi.Sampler,
        "ray": mi.Ray3f,
        "pi": mi.PreliminaryIntersection3f,
        "hits": AssetHits,
        "beta": mi.Color3f,
        "L": mi.Color3f,
        "eta": mi.Float,
        "depth": mi.UInt32,
        "before": mi.Interaction3f,
        "pdf": mi.Float,
        "is_delta": mi.Bool,
    }


class Vertex:
    """Path vertices: on Mitsuba's shapes (si) or on assets (points, wo in object space)."""

    def __init__(self, world: World, state: Path) -> None:
        self.hits = state.hits
        self.on_asset = state.active & (state.hits.instance != NOBODY)
        self.on_plain = state.active & ~self.on_asset
        self.si = state.pi.compute_surface_interaction(state.ray, mi.RayFlags.All, self.on_plain)
        self.points, self.wo, mixture = world.points(state.hits, state.ray, self.on_asset)
        points: Points = dr.detach(self.points)
        self.lobes = Lobes(mixture, points.axis, dr.detach(self.wo))
        self.start_instance = dr.select(self.on_asset, state.hits.instance, NOBODY)
        place = world.to_world_points(state.hits.instance, self.points.x)
        self.place = dr.zeros(mi.Interaction3f)
        self.place.p = dr.select(self.on_asset, place, self.si.p)
        self.place.t = dr.select(self.on_asset, state.hits.t, self.si.t)
        self.place.time = state.ray.time


class Tracer:
    """Paths in a scene."""

    def __init__(self, scene: mi.Scene, world: World, max_depth: int, rr_depth: int) -> None:
        self._scene, self._world = scene, world
        self._max_depth, self._rr_depth = max_depth, rr_depth
        self._context = mi.BSDFContext()
        self._has_environment = scene.environment() is not None

    def start(self, sampler: mi.Sampler, ray: mi.Ray3f, active: mi.Bool) -> Path:
        """Camera rays."""
        state = Path()
        state.active, state.sampler = mi.Bool(active), sampler
        state.ray = mi.Ray3f(ray)
        state.pi, state.hits, state.beta = self._intersect(
            state.ray, mi.UInt32(NOBODY), sampler, state.active
        )
        state.L, state.eta, state.depth = mi.Color3f(0), mi.Float(1), mi.UInt32(0)
        state.before = dr.zeros(mi.Interaction3f)
        state.pdf, state.is_delta = mi.Float(1), mi.Bool(True)
        return state

    def step(self, state: Path) -> Path:
        """Add emission and direct light at the hits, then continue the paths."""
        at = Vertex(self._world, state)
        state.L += state.beta * self._emitted(state, at)
        met = at.on_asset | (at.on_plain & at.si.is_valid())
        state.active &= met & (state.depth + 1 < self._max_depth)
        state.L += state.beta * self._direct(state, at)
        self._go_on(state, at)
        return state

    def _intersect(
        self, ray: mi.Ray3f, start_instance: mi.UInt32, sampler: mi.Sampler, active: mi.Bool
    ) -> tuple[mi.PreliminaryIntersection3f, AssetHits, mi.Color3f]:
        plain = self._scene.ray_intersect_preliminary(dr.detach(ray), coherent=False, active=active)
        far = dr.select(plain.is_valid(), plain.t, dr.inf)
        hits, weight = self._world.closest(ray, far, start_instance, sampler, active)
        return plain, hits, weight

    def _emitted(self, state: Path, at: Vertex) -> mi.Color3f:
        """Radiance emitted by Mitsuba's emitters, with MIS weights, and by assets."""
        emitter = at.si.emitter(self._scene, at.on_plain)
        ds = mi.DirectionSample3f(self._scene, at.si, state.before)
        queried = at.on_plain & ~state.is_delta
        pdf = self._scene.pdf_emitter_direction(state.before, ds, queried)
        share = dr.select(state.is_delta, 1, _share(state.pdf, pdf))
        radiance = share * emitter.eval(at.si, at.on_plain)
        radiance = dr.select(at.on_plain, radiance, 0)
        if self._world.emits:
            radiance += self._world.emission(at.hits, at.points, at.wo, at.on_asset)
        return radiance

    def _direct(self, state: Path, at: Vertex) -> mi.Color3f:
        """Light from a sample of the emitters."""
        bsdf = at.si.bsdf()
        smooth = mi.has_flag(bsdf.flags(), mi.BSDFFlags.Smooth)
        active = state.active & (at.on_asset | smooth)
        ds, light = self._scene.sample_emitter_direction(
            at.place, state.sampler.next_2d(active), False, active
        )
        active &= (ds.pdf != 0) & dr.any(light != 0)
        wi = self._world.to_object_directions(at.hits.instance, ds.d)
        shadow = self._shadow_ray(at, ds, wi)
        active &= ~self._scene.ray_test(shadow, active=active)
        left = self._world.transmittance(shadow, at.start_instance, active)
        active &= dr.any(left > 0)
        # Mitsuba's own surfaces.
        wo_local = at.si.to_local(ds.d)
        value, pdf = bsdf.eval_pdf(self._context, at.si, wo_local, active & at.on_plain)
        # Assets: the cosine is in the transport.
        on_asset = active & at.on_asset
        transport = self._world.transport(
            at.hits, at.points, at.wo, wi, ds.dist * _SHADOW_END, on_asset, state.sampler
        )
        value = dr.select(on_asset, transport, value)
        pdf = dr.select(on_asset, at.lobes.pdf(dr.detach(wi)), pdf)
        share = dr.select(ds.delta, 1, _share(ds.pdf, pdf))
        return dr.select(active, value * light * left * dr.detach(share), 0)

    def _shadow_ray(self, at: Vertex, ds: mi.DirectionSample3f, wi: mi.Vector3f) -> mi.Ray3f:
        ray = at.si.spawn_ray_to(ds.p)
        _, origin = self._world.origins(at.hits, at.points, wi)
        ray.o = dr.select(at.on_asset, origin, ray.o)
        ray.d = dr.select(at.on_asset, ds.d, ray.d)
        ray.maxt = dr.select(at.on_asset, ds.dist * _SHADOW_END, ray.maxt)
        return dr.detach(ray)

    def _go_on(self, state: Path, at: Vertex) -> None:
        """Follow a ray in a direction of the surface's choice."""
        choice, u = state.sampler.next_1d(state.active), state.sampler.next_2d(state.active)
        on_plain, on_asset = state.active & at.on_plain, state.active & at.on_asset
        bs, weight = at.si.bsdf().sample(self._context, at.si, choice, u, on_plain)
        wi = at.lobes.sample(choice, u)
        pdf = at.lobes.pdf(wi)
        _, origin = self._world.origins(at.hits, at.points, wi)
        direction = self._world.to_world_directions(at.hits.instance, wi)
        ray = at.si.spawn_ray(at.si.to_world(bs.wo))
        ray.o = dr.select(at.on_asset, origin, ray.o)
        ray.d = dr.select(at.on_asset, direction, ray.d)
        ray = dr.detach(ray)
        alive = (on_plain & dr.any(weight != 0)) | (on_asset & (pdf > 0))
        pi, hits, passed = self._intersect(ray, at.start_instance, state.sampler, alive)
        alive &= ~self._world.is_inside(hits, ray, alive)  # black
        far = dr.minimum(dr.select(pi.is_valid(), pi.t, dr.inf), hits.t)
        if not self._has_environment:
            alive &= dr.isfinite(far)  # a ray into nothing brings nothing
        on_asset &= alive
        transport = self._world.transport(
            at.hits, at.points, at.wo, wi, far, on_asset, state.sampler
        )
        weight = dr.select(at.on_asset, transport / pdf, weight)
        beta = state.beta * weight * passed
        state.eta = dr.select(on_plain, state.eta * bs.eta, state.eta)
        state.depth += 1
        survival = dr.minimum(dr.max(dr.detach(beta)) * dr.square(state.eta), 0.95)
        survival = dr.select(state.depth >= self._rr_depth, survival, 1)
        alive &= (state.sampler.next_1d(state.active) < survival) & dr.any(beta != 0)
        state.active = alive
        state.beta = dr.select(alive, beta / dr.maximum(survival, 1e-20), 0)
        state.before, state.pi, state.hits, state.ray = dr.detach(at.place), pi, hits, ray
        state.pdf = dr.select(at.on_asset, pdf, bs.pdf)
        is_delta = mi.has_flag(bs.sampled_type, mi.BSDFFlags.Delta)
        state.is_delta = dr.select(at.on_asset, False, is_delta)


def _share(pdf: mi.Float, other: mi.Float) -> mi.Float:
    """Power heuristic: the part of the estimate that belongs to the first way."""
    first, second = dr.square(pdf), dr.square(other)
    total: Any = first + second
    return dr.select(total > 0, first / dr.select(total > 0, total, 1), 0)
