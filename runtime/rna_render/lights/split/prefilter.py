"""An environment seen through blurred spots: its mean under von Mises-Fisher distributions.

The mean of radiance under the density c(k) exp(k d.axis), c(k) = k / (4 pi sinh k), is tabulated
for LEVELS concentrations k from 0.25 to 128, each twice the last. A level is a square grid of axes
in the octahedral map about +y: (x, z) / (|x| + |y| + |z|) in the upper half, and in the lower one
the same folded out over the square's edges; samples lie on the vertices of the grid, the first
and the last on the edges. Between them the mean is bilinear, and linear in log2 k between levels;
beyond the first and the last level it is that of the nearest.
"""

from __future__ import annotations

import math

import numpy as np

from rna_render.lights.split.bright_directions import cell_directions
from rna_sdk.machine.compiled import compiled

SIDES = (17, 17, 17, 17, 17, 33, 33, 33, 65, 65)
"""Vertices a side of each level."""
LEVELS = len(SIDES)
FIRST_KAPPA = 0.25

_STARTS = np.cumsum([0, *(side * side for side in SIDES)])
_SIDES = np.array(SIDES)
_AT_ONCE = 512  # axes


class PrefilteredEnvironment:
    """Means of an environment under von Mises-Fisher distributions.

    Attributes:
        means: (n, 3) float32, radiance: of all levels, each row by row, along x first.
    """

    def __init__(self, flux: np.ndarray) -> None:
        """flux: (ROWS, COLUMNS, 3), as SplitEnvironment.rest."""
        cells = cell_directions().astype(np.float32)
        radiance = flux.reshape(-1, 3).astype(np.float32) * np.float32(len(cells) / (4.0 * np.pi))
        means = []
        for level, side in enumerate(SIDES):
            kappa = np.float32(FIRST_KAPPA * 2.0**level)
            axes = octahedral_directions(side)
            for start in range(0, len(axes), _AT_ONCE):
                weights = np.exp(kappa * (axes[start : start + _AT_ONCE] @ cells.T - 1))
                means.append(weights @ radiance / weights.sum(axis=1, keepdims=True))
        self.means = np.concatenate(means)

    def light(
        self, amplitudes: np.ndarray, axes: np.ndarray, angle: float, scale: np.ndarray
    ) -> np.ndarray:
        """Radiance that lobes send to the viewer: (n, 3) float32.

        amplitudes: (n, L, 3) float32. axes: (n, L, 3) float32, kappa times unit vectors, in the
        world. angle: radians that the environment is turned about +y, as EquirectangularImage.
        scale: (3,), of the environment's radiance.
        """
        result = np.empty((len(axes), 3), np.float32)
        _light(self.means, amplitudes, axes, np.cos(angle), np.sin(angle), result)
        result *= np.asarray(scale, np.float32)
        return result


def octahedral_directions(side: int) -> np.ndarray:
    """Of the vertices of a level's grid: (side * side, 3) float32, unit."""
    at = np.linspace(-1.0, 1.0, side)
    x, z = np.tile(at, side), np.repeat(at, side)
    y = 1.0 - np.abs(x) - np.abs(z)
    below = np.maximum(-y, 0.0)
    d = np.stack([x - np.copysign(below, x), y, z - np.copysign(below, z)], axis=1)
    return np.asarray(d / np.linalg.norm(d, axis=1, keepdims=True), np.float32)


@compiled(rows="axes amplitudes result")
def _light(
    means: np.ndarray,
    amplitudes: np.ndarray,
    axes: np.ndarray,
    cosine: float,
    sine: float,
    result: np.ndarray,
) -> None:
    c, s = np.float32(cosine), np.float32(sine)
    for i in range(len(axes)):
        r, g, b = np.float32(0.0), np.float32(0.0), np.float32(0.0)
        for j in range(axes.shape[1]):
            ax, ay, az = axes[i, j, 0], axes[i, j, 1], axes[i, j, 2]
            # Against the turn of the environment.
            mean = _mean(means, c * ax - s * az, ay, s * ax + c * az)
            r += amplitudes[i, j, 0] * mean[0]
            g += amplitudes[i, j, 1] * mean[1]
            b += amplitudes[i, j, 2] * mean[2]
        result[i, 0], result[i, 1], result[i, 2] = r, g, b


@compiled()
def _mean(
    means: np.ndarray, x: np.float32, y: np.float32, z: np.float32
) -> tuple[np.float32, np.float32, np.float32]:
    kappa = math.sqrt(x * x + y * y + z * z)
    place = min(max(np.log2(max(kappa, 1e-6) / FIRST_KAPPA), 0.0), LEVELS - 1.0)
    level = min(int(place), LEVELS - 2)
    share = np.float32(place - level)
    length = max(abs(x) + abs(y) + abs(z), np.float32(1e-30))
    u, v = x / length, z / length
    if y < 0.0:
        fold = np.float32(1.0) - abs(u) - abs(v)
        u, v = u + math.copysign(fold, u), v + math.copysign(fold, v)
    low = _on_grid(means, level, u, v)
    high = _on_grid(means, level + 1, u, v)
    return (
        low[0] + share * (high[0] - low[0]),
        low[1] + share * (high[1] - low[1]),
        low[2] + share * (high[2] - low[2]),
    )


@compiled()
def _on_grid(
    means: np.ndarray, level: int, u: np.float32, v: np.float32
) -> tuple[np.float32, np.float32, np.float32]:
    side, half = _SIDES[level], np.float32(0.5)
    across, down = (u + 1) * half * (side - 1), (v + 1) * half * (side - 1)
    column = min(max(int(across), 0), side - 2)
    row = min(max(int(down), 0), side - 2)
    a, b = np.float32(across - column), np.float32(down - row)
    at = _STARTS[level] + row * side + column
    one = np.float32(1.0)
    w0, w1, w2, w3 = (one - a) * (one - b), a * (one - b), (one - a) * b, a * b
    return (
        w0 * means[at, 0]
        + w1 * means[at + 1, 0]
        + w2 * means[at + side, 0]
        + w3 * means[at + side + 1, 0],
        w0 * means[at, 1]
        + w1 * means[at + 1, 1]
        + w2 * means[at + side, 1]
        + w3 * means[at + side + 1, 1],
        w0 * means[at, 2]
        + w1 * means[at + 1, 2]
        + w2 * means[at + side, 2]
        + w3 * means[at + side + 1, 2],
    )
