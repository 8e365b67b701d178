"""Samples of lights at points of the scene: the lights that get one, and occlusion of the way.

Shadow catchers compare that light with what an empty scene would have.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rna_render.lights import Light, LightSamples, LightSelection
from rna_render.paths.sampling import CHOICES, LIGHT, LIGHTS_AT_A_VERTEX, NEARBY, PathNumbers
from rna_render.world.world import Vertices, World
from rna_sdk.machine.compiled import compiled

# A shadow ray ends this part of its length before the light, which is a surface itself.
SHORTER = np.float32(1.0 - 2.0**-13)


# Few lights all have samples at so many points of a path, fewer at each next one.
FULLY_LIT = 2


@dataclass(frozen=True, slots=True)
class LightChoice:
    """Samples of lights to take at points.

    row: (n,) which point each is for, ascending. light: (n,) of which light. u: (n, 2) in [0, 1).
    nearby: likewise, for estimates of nearby light; None where no body counts it.
    """

    row: np.ndarray
    light: np.ndarray
    u: np.ndarray
    nearby: np.ndarray | None = None


class LightSampling:
    """Samples of the lights of a world, and shadow rays to them.

    At the first points of a path, few lights all have samples; else one light is chosen, by its
    power, and has one. most: samples of a light at a point; None for as many as it asks for.
    """

    def __init__(self, world: World, lights: Sequence[Light], most: int | None = None) -> None:
        self._world, self._lights = world, lights
        self._selection = LightSelection(lights, world.radius)
        self._delta = np.array([light.delta for light in lights], bool)
        counts = [light.samples for light in lights]
        self._times = np.array([min(n, most or n) for n in counts], np.int64)

    def choose(self, numbers: PathNumbers) -> tuple[list[LightChoice], np.ndarray]:
        """The samples of lights at each of n points, and how many each light gets on average.

        Returns any number of choices, and (k,) float64.
        """
        row, probability = np.arange(len(numbers.pixels)), np.zeros(len(self._lights))
        if not self._lights:
            return [], probability
        if numbers.depth <= FULLY_LIT and len(self._lights) <= LIGHTS_AT_A_VERTEX:
            times = np.maximum(self._times // numbers.depth, 1)
            every = [
                LightChoice(
                    np.repeat(row, parts),
                    np.full(len(row) * parts, k),
                    numbers.square(LIGHT + k, parts),
                    self._of_nearby(numbers, LIGHT + k, parts),
                )
                for k, parts in enumerate(times.tolist())
            ]
            probability[:] = times
            return every, probability
        chosen = self._selection.choose(numbers.square(CHOICES)[:, 0])
        probability[:] = self._selection.probability
        of_nearby = self._of_nearby(numbers, LIGHT, 1)
        return [LightChoice(row, chosen, numbers.square(LIGHT), of_nearby)], probability

    def _of_nearby(self, numbers: PathNumbers, dimension: int, parts: int) -> np.ndarray | None:
        if not self._world.counts_nearby:
            return None
        return numbers.square(NEARBY + dimension, parts)

    def sample(self, choice: LightChoice, x_world: np.ndarray) -> LightSamples:
        """The samples at points x, (n, 3) float32, one for each row of the choice."""
        chosen = np.flatnonzero(np.bincount(choice.light))
        if len(chosen) == 1:
            return self._lights[int(chosen[0])].sample(x_world, choice.u)
        result = LightSamples.zeros(len(x_world))
        for k in chosen.tolist():
            row = np.flatnonzero(choice.light == k)
            samples = self._lights[k].sample(x_world[row], choice.u[row])
            for of_all, of_light in zip(result, samples, strict=True):
                of_all[row] = of_light
        return result

    @property
    def delta(self) -> np.ndarray:
        """Lights that no ray can hit: (k,) bool."""
        return self._delta

    def visibility(
        self,
        vertices: Vertices,
        row: np.ndarray,
        wi_world: np.ndarray,
        distance: np.ndarray,
        start_instance: np.ndarray | None,
    ) -> np.ndarray:
        """Transmittance of the scene between the rows and the lights along wi.

        Returns (k, 3) float32; (k, 1), 0 or 1, where nothing in the scene lets light through.
        wi_world, distance: (k, 3) and (k,) float32, as in LightSamples. start_instance: (k,) int32,
        the instances that the shadow rays pass through, if any.
        """
        origin = self._world.origins(vertices, row, wi_world)
        direction, length = np.empty_like(wi_world), np.empty_like(distance)
        _aim(vertices.x_world, row, wi_world, distance, origin, direction, length)
        scene = self._world.scene
        if scene.transmits:
            return scene.transmittance(origin, direction, length, start_instance)
        return (~scene.occluded(origin, direction, length, start_instance)).astype(np.float32)[
            :, None
        ]


@compiled(rows="row wi_world distance origin direction length", fastmath=())
def _aim(
    x_world: np.ndarray,
    row: np.ndarray,
    wi_world: np.ndarray,
    distance: np.ndarray,
    origin: np.ndarray,
    direction: np.ndarray,
    length: np.ndarray,
) -> None:
    """Directions and lengths of rays that go from their origins to just before the lights.

    The step off the surface may be longer than SHORTER leaves before a light, so rays go to the
    point of the light from where they start, not from the vertex.
    """
    for i in range(len(row)):
        squared = np.float32(0.0)
        for axis in range(3):
            direction[i, axis] = wi_world[i, axis]
            if np.isfinite(distance[i]):
                step = origin[i, axis] - x_world[row[i], axis]
                direction[i, axis] = wi_world[i, axis] * distance[i] - step
            squared += direction[i, axis] * direction[i, axis]
        length[i] = distance[i]
        if np.isfinite(distance[i]):
            length[i] = np.sqrt(squared)
            for axis in range(3):
                direction[i, axis] /= max(length[i], np.float32(1e-30))
        length[i] *= SHORTER


def caught_light(
    lighting: LightSampling, vertices: Vertices, d_world: np.ndarray, numbers: PathNumbers
) -> np.ndarray:
    """Light that arrives, and the light without occlusion: (n, 2) float32.

    Irradiance, mean of RGB, on the side that rays along d hit: no sky shines up through a floor.
    d_world: (n, 3) float32, of the rays that hit the vertices.
    """
    result = np.zeros((len(vertices), 2))
    choices, probability = lighting.choose(numbers)
    for choice in choices:
        row = choice.row
        samples = lighting.sample(choice, vertices.x_world[row])
        visibility = lighting.visibility(vertices, row, samples.wi_world, samples.distance, None)
        cosine = np.abs(np.sum(vertices.n_world[row] * samples.wi_world, axis=1))
        side = np.sum(vertices.ng_world * d_world, axis=1)[row]
        side *= np.sum(vertices.ng_world[row] * samples.wi_world, axis=1)
        cosine = np.where(side < 0.0, cosine, np.float32(0.0))
        pdf = samples.pdf * probability[choice.light]
        weight = np.divide(cosine, pdf, out=np.zeros_like(cosine), where=pdf > 0.0)
        received = (samples.radiance * visibility).mean(axis=1) * weight
        light = np.column_stack([received, samples.radiance.mean(axis=1) * weight])
        for column in range(2):
            result[:, column] += np.bincount(choice.row, light[:, column], len(vertices))
    return result.astype(np.float32)
