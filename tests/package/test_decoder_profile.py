"""The decoder profile: its graphs come back and run as in ONNX; other graphs are refused."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import onnx
import pytest
from onnx import helper, numpy_helper

from rna_sdk.errors import PackageError
from rna_sdk.package import ProfileDecoder, decoder_from_bytes, decoder_to_bytes
from tests.package.builders import random_decoder, random_int8_decoder
from tests.package.onnx_reference import onnx_result

Change = Callable[[onnx.ModelProto], object]
DECODERS = [random_decoder(18, 8, 2), random_int8_decoder(18, 8, 2)]
BOTH = pytest.mark.parametrize("decoder", DECODERS, ids=["float32", "int8"])


def with_matrix(decoder: ProfileDecoder) -> ProfileDecoder:
    matrix = np.random.default_rng(1).uniform(0, 1, (6, 3)).astype(np.float32)
    return replace(decoder, matrix=matrix, output="emission")


@pytest.mark.parametrize("ending", [lambda decoder: decoder, with_matrix], ids=["unit", "matrix"])
@BOTH
def test_what_is_written_is_what_is_read(decoder, ending):
    decoder = ending(decoder)
    data = decoder_to_bytes(decoder, "tests")
    onnx.checker.check_model(onnx.load_from_string(data))
    actual = decoder_from_bytes(data, "x")
    assert decoder_to_bytes(actual, "tests") == data
    assert (actual.is_int8, actual.columns, actual.outputs) == (
        *(decoder.is_int8, 18, decoder.outputs),
    )
    queries = np.random.default_rng(0).normal(size=(500, 18)).astype(np.float32)
    expected = onnx_result(decoder, queries)
    close = np.isclose(actual.run(queries), expected, rtol=1e-4, atol=1e-5).all(axis=1)
    assert close.mean() >= (0.98 if decoder.is_int8 else 1)  # ties of int8 round either way
    assert expected.std() > 0.1


def test_runs_in_double_precision():
    queries = np.random.default_rng(0).normal(size=(200, 18))
    for decoder in DECODERS:
        single, double = decoder.run(queries.astype(np.float32)), decoder.run(queries)
        assert (single.dtype, double.dtype) == (np.float32, np.float64)
        assert np.isclose(single, double, rtol=1e-3, atol=1e-4).all(axis=1).mean() > 0.98


def test_cost_is_a_sum_over_layers():
    decoder = random_decoder(18, 8, 2)
    assert (decoder.values, decoder.multiply_adds) == (8 + 8 + 6 + 6, 18 * 8 + 8 * 8 + 8 * 6)
    mixed = with_matrix(decoder)
    assert mixed.multiply_adds == decoder.multiply_adds + 6 * 3 and mixed.values == 8 + 8 + 6 + 3


def node_of(model: onnx.ModelProto, operator: str, number: int = 0) -> onnx.NodeProto:
    return [node for node in model.graph.node if node.op_type == operator][number]


def with_operand(model: onnx.ModelProto, node: onnx.NodeProto, value: object) -> None:
    """Another constant as the second operand of a node."""
    model.graph.initializer.append(numpy_helper.from_array(np.asarray(value), "other"))
    node.input[1] = "other"


def scale_the_product(model: onnx.ModelProto) -> None:
    node_of(model, "Gemm").attribute.append(helper.make_attribute("alpha", 2.0))


def read_a_value_twice(model: onnx.ModelProto) -> None:
    model.graph.node.append(helper.make_node("Exp", [node_of(model, "Gemm").output[0]], ["other"]))


def leave_the_exponential_out(model: onnx.ModelProto) -> None:
    node_of(model, "Exp").op_type = "Relu"


def another_shape_of_a_number(model: onnx.ModelProto) -> None:
    with_operand(model, node_of(model, "Sub"), np.ones(1, np.float32))


def let_negative_logarithms_through(model: onnx.ModelProto) -> None:
    with_operand(model, node_of(model, "Clip", 1), np.float32(-1))


def constants_unpacked(model: onnx.ModelProto) -> None:
    tensor = next(t for t in model.graph.initializer if t.name == node_of(model, "Sub").input[1])
    tensor.CopyFrom(helper.make_tensor(tensor.name, 1, (), [1.0]))


def a_dangling_dequantizer(model: onnx.ModelProto) -> None:
    one = node_of(model, "Sub").input[1]
    model.graph.node.append(helper.make_node("DequantizeLinear", [one, one], ["other"]))


def a_constant_that_is_the_queries(model: onnx.ModelProto) -> None:
    model.graph.initializer.append(numpy_helper.from_array(np.float32(1), "queries"))


def an_output_before_the_end(model: onnx.ModelProto) -> None:
    model.graph.output[0].name = node_of(model, "Exp").output[0]


@pytest.mark.parametrize(
    "change",
    [
        scale_the_product,
        read_a_value_twice,
        leave_the_exponential_out,
        another_shape_of_a_number,
        let_negative_logarithms_through,
        constants_unpacked,
        a_dangling_dequantizer,
        a_constant_that_is_the_queries,
        an_output_before_the_end,
    ],
)
@BOTH
def test_other_graphs_are_refused(decoder, change):
    refused(decoder, change)


def a_zero_point(model: onnx.ModelProto) -> None:
    for operator in ("QuantizeLinear", "DequantizeLinear"):
        node_of(model, operator).input[2] = "other"
    model.graph.initializer.append(numpy_helper.from_array(np.uint8(1), "other"))


def a_zero_point_of_weights(model: onnx.ModelProto) -> None:
    model.graph.initializer.append(numpy_helper.from_array(np.zeros(8, np.int8), "other"))
    node_of(model, "DequantizeLinear", 1).input.append("other")


def a_bias_of_another_scale(model: onnx.ModelProto) -> None:
    with_operand(model, node_of(model, "DequantizeLinear", 2), np.full(8, 0.1, np.float32))


def two_scales_for_one_value(model: onnx.ModelProto) -> None:
    with_operand(model, node_of(model, "DequantizeLinear"), np.float32(0.5))


def weights_dequantised_too_late(model: onnx.ModelProto) -> None:
    nodes = list(model.graph.node)
    nodes.append(nodes.pop(nodes.index(node_of(model, "DequantizeLinear", 1))))
    del model.graph.node[:]
    model.graph.node.extend(nodes)


def scales_along_the_inputs(model: onnx.ModelProto) -> None:
    node_of(model, "DequantizeLinear", 1).attribute[0].i = 0


@pytest.mark.parametrize(
    "change",
    [
        a_zero_point,
        a_zero_point_of_weights,
        a_bias_of_another_scale,
        two_scales_for_one_value,
        weights_dequantised_too_late,
        scales_along_the_inputs,
    ],
)
def test_other_quantisations_are_refused(change):
    refused(DECODERS[1], change)


def refused(decoder: ProfileDecoder, change: Change) -> None:
    model = onnx.load_from_string(decoder_to_bytes(decoder))
    change(model)
    with pytest.raises(PackageError, match="DECODER_PROFILE at x#/graph/") as caught:
        decoder_from_bytes(model.SerializeToString(), "x")
    assert "expected" in str(caught.value)
