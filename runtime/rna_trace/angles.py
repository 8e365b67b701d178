"""Sines and arctangents in turns: compiled, of polynomials, several times as fast as libm's."""

import numpy as np

from rna_sdk.machine.compiled import compiled

# Taylor's series on [-pi/4, pi/4]: sin(x) = x + x^3 (S0 + S1 x^2 + ...), and cos(x) likewise.
_S = tuple(1.0 / v for v in (-6.0, 120.0, -5040.0, 362880.0, -39916800.0, 6227020800.0))
_C = tuple(1.0 / v for v in (-2.0, 24.0, -720.0, 40320.0, -3628800.0, 479001600.0))

# atan(x) = x (A0 + A1 x^2 + ...) on [0, tan(pi/8)], interpolated at Chebyshev's nodes: to 3e-13.
_A = (
    0.9999999999992709,
    -0.33333333278383387,
    0.1999999318874514,
    -0.1428539125346393,
    0.11103534803114605,
    -0.08993216206403104,
    0.06977000253224784,
    -0.03770164806582585,
)
_EIGHTH = np.sqrt(2.0) - 1.0  # tan(pi/8)


@compiled(fastmath=())
def sine_and_cosine(turns: float) -> tuple[float, float]:
    """Sine and cosine of an angle in turns, from -1 to 2: float64, to 1e-12."""
    quarter = np.floor(4.0 * turns + 0.5)
    x = (turns - 0.25 * quarter) * (2.0 * np.pi)
    x2 = x * x
    s, c = _S[5], _C[5]
    for k in range(4, -1, -1):
        s, c = _S[k] + x2 * s, _C[k] + x2 * c
    s, c = x + x * x2 * s, 1.0 + x2 * c
    place = np.int64(quarter) & 3
    sine = c if place & 1 else s
    cosine = s if place & 1 else c
    return (-sine if place & 2 else sine), (-cosine if (place + 1) & 2 else cosine)


@compiled(fastmath=())
def turns_of(y: float, x: float) -> float:
    """atan2(y, x) / (2 pi), in [-1/2, 1/2]: to 1e-13; 0 for (0, 0)."""
    high, low = max(abs(x), abs(y)), min(abs(x), abs(y))
    ratio = low / high if high > 0.0 else 0.0
    shifted = ratio > _EIGHTH
    z = (ratio - 1.0) / (ratio + 1.0) if shifted else ratio
    z2 = z * z
    value = _A[7]
    for k in range(6, -1, -1):
        value = _A[k] + z2 * value
    turns = z * value / (2.0 * np.pi) + (0.125 if shifted else 0.0)
    if abs(y) > abs(x):
        turns = 0.25 - turns
    if x < 0.0:
        turns = 0.5 - turns
    return -turns if y < 0.0 else turns
