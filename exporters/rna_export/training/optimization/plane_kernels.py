"""Compiled CPU kernels of the triplane: gather from blurred planes, its transpose, Adam, diffusion.

Every element is written by one thread and summed in the order of the samples, so results repeat
to the bit whatever the number of threads. `triplane.py` holds the PyTorch twins.
"""

import math

import numpy as np
from numba import prange
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled

Floats = NDArray[np.float32]

_FASTMATH = ("contract", "reassoc")
_BANDS = 4  # of a plane's rows, each a task: no two tasks write the same texel
_RUN = 4096  # elements of a task of `adam`
_COLUMNS = 32  # of a task of `diffuse`


@compiled(fastmath=_FASTMATH)
def _first_texel(coordinate: np.float32, resolution: int) -> tuple[int, np.float32]:
    """First texel of two and the weight of the second, for a coordinate in [0, 1]."""
    texel = min(
        max(coordinate * resolution - np.float32(0.5), np.float32(0.0)), np.float32(resolution - 1)
    )
    first = min(int(texel), resolution - 2)
    return first, texel - np.float32(first)


@compiled(parallel=True, fastmath=_FASTMATH)
def footprints(
    p: Floats, kernel: Floats, normalisation: Floats, first: NDArray[np.int32], weights: Floats
) -> None:
    """Weights of texels, along each axis, in a bilinear lookup in blurred planes.

    p: (n, 3) in [0, 1]. kernel: (2 r + 1,) float32 of the blur; [1] is none. normalisation: (R,)
    float32, 1 / what of the kernel lies inside the plane. Written: first (n, 3) int32, and
    weights (n, 3, m) float32 of texels first .. first + m - 1, with m = min(2 r + 2, R).
    """
    radius, m, resolution = len(kernel) // 2, weights.shape[2], len(normalisation)
    for i in prange(len(p)):
        for axis in range(3):
            texel, u = _first_texel(p[i, axis], resolution)
            start = min(max(texel - radius, 0), resolution - m)
            first[i, axis] = start
            weights[i, axis] = 0.0
            for side in range(2):
                centre = texel + side
                w = (u if side else np.float32(1.0) - u) * normalisation[centre]
                for d in range(len(kernel)):
                    t = centre + d - radius
                    if 0 <= t < resolution:
                        weights[i, axis, t - start] += w * kernel[d]


@compiled(parallel=True, fastmath=_FASTMATH)
def gather(planes: Floats, first: NDArray[np.int32], weights: Floats, features: Floats) -> None:
    """features (n, C) = sum over planes (3, R, R, C) of the texels of each footprint, weighed."""
    m, channels = weights.shape[2], planes.shape[3]
    for i in prange(len(first)):
        features[i] = 0.0
        for k in range(3):
            across, down = k, (k + 1) % 3
            for b in range(m):
                row = first[i, down] + b
                for a in range(m):
                    w = weights[i, down, b] * weights[i, across, a]
                    column = first[i, across] + a
                    for c in range(channels):
                        features[i, c] += w * planes[k, row, column, c]


@compiled(parallel=True, fastmath=_FASTMATH)
def scatter(gradient: Floats, first: NDArray[np.int32], weights: Floats, planes: Floats) -> None:
    """The transpose of `gather`: adds gradient (n, C) into planes (3, R, R, C)."""
    m, resolution, channels = weights.shape[2], planes.shape[1], planes.shape[3]
    band = (resolution + _BANDS - 1) // _BANDS
    for task in prange(3 * _BANDS):
        k, low = task // _BANDS, (task % _BANDS) * band
        across, down = k, (k + 1) % 3
        for i in range(len(first)):
            top = first[i, down]
            for b in range(max(0, low - top), min(m, low + band - top)):
                for a in range(m):
                    w = weights[i, down, b] * weights[i, across, a]
                    column = first[i, across] + a
                    for c in range(channels):
                        planes[k, top + b, column, c] += w * gradient[i, c]


@compiled(parallel=True, fastmath=_FASTMATH)
def adam(
    values: Floats,
    gradient: Floats,
    mean: Floats,
    square: Floats,
    rate: np.float32,
    betas: tuple[np.float32, np.float32],
    epsilon: np.float32,
) -> None:
    """A step of Adam; all arrays (n,) float32. The gradient is cleared for the next step.

    mean, square: moving averages of the gradient and its square, by `betas`. rate, epsilon: with
    Adam's corrections for the steps so far: Kingma and Ba, 2015, end of section 2.
    """
    first_moment, second_moment = betas
    for task in prange((len(values) + _RUN - 1) // _RUN):
        start = task * _RUN
        x, g = values[start : start + _RUN], gradient[start : start + _RUN]
        m, v = mean[start : start + _RUN], square[start : start + _RUN]
        for i in range(len(x)):
            m_i = first_moment * m[i] + (np.float32(1.0) - first_moment) * g[i]
            v_i = second_moment * v[i] + (np.float32(1.0) - second_moment) * g[i] * g[i]
            m[i], v[i], g[i] = m_i, v_i, np.float32(0.0)
            x[i] -= rate * m_i / (np.float32(math.sqrt(v_i)) + epsilon)


@compiled(fastmath=_FASTMATH)
def _exchange(texels: Floats, share: np.float32, taken: Floats) -> None:
    """Along the first axis of texels (R, n, C), in place. taken: (n, C) to work in."""
    last, n, channels = texels.shape[0] - 1, texels.shape[1], texels.shape[2]
    taken[:] = 0.0  # from these texels, by those before
    for i in range(last):
        for j in range(n):
            for c in range(channels):
                given = share * (texels[i + 1, j, c] - texels[i, j, c])
                texels[i, j, c] += given - taken[j, c]
                taken[j, c] = given
    for j in range(n):
        for c in range(channels):
            texels[last, j, c] -= taken[j, c]


@compiled(parallel=True, fastmath=_FASTMATH)
def diffuse(planes: Floats, share: np.float32) -> None:
    """Exchange a share of the difference between neighbours, along rows, then along columns.

    planes: (3, R, R, C) float32, changed in place; their sums stay as they are.
    """
    resolution, channels = planes.shape[1], planes.shape[3]
    for line in prange(3 * resolution):
        row = planes[line // resolution, line % resolution]
        taken = np.empty((1, channels), np.float32)
        _exchange(row.reshape(resolution, 1, channels), share, taken)
    blocks = (resolution + _COLUMNS - 1) // _COLUMNS
    for task in prange(3 * blocks):
        start = task % blocks * _COLUMNS
        columns = planes[task // blocks][:, start : start + _COLUMNS]
        _exchange(columns, share, np.empty(columns.shape[1:], np.float32))
