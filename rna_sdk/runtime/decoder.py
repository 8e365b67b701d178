"""A tier's decoder, ready to run."""

from __future__ import annotations

import numpy as np
import onnxruntime as ort
from numpy.typing import NDArray

from rna_sdk.runtime.decoder_graph import prepare_decoder

_TILES = ((32_768, 4096), (131_072, 2048), (524_288, 1024))
"""(bytes of the model, rows): up to this size, so many rows a call run fastest.

Measured with 22 inputs, 4 hidden layers and widths 16 to 512: what counts is that the
activations of two layers stay in a core's L2 cache and that a call's fixed cost does not show.
"""

_LARGE_MODEL_TILE = 512


class Decoder:
    """An ONNX decoder in an onnxruntime session of one thread; threads may share it.

    Attributes:
        columns: of the queries it wants: K, or more to fill up, whose values do not count.
        tile_rows: rows a call for which it runs fastest.
    """

    def __init__(self, model: bytes | memoryview, largest_query: float = np.inf) -> None:
        """model: ONNX bytes, input `queries` and output `transport`, float32.

        largest_query: no number in the queries will be further from 0.
        """
        options = ort.SessionOptions()
        options.intra_op_num_threads = 1
        options.inter_op_num_threads = 1
        options.execution_mode = ort.ExecutionMode.ORT_SEQUENTIAL
        options.graph_optimization_level = ort.GraphOptimizationLevel.ORT_ENABLE_ALL
        options.add_session_config_entry("session.intra_op.allow_spinning", "0")
        options.log_severity_level = 3
        data, self._entry = prepare_decoder(bytes(model), largest_query)
        self._session = ort.InferenceSession(data, options, providers=["CPUExecutionProvider"])
        source = self._session.get_inputs()[0]
        self._input = source.name
        self._shape = [size if isinstance(size, int) else -1 for size in source.shape]
        self.columns = len(self._entry.gain) if self._entry else int(self._shape[-1])
        fitting = [rows for size, rows in _TILES if len(model) <= size]
        self.tile_rows = fitting[0] if fitting else _LARGE_MODEL_TILE

    def run(self, queries: NDArray[np.float32]) -> NDArray[np.float32]:
        """(n, 6) float32: visible and shadowed RGB of `queries`, (n, columns) float32, finite."""
        values = self._entry.quantized(queries) if self._entry else queries
        inputs = {self._input: values.reshape(self._shape)}
        transport: NDArray[np.float32] = self._session.run(["transport"], inputs)[0]
        return transport
