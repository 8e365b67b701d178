"""The ONNX file of a decoder: the inverse of `decoder_from_bytes`."""

import numpy as np

from rna_sdk.package.decoder.decoder_form import INPUT_NAME
from rna_sdk.package.decoder.onnx_writer import GraphWriter, value
from rna_sdk.package.decoder.profile_decoder import ProfileDecoder


def decoder_to_bytes(decoder: ProfileDecoder, producer: str = "") -> bytes:
    """The decoder as a chain of nodes (spec/RNA.md, 6.2); equal decoders give equal bytes.

    producer: name of the software that made it.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     data = bytes(package.decoder("small"))
        >>> decoder_to_bytes(decoder_from_bytes(data, "small"), "rna-export") == data
        True
    """
    graph = GraphWriter()
    x = graph.node("Clip", INPUT_NAME, decoder.low, decoder.high)
    x = _int8_layers(graph, x, decoder) if decoder.is_int8 else _float_layers(graph, x, decoder)
    write_ending(graph, x, decoder)
    ends = (INPUT_NAME, decoder.columns), (decoder.output, decoder.outputs)
    source, result = (value(name, ["N", columns]) for name, columns in ends)
    return graph.model(source, result, producer=producer)


def _float_layers(graph: GraphWriter, x: str, decoder: ProfileDecoder) -> str:
    for layer in decoder.layers:
        x = graph.node("Gemm", x, layer.weight, layer.bias)
        x = graph.node("Relu", x) if layer.relu else x
    return x


def _int8_layers(graph: GraphWriter, x: str, decoder: ProfileDecoder) -> str:
    """Gemm between DequantizeLinear and QuantizeLinear, whose clamping at 0 is the ReLU."""
    assert decoder.gain is not None and decoder.offset is not None
    x = graph.node("Add", graph.node("Mul", x, decoder.gain), decoder.offset)
    zero = graph.constant(np.uint8(0))
    for layer in decoder.layers:
        assert layer.scale is not None and layer.unit is not None
        step = graph.constant(layer.step)
        x = graph.node("QuantizeLinear", x, step, zero)
        x = graph.node("DequantizeLinear", x, step, zero)
        weight = graph.node("DequantizeLinear", layer.weight, layer.scale, axis=1)
        bias = graph.node("DequantizeLinear", layer.bias, layer.unit, axis=0)
        x = graph.node("Gemm", x, weight, bias)
    return x


def write_ending(graph: GraphWriter, x: str, decoder: ProfileDecoder) -> None:
    """The nodes from the last layer's result x to the decoder's."""
    x = graph.node("Exp", graph.node("Clip", x, 0.0, decoder.top))
    x = graph.node("Sub", x, 1.0)
    if decoder.matrix is None:
        graph.node("Mul", x, decoder.unit, output=decoder.output)
    else:
        graph.node("MatMul", x, decoder.matrix, output=decoder.output)
