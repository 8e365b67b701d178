"""Lights for tests, made as scene files make them, and what rays that are traced find of them."""

from typing import Any

import numpy as np
from pydantic import TypeAdapter

from rna_render.lights import InfiniteLight, Light, LightSamples, MeshLight, PlacedLight, make_light
from rna_render.scene.light_models import LightModel
from rna_trace.embree import TriangleScene
from rna_trace.embree.tracing import ClosestHits, GeometryScene, closest_hits, rays_of

ADAPTER: TypeAdapter[Any] = TypeAdapter(LightModel)


def light(type: str, **fields: Any) -> Light:
    """A light as a scene file describes it; paths are those of the file system."""
    return make_light(ADAPTER.validate_python({"type": type, **fields}))


def at(x: tuple[float, float, float], n: int) -> np.ndarray:
    """One point n times: (n, 3) float32."""
    return np.tile(np.float32(x), (n, 1))


def samples(of: Light, x: tuple[float, float, float], n: int) -> LightSamples:
    """n samples from one point, stratified: n is a square of a whole number."""
    side = round(n**0.5)
    assert side * side == n
    i, j = np.meshgrid(np.arange(side), np.arange(side), indexing="ij")
    strata = np.stack([i.ravel(), j.ravel()], axis=1)
    u = (strata + np.random.default_rng(1).random((n, 2))) / side
    return of.sample(at(x, n), u)


def independent_samples(of: Light, x: tuple[float, float, float], n: int) -> LightSamples:
    return of.sample(at(x, n), np.random.default_rng(2).random((n, 2)))


class Quad:
    """A MeshLight, and the geometry that an object would have: four triangles of a bent band.

    They shine with 1, 0, 3 and 2 times (1 + u) in the three channels.
    """

    positions = np.float32(
        [[-1, 0, 0], [-1, 1, 0.2], [0, 0, 0.3], [0, 1, 0], [1, 0, 0], [1, 1.3, -0.4]]
    )
    triangles = np.uint32([[0, 2, 1], [1, 2, 3], [2, 4, 3], [3, 4, 5]])
    strength = np.float32([1, 0, 3, 2])

    def __init__(self) -> None:
        self.light = MeshLight(
            self.positions, self.triangles, self.strength * 4.0 / 3.0, self.emission, "mesh"
        )
        self.scene = TriangleScene([(self.positions, self.triangles)])

    def emission(self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        value = self.strength[triangle] * (np.float32(1) + u)
        return np.tile(value[:, None], (1, 3))


def radiance_and_pdf(
    of: Light | Quad, x: tuple[float, float, float], d_world: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Radiance (n, 3) and density (n,) that rays from x find: 0 where they find no light."""
    if isinstance(of, InfiniteLight):
        return of.eval_environment(d_world)
    shape = of.light if isinstance(of, Quad) else of
    x_world, hits = at(x, len(d_world)), _traced(of, x, d_world)
    hit = hits.geometry >= 0
    radiance, pdf = np.zeros((len(hit), 3), np.float32), np.zeros(len(hit), np.float32)
    ng_world = (hits.ng @ _placed(of)[1][:3, :3].T).astype(np.float32)
    lines = x_world[hit], d_world[hit]
    radiance[hit], pdf[hit] = shape.eval_hit(*lines, hits.take(np.flatnonzero(hit)), ng_world[hit])
    return radiance, pdf


def distances(of: Light | Quad, x: tuple[float, float, float], d_world: np.ndarray) -> np.ndarray:
    """From x to the light's surface along each direction, or infinity: (n,) float32."""
    return _traced(of, x, d_world).t


def _placed(of: Light | Quad) -> tuple[GeometryScene, np.ndarray]:
    if isinstance(of, Quad):
        return of.scene, np.eye(4)
    assert isinstance(of, PlacedLight)
    return of.scene, of.world_from_object


def _traced(
    of: Light | Quad, x_world: tuple[float, float, float], d_world: np.ndarray
) -> ClosestHits:
    scene, matrix = _placed(of)
    object_from_world = np.linalg.inv(matrix)
    x = at(tuple(object_from_world[:3, :3] @ x_world + object_from_world[:3, 3]), len(d_world))
    d = (d_world @ object_from_world[:3, :3].T).astype(np.float32)
    return closest_hits(scene.handle, rays_of(x, d))
