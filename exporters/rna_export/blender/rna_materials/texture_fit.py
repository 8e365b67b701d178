"""A texture that a package repeats, fitted to a colour that Cycles shows, and how far it is off."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
from rna_materials.uv_charts import LARGEST, Chart
from rna_materials.uv_render import ColourOfUv

GOOD = 0.004  # mean error that needs no finer texture
_FINER = (1, 2, 4, 8, 16)  # times the texels of the images: of values that jump between texels
_COARSE = 1024  # texels a side up to which more than 4 times are tried
_GAIN = 0.7  # of the error is left, at most, by a texture that is worth its texels


@dataclass
class Fit:
    """A texture over a chart. error: mean, over points of the surfaces that have the material."""

    chart: Chart
    texture: np.ndarray
    cutoff: float | None
    error: float


Texture = tuple[np.ndarray, float | None]
"""Texels, and the cutoff of holes."""


def best_fit(
    colour: ColourOfUv,
    tried: Iterable[Chart],
    make: Callable[[Chart, tuple[int, int]], Texture],
    error: Callable[[Chart, Texture], float],
    largest: int = LARGEST,
) -> Fit | None:
    """The first good texture, else the best, of several charts and sizes; None without charts.

    largest: texels a side, at most.
    """
    best: Fit | None = None
    for chart in tried:
        last, size = np.inf, (0, 0)
        for finer in _FINER:
            before, size = size, chart.size(colour.depends, finer, largest)
            if size == before or (finer > 4 and max(size) > _COARSE):
                break
            made = make(chart, size)
            fit = Fit(chart, *made, error(chart, made))
            if best is None or fit.error < best.error:
                best = fit
            if best.error <= GOOD:
                return best
            if fit.error > _GAIN * last:
                break
            last = fit.error
    return best


def hole_texture(value: np.ndarray, shown: np.ndarray, cutoff: float | None) -> Texture:
    """8 bit texels of a transmittance (h, w, 3), and their cutoff.

    value: what is compared with the cutoff. shown: what Cycles shows, which decides on which side
    of the cutoff a rounded texel is.
    """
    texels = np.round(255.0 * np.clip(value, 0.0, 1.0))
    if cutoff is not None:
        last = np.floor(255.0 * cutoff)
        is_hole = shown[..., :1] > 0.5
        texels = np.where(is_hole, np.maximum(texels, last + 1.0), np.minimum(texels, last))
    if cutoff is not None or (texels == texels[..., :1]).all():
        texels = texels[..., :1]
    return np.ascontiguousarray(texels, np.uint8), cutoff


def is_binary(texels: np.ndarray) -> bool:
    """Whether texels are holes or none, without any between."""
    return texels.shape[2] == 1 and set(np.unique(texels)) == {0, 255}


def hole_error(chart: Chart, made: Texture, uvs: np.ndarray, truth: np.ndarray) -> float:
    """Mean difference of a hole texture from `truth` (n, 3) at UVs (n, 2)."""
    texels, cutoff = made
    alpha = looked_up(texels, chart, uvs) / 255.0
    if cutoff is not None:
        alpha = (alpha > cutoff).astype(np.float64)
    return float(np.abs(alpha - np.clip(truth, 0.0, 1.0)).mean())


def looked_up(texels: np.ndarray, chart: Chart, uvs: np.ndarray) -> np.ndarray:
    """(n, c): a texture (h, w, c), bilinear and repeated, at UVs (n, 2): spec/RNA.md, 4.4."""
    height, width = texels.shape[:2]
    st = chart.stored(uvs.astype(np.float32)).astype(np.float64)
    x, y = st[:, 0] * width - 0.5, st[:, 1] * height - 0.5
    i, j = np.floor(x), np.floor(y)
    a, b = (x - i)[:, None], (y - j)[:, None]
    columns = [np.mod(i + k, width).astype(int) for k in (0, 1)]
    rows = [np.mod(j + k, height).astype(int) for k in (0, 1)]
    upper, lower = (
        (1.0 - a) * texels[row, columns[0]] + a * texels[row, columns[1]] for row in rows
    )
    return np.asarray((1.0 - b) * upper + b * lower)
