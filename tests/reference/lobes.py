"""Lobes in plain numpy, float64: the twin of `runtime/kernels/lobe_kernels.py`.

The formulas of `spec/RNA.md`, 12, RNA_environment.
"""

import numpy as np
from numpy.typing import NDArray

Float = NDArray[np.float64]

WIDE, NARROW = 2.0, 10.0
"""kappa of a lobe that the decoder leaves as it is: of the first half of them, and of the rest."""

SHIFT = 8.0
"""Shift of axes in the output, which is never negative."""

SMALLEST_KAPPA = 0.01


def unit(vectors: NDArray[np.floating]) -> Float:
    wide = np.asarray(vectors, np.float64)
    result: Float = wide / np.linalg.norm(wide, axis=1, keepdims=True)
    return result


def mirror_reference(kind: str, axes: NDArray[np.floating], wo: NDArray[np.floating]) -> Float:
    """(n, 3), unit: 2 (n . wo) n - wo at normals of a surface, wo - 2 (wo . t) t at tangents."""
    axis, o = unit(axes), unit(wo)
    turned = 2.0 * np.sum(axis * o, axis=1, keepdims=True) * axis
    result: Float = turned - o if kind == "surface" else o - turned
    return result


def visibility_reference(
    harmonics: NDArray[np.int8], corners: NDArray[np.integer], weights: NDArray[np.floating]
) -> Float:
    """(n, 16): coefficients at points; corners, weights: (n, 3 or 2), vertices and their shares."""
    mixed: Float = np.einsum("nk,nkc->nc", weights, harmonics[corners].astype(np.float64) / 127.0)
    return mixed


def lobes_reference(
    kind: str,
    output: NDArray[np.floating],
    axes: NDArray[np.floating],
    wo: NDArray[np.floating],
    free: NDArray[np.floating],
) -> tuple[Float, Float]:
    """Amplitudes and axes, (n, L, 3) each, of a decoder's output (n, 9 L).

    axes: normals or tangents. free: (n,), the asset's own visibility along the mirror direction.
    """
    values = np.asarray(output, np.float64).reshape(len(output), -1, 3, 3)
    v = np.clip(np.asarray(free, np.float64), 0.0, 1.0)[:, None, None]
    amplitudes = v * values[:, :, 0] + (1.0 - v) * values[:, :, 1]
    wide = WIDE * unit(axes) if kind == "surface" else -WIDE * unit(wo)
    narrow = NARROW * mirror_reference(kind, axes, wo)
    half = values.shape[1] // 2
    base = np.repeat(np.stack([wide, narrow], axis=1), half, axis=1)
    return amplitudes, values[:, :, 2] - SHIFT + base


def log_normalisation(kappa: NDArray[np.floating]) -> NDArray[np.floating]:
    """ln c(kappa), c = kappa / (4 pi sinh kappa): exp(a . d) c(|a|) integrates to 1 over d."""
    k = np.maximum(kappa, SMALLEST_KAPPA)
    result: NDArray[np.floating] = np.log(k / (2.0 * np.pi)) - np.log1p(-np.exp(-2.0 * k)) - k
    return result


def radiance_reference(
    amplitudes: NDArray[np.floating],
    axes: NDArray[np.floating],
    light: NDArray[np.floating],
    flux: NDArray[np.floating],
) -> Float:
    """(n, 3): radiance under a light that is a von Mises-Fisher distribution about light (3,).

    Its radiance from direction d is flux (3,) c(|light|) exp(light . d).
    """
    a, b = np.linalg.norm(axes, axis=2), np.linalg.norm(light[None], axis=1)
    both = np.linalg.norm(axes + light, axis=2)
    logs = log_normalisation(a) + log_normalisation(b) - log_normalisation(both)
    result: Float = np.einsum("nlc,nl->nc", amplitudes, np.exp(logs)) * flux
    return result
