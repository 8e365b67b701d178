"""Environments by lobes, where the camera sees an asset that has them.

There the lobes carry the light of the whole environment, without what is far brighter than its
surroundings, as if nothing but the asset were there. Samples of lights find the bright part. The
rays that continue the path bring the difference: one that meets another thing has its radiance,
without what the lobes carry from that direction; one that escapes has what they do not carry.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from rna_render.lights import EnvironmentImageLight, EnvironmentLight, Light
from rna_render.lights.split_light import SplitLight, split_light
from rna_render.paths.light_sampling import LightSampling
from rna_render.paths.sampling import LIGHTS_AT_A_VERTEX
from rna_render.world.world import Vertices, World


class LobeLighting:
    """The environments among some lights, split.

    as_directions: what is bright are delta lights, free of noise, instead of images.

    Attributes:
        environments: places of the lights that lobes stand for, and what they are split into.
        bright: lights that have samples instead, at points with lobes.
    """

    def __init__(self, lights: Sequence[Light], as_directions: bool = False) -> None:
        self.environments: list[tuple[int, SplitLight]] = [
            (k, split_light(light, as_directions))
            for k, light in enumerate(lights)
            if isinstance(light, EnvironmentLight | EnvironmentImageLight)
        ]
        self.bright = [light for _, split in self.environments for light in split.bright]

    def sampling(self, world: World, lights: Sequence[Light]) -> LightSampling:
        """Samples of lights at points with lobes; lights: the others', then `bright`."""
        carried = {k for k, _ in self.environments}
        only = [k for k in range(len(lights)) if k not in carried]
        deltas = sum(light.delta for light in self.bright)
        return LightSampling(world, lights, only, LIGHTS_AT_A_VERTEX + deltas)

    def light(
        self, world: World, vertices: Vertices
    ) -> Iterator[tuple[slice, np.ndarray, list[tuple[int, np.ndarray]]]]:
        """For each part with lobes its rows, how free their mirror directions are, and the light.

        The light: place of the environment, and (n, 3) float32, radiance towards the viewer.
        """
        for rows, points in vertices.parts:
            if not points.gives_lobes:
                continue
            amplitudes, axes, free = points.lobes()
            instance = np.repeat(vertices.instance[rows], axes.shape[1])
            turned = world.to_world_directions(instance, axes.reshape(-1, 3)).reshape(axes.shape)
            light = [(k, split.light(amplitudes, turned)) for k, split in self.environments]
            yield rows, free, light


def lobed_rows(vertices: Vertices) -> np.ndarray:
    """Which vertices have lobes: (m,) bool."""
    lobed = np.zeros(len(vertices), bool)
    for rows, points in vertices.parts:
        lobed[rows] = points.gives_lobes
    return lobed
