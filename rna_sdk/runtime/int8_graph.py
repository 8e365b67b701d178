"""Rewrite an int8 decoder for speed: the same integers in a form that onnxruntime runs faster.

onnxruntime has two operators for a layer between QuantizeLinear and DequantizeLinear: QGemm, and
for a 1 x 1 convolution over a row of "pixels", one query each, QLinearConv. The second is faster
up to 256 neurons: at width 64 a query takes 88 ns instead of 157, at 128 256 instead of 326, at
256 760 instead of 820, at 512 2,740 instead of 1,880. Only QGemm gives float32.

    uint8 [n, k] -> Reshape -> [1, 1, n, k] -> QLinearConv -> ... -> Reshape -> QGemm -> [n, m]

Without VNNI, both add products of uint8 and int8 two by two in 16 bits. Weights that can saturate
these (`package/saturation.py`) are therefore handed over as uint8 with zero point 128, whose
products are added in 32 bits on every CPU, if more slowly.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.protobuf import Message, WireError
from rna_sdk.package.saturation import can_saturate
from rna_sdk.runtime import onnx_bytes as pb
from rna_sdk.runtime.int8_entry import Entry, find_entry
from rna_sdk.runtime.int8_layers import Int8Layer, find_int8_layers

_QUERIES = "queries"
_WIDEST_CONVOLUTION = 256
_DOMAIN = "com.microsoft"  # onnxruntime's own operators; this QLinearConv takes channels last
_OWN = "rna_sdk"  # begins the names of values that the rewriting adds


def fuse_int8_layers(model: bytes) -> tuple[bytes, Entry | None]:
    """`model` with an operator in integers for each int8 layer; as it is where it has none.

    With an Entry the model no longer takes queries, but what the entry makes of them.
    """
    message = Message(memoryview(model))
    graph = message.message(7)
    try:
        layers = find_int8_layers(graph)
        entry = _entry(graph, layers[0]) if layers else None
    except (WireError, ValueError):
        return model, None
    if not layers:
        return model, None
    if entry is not None:
        added = entry.columns - len(entry.gain)
        weight = np.pad(layers[0].weight, ((0, added), (0, 0)))
        layers[0] = replace(layers[0], weight=weight)
    return _assemble(message, graph, layers, entry), entry


def _entry(graph: Message, first: Int8Layer) -> Entry | None:
    """How queries become the first layer's input, if nothing else reads that."""
    source = first.input[0]
    others = (node for k, node in enumerate(graph.messages(1)) if k not in first.places)
    if any(source in node.texts(1) for node in others):
        return None
    return find_entry(graph, _QUERIES, source)


def _assemble(
    model: Message, graph: Message, layers: list[Int8Layer], entry: Entry | None
) -> bytes:
    """The model with each layer's nodes replaced, and without those of the entry."""
    nodes = [[node] for node in pb.chunks(graph, 1)]
    tensors = pb.chunks(graph, 5)
    fused = {place for layer in layers for place in layer.places}
    fused.update(entry.places if entry else ())
    for place in fused:
        nodes[place] = []
    others = [node for k, node in enumerate(graph.messages(1)) if k not in fused]
    rows = {name for node in others for name in node.texts(1)}
    rows |= {layer.input[0] for layer in layers if not _is_convolved(layer)}
    pixels: set[str] = set()
    for layer in layers:
        group, source, result = nodes[layer.places[0]], layer.input[0], layer.output[0]
        inputs, outputs = layer.weight.shape
        if _is_convolved(layer) and source not in pixels:
            tensors.append(pb.tensor(_own(source, "shape"), np.array([1, 1, -1, inputs])))
            group.append(pb.node("Reshape", [source, _own(source, "shape")], _pixels(source)))
        tensors += _tensors(layer)
        if not _is_convolved(layer):
            group.append(_product(layer))
            continue
        group.append(_convolution(layer))
        pixels |= {source, result}
        if result in rows:
            tensors.append(pb.tensor(_own(result, "rows"), np.array([-1, outputs])))
            group.append(pb.node("Reshape", [_pixels(result), _own(result, "rows")], result))
    fields = [pb.chunk(1, node) for group in nodes for node in group]
    fields += [pb.chunk(2, b"decoder"), *(pb.chunk(5, tensor) for tensor in tensors)]
    queries = pb.chunks(graph, 11)
    if entry is not None:
        queries = [pb.value(layers[0].input[0], ["N", entry.columns], "uint8")]
    fields += [pb.chunk(11, value) for value in queries]
    fields += [pb.chunk(12, value) for value in pb.chunks(graph, 12)]
    opsets = [*pb.chunks(model, 8), pb.opset(_DOMAIN, 1)]
    head = pb.integer(1, model.integer(1)) + b"".join(pb.chunk(8, o) for o in opsets)
    return head + pb.chunk(7, b"".join(fields))


def _is_convolved(layer: Int8Layer) -> bool:
    return len(layer.output) > 1 and len(layer.bias) <= _WIDEST_CONVOLUTION


def _own(value: str, part: str) -> str:
    return f"{_OWN}/{value}/{part}"


def _pixels(value: str) -> str:
    return _own(value, "pixels")


def _convolution(layer: Int8Layer) -> bytes:
    """The layer on [1, 1, n, channels]."""
    (source, *input_constants), (result, *output_constants) = layer.input, layer.output
    weight = [_own(result, part) for part in ("weight", "scale", "zero")]
    operands = [_pixels(source), *input_constants, *weight, *output_constants]
    attributes: pb.Attributes = {"kernel_shape": [1, 1], "channels_last": 1}
    operands.append(_own(result, "bias"))
    return pb.node("QLinearConv", operands, _pixels(result), attributes, _DOMAIN)


def _product(layer: Int8Layer) -> bytes:
    """The layer on [n, channels]."""
    result, *output_constants = layer.output
    constants = [_own(result, part) for part in ("weight", "scale", "zero", "bias")]
    operands = [*layer.input, *constants, *output_constants]
    return pb.node("QGemm", operands, result, domain=_DOMAIN)


def _tensors(layer: Int8Layer) -> list[bytes]:
    """Weight, its scale and zero point, and bias."""
    weight, zero = _exact_weight(layer.weight)
    values: dict[str, NDArray[Any]] = {
        "weight": weight.T[:, :, None, None] if _is_convolved(layer) else weight,
        "scale": layer.weight_scale,
        "zero": np.full(len(layer.bias), zero),
        "bias": layer.bias,
    }
    return [pb.tensor(_own(layer.output[0], part), value) for part, value in values.items()]


def _exact_weight(weight: NDArray[np.int8]) -> tuple[NDArray[Any], np.integer[Any]]:
    """The weight in a dtype whose products no engine sums with saturation, and its zero point."""
    if not can_saturate(weight):
        return weight, np.int8(0)
    return (weight.astype(np.int16) + 128).astype(np.uint8), np.uint8(128)
