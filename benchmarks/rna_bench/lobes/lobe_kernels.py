"""Lobes under lights that are von Mises-Fisher distributions, and gradients by the lobes.

A lobe with the axis a has the density c(|a|) exp(a.d) over directions d, with c(k) = k / (4 pi
sinh k). The integral of the product of two such densities is c(|a|) c(|b|) / c(|a + b|).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numba import prange
from numpy.typing import NDArray

from rna_sdk.compiled import compiled

Numbers = NDArray[np.float32]

SMALLEST_KAPPA = np.float32(0.01)
_LOG_TWO_PI = np.float32(math.log(2 * math.pi))
_ONE, _TWO, _THIRD = np.float32(1.0), np.float32(2.0), np.float32(1.0 / 3.0)
_SERIES = np.float32(0.05)  # below it the slope of log c is its first term


@compiled()
def _log_c(kappa: Any) -> Any:
    return np.log(kappa) - _LOG_TWO_PI - np.log1p(-np.exp(-_TWO * kappa)) - kappa


@compiled()
def _slope(kappa: Any) -> Any:
    """Derivative of log c, over kappa."""
    if kappa < _SERIES:
        return -_THIRD
    e = np.exp(-_TWO * kappa)
    return (_ONE / kappa - (_ONE + e) / (_ONE - e)) / kappa


@compiled()
def _length(x: Any, y: Any, z: Any) -> Any:
    return max(np.sqrt(x * x + y * y + z * z), SMALLEST_KAPPA)


@compiled(parallel=True)
def answer(
    amplitude: Numbers, axis: Numbers, lights: Numbers, answers: Numbers, shares: Numbers
) -> None:
    """What lobes answer under lights whose mean over all directions is 1 / (4 pi).

    amplitude, axis: (n, L, 3). lights: (n, K, 3), their axes. Written: answers (n, K, 3); shares
    (n, K, L, 4), the answer of an amplitude of 1 and its gradient by the axis.
    """
    for i in prange(len(axis)):
        answers[i] = np.float32(0.0)
        for j in range(axis.shape[1]):
            x, y, z = axis[i, j, 0], axis[i, j, 1], axis[i, j, 2]
            kappa = _length(x, y, z)
            peak, own = _log_c(kappa), _slope(kappa)
            for k in range(lights.shape[1]):
                bx, by, bz = lights[i, k, 0], lights[i, k, 1], lights[i, k, 2]
                together = _length(x + bx, y + by, z + bz)
                share = np.exp(peak + _log_c(_length(bx, by, bz)) - _log_c(together))
                slope = _slope(together)
                shares[i, k, j, 0] = share
                shares[i, k, j, 1] = share * (own * x - slope * (x + bx))
                shares[i, k, j, 2] = share * (own * y - slope * (y + by))
                shares[i, k, j, 3] = share * (own * z - slope * (z + bz))
                for c in range(3):
                    answers[i, k, c] += amplitude[i, j, c] * share


@compiled(parallel=True)
def difference(
    amplitude: Numbers,
    axis: Numbers,
    directions: Numbers,
    transport: Numbers,
    weights: Numbers,
    differences: Numbers,
) -> None:
    """Estimate of lobes minus truth under K lights, from the same D directions of both.

    It has no bias, and its noise is that of what the lobes do not yet explain. directions and
    transport: (n, D, 3). weights: (n, K, D), of directions under the lights. Written: differences
    (n, K, 3).
    """
    for i in prange(len(axis)):
        differences[i] = np.float32(0.0)
        for d in range(directions.shape[1]):
            x, y, z = directions[i, d, 0], directions[i, d, 1], directions[i, d, 2]
            r, g, b = -transport[i, d, 0], -transport[i, d, 1], -transport[i, d, 2]
            for j in range(axis.shape[1]):
                ax, ay, az = axis[i, j, 0], axis[i, j, 1], axis[i, j, 2]
                density = np.exp(_log_c(_length(ax, ay, az)) + ax * x + ay * y + az * z)
                r += amplitude[i, j, 0] * density
                g += amplitude[i, j, 1] * density
                b += amplitude[i, j, 2] * density
            for k in range(weights.shape[1]):
                differences[i, k, 0] += weights[i, k, d] * r
                differences[i, k, 1] += weights[i, k, d] * g
                differences[i, k, 2] += weights[i, k, d] * b


@compiled(parallel=True)
def gradients(
    amplitude: Numbers,
    of_answers: Numbers,
    shares: Numbers,
    of_amplitude: Numbers,
    of_axis: Numbers,
) -> None:
    """Gradients by amplitudes and axes, (n, L, 3) each, written, from (n, K, 3) by answers."""
    for i in prange(len(amplitude)):
        for j in range(amplitude.shape[1]):
            for c in range(3):
                of_amplitude[i, j, c] = of_axis[i, j, c] = np.float32(0.0)
            for k in range(of_answers.shape[1]):
                through = np.float32(0.0)
                for c in range(3):
                    of_amplitude[i, j, c] += of_answers[i, k, c] * shares[i, k, j, 0]
                    through += of_answers[i, k, c] * amplitude[i, j, c]
                for c in range(3):
                    of_axis[i, j, c] += through * shares[i, k, j, 1 + c]
