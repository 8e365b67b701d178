"""A decoder of transport or of emission, ready to run."""

import os
import warnings

import numpy as np
import onnxruntime as ort
from numpy.typing import NDArray

from rna_sdk.package.decoder.decoder_writer import decoder_to_bytes
from rna_sdk.package.decoder.profile_decoder import ProfileDecoder
from rna_sdk.runtime.engine.agreement import TIES, close_rows
from rna_sdk.runtime.engine.compiled_decoder import CompiledDecoder
from rna_sdk.runtime.engine.decoder_graph import fast_graph
from rna_sdk.runtime.engine.int8_entry import Entry

_COMPILED_TILE = 8192
"""Rows a call of a kernel of ours, whose activations are of a panel, not of the tile.

Python does the less between calls, one thread at a time.
"""

_TILES = ((32_768, 4096), (131_072, 2048), (524_288, 1024))
"""(bytes of the model, rows): up to this size, so many rows a call of onnxruntime run fastest.

Measured with 22 inputs, 4 hidden layers and widths 16 to 512: what counts is that the
activations of two layers stay in a core's L2 cache and that a call's fixed cost does not show.
"""

_LARGE_MODEL_TILE = 512

COMPILED_WIDTH = 128
"""Widest layer of the decoders that run in a kernel of ours: up to here it is the faster one."""

_CHECKED_ROWS = 512


class DecoderWarning(UserWarning):
    """A decoder runs slower than it should, since its fast form gave other results."""


class Decoder:
    """A decoder in a kernel of ours or an onnxruntime session; threads may share it.

    Attributes:
        columns: of the queries it wants: K, or more to fill up, whose values do not count.
        tile_rows: rows a call for which it runs fastest.
    """

    def __init__(self, decoder: ProfileDecoder, largest_query: float = np.inf) -> None:
        """largest_query: no number in the queries will be further from 0.

        Warns with DecoderWarning where the fast form differs from the chain of the format on this
        machine; onnxruntime then runs that chain.
        """
        chain = decoder_to_bytes(decoder)
        fast = _fast_form(decoder, largest_query)
        if fast is not None and not _agree(fast, chain, largest_query, decoder.is_int8):
            message = (
                "a decoder's fast form gives other results than its graph on this CPU; "
                "the graph runs as it is, more slowly"
            )
            warnings.warn(message, DecoderWarning, stacklevel=2)
            fast = None
        self._form = fast or Graph(chain)
        self.columns = self._form.columns
        self.tile_rows = _tile_rows(self._form, len(chain))

    def run(self, queries: NDArray[np.float32]) -> NDArray[np.float32]:
        """The output, (n, outputs) float32, of `queries`, (n, columns) float32, finite."""
        return self._form.run(queries)


class Graph:
    """A graph in a session, and the required form of its queries."""

    def __init__(self, model: bytes, entry: Entry | None = None, optimized: bool = True) -> None:
        """entry: makes the graph's input from queries, where the graph does not take queries."""
        self._entry, self._model, self._optimized = entry, model, optimized
        self._session, self._process = self._opened(), os.getpid()
        source = self._session.get_inputs()[0]
        self._input = source.name
        self._shape = [size if isinstance(size, int) else -1 for size in source.shape]
        self.columns = len(entry.gain) if entry else int(self._shape[-1])

    def _opened(self) -> ort.InferenceSession:
        options = ort.SessionOptions()
        options.intra_op_num_threads = 1
        options.inter_op_num_threads = 1
        options.execution_mode = ort.ExecutionMode.ORT_SEQUENTIAL
        levels = ort.GraphOptimizationLevel
        options.graph_optimization_level = (
            levels.ORT_ENABLE_ALL if self._optimized else levels.ORT_DISABLE_ALL
        )
        options.add_session_config_entry("session.intra_op.allow_spinning", "0")
        # Layers in int8 that are not rewritten run in float32: onnxruntime's own way to run them
        # in integers can saturate on CPUs without VNNI.
        options.add_session_config_entry("session.disable_quant_qdq", "1")
        options.log_severity_level = 3
        return ort.InferenceSession(self._model, options, providers=["CPUExecutionProvider"])

    def run(self, queries: NDArray[np.float32]) -> NDArray[np.float32]:
        values = self._entry.quantized(queries) if self._entry else queries
        if self._process != os.getpid():  # forked, perhaps while a thread held the session's locks
            self._session, self._process = self._opened(), os.getpid()
        inputs = {self._input: values.reshape(self._shape)}
        output: NDArray[np.float32] = self._session.run(None, inputs)[0]
        return output


def _tile_rows(form: Graph | CompiledDecoder, model_bytes: int) -> int:
    if isinstance(form, CompiledDecoder):
        return _COMPILED_TILE
    return next((rows for size, rows in _TILES if model_bytes <= size), _LARGE_MODEL_TILE)


def _fast_form(decoder: ProfileDecoder, largest_query: float) -> Graph | CompiledDecoder | None:
    """A form that is faster than onnxruntime on the chain of the format; None if there is none."""
    if not decoder.is_int8 and decoder.width <= COMPILED_WIDTH:
        return CompiledDecoder(decoder)
    faster = fast_graph(decoder, largest_query)
    return None if faster is None else Graph(*faster)


def _agree(
    fast: Graph | CompiledDecoder, chain: bytes, largest_query: float, is_int8: bool
) -> bool:
    """Whether the fast form agrees with the chain of the format on fixed queries."""
    graph = Graph(chain, optimized=False)
    queries = np.zeros((_CHECKED_ROWS, max(fast.columns, graph.columns)), np.float32)
    rng = np.random.default_rng(0)
    shape = _CHECKED_ROWS, graph.columns
    # Mostly within the blocks' range, some rows far beyond.
    reach = np.where(np.arange(_CHECKED_ROWS) % 4, 1.0, min(largest_query, 100.0))
    queries[:, : graph.columns] = rng.uniform(-1, 1, shape) * reach[:, None]
    expected = graph.run(np.ascontiguousarray(queries[:, : graph.columns]))
    result = fast.run(np.ascontiguousarray(queries[:, : fast.columns]))
    close = close_rows(result, expected, reach)
    return bool(close.mean() >= (1 - TIES if is_int8 else 1.0))
