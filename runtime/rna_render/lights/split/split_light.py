"""An environment in two: what lobes of assets carry, and what is far brighter, as directions."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from rna_render.lights.base import Light
from rna_render.lights.equirectangular import EquirectangularImage
from rna_render.lights.kinds.directional import DirectionalLight
from rna_render.lights.kinds.environment import EnvironmentImageLight, EnvironmentLight
from rna_render.lights.split.bright_directions import (
    COLUMNS,
    ROWS,
    SplitEnvironment,
    split_environment,
)
from rna_render.lights.split.prefilter import PrefilteredEnvironment
from rna_render.scene.light_models import DirectionalModel

# How sharply lobes see an environment: few are narrower. A sharper rest would have small bright
# places, which rays seldom find and lobes do not have.
REST_KAPPA = np.float32(32.0)


@dataclass(frozen=True)
class SplitLight:
    """An environment light in two, which together have its light.

    Attributes:
        bright: what is far brighter than its surroundings: at most MOST directions.
    """

    bright: tuple[Light, ...]
    _sky: PrefilteredEnvironment
    _angle: float
    _scale: np.ndarray

    def light(self, amplitudes: np.ndarray, axes_world: np.ndarray) -> np.ndarray:
        """Radiance to the viewer, without that of `bright`; see PrefilteredEnvironment.light."""
        return self._sky.light(amplitudes, axes_world, self._angle, self._scale)

    def rest(self, d_world: np.ndarray) -> np.ndarray:
        """Radiance from directions, without that of `bright`, as lobes see it.

        d_world: (n, 3) float32, unit. Returns (n, 3) float32.
        """
        return self.light(np.ones((len(d_world), 1, 3), np.float32), REST_KAPPA * d_world[:, None])


def split_light(light: EnvironmentLight | EnvironmentImageLight) -> SplitLight:
    """The environment in two."""
    scale = np.asarray(light.model.radiance, np.float32)
    if isinstance(light, EnvironmentLight):
        return SplitLight((), _even_sky(), 0.0, scale)
    split, sky = _of_image(light.untouched)
    angle = float(np.radians(light.model.rotation_deg))
    return SplitLight(tuple(_directional_lights(split, light, angle)), sky, angle, scale)


def _directional_lights(
    split: SplitEnvironment, light: EnvironmentImageLight, angle: float
) -> list[Light]:
    c, s = np.cos(angle), np.sin(angle)
    turned = split.directions @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T
    irradiance = split.flux * np.asarray(light.model.radiance)
    return [
        DirectionalLight(
            DirectionalModel(
                type="directional",
                direction=tuple(towards.tolist()),
                irradiance=tuple(flux.tolist()),
                group=light.group,
            )
        )
        for towards, flux in zip(turned, irradiance, strict=True)
    ]


@lru_cache(maxsize=1)
def _even_sky() -> PrefilteredEnvironment:
    return PrefilteredEnvironment(np.full((ROWS, COLUMNS, 3), 4.0 * np.pi / (ROWS * COLUMNS)))


@lru_cache(maxsize=4)
def _of_image(image: EquirectangularImage) -> tuple[SplitEnvironment, PrefilteredEnvironment]:
    split = split_environment(image.texels)
    return split, PrefilteredEnvironment(split.rest)
