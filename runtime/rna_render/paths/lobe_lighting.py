"""Environments by lobes, where the camera sees an asset that has them.

There the lobes carry the light of the whole environment, as if nothing but the asset were there;
what is far brighter than its surroundings is left out, and comes as a few directional lights. The
rays that continue the path bring the difference: one that meets another thing has its radiance,
without what the lobes carry from that direction. With no other thing there are no such rays, and
no noise."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from rna_render.lights import EnvironmentImageLight, EnvironmentLight, Light, PlacedLight
from rna_render.lights.split.split_light import SplitLight, split_light
from rna_render.materials import MeshObject
from rna_render.paths.light_sampling import LightSampling
from rna_render.paths.sampling import LIGHTS_AT_A_VERTEX
from rna_render.world.placements import Placement
from rna_render.world.world import Vertices, World


class LobeLighting:
    """The environments among some lights, split.

    Attributes:
        environments: places of the lights that lobes stand for, and what they are split into.
        bright: lights that have samples instead, at points with lobes; no ray can meet them.
    """

    def __init__(self, lights: Sequence[Light]) -> None:
        self.environments: list[tuple[int, SplitLight]] = [
            (k, split_light(light))
            for k, light in enumerate(lights)
            if isinstance(light, EnvironmentLight | EnvironmentImageLight)
        ]
        self.bright = [light for _, split in self.environments for light in split.bright]

    def sampling(
        self, world: World, lights: Sequence[Light], most: int | None = None
    ) -> LightSampling:
        """Samples of lights at points with lobes; lights: the others', then `bright`.

        most: as for LightSampling.
        """
        carried = {k for k, _ in self.environments}
        only = [k for k in range(len(lights)) if k not in carried]
        return LightSampling(world, lights, only, LIGHTS_AT_A_VERTEX + len(self.bright), most)

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


def lobed_objects(world: World) -> list[int]:
    """Numbers, as in World.number, of the objects that the camera may see lobes of."""
    placed = zip(world.placements, world.number.tolist(), strict=True)
    return [number for placement, number in placed if _has_lobes(placement)]


def _has_lobes(placement: Placement) -> bool:
    asset = placement.object
    if isinstance(asset, MeshObject | PlacedLight) or placement.shapes is not None:
        return False
    return any(part.environment_form is not None for part in asset.parts)
