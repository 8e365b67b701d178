"""Rewrite a decoder for speed: the same arithmetic in a form that onnxruntime runs faster.

onnxruntime runs Gemm + Relu in three passes over the activations: copy the bias, multiply and
add, clamp. A 1 x 1 convolution over a row of "pixels", one query each, is the same layer, and
its blocked form on x86 does all three while the result is in registers: at width 64 a layer
takes 44 to 46 ns/query instead of 55 to 59.

    queries [n, k]    -> Gemm -> Relu -> ... -> Gemm -> [n, m]
    queries [1, 1, n, k padded] -> Transpose -> Conv -> Relu -> ... -> Conv -> Transpose,
    Reshape -> [n, m]
"""

from __future__ import annotations

import platform

import numpy as np

from rna_sdk.package.decoder.onnx_model import Model, read_model
from rna_sdk.package.decoder.protobuf import WireError
from rna_sdk.runtime.engine.graph_rewriting import GraphRewriting
from rna_sdk.runtime.engine.int8_entry import Entry
from rna_sdk.runtime.engine.int8_graph import fuse_int8_layers
from rna_sdk.runtime.engine.layer_chain import Layer, find_chain

_QUERIES = "queries"
_PIXELS, _RESULT = "rna_sdk/pixels", "rna_sdk/result"  # values that the rewriting adds

_BLOCK = 16
"""Channels that onnxruntime's blocked convolution takes together on AVX-512; 8 on AVX2."""

_INPUT_STEP = 4
"""The first layer's channels must be a multiple of this, and at least a block."""


def prepare_decoder(model: bytes, largest_query: float) -> tuple[bytes, Entry | None]:
    """The decoder to run on this machine: `model` rewritten where that pays, or as it is.

    With an Entry, what it makes of the queries is what the decoder takes.

    largest_query: no number in the queries will be further from 0.
    """
    if platform.machine().lower() not in ("x86_64", "amd64"):
        return model, None  # measured, and onnxruntime has the blocked convolution, on x86 only
    return fuse_int8_layers(convolve_layers(model, largest_query))


def convolve_layers(data: bytes, largest_query: float = np.inf) -> bytes:
    """The model with its chain of fully connected layers as 1 x 1 convolutions.

    The result reads `queries` as float32 [1, 1, n, k], where k has been padded; what it gives
    for the added columns makes no difference. A Clip of the queries that changes none of them up
    to `largest_query` is left out. The bytes come back as they are where the graph
    has no such chain, or a hidden layer does not fill whole blocks of channels.
    """
    try:
        model = read_model(memoryview(data))
        layers = find_chain(model, _QUERIES)
    except (WireError, ValueError):
        return data
    if len(layers) < 2 or any(len(layer.weight) % _BLOCK for layer in layers[1:]):
        return data
    return _convolved(model, layers, _idle_clip(model, layers[0], largest_query))


def _idle_clip(model: Model, first: Layer, largest_query: float) -> int | None:
    """Place of the node that clips the queries for the first layer, if it changes none."""
    for place, node in enumerate(model.nodes):
        if node.operator != "Clip" or node.inputs[0] != _QUERIES or node.outputs != (first.input,):
            continue
        low, high = (model.floats(name) for name in (*node.inputs[1:], "", "")[:2])
        if low is not None and high is not None and largest_query <= min(-low.min(), high.max()):
            return place
    return None


def _convolved(model: Model, layers: list[Layer], idle: int | None) -> bytes:
    """The model with `layers` as convolutions, and without the node `idle` before them."""
    width = len(layers[0].weight)
    columns = max(-(-width // _INPUT_STEP) * _INPUT_STEP, _BLOCK)
    graph = GraphRewriting(model)
    graph.remove(layer.place for layer in layers)
    graph.remove([] if idle is None else [idle])
    first, last = layers[0], layers[-1]
    source = first.input if idle is None else _QUERIES
    # onnxruntime folds a transpose of these orders into its blocking of channels.
    graph.add(first.place, "Transpose", [source], _PIXELS, {"perm": [0, 3, 1, 2]})
    for layer in layers:
        source = _PIXELS if layer is first else layer.input
        result = _RESULT if layer is last else layer.output
        _add_convolution(graph, layer, source, result, columns - width if layer is first else 0)
    rows, shape = _RESULT + "/rows", _RESULT + "/shape"
    graph.add(last.place, "Transpose", [_RESULT], rows, {"perm": [0, 2, 3, 1]})
    graph.constant(shape, np.array([-1, len(last.bias)]))
    graph.add(last.place, "Reshape", [rows, shape], last.output)
    return graph.to_bytes((_QUERIES, [1, 1, "n", columns], "float32"))


def _add_convolution(
    graph: GraphRewriting, layer: Layer, source: str, result: str, added_inputs: int
) -> None:
    """The layer on [1, channels, 1, n]; added inputs weigh nothing."""
    weight = np.pad(layer.weight.T, ((0, 0), (0, added_inputs)))[:, :, None, None]
    kernel = graph.constant(layer.output + "/kernel", weight)
    bias = graph.constant(layer.output + "/bias", layer.bias)
    graph.add(layer.place, "Conv", [source, kernel, bias], result, {"kernel_shape": [1, 1]})
