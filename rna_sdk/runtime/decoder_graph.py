"""Rewrite a decoder for speed: the same arithmetic in a form that onnxruntime runs faster.

onnxruntime runs Gemm + Relu in three passes over the activations: copy the bias, multiply and
add, clamp. A 1 x 1 convolution over a row of "pixels", one query each, is the same layer, and
its blocked form on x86 does all three while the result is in registers: at width 64 a layer
takes 44 to 46 ns a query instead of 55 to 59.

    queries [n, k]    -> Gemm -> Relu -> ... -> Gemm -> [n, m]
    queries [1, 1, n, k padded] -> Transpose -> Conv -> Relu -> ... -> Conv -> Transpose,
    Reshape -> [n, m]
"""

from __future__ import annotations

import platform

import numpy as np

from rna_sdk.package.protobuf import Message, WireError
from rna_sdk.runtime import onnx_bytes as pb
from rna_sdk.runtime.int8_entry import Entry
from rna_sdk.runtime.int8_graph import fuse_int8_layers
from rna_sdk.runtime.layer_chain import Layer, find_chain, floats

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


def convolve_layers(model: bytes, largest_query: float = np.inf) -> bytes:
    """`model` with its chain of fully connected layers as 1 x 1 convolutions.

    The result reads `queries` as float32 [1, 1, n, k], where k has been padded; what it gives
    for the added columns makes no difference. A Clip of the queries that changes none of them up
    to `largest_query` is left out. The bytes come back as they are where the graph
    has no such chain, or a hidden layer does not fill whole blocks of channels.
    """
    message = Message(memoryview(model))
    graph = message.message(7)
    try:
        layers = find_chain(graph, _QUERIES)
    except (WireError, ValueError):
        return model
    if len(layers) < 2 or any(len(layer.weight) % _BLOCK for layer in layers[1:]):
        return model
    return _assemble(message, graph, layers, _idle_clip(graph, layers[0], largest_query))


def _idle_clip(graph: Message, first: Layer, largest_query: float) -> int | None:
    """Place of the node that clips the queries for the first layer, if it changes none."""
    constants = {tensor.text(8): tensor for tensor in graph.messages(5)}
    for place, node in enumerate(graph.messages(1)):
        inputs = node.texts(1)
        if node.text(4) != "Clip" or inputs[0] != _QUERIES or node.texts(2) != [first.input]:
            continue
        low, high = (floats(constants.get(name)) for name in (*inputs[1:], "", "")[:2])
        if low is not None and high is not None and largest_query <= min(-low.min(), high.max()):
            return place
    return None


def _assemble(model: Message, graph: Message, layers: list[Layer], idle: int | None) -> bytes:
    """The model with `layers` as convolutions, and without the node `idle` before them.

    Types of values in between are left out: they may name shapes that have changed.
    """
    width = len(layers[0].weight)
    columns = max(-(-width // _INPUT_STEP) * _INPUT_STEP, _BLOCK)
    nodes = [[node] for node in pb.chunks(graph, 1)]
    tensors = pb.chunks(graph, 5)
    for layer in layers:
        source = _PIXELS if layer is layers[0] else layer.input
        result = _RESULT if layer is layers[-1] else layer.output
        nodes[layer.place] = [_convolution(layer, source, result)]
        tensors += _constants(layer, columns - width if layer is layers[0] else 0)
    source = layers[0].input
    if idle is not None:
        nodes[idle], source = [], _QUERIES
    nodes[layers[0].place].insert(0, _transpose(source, _PIXELS, [0, 3, 1, 2]))
    rows = _RESULT + "/rows"
    nodes[layers[-1].place] += [
        _transpose(_RESULT, rows, [0, 2, 3, 1]),
        pb.node("Reshape", [rows, _RESULT + "/shape"], layers[-1].output),
    ]
    tensors.append(pb.tensor(_RESULT + "/shape", np.array([-1, len(layers[-1].bias)])))
    fields = [pb.chunk(1, node) for group in nodes for node in group]
    fields += [pb.chunk(2, b"decoder"), *(pb.chunk(5, tensor) for tensor in tensors)]
    fields += [pb.chunk(11, pb.value(_QUERIES, [1, 1, "n", columns]))]
    fields += [pb.chunk(12, output) for output in pb.chunks(graph, 12)]
    opsets = b"".join(pb.chunk(8, opset) for opset in pb.chunks(model, 8))
    return pb.integer(1, model.integer(1)) + opsets + pb.chunk(7, b"".join(fields))


def _convolution(layer: Layer, source: str, result: str) -> bytes:
    """The layer on [1, channels, 1, n]."""
    operands = [source, layer.output + "/kernel", layer.output + "/bias"]
    return pb.node("Conv", operands, result, {"kernel_shape": [1, 1]})


def _constants(layer: Layer, added_inputs: int) -> list[bytes]:
    """Kernel and bias of the layer's convolution; added inputs weigh nothing."""
    kernel = np.pad(layer.weight.T, ((0, 0), (0, added_inputs)))[:, :, None, None]
    return [
        pb.tensor(layer.output + "/kernel", kernel),
        pb.tensor(layer.output + "/bias", layer.bias),
    ]


def _transpose(source: str, result: str, order: list[int]) -> bytes:
    """onnxruntime folds a transpose of these orders into its blocking of channels."""
    return pb.node("Transpose", [source], result, {"perm": order})
