"""Mirror directions, visibility about vertices, and the lobes in a decoder's output, compiled.

spec/RNA.md, 12, RNA_environment; `tests/reference/lobes.py` says the same in numpy.
"""

import math

import numpy as np
from numba import types
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled
from rna_sdk.runtime.kernels.output_kernel import OUTPUT, sanitised
from rna_sdk.runtime.kernels.vectors import Rows, dot, unit

# Of spec/RNA.md, 12.1: kappa of a lobe that the decoder leaves as it is, of the first half
# of them and of the rest; and of axes in the output, in which nothing is negative.
WIDE, NARROW, SHIFT = 2.0, 10.0, 8.0

_VECTORS = types.Array(types.float32, 2, "C", readonly=True)
_SCALARS = types.Array(types.float32, 1, "C", readonly=True)


@compiled(_VECTORS, _VECTORS, types.boolean, types.float32[:, ::1])
def mirror_rows(axes: Rows, wo: Rows, is_fiber: bool, result: Rows) -> None:
    """result[i]: where light comes from that is reflected to wo; 0 without a direction."""
    for i in range(len(result)):
        n, o = unit(axes, i), unit(wo, i)
        along = 2.0 * dot(n, o)
        a, b = (-along, 1.0) if is_fiber else (along, -1.0)
        known = math.isfinite(along)
        for k in range(3):
            result[i, k] = a * n[k] + b * o[k] if known else 0.0


@compiled(
    types.Array(types.int8, 2, "C", readonly=True),
    types.Array(types.uint32, 2, "C", readonly=True),
    types.Array(types.int64, 1, "C", readonly=True),
    _SCALARS,
    _SCALARS,
    types.float32[:, ::1],
)
def mixed_harmonics(
    harmonics: NDArray[np.int8],
    corners: NDArray[np.uint32],
    primitive: NDArray[np.int64],
    u: NDArray[np.float32],
    v: NDArray[np.float32],
    result: Rows,
) -> None:
    """result[i]: coefficients at a point of a triangle, or of a segment: (n, 16) float32.

    harmonics: (vertices, 16). corners: (primitives, 3 or 2) of vertices. u, v: weights of the
    second and third corner.
    """
    for i in range(len(result)):
        vertices = corners[primitive[i]]
        third = v[i] if len(vertices) == 3 else np.float32(0.0)
        first = np.float32(1.0) - u[i] - third
        a, b, c = vertices[0], vertices[1], vertices[len(vertices) - 1]
        for k in range(result.shape[1]):
            mixed = first * harmonics[a, k] + u[i] * harmonics[b, k] + third * harmonics[c, k]
            result[i, k] = mixed / np.float32(127.0)


@compiled(_VECTORS, _SCALARS, types.intp, types.float32[:, ::1], types.boolean[::1])
def put_visibility(
    visibility: Rows,
    free: NDArray[np.float32],
    column: int,
    queries: Rows,
    valid: NDArray[np.bool_],
) -> None:
    """Write the visibility into `queries` from this column on; rows with NaN are not valid."""
    for i in range(len(queries)):
        valid[i] = valid[i] and math.isfinite(free[i])
        for k in range(visibility.shape[1]):
            valid[i] = valid[i] and math.isfinite(visibility[i, k])
            queries[i, column + k] = visibility[i, k]


@compiled(
    OUTPUT,
    types.boolean[::1],
    _VECTORS,
    _VECTORS,
    _SCALARS,
    types.boolean,
    types.float32[:, :, ::1],
    types.float32[:, :, ::1],
)
def write_lobes(
    output: Rows,
    valid: NDArray[np.bool_],
    wide: Rows,
    mirror: Rows,
    free: NDArray[np.float32],
    backwards: bool,
    amplitudes: NDArray[np.float32],
    axes: NDArray[np.float32],
) -> None:
    """Lobes of the output (m, 9 L), m >= n: amplitudes and axes, (n, L, 3) each.

    wide, mirror: (n, 3), directions that lobes are about. backwards: whether `wide` is negated.
    free: (n,), visibility along `mirror`. Rows that are not valid are 0.
    """
    count = amplitudes.shape[1]
    for i in range(len(amplitudes)):
        if not valid[i]:
            amplitudes[i] = axes[i] = np.float32(0.0)
            continue
        v = min(max(free[i], np.float32(0.0)), np.float32(1.0))
        about = unit(wide, i)
        turned = -WIDE if backwards else WIDE
        for j in range(count):
            for k in range(3):
                visible, shadowed = (
                    sanitised(output[i, 9 * j + k]),
                    sanitised(output[i, 9 * j + 3 + k]),
                )
                amplitudes[i, j, k] = sanitised(v * visible + (np.float32(1.0) - v) * shadowed)
                base = turned * about[k] if j < count // 2 else NARROW * mirror[i, k]
                axes[i, j, k] = sanitised(output[i, 9 * j + 6 + k]) - SHIFT + base
