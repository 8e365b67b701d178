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

from rna_sdk.package.decoder.onnx_model import Model, read_model
from rna_sdk.package.decoder.protobuf import WireError
from rna_sdk.package.decoder.saturation import can_saturate
from rna_sdk.runtime.engine.graph_rewriting import GraphRewriting
from rna_sdk.runtime.engine.int8_entry import Entry, find_entry
from rna_sdk.runtime.engine.int8_layers import Int8Layer, find_int8_layers
from rna_sdk.runtime.engine.onnx_bytes import Attributes

_QUERIES = "queries"
_WIDEST_CONVOLUTION = 256
_DOMAIN = "com.microsoft"  # onnxruntime's own operators; this QLinearConv takes channels last
_OWN = "rna_sdk"  # begins the names of values that the rewriting adds


def fuse_int8_layers(data: bytes) -> tuple[bytes, Entry | None]:
    """The model with an operator in integers for each int8 layer; as it is where it has none.

    With an Entry the model no longer takes queries, but what the entry makes of them.
    """
    try:
        model = read_model(memoryview(data))
        layers = find_int8_layers(model)
        entry = _entry(model, layers[0]) if layers else None
    except (WireError, ValueError):
        return data, None
    if not layers:
        return data, None
    if entry is not None:
        added = entry.columns - len(entry.gain)
        weight = np.pad(layers[0].weight, ((0, added), (0, 0)))
        layers[0] = replace(layers[0], weight=weight)
    return _fused(model, layers, entry), entry


def _entry(model: Model, first: Int8Layer) -> Entry | None:
    """The graph's entry from queries to the first layer's input; None if other nodes read that."""
    source = first.input[0]
    others = (node for k, node in enumerate(model.nodes) if k not in first.places)
    if any(source in node.inputs for node in others):
        return None
    return find_entry(model, _QUERIES, source)


def _fused(model: Model, layers: list[Int8Layer], entry: Entry | None) -> bytes:
    """The model with each layer's nodes replaced, and without those of the entry."""
    fused = {place for layer in layers for place in layer.places}
    fused.update(entry.places if entry else ())
    graph = GraphRewriting(model)
    graph.remove(fused)
    others = [node for k, node in enumerate(model.nodes) if k not in fused]
    rows = {name for node in others for name in node.inputs}
    rows |= {layer.input[0] for layer in layers if not _is_convolved(layer)}
    pixels: set[str] = set()
    for layer in layers:
        if _is_convolved(layer):
            _add_convolution(graph, layer, pixels, rows)
        else:
            _add_product(graph, layer)
    queries = None if entry is None else (layers[0].input[0], ("N", entry.columns), "uint8")
    return graph.to_bytes(queries, [(_DOMAIN, 1)])


def _is_convolved(layer: Int8Layer) -> bool:
    return len(layer.output) > 1 and len(layer.bias) <= _WIDEST_CONVOLUTION


def _own(value: str, part: str) -> str:
    return f"{_OWN}/{value}/{part}"


def _pixels(value: str) -> str:
    return _own(value, "pixels")


def _add_convolution(
    graph: GraphRewriting, layer: Int8Layer, pixels: set[str], rows: set[str]
) -> None:
    """The layer on [1, 1, n, channels].

    pixels: values that are there in this shape; those of the layer are added. rows: values that
    are read as [n, channels].
    """
    (source, *input_constants), (result, *output_constants) = layer.input, layer.output
    place, (inputs, outputs) = layer.places[0], layer.weight.shape
    if source not in pixels:
        shape = graph.constant(_own(source, "shape"), np.array([1, 1, -1, inputs]))
        graph.add(place, "Reshape", [source, shape], _pixels(source))
    *weight, bias = _constants(graph, layer)
    operands = [_pixels(source), *input_constants, *weight, *output_constants, bias]
    attributes: Attributes = {"kernel_shape": [1, 1], "channels_last": 1}
    graph.add(place, "QLinearConv", operands, _pixels(result), attributes, _DOMAIN)
    pixels |= {source, result}
    if result in rows:
        shape = graph.constant(_own(result, "rows"), np.array([-1, outputs]))
        graph.add(place, "Reshape", [_pixels(result), shape], result)


def _add_product(graph: GraphRewriting, layer: Int8Layer) -> None:
    """The layer on [n, channels]."""
    result, *output_constants = layer.output
    operands = [*layer.input, *_constants(graph, layer), *output_constants]
    graph.add(layer.places[0], "QGemm", operands, result, domain=_DOMAIN)


def _constants(graph: GraphRewriting, layer: Int8Layer) -> list[str]:
    """Names of weight, its scale and zero point, and bias."""
    weight, zero = _exact_weight(layer.weight)
    values: dict[str, NDArray[Any]] = {
        "weight": weight.T[:, :, None, None] if _is_convolved(layer) else weight,
        "scale": layer.weight_scale,
        "zero": np.full(len(layer.bias), zero),
        "bias": layer.bias,
    }
    return [graph.constant(_own(layer.output[0], part), v) for part, v in values.items()]


def _exact_weight(weight: NDArray[np.int8]) -> tuple[NDArray[Any], np.integer[Any]]:
    """The weight in a dtype whose products no engine sums with saturation, and its zero point."""
    if not can_saturate(weight):
        return weight, np.int8(0)
    return (weight.astype(np.int16) + 128).astype(np.uint8), np.uint8(128)
