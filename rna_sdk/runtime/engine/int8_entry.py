"""How the queries of an int8 decoder become uint8: found in its graph, done by a kernel here.

onnxruntime takes four passes over the queries for it, 38 ns/query; the kernel takes one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
from numba import types
from numpy.typing import NDArray

from rna_sdk.compiled import compiled
from rna_sdk.package.decoder.onnx_model import Model

_VECTOR = types.Array(types.float32, 1, "C", readonly=True)
_COLUMN_STEP = 4
"""Columns must be a multiple of this, or onnxruntime takes twice as long for the first layer."""


@dataclass(frozen=True)
class Entry:
    """uint8 = round(clip(query, *limits) * gain + offset), clamped; gain and offset (columns,).

    Attributes:
        places: indices of its nodes in the graph.
    """

    places: tuple[int, ...]
    limits: NDArray[np.float32]
    gain: NDArray[np.float32]
    offset: NDArray[np.float32]

    @property
    def columns(self) -> int:
        """Number of columns of the uint8 array: those of the queries, zero-padded."""
        return -(-len(self.gain) // _COLUMN_STEP) * _COLUMN_STEP

    def quantized(self, queries: NDArray[np.float32]) -> NDArray[np.uint8]:
        """(n, columns) uint8 of `queries`, (n, k) float32, finite."""
        result = np.zeros((len(queries), self.columns), np.uint8)
        _quantizer()(queries, self.limits, self.gain, self.offset, result)
        return result


def find_entry(model: Model, start: str, end: str) -> Entry | None:
    """Clip, Mul, Add, QuantizeLinear from the value `start` to `end`; None if it is otherwise."""
    value, places, operands = start, [], []
    for operator in ("Clip", "Mul", "Add", "QuantizeLinear"):
        place = next((k for k, node in enumerate(model.nodes) if value in node.inputs[:1]), None)
        if place is None or model.readers[value] != 1 or model.nodes[place].operator != operator:
            return None
        places.append(place)
        operands.append(model.arrays(model.nodes[place].inputs[1:]))
        value = model.nodes[place].outputs[0]
    found = [number for group in operands for number in group if number is not None]
    if value != end or len(found) != 6:
        return None
    low, high, gain, offset, scale, zero = found
    if gain.ndim != 1 or gain.shape != offset.shape or zero.dtype != np.uint8:
        return None
    if scale.ndim or scale != 1 or zero != 0:
        return None
    limits = np.array([low, high], np.float32).reshape(2)
    return Entry(tuple(places), limits, gain.astype(np.float32), offset.astype(np.float32))


@cache
def _quantizer() -> Callable[..., None]:
    """The kernel, compiled when the first int8 decoder asks for it."""

    @compiled(
        types.Array(types.float32, 2, "C", readonly=True),
        _VECTOR,
        _VECTOR,
        _VECTOR,
        types.uint8[:, ::1],
    )
    def quantize(
        queries: NDArray[np.float32],
        limits: NDArray[np.float32],
        gain: NDArray[np.float32],
        offset: NDArray[np.float32],
        result: NDArray[np.uint8],
    ) -> None:
        low, high = limits[0], limits[1]
        for i in range(len(queries)):
            for k in range(len(gain)):
                x = min(max(queries[i, k], low), high) * gain[k] + offset[k]
                result[i, k] = np.uint8(np.rint(min(max(x, np.float32(0.0)), np.float32(255.0))))

    return quantize
