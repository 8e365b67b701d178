"""Decoder inputs on the CPU, compiled, with their gradient; `inputs.py` holds the PyTorch twin."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import torch
from numba import prange
from torch import Tensor

from rna_sdk.compiled import compiled
from rna_sdk.package import query_width
from rna_sdk.runtime import query_kernel as runtime
from rna_sdk.runtime.fiber_blocks import fiber_blocks
from rna_sdk.runtime.surface_blocks import BEND, half_vector, highlight, learned_normal
from rna_sdk.runtime.vectors import clamped, dot, first_three, unit, write


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
        columns = runtime.block_columns(blocks, features.shape[1])
        of_h = axis[:, 0] if h is None else h
        arrays = [x.numpy() for x in (axis, of_h, wo, wo if wi is None else wi)]
        queries = torch.empty(len(p), query_width(blocks, features.shape[1]))
        f = features.detach().numpy()
        _fill(f, p.numpy(), *arrays, columns, h is not None, queries.numpy())
        ctx.f, ctx.arrays, ctx.columns = f, arrays, columns
        return queries

    @staticmethod
    def backward(ctx: Any, gradient: Tensor) -> tuple[Tensor | None, ...]:
        axis, _, wo, wi = ctx.arrays
        of_features = torch.zeros(ctx.f.shape)
        _gradient(gradient.numpy(), ctx.f, axis, wo, wi, ctx.columns, of_features.numpy())
        return None, of_features, None, None, None, None, None


@compiled(parallel=True)
def _fill(features, p, axes, h, wo, wi, columns, is_fiber, queries):
    channels = features.shape[1]
    for i in prange(len(features)):
        axis, o, l = unit(axes, i), unit(wo, i), unit(wi, i)  # noqa: E741
        if columns[runtime.FEATURES] >= 0:
            first = columns[runtime.FEATURES]
            for c in range(channels):
                queries[i, first + c] = features[i, c]
        if columns[runtime.POSITION] >= 0:
            for a in range(3):
                queries[i, columns[runtime.POSITION] + a] = np.float32(2.0) * p[i, a] - 1.0
        at_axis = columns[runtime.TANGENT] if is_fiber else columns[runtime.NORMAL]
        if at_axis >= 0:
            write(queries, i, at_axis, axis)
        if columns[runtime.WO] >= 0:
            write(queries, i, columns[runtime.WO], o)
        if columns[runtime.WI] >= 0:
            write(queries, i, columns[runtime.WI], l)
        if is_fiber:
            offset = clamped(np.float64(h[i]))
            if columns[runtime.H] >= 0:
                queries[i, columns[runtime.H]] = np.float32(offset)
            angles, lobes = fiber_blocks(axis, offset, o, l)
            if columns[runtime.FIBER_ANGLES] >= 0:
                write(queries, i, columns[runtime.FIBER_ANGLES], angles)
            if columns[runtime.FIBER_LOBES] >= 0:
                write(queries, i, columns[runtime.FIBER_LOBES], lobes)
        else:
            if columns[runtime.HALF_VECTOR] >= 0:
                write(queries, i, columns[runtime.HALF_VECTOR], half_vector(axis, o, l))
            if columns[runtime.HIGHLIGHT] >= 0:
                write(queries, i, columns[runtime.HIGHLIGHT], highlight(axis, o, l))
            if columns[runtime.LEARNED_NORMAL] >= 0:
                bend = first_three(features, i, 0, channels)
                values = learned_normal(axis, bend, o, l)
                write(queries, i, columns[runtime.LEARNED_NORMAL], values)


@compiled(parallel=True)
def _gradient(gradient, features, axes, wo, wi, columns, of_features):
    channels, at = features.shape[1], columns[runtime.LEARNED_NORMAL]
    first = columns[runtime.FEATURES]
    for i in prange(len(features)):
        if first >= 0:
            for c in range(channels):
                of_features[i, c] = gradient[i, first + c]
        if at < 0:
            continue
        n, o, l = unit(axes, i), unit(wo, i), unit(wi, i)  # noqa: E741
        f = first_three(features, i, 0, channels)
        q = (n[0] + BEND * f[0], n[1] + BEND * f[1], n[2] + BEND * f[2])
        h = (o[0] + l[0], o[1] + l[1], o[2] + l[2])
        qq, hh = dot(q, q), dot(h, h)
        if qq < 1e-12 or hh < 1e-12:
            continue
        q_h = dot(q, h) / math.sqrt(qq * hh)
        # Of q.h and of log2(1 - q.h + 1e-4) / 6, by q.h; then of q.h, by q.
        slope = np.float64(gradient[i, at])
        if q_h < 1.0:
            slope -= gradient[i, at + 1] / (6.0 * math.log(2.0) * (1.0 - q_h + 1e-4))
        for c in range(min(3, channels)):
            of_q = h[c] / math.sqrt(qq * hh) - q_h * q[c] / qq
            of_features[i, c] += np.float32(slope * BEND * of_q)
