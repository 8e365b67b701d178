"""Environments in cells of equal solid angle, and the whole integral of the transport over them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import torch

from rna_bench.lobes.directions import log_c
from rna_bench.lobes.lobe_kernels import SMALLEST_KAPPA
from rna_bench.lobes.lobe_model import LobeModel
from rna_bench.lobes.view_points import AssetViews
from rna_export.metrics import IRRADIANCE, psnr

_CELLS = (64, 128)  # rows of equal height, and cells around
_AT_ONCE = 20  # points
_SHOWN = 0.95  # part of the values that an exposure shows below white


def cell_directions() -> np.ndarray:
    """The middle of each cell, unit, y up: (8192, 3) float32."""
    rows, around = _CELLS
    y = 1 - 2 * (np.arange(rows) + 0.5) / rows
    phi = (np.arange(around) + 0.5) / around * 2 * np.pi
    r = np.sqrt(1 - y * y)
    parts = r[:, None] * np.cos(phi), np.tile(y[:, None], around), r[:, None] * np.sin(phi)
    return np.stack(parts, axis=-1).reshape(-1, 3).astype(np.float32)


def cell_flux(texels: np.ndarray, turn: float = 0.0) -> np.ndarray:
    """Radiance times solid angle of each cell, (8192, 3) float32.

    texels: (h, w, 3), equirectangular, y up. turn: about y, radians.
    """
    height, width = texels.shape[:2]
    rows, around = _CELLS
    theta = (np.arange(height) + 0.5) / height * np.pi
    phi = (np.arange(width) + 0.5) / width * 2 * np.pi + turn
    row = np.minimum((1 - np.cos(theta)) / 2 * rows, rows - 1).astype(np.int64)
    column = (phi / (2 * np.pi) % 1.0 * around).astype(np.int64)
    cell = (row[:, None] * around + column).ravel()
    solid = np.sin(theta) * (np.pi / height) * (2 * np.pi / width)
    radiance = (texels * solid[:, None, None]).reshape(-1, 3)
    flux = [np.bincount(cell, radiance[:, k], rows * around) for k in range(3)]
    return np.stack(flux, axis=1).astype(np.float32)


@dataclass(frozen=True)
class Score:
    """Error of lobes under one environment.

    Attributes:
        psnr: dB, of the lobes alone, at the exposure that shows 95% of the values below white.
        with_lights: the same, with the brightest cells asked of the decoder of transport.
        brightness: mean over that of the integral, RGB.
    """

    psnr: float
    with_lights: float
    brightness: tuple[float, float, float]


class Integrals:
    """The transport of random points along all cells."""

    def __init__(self, views: AssetViews, count: int = 600, seed: int = 77) -> None:
        self._points = views.points(count, np.random.default_rng(seed))
        d = cell_directions()
        along = []
        for start in range(0, count, _AT_ONCE):
            row = np.arange(start, min(start + _AT_ONCE, count))
            asked = np.repeat(row, len(d)), np.tile(d, (len(row), 1))
            along.append(views.transport(self._points, *asked).reshape(len(row), len(d), 3))
        self._transport = np.concatenate(along)

    def densities(self, model: LobeModel) -> tuple[np.ndarray, np.ndarray]:
        """Amplitudes (n, L, 3), and densities of the lobes along the cells (n, L, cells)."""
        rows = {name: torch.from_numpy(array) for name, array in self._points.rows().items()}
        with torch.no_grad():
            amplitude, axis = (tensor.numpy() for tensor in model(rows))
        kappa = np.maximum(np.linalg.norm(axis, axis=2), SMALLEST_KAPPA)
        exponent = log_c(kappa)[..., None] + axis @ cell_directions().T
        return amplitude, np.exp(exponent).astype(np.float32)

    def score(self, lobes: tuple[np.ndarray, np.ndarray], flux: np.ndarray, lights: int) -> Score:
        """Error under an environment, with so many of its brightest cells as lights."""
        truth = np.einsum("ndc,dc->nc", self._transport, flux)
        amplitude, density = lobes
        answer = np.einsum("nlc,nlc->nc", amplitude, density @ flux)
        brightest = np.argsort(-flux.mean(axis=1))[:lights]
        rest = flux.copy()
        rest[brightest] = 0.0
        exact = np.einsum("ndc,dc->nc", self._transport[:, brightest], flux[brightest])
        both = np.einsum("nlc,nlc->nc", amplitude, density @ rest) + exact
        r, g, b = (answer.mean(axis=0) / truth.mean(axis=0)).tolist()
        exposure = float(1 / np.quantile(truth, _SHOWN)) / IRRADIANCE  # white is 1
        scores = psnr(answer, truth, exposure), psnr(both, truth, exposure)
        return Score(*scores, (r, g, b))
