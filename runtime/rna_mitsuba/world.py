"""All assets of a scene, placed, beside the shapes that Mitsuba itself traces."""

from typing import Any, ClassVar

import drjit as dr
import mitsuba as mi

from rna_mitsuba.lobes import PointMixture
from rna_mitsuba.nearby import nearby_estimate
from rna_mitsuba.points import Points
from rna_mitsuba.shape import RnaShape
from rna_mitsuba.tracing import NO_STRAND, Hits

NOBODY = 0xFFFFFFFF
"""Number of the instance where there is none."""


class Placement:
    """A similarity between an asset's object space and the world."""

    def __init__(self, shape: RnaShape) -> None:
        matrix = shape.to_world.matrix
        linear = mi.Matrix3f(*(matrix[i, j] for i in range(3) for j in range(3)))
        self.scale = dr.power(dr.abs(dr.det(linear)), 1 / 3)
        self._rotation = linear / self.scale
        self._back = self._rotation.T
        self._origin = mi.Point3f(*(matrix[k, 3] for k in range(3)))

    def point(self, x: mi.Point3f) -> mi.Point3f:
        """Object to world."""
        return mi.Point3f(self._rotation @ mi.Vector3f(x) * self.scale) + self._origin

    def direction(self, d: mi.Vector3f) -> mi.Vector3f:
        """Object to world, as long as before."""
        return self._rotation @ d

    def object_point(self, x: mi.Point3f) -> mi.Point3f:
        """World to object."""
        return mi.Point3f(self._back @ mi.Vector3f(x - self._origin) / self.scale)

    def object_direction(self, d: mi.Vector3f) -> mi.Vector3f:
        """World to object, as long as before."""
        return self._back @ d


class AssetHits(Hits):
    """Closest hits on assets: t in the world, and which instance it was, NOBODY for misses."""

    DRJIT_STRUCT: ClassVar = {**Hits.DRJIT_STRUCT, "instance": mi.UInt32}

    def __init__(self, instance: Any = None, **of_hits: Any) -> None:
        super().__init__(**of_hits)
        self.instance = instance


class World:
    """The assets of a scene as the integrator queries them."""

    def __init__(self, shapes: list[RnaShape]) -> None:
        self._shapes = shapes
        self._places = [Placement(shape) for shape in shapes]
        self.has_fibers = any(g.is_fiber for shape in shapes for g in shape.loaded.scene.geometries)
        every = [part for shape in shapes for part in shape.loaded.evaluators]
        self.counts_nearby = any(part.nearby is not None for part in every)
        self.emits = any(shape.loaded.emits for shape in shapes)
        self.transmits = any(shape.loaded.scene.transmits for shape in shapes)
        self._sides = [shape.loaded.scene.sides for shape in shapes]  # not in the loop of paths

    def closest(
        self,
        ray: mi.Ray3f,
        far: mi.Float,
        start_instance: mi.UInt32,
        sampler: mi.Sampler,
        active: mi.Bool,
    ) -> tuple[AssetHits, mi.Color3f]:
        """The first hits nearer than far, except on `start_instance`, and weights of passed hits.

        Where a hit lets light through, the ray goes on at random, as often as it does.
        """
        best = AssetHits(
            t=mi.Float(far),
            part=mi.UInt32(0),
            primitive=mi.UInt32(0),
            u=mi.Float(0),
            v=mi.Float(0),
            instance=mi.UInt32(NOBODY),
        )
        weight = mi.Color3f(1)
        for k, (shape, place) in enumerate(zip(self._shapes, self._places, strict=True)):
            o, d = place.object_point(ray.o), place.object_direction(ray.d)
            o, d, scale = dr.detach(o), dr.detach(d), dr.detach(place.scale)
            tested = active & (start_instance != k)
            hits, passed = _closest(shape, o, d, best.t / scale, sampler, tested)
            nearer = tested & dr.isfinite(hits.t) & (hits.t * scale < best.t)
            weight *= dr.select(tested, passed, 1)
            candidate = AssetHits(
                t=hits.t * scale,
                part=hits.part,
                primitive=hits.primitive,
                u=hits.u,
                v=hits.v,
                instance=mi.UInt32(k),
            )
            best = dr.select(nearer, candidate, best)
        best.t = dr.select(best.instance == NOBODY, dr.inf, best.t)
        return best, weight

    def points(
        self, hits: AssetHits, ray: mi.Ray3f, active: mi.Bool
    ) -> tuple[Points, mi.Vector3f, PointMixture]:
        """Points of hits and wo, both in object space; the lobes that rays leave them in."""
        points, wo, mixture = dr.zeros(Points), mi.Vector3f(0, 0, 1), dr.zeros(PointMixture)
        for k, (shape, place) in enumerate(zip(self._shapes, self._places, strict=True)):
            o, d = place.object_point(ray.o), place.object_direction(ray.d)
            wo = dr.select(hits.instance == k, -d, wo)
            for part, geometry in enumerate(shape.loaded.scene.geometries):
                here = active & (hits.instance == k) & (hits.part == part)
                way = d * (hits.t / dr.detach(place.scale)) if geometry.is_fiber else d
                at = geometry.points(hits.primitive, hits.u, hits.v, o, way, here)
                points = dr.select(here, at, points)
                for first, lobes in shape.loaded.mixtures[part]:
                    mixture = dr.select(here & (hits.primitive >= first), lobes, mixture)
        return points, wo, mixture

    def is_inside(self, hits: AssetHits, ray: mi.Ray3f, active: mi.Bool) -> mi.Bool:
        """Whether scattered rays meet parts from the inside of solids, which nothing captures."""
        result = mi.Bool(False)
        for k, (shape, place) in enumerate(zip(self._shapes, self._places, strict=True)):
            d, scene = place.object_direction(ray.d), shape.loaded.scene
            for part, side in enumerate(self._sides[k]):
                if side:
                    here = active & (hits.instance == k) & (hits.part == part)
                    result |= here & (side * scene.facing(part, hits, d, here) > 0)
        return result

    def to_world_points(self, instance: mi.UInt32, x: mi.Point3f) -> mi.Point3f:
        """Points from the object space of their instances to world space."""
        result = mi.Point3f(0)
        for k, place in enumerate(self._places):
            result = dr.select(instance == k, place.point(x), result)
        return result

    def to_world_directions(self, instance: mi.UInt32, d: mi.Vector3f) -> mi.Vector3f:
        """Directions from the object space of their instances to world space."""
        result = mi.Vector3f(0, 0, 1)
        for k, place in enumerate(self._places):
            result = dr.select(instance == k, place.direction(d), result)
        return result

    def to_object_directions(self, instance: mi.UInt32, d: mi.Vector3f) -> mi.Vector3f:
        """Directions from world space to the object space of their instances."""
        result = mi.Vector3f(0, 0, 1)
        for k, place in enumerate(self._places):
            result = dr.select(instance == k, place.object_direction(d), result)
        return result

    def origins(
        self, hits: AssetHits, points: Points, wi: mi.Vector3f
    ) -> tuple[mi.Point3f, mi.Point3f]:
        """Origins of rays along wi (object space), in object space and in the world."""
        step, origin_world = mi.Float(0), mi.Point3f(0)
        for k, shape in enumerate(self._shapes):
            step = dr.select(hits.instance == k, shape.loaded.scene.step, step)
        origin = points.origin(wi, step)
        for k, place in enumerate(self._places):
            here = hits.instance == k
            origin_world = dr.select(here, place.point(origin), origin_world)
        return origin, origin_world

    def transport(
        self,
        hits: AssetHits,
        points: Points,
        wo: mi.Vector3f,
        wi: mi.Vector3f,
        distance: mi.Float,
        active: mi.Bool,
        sampler: mi.Sampler,
    ) -> mi.Color3f:
        """T of the contract, wo and wi in object space; distance: to the light, in the world."""
        u = sampler.next_2d(active) if self.counts_nearby else None
        total = mi.Color3f(0)
        origin, _ = self.origins(hits, points, dr.detach(wi))
        for k, (shape, place) in enumerate(zip(self._shapes, self._places, strict=True)):
            mine, scene = active & (hits.instance == k), shape.loaded.scene
            far = distance / dr.detach(place.scale)
            v = scene.visibility(
                dr.detach(origin), dr.detach(wi), dr.detach(far), hits.part, points.strand, mine
            )
            for part, evaluator in enumerate(shape.loaded.evaluators):
                here = mine & (hits.part == part)
                at = points.query(wo) | {"wi": wi}
                at = scene.query(part, hits, points, at, here)
                if evaluator.nearby is not None:
                    lengths = evaluator.nearby.lengths
                    at["nearby"] = nearby_estimate(scene, lengths, points.x, wi, far, u, here)
                total = dr.select(here, evaluator.transport(v, at, here), total)
        return total

    def emission(
        self, hits: AssetHits, points: Points, wo: mi.Vector3f, active: mi.Bool
    ) -> mi.Color3f:
        """L_e of the contract."""
        total = mi.Color3f(0)
        for k, shape in enumerate(self._shapes):
            for part, evaluator in enumerate(shape.loaded.evaluators):
                here = active & (hits.instance == k) & (hits.part == part)
                if evaluator.emits:
                    at = points.query(wo)
                    at = shape.loaded.scene.query(part, hits, points, at, here)
                    (emitted,) = evaluator.decode("emission", at, here)
                    total = dr.select(here, emitted, total)
        return total

    def transmittance(
        self, ray: mi.Ray3f, start_instance: mi.UInt32, active: mi.Bool
    ) -> mi.Color3f:
        """Transmittance of all instances but `start_instance` along shadow rays."""
        result = mi.Color3f(1)
        for k, (shape, place) in enumerate(zip(self._shapes, self._places, strict=True)):
            o, d = place.object_point(ray.o), place.object_direction(ray.d)
            tested, far = active & (start_instance != k), ray.maxt / place.scale
            v = shape.loaded.scene.visibility(
                dr.detach(o),
                dr.detach(d),
                dr.detach(far),
                mi.UInt32(NOBODY),
                mi.UInt32(NO_STRAND),
                tested,
            )
            result = dr.select(tested, result * v, result)
        return result


def _closest(
    shape: RnaShape,
    o: mi.Point3f,
    d: mi.Vector3f,
    far: mi.Float,
    sampler: mi.Sampler,
    active: mi.Bool,
) -> tuple[Hits, mi.Color3f]:
    """First hit that stops a ray, in object space, and the transmittance of those before it."""
    scene = shape.loaded.scene
    if scene.is_plain:
        return scene.closest(o, d, far, active), mi.Color3f(1)
    nothing = Hits(mi.Float(dr.inf), mi.UInt32(0), mi.UInt32(0), mi.Float(0), mi.Float(0))

    def go_on(weight, near, last, going, result, o, d, far, sampler):  # type: ignore[no-untyped-def]
        hits = scene.closest(o + near * d, d, far - near, going)
        going = going & dr.isfinite(hits.t)
        hits.t = hits.t + near
        part, strand = mi.UInt32(NOBODY), mi.UInt32(NO_STRAND)
        tau = scene.hit_transmittance(hits, o + hits.t * d, d, part, strand, going)
        number = hits.primitive * len(scene.geometries) + hits.part
        tau = dr.select(number == last, mi.Color3f(1), tau)
        chance = dr.clip(dr.mean(tau), 0, 1)
        passes = sampler.next_1d(going) < chance
        share = dr.select(passes, tau / dr.maximum(chance, 1e-20), (1 - tau) / (1 - chance))
        weight = dr.select(going, weight * share, weight)
        result = dr.select(going & ~passes, hits, result)
        last = dr.select(scene.is_fiber(hits.part), mi.UInt32(NO_STRAND), number)
        return weight, hits.t + scene.step, last, going & passes, result, o, d, far, sampler

    start = mi.Color3f(1), mi.Float(0), mi.UInt32(NO_STRAND), mi.Bool(active), nothing
    state = dr.while_loop(
        (*start, o, d, far, sampler), lambda *state: state[3], go_on, label="closest"
    )
    return state[4], state[0]
