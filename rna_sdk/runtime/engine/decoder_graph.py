"""A decoder as another graph: the same arithmetic in a form that onnxruntime runs
faster.

float32: onnxruntime runs Gemm + Relu in three passes over the activations: copy the bias, multiply
and add, clamp. A 1 x 1 convolution over a row of "pixels", one query each, is the same layer, and
its blocked form on x86 does all three while the result is in registers: at width 64 a layer takes
44 to 46 ns/query instead of 55 to 59.

    queries [1, 1, n, k padded] -> Transpose -> Conv -> Relu -> ... -> Conv -> Transpose,
    Reshape -> [n, m]

int8: onnxruntime has two operators for a layer in integers: QGemm, and for a 1 x 1 convolution
QLinearConv. The second is faster up to 256 neurons: at width 64 a query takes 88 ns instead of 157,
at 128 256 instead of 326, at 256 760 instead of 820, at 512 2,740 instead of 1,880. Only QGemm
gives float32.

    uint8 [n, k padded] -> Reshape -> [1, 1, n, k] -> QLinearConv -> ... -> Reshape -> QGemm
    -> [n, m]

Without VNNI, both add products of uint8 and int8 two by two in 16 bits. Weights that can saturate
these (`package/decoder/saturation.py`) are therefore handed over as uint8 with zero point 128,
whose products are added in 32 bits on every CPU, if more slowly.
"""

import platform
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder.decoder_form import INPUT_NAME
from rna_sdk.package.decoder.decoder_writer import write_ending
from rna_sdk.package.decoder.onnx_writer import GraphWriter
from rna_sdk.package.decoder.onnx_writer import value as value_info
from rna_sdk.package.decoder.profile_decoder import ProfileDecoder
from rna_sdk.package.decoder.saturation import can_saturate
from rna_sdk.runtime.engine.int8_entry import Entry

_BLOCK = 16
"""Channels that onnxruntime's blocked convolution takes together on AVX-512; 8 on AVX2."""

_INPUT_STEP = 4
"""The first layer's channels must be a multiple of this, and at least a block."""

_WIDEST_CONVOLUTION = 256
_DOMAIN = "com.microsoft"  # onnxruntime's own operators; this QLinearConv takes channels last


def fast_graph(decoder: ProfileDecoder, largest_query: float) -> tuple[bytes, Entry | None] | None:
    """The decoder's graph for this machine; None where the chain of the format is as fast.

    With an Entry, what it makes of the queries is what the graph takes.

    largest_query: no number in the queries will be further from 0.
    """
    if platform.machine().lower() not in ("x86_64", "amd64"):
        return None  # measured, and onnxruntime has the blocked convolution, on x86 only
    if (entry := Entry.of(decoder)) is not None:
        return int8_graph(decoder, entry.columns), entry
    data = float_graph(decoder, largest_query)
    return None if data is None else (data, None)


def float_graph(decoder: ProfileDecoder, largest_query: float = np.inf) -> bytes | None:
    """A decoder in float32 with 1 x 1 convolutions as its layers.

    It reads `queries` as float32 [1, 1, n, k], where k has been padded; what it gives for the added
    columns makes no difference. A Clip of the queries that changes none of them up to
    `largest_query` is left out. None where a hidden layer does not fill whole blocks of channels.
    """
    layers = decoder.layers
    if len(layers) < 2 or any(len(layer.weight) % _BLOCK for layer in layers[1:]):
        return None
    width = len(layers[0].weight)
    columns = max(-(-width // _INPUT_STEP) * _INPUT_STEP, _BLOCK)
    graph, value = GraphWriter(), INPUT_NAME
    if largest_query > min(-decoder.low, decoder.high):
        value = graph.node("Clip", value, decoder.low, decoder.high)
    # onnxruntime folds a transpose of these orders into its blocking of channels.
    value = graph.node("Transpose", value, perm=[0, 3, 1, 2])
    for layer in layers:
        added = columns - width if layer is layers[0] else 0
        kernel = np.pad(layer.weight.T, ((0, 0), (0, added)))[:, :, None, None]
        value = graph.node("Conv", value, kernel, layer.bias, kernel_shape=[1, 1])
        value = graph.node("Relu", value) if layer.relu else value
    value = graph.node("Transpose", value, perm=[0, 2, 3, 1])
    value = graph.node("Reshape", value, np.array([-1, len(layers[-1].bias)]))
    return _closed(graph, value, decoder, value_info(INPUT_NAME, [1, 1, "n", columns]))


def int8_graph(decoder: ProfileDecoder, columns: int) -> bytes:
    """A decoder in int8 with one operator in integers for each layer.

    It reads the first layer's inputs as uint8 [n, columns], those beyond the layer's of no weight.
    """
    graph, value, convolved = GraphWriter(), INPUT_NAME, False
    for layer, following in zip(decoder.layers, (*decoder.layers[1:], None), strict=True):
        assert layer.scale is not None
        added = columns - len(layer.weight) if layer is decoder.layers[0] else 0
        weight, zero = _exact_weight(np.pad(layer.weight, ((0, added), (0, 0))))
        inputs, outputs = weight.shape
        before = convolved
        convolved = following is not None and outputs <= _WIDEST_CONVOLUTION
        if convolved != before:
            shape = [1, 1, -1, inputs] if convolved else [-1, inputs]
            value = graph.node("Reshape", value, np.array(shape))
        step, zeros = np.float32(layer.step), np.full(outputs, zero)
        result: list[np.generic] = []
        if following is not None:
            result = [np.float32(following.step), np.uint8(0)]
        if convolved:
            value = graph.node(
                "QLinearConv",
                value,
                step,
                np.uint8(0),
                weight.T[:, :, None, None],
                layer.scale,
                zeros,
                *result,
                layer.bias,
                domain=_DOMAIN,
                kernel_shape=[1, 1],
                channels_last=1,
            )
        else:
            value = graph.node(
                "QGemm",
                value,
                step,
                np.uint8(0),
                weight,
                layer.scale,
                zeros,
                layer.bias,
                *result,
                domain=_DOMAIN,
            )
    return _closed(graph, value, decoder, value_info(INPUT_NAME, ["N", columns], "uint8"))


def _exact_weight(weight: NDArray[np.int8]) -> tuple[NDArray[Any], np.integer[Any]]:
    """The weight in a dtype whose products no engine sums with saturation, and its zero point."""
    if not can_saturate(weight):
        return weight, np.int8(0)
    return (weight.astype(np.int16) + 128).astype(np.uint8), np.uint8(128)


def _closed(graph: GraphWriter, value: str, decoder: ProfileDecoder, queries: bytes) -> bytes:
    """The model from `queries` to the result, made from the last layer's output."""
    write_ending(graph, value, decoder)
    result = value_info(decoder.output, ["N", decoder.outputs])
    return graph.model(queries, result, domain=_DOMAIN)
