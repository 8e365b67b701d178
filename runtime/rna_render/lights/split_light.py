"""An environment in two: what lobes of assets carry, and what is far brighter, for samples."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from rna_render.lights.base import Light
from rna_render.lights.bright_directions import (
    COLUMNS,
    ROWS,
    SplitEnvironment,
    cell_flux,
    rest_of_texels,
    split_environment,
)
from rna_render.lights.directional import DirectionalLight
from rna_render.lights.environment import EnvironmentImageLight, EnvironmentLight
from rna_render.lights.equirectangular import EquirectangularImage
from rna_render.lights.prefilter import PrefilteredEnvironment
from rna_render.scene.light_models import DirectionalModel


@dataclass(frozen=True)
class SplitLight:
    """An environment light in two, which together have its light.

    Attributes:
        whole: the environment.
        bright: what is far brighter than its surroundings; may be none.
    """

    whole: EnvironmentLight | EnvironmentImageLight
    bright: tuple[Light, ...]
    _sky: PrefilteredEnvironment
    _excess: EnvironmentImageLight | None
    _angle: float
    _scale: np.ndarray

    def light(self, amplitudes: np.ndarray, axes_world: np.ndarray) -> np.ndarray:
        """Radiance to the viewer, without that of `bright`; see PrefilteredEnvironment.light."""
        return self._sky.light(amplitudes, axes_world, self._angle, self._scale)

    def rest(self, d_world: np.ndarray) -> np.ndarray:
        """Radiance from directions, (n, 3) float32, without that of `bright`: (n, 3) float32."""
        radiance, _ = self.whole.eval_environment(d_world)
        if self._excess is not None:
            radiance -= self._excess.eval_environment(d_world)[0]
        return radiance


def split_light(
    light: EnvironmentLight | EnvironmentImageLight, as_directions: bool = False
) -> SplitLight:
    """The environment in two.

    as_directions: what is bright is at most MOST directions; else an image, with all its light
    where it was.
    """
    scale = np.asarray(light.model.radiance, np.float32)
    if isinstance(light, EnvironmentLight):
        return SplitLight(light, (), _even_sky(), None, 0.0, scale)
    split, sky, image = _of_image(light.untouched)
    angle = float(np.radians(light.model.rotation_deg))
    excess = None if image is None else EnvironmentImageLight(light.model, image)
    bright: Sequence[Light] = () if excess is None else (excess,)
    if as_directions:
        bright = _directional_lights(split, light, angle)
    return SplitLight(light, tuple(bright), sky, excess, angle, scale)


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
def _of_image(
    image: EquirectangularImage,
) -> tuple[SplitEnvironment, PrefilteredEnvironment, EquirectangularImage | None]:
    """Its split; the rest; what the rest is without, None for nothing."""
    texels = image.texels
    split = split_environment(texels)
    rest = rest_of_texels(texels, split)
    excess = None if (split.share == 1.0).all() else EquirectangularImage(texels - rest)
    return split, PrefilteredEnvironment(cell_flux(rest)), excess
