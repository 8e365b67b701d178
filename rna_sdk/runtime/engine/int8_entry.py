"""How the queries of an int8 decoder become uint8, in a kernel here.

onnxruntime takes four passes over the queries for it, 38 ns/query; the kernel takes one.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
from numba import types
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled
from rna_sdk.package.decoder.profile_decoder import ProfileDecoder

_VECTOR = types.Array(types.float32, 1, "C", readonly=True)
_COLUMN_STEP = 4
"""Columns must be a multiple of this, or onnxruntime takes twice as long for the first layer."""


@dataclass(frozen=True)
class Entry:
    """uint8 = round(clip(query, *limits) * gain + offset), clamped; gain and offset (columns,)."""

    limits: NDArray[np.float32]
    gain: NDArray[np.float32]
    offset: NDArray[np.float32]

    @classmethod
    def of(cls, decoder: ProfileDecoder) -> "Entry | None":
        """Entry of a decoder in int8; None for a decoder in float32."""
        if decoder.gain is None or decoder.offset is None:
            return None
        step = np.float32(decoder.layers[0].step)  # 1 in what rna-export writes
        limits = np.array([decoder.low, decoder.high], np.float32)
        return cls(limits, decoder.gain / step, decoder.offset / step)

    @property
    def columns(self) -> int:
        """Number of columns of the uint8 array: the columns of the queries, zero-padded."""
        return -(-len(self.gain) // _COLUMN_STEP) * _COLUMN_STEP

    def quantized(self, queries: NDArray[np.float32]) -> NDArray[np.uint8]:
        """(n, columns) uint8 of `queries`, (n, k) float32, finite."""
        result = np.zeros((len(queries), self.columns), np.uint8)
        _quantizer()(queries, self.limits, self.gain, self.offset, result)
        return result


@cache
def _quantizer() -> Callable[..., None]:
    """The kernel, compiled for the first int8 decoder."""

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
