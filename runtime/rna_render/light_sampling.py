"""Samples of lights at points of the scene: which lights get one, and what stands in its way."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rna_render.lights import Light, LightSamples, LightSelection
from rna_render.path_numbers import CHOICES, LIGHT, LIGHTS_AT_A_VERTEX, PathNumbers
from rna_render.world import Vertices, World

# A shadow ray ends this part of its length before the light, which is a surface itself.
SHORTER = np.float32(1.0 - 2.0**-13)

# Samples that each light has where all lights have some, if it has more than one direction. The
# camera ray and the path that follows are the same for all of them: under an environment image the
# same time brings half the variance of one sample, under lamps as much.
SAMPLES_A_LIGHT = 2


@dataclass(frozen=True, slots=True)
class LightChoice:
    """One light for each of n points, (n,) its number, and (n, 2) in [0, 1) for its sample."""

    light: np.ndarray
    u: np.ndarray


class LightSampling:
    """Samples of the lights of a world, and shadow rays to them.

    At points that the camera sees, few lights all have samples; else one light is chosen, by its
    power, and has one.
    """

    def __init__(self, world: World, lights: Sequence[Light]) -> None:
        self._world = world
        self._lights = lights
        self._selection = LightSelection(lights, world.radius)
        self._delta = np.array([light.delta for light in lights], bool)

    def choose(self, numbers: PathNumbers) -> tuple[list[LightChoice], np.ndarray]:
        """Lights that get a sample at each of n points, and how many each light gets on average.

        Returns any number of choices of one light a point, and (k,) float64.
        """
        count = len(numbers.pixels)
        if not self._lights:
            return [], np.zeros(0)
        if numbers.depth == 1 and len(self._lights) <= LIGHTS_AT_A_VERTEX:
            times = np.where(self._delta, 1, SAMPLES_A_LIGHT)
            every = [
                LightChoice(np.full(count, light), numbers.square(LIGHT + light, part, parts))
                for light, parts in enumerate(times.tolist())
                for part in range(parts)
            ]
            return every, times.astype(np.float64)
        chosen = self._selection.choose(numbers.square(CHOICES)[:, 0])
        return [LightChoice(chosen, numbers.square(LIGHT))], self._selection.probability

    def sample(self, choice: LightChoice, x_world: np.ndarray) -> LightSamples:
        """A sample of each point's light; x_world: (n, 3) float32."""
        chosen = np.unique(choice.light)
        if len(chosen) == 1:
            return self._lights[int(chosen[0])].sample(x_world, choice.u)
        n = len(x_world)
        result = LightSamples(
            np.zeros((n, 3), np.float32),
            np.zeros(n, np.float32),
            np.zeros((n, 3), np.float32),
            np.zeros(n, np.float32),
        )
        for k in chosen:
            row = np.flatnonzero(choice.light == k)
            samples = self._lights[k].sample(x_world[row], choice.u[row])
            result.wi_world[row], result.distance[row] = samples.wi_world, samples.distance
            result.radiance[row], result.pdf[row] = samples.radiance, samples.pdf
        return result

    def delta(self, light: np.ndarray) -> np.ndarray:
        """Which of the given lights no ray can meet: (n,) bool."""
        return self._delta[light]

    def blocked(
        self, vertices: Vertices, row: np.ndarray, samples: LightSamples, own: np.ndarray | None
    ) -> np.ndarray:
        """Whether something stands between the given rows and their samples: (k,) bool.

        own: (k,) int32, the instances that the shadow rays pass through, if any.
        """
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
