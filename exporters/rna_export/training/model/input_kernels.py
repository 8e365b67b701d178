"""Compiled CPU kernels of decoder inputs and their gradient; PyTorch reference: `inputs.py`."""

import math
from typing import Any

import numpy as np
import torch
from numba import prange
from numpy.typing import NDArray
from torch import Tensor

from rna_sdk.machine.compiled import compiled
from rna_sdk.package import query_width
from rna_sdk.package.block_table import FEATURES, LEARNED_NORMAL
from rna_sdk.runtime.kernels.block_columns import block_columns, first_three
from rna_sdk.runtime.kernels.input_blocks import (
    BEND,
    bent_normal,
    halfway,
    put_fiber,
    put_surface,
)
from rna_sdk.runtime.kernels.lane_memory import load_column, load_lanes, load_vectors, store_column
from rna_sdk.runtime.kernels.lane_vectors import clamped, unit
from rna_sdk.runtime.kernels.lanes import LANES, where
from rna_sdk.runtime.kernels.vectors import Rows, dot

_OF_LOG = 1.0 / (6.0 * math.log(2.0))
_SHORTEST = 1e-6
"""Length of n + BEND f below which q is n, which no feature moves."""


class Inputs(torch.autograd.Function):
    """Queries (n, K) of features (n, C) and of what else a sample has; gradient to features alone.

    Arguments: the blocks; features; p, positions in the bounds, 0 to 1; the frame's axis, normal
    or tangent; h, None of a surface; wo; wi, None where no block reads it.
    """

    @staticmethod
    def forward(
        ctx: Any,
        blocks: tuple[str, ...],
        features: Tensor,
        p: Tensor,
        axis: Tensor,
        h: Tensor | None,
        wo: Tensor,
        wi: Tensor | None,
    ) -> Tensor:
        columns = block_columns(blocks, features.shape[1])
        sources = features.detach(), p, axis, axis.new_empty(0) if h is None else h, wo
        arrays = [_whole(x) for x in (*sources, wo if wi is None else wi)]
        queries = torch.empty(len(arrays[0]), query_width(blocks, features.shape[1]))
        _fill(
            arrays[0],
            arrays[1],
            arrays[2],
            arrays[3],
            arrays[4],
            arrays[5],
            columns,
            h is not None,
            queries.numpy(),
        )
        ctx.arrays, ctx.columns = arrays, columns
        # The whole tensor, or a copy: autograd lets nobody write into a function's view.
        rows = len(features)
        return queries if len(queries) == rows else queries[:rows].clone()

    @staticmethod
    def backward(ctx: Any, gradient: Tensor) -> tuple[Tensor | None, ...]:
        features, _, axis, _, wo, wi = ctx.arrays
        of_features = torch.empty(features.shape)
        _gradient(_whole(gradient), features, axis, wo, wi, ctx.columns, of_features.numpy())
        return None, of_features[: len(gradient)], None, None, None, None, None


def _whole(rows: Tensor) -> np.ndarray:
    """The rows, C-contiguous, filled up with zeros to a multiple of LANES."""
    missing = -len(rows) % LANES
    if missing:
        rows = torch.cat([rows, rows.new_zeros(missing, *rows.shape[1:])])
    return rows.contiguous().numpy()


@compiled(parallel=True)
def _fill(
    features: Rows,
    p: Rows,
    axes: Rows,
    h: Rows,
    wo: Rows,
    wi: Rows,
    columns: NDArray[np.int64],
    is_fiber: bool,
    queries: Rows,
) -> None:
    for block in prange(len(features) // LANES):
        _fill_block(block * LANES, features, p, axes, h, wo, wi, columns, is_fiber, queries)


@compiled()
def _fill_block(
    row: int,
    features: Rows,
    p: Rows,
    axes: Rows,
    h: Rows,
    wo: Rows,
    wi: Rows,
    columns: NDArray[np.int64],
    is_fiber: bool,
    queries: Rows,
) -> None:
    start, channels = np.uintp(row), features.shape[1]
    axis = unit(load_vectors(axes, start))
    o, l = unit(load_vectors(wo, start)), unit(load_vectors(wi, start))  # noqa: E741
    first = columns[FEATURES]
    if first >= 0:
        for i in range(row, row + LANES):
            for c in range(channels):
                queries[i, first + c] = features[i, c]
    x = load_vectors(p, start)
    if is_fiber:
        put_fiber(queries, row, columns, x, axis, clamped(load_lanes(h, start)), o, l)
    else:
        f = first_three(features, start * np.uintp(channels), np.uintp(channels), channels)
        put_surface(queries, row, columns, x, axis, f, o, l, halfway(o, l))


@compiled(parallel=True)
def _gradient(
    gradient: Rows,
    features: Rows,
    axes: Rows,
    wo: Rows,
    wi: Rows,
    columns: NDArray[np.int64],
    of_features: Rows,
) -> None:
    for block in prange(len(features) // LANES):
        row, first = block * LANES, columns[FEATURES]
        for i in range(row, row + LANES):
            for c in range(features.shape[1]):
                of_features[i, c] = gradient[i, first + c] if first >= 0 else np.float32(0.0)
        if columns[LEARNED_NORMAL] >= 0:
            _add_bending(row, gradient, features, axes, wo, wi, columns, of_features)


@compiled()
def _add_bending(
    row: int,
    gradient: Rows,
    features: Rows,
    axes: Rows,
    wo: Rows,
    wi: Rows,
    columns: NDArray[np.int64],
    of_features: Rows,
) -> None:
    """of_features += gradient of `learned_normal`, in LANES rows from `row` on."""
    start, width = np.uintp(row), np.uintp(gradient.shape[1])
    channels = np.uintp(features.shape[1])
    at = start * width + np.uintp(columns[LEARNED_NORMAL])
    n = unit(load_vectors(axes, start))
    o, l = unit(load_vectors(wo, start)), unit(load_vectors(wi, start))  # noqa: E741
    f = first_three(features, start * channels, channels, features.shape[1])
    q, m = bent_normal(n, f), halfway(o, l)
    length = dot((n[0] + BEND * f[0], n[1] + BEND * f[1], n[2] + BEND * f[2]), q)
    opposite = dot(m, m) == 0.0
    d = m[0] - q[0], m[1] - q[1], m[2] - q[2]
    # Of q.m and of log2(1 - q.m + 1e-4) / 6, by q.m; then of q.m, by what q is the direction of.
    of_gap = load_column(gradient, at + np.uintp(1), width)
    slope = load_column(gradient, at, width) - of_gap * _OF_LOG / (0.5 * dot(d, d) + 1e-4)
    slope = where(opposite, 0.0, where(length < _SHORTEST, 0.0, slope * BEND / length))
    along = dot(d, q)
    for c in range(min(3, features.shape[1])):
        place = start * channels + np.uintp(c)
        value = load_column(of_features, place, channels) + slope * (d[c] - along * q[c])
        store_column(of_features, place, channels, value)
