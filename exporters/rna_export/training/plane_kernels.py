"""Compiled CPU kernels of the triplane: gather, its transpose, and the separable blur.

Every output element is summed by one thread in a fixed order, so results repeat to the bit
whatever the number of threads. `triplane.py` holds the PyTorch twins.
"""

from __future__ import annotations

import numpy as np
from numba import prange

from rna_sdk.compiled import compiled

_FASTMATH = ("contract", "reassoc")


@compiled(fastmath=_FASTMATH)
def _footprint(coordinate, resolution):
    """First texel of two and the weight of the second, for a coordinate in [0, 1]."""
    texel = min(
        max(coordinate * resolution - np.float32(0.5), np.float32(0.0)), np.float32(resolution - 1)
    )
    first = min(int(texel), resolution - 2)
    return first, texel - np.float32(first)


@compiled(parallel=True, fastmath=_FASTMATH)
def gather(planes, p, features):
    """features (n, C) = sum over planes (3, R, R, C) of bilinear lookups at p (n, 3) in [0, 1]."""
    resolution, channels = planes.shape[1], planes.shape[3]
    for i in prange(len(p)):
        features[i] = 0.0
        for k in range(3):
            column, u = _footprint(p[i, k], resolution)
            row, v = _footprint(p[i, (k + 1) % 3], resolution)
            for c in range(channels):
                top = planes[k, row, column, c] * (1 - u) + planes[k, row, column + 1, c] * u
                low = (
                    planes[k, row + 1, column, c] * (1 - u) + planes[k, row + 1, column + 1, c] * u
                )
                features[i, c] += top * (1 - v) + low * v


@compiled(parallel=True, fastmath=_FASTMATH)
def scatter(gradient, p, planes):
    """The transpose of `gather`: adds gradient (n, C) into planes (3, R, R, C)."""
    resolution, channels = planes.shape[1], planes.shape[3]
    half = (resolution + 1) // 2
    for task in prange(6):  # a thread owns one half of one plane's rows
        k, first_row = task // 2, (task % 2) * half
        for i in range(len(p)):
            row, v = _footprint(p[i, (k + 1) % 3], resolution)
            for dr in range(2):
                r = row + dr
                if r < first_row or r >= first_row + half:
                    continue
                column, u = _footprint(p[i, k], resolution)
                weight = v if dr else 1 - v
                for c in range(channels):
                    g = gradient[i, c] * weight
                    planes[k, r, column, c] += g * (1 - u)
                    planes[k, r, column + 1, c] += g * u


@compiled(parallel=True, fastmath=_FASTMATH)
def blur_columns(planes, kernel, out):
    """out[k, r, c] = sum over d of kernel[d] planes[k, r, c + d - radius]; zero outside."""
    size, channels, radius = planes[0, 0].size, planes.shape[3], len(kernel) // 2
    lines, results = planes.reshape(-1, size), out.reshape(-1, size)
    for line in prange(len(lines)):
        results[line] = 0.0
        for d in range(len(kernel)):
            # One run over the whole line for each d: faster than over each texel's channels.
            shift = (d - radius) * channels
            first, end = max(0, -shift), min(size, size - shift)
            source, result = lines[line, first + shift : end + shift], results[line, first:end]
            for i in range(len(result)):
                result[i] += kernel[d] * source[i]


@compiled(parallel=True, fastmath=_FASTMATH)
def blur_rows(planes, kernel, out):
    """As `blur_columns`, along the rows."""
    resolution, radius = planes.shape[1], len(kernel) // 2
    for line in prange(planes.shape[0] * planes.shape[1]):
        k, r = line // planes.shape[1], line % planes.shape[1]
        out[k, r] = 0.0
        for d in range(max(0, radius - r), min(len(kernel), resolution + radius - r)):
            for c in range(planes.shape[2]):
                for f in range(planes.shape[3]):
                    out[k, r, c, f] += kernel[d] * planes[k, r + d - radius, c, f]
