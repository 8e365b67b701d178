"""A float32 decoder of the profile in a compiled kernel of ours.

PANEL rows go through all layers while they are in the first-level cache, and no call has a cost of
its own, as each node of a graph in onnxruntime has.
"""

from collections.abc import Callable
from functools import cache

import numpy as np
from numba import types
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled
from rna_sdk.package.decoder.profile_decoder import ProfileDecoder
from rna_sdk.runtime.kernels.lane_memory import load_lanes, store_column, store_lanes
from rna_sdk.runtime.kernels.lane_vectors import between, exp
from rna_sdk.runtime.kernels.lanes import LANES
from rna_sdk.runtime.kernels.layer_kernel import (
    BLOCK,
    PANEL,
    REGISTERS,
    block_sums,
    load_square,
    packed_layer,
    register_lanes,
)

Numbers = NDArray[np.float32]

_QUERIES = types.Array(types.float32, 2, "C", readonly=True)
_NUMBERS = types.Array(types.float32, 1, "C", readonly=True)
_SIZES = types.Array(types.int64, 2, "C", readonly=True)

_LARGEST_EXPONENT = 100.0
"""Beyond it exp is infinite in float32."""


class CompiledDecoder:
    """Runs a decoder with float32 layers; thread-safe.

    Attributes:
        columns: of the queries.
    """

    def __init__(self, model: ProfileDecoder) -> None:
        matrices = [(layer.weight, layer.bias) for layer in model.layers]
        self.columns = len(matrices[0][0])
        self._relus = len(matrices) - 1
        if model.matrix is not None:
            matrices.append((model.matrix, np.zeros(model.matrix.shape[1], np.float32)))
        self._outputs = matrices[-1][0].shape[1]
        self._weights = np.concatenate([packed_layer(*matrix) for matrix in matrices])
        inputs = [len(weight) for weight, _ in matrices]
        outputs = [-(-weight.shape[1] // BLOCK) * BLOCK for weight, _ in matrices]
        self._sizes = np.array([inputs, outputs], np.int64)
        top = min(model.top, _LARGEST_EXPONENT)
        self._limits = np.array([model.low, model.high, top, model.unit], np.float32)
        self._kernel = decoder_kernel(register_lanes())

    def run(self, queries: Numbers) -> Numbers:
        """The output, (n, outputs) float32, of `queries`, (n, columns) float32, finite."""
        rows = len(queries)
        padded = -(-rows // LANES) * LANES
        if padded != rows:
            queries = np.resize(queries, (padded, self.columns))
        result = np.empty((padded, self._outputs), np.float32)
        if rows:
            self._kernel(queries, self._weights, self._sizes, self._relus, self._limits, result)
        return result[:rows]


@cache
def decoder_kernel(lanes: int) -> Callable[..., None]:
    """The kernel for registers of the given number of float32.

    Its arguments: queries (n, K), n a multiple of LANES; weights, those of all layers behind one
    another; sizes (2, layers): inputs, and outputs in whole blocks; relus: layers with a Relu; the
    exponentials come behind the next one; limits: low, high, top, unit; result (n, outputs),
    written.
    """
    part_rows = REGISTERS * lanes

    @compiled(_QUERIES, _NUMBERS, _SIZES, types.int64, _NUMBERS, types.float32[:, ::1])
    def decode(
        queries: Numbers,
        weights: Numbers,
        sizes: NDArray[np.int64],
        relus: int,
        limits: Numbers,
        result: Numbers,
    ) -> None:
        layers = sizes.shape[1]
        widest = 0
        for k in range(layers):
            widest = max(widest, sizes[0, k], sizes[1, k])
        x, y = np.zeros(widest * PANEL, np.float32), np.zeros(widest * PANEL, np.float32)
        for row in range(0, len(queries), PANEL):
            rows = min(PANEL, len(queries) - row)
            _load_panel(queries, row, rows, limits, x)
            at = 0
            for k in range(layers):
                inputs, outputs = sizes[0, k], sizes[1, k]
                for part in range(0, PANEL, part_rows):
                    for first in range(0, outputs, BLOCK):
                        start, block = at + first * (inputs + 1), first * PANEL + part
                        block_sums(lanes, x, part, weights, start, inputs, y, block, k < relus)  # type: ignore[call-arg]
                if k == relus:
                    _exponentials(y, outputs, limits[2], limits[3])
                at += (inputs + 1) * outputs
                x, y = y, x
            _store_panel(x, row, rows, result)

    return decode


@compiled()
def _load_panel(queries: Numbers, row: int, rows: int, limits: Numbers, panel: Numbers) -> None:
    """Queries of a panel's rows, a multiple of LANES, within the limits."""
    columns, flat = queries.shape[1], queries.reshape(-1)
    for first in range(0, rows, LANES):
        at = (row + first) * columns
        if columns < LANES:
            for r in range(LANES):
                for c in range(columns):
                    panel[c * PANEL + first + r] = flat[at + r * columns + c]
        else:
            for begin in range(0, columns, LANES):
                # The last square holds columns of the one before, too, unless all are whole.
                column = min(begin, columns - LANES)
                load_square(queries, at + column, columns, panel, column * PANEL + first)
        for column in range(columns):
            place = np.uintp(column * PANEL + first)
            values = between(load_lanes(panel, place), limits[0], limits[1])
            store_lanes(panel, place, values)


@compiled()
def _exponentials(panel: Numbers, numbers: int, top: float, unit: float) -> None:
    """panel = (exp(clip(panel, 0, top)) - 1) unit for the first `numbers` of each row."""
    for place in range(0, numbers * PANEL, LANES):
        x = between(load_lanes(panel, np.uintp(place)), 0.0, top)
        store_lanes(panel, np.uintp(place), (exp(x) - 1.0) * unit)


@compiled()
def _store_panel(panel: Numbers, row: int, rows: int, result: Numbers) -> None:
    outputs = np.uintp(result.shape[1])
    for first in range(0, rows, LANES):
        for k in range(result.shape[1]):
            at = np.uintp(row + first) * outputs + np.uintp(k)
            store_column(result, at, outputs, load_lanes(panel, np.uintp(k * PANEL + first)))
