"""The decoder profile: what keeps to it, and what leaves it at which node."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import onnx
import pytest
from onnx import helper, numpy_helper

from rna_sdk.package.decoder.onnx_model import read_model
from rna_sdk.package.decoder.profile_decoder import read_profile, saturating_weights
from tests.package.builders import make_decoder_model, make_int8_decoder_model


def reason(model: onnx.ModelProto) -> str | None:
    found = read_profile(read_model(memoryview(model.SerializeToString())))
    return found if isinstance(found, str) else None


def models() -> list[onnx.ModelProto]:
    return [make_decoder_model(18, 8, 2), make_int8_decoder_model(18, 8, 2, in_profile=True)]


def end_in_a_matrix(model: onnx.ModelProto) -> None:
    model.graph.node[-1].op_type = "MatMul"
    replace(model, "unit", np.eye(6, dtype=np.float32))


def replace(model: onnx.ModelProto, name: str, value: np.ndarray) -> None:
    (tensor,) = (t for t in model.graph.initializer if t.name == name)
    tensor.CopyFrom(numpy_helper.from_array(np.asarray(value), name))


@pytest.mark.parametrize("model", models(), ids=["float32", "int8"])
def test_both_precisions_and_both_ends_keep_to_it(model: onnx.ModelProto) -> None:
    assert reason(model) is None
    end_in_a_matrix(model)
    assert reason(model) is None


def node_of(model: onnx.ModelProto, operator: str) -> onnx.NodeProto:
    return next(node for node in model.graph.node if node.op_type == operator)


def scale_the_product(model: onnx.ModelProto) -> None:
    node_of(model, "Gemm").attribute.append(helper.make_attribute("alpha", 2.0))


def read_a_value_twice(model: onnx.ModelProto) -> None:
    model.graph.node.append(helper.make_node("Exp", [node_of(model, "Gemm").output[0]], ["other"]))


def leave_the_exponential_out(model: onnx.ModelProto) -> None:
    node_of(model, "Exp").op_type = "Relu"


def another_constant_type(model: onnx.ModelProto) -> None:
    replace(model, "one", np.ones(1, np.float32))


def subtract_another_number(model: onnx.ModelProto) -> None:
    replace(model, "one", np.float32(2))


def let_negative_logarithms_through(model: onnx.ModelProto) -> None:
    replace(model, "zero", np.float32(-1))


def constants_unpacked(model: onnx.ModelProto) -> None:
    (tensor,) = (t for t in model.graph.initializer if t.name == "one")
    tensor.CopyFrom(helper.make_tensor("one", 1, (), [1.0]))


def a_dangling_dequantizer(model: onnx.ModelProto) -> None:
    model.graph.node.append(helper.make_node("DequantizeLinear", ["zero", "one"], ["other"]))


@pytest.mark.parametrize("model", models(), ids=["float32", "int8"])
@pytest.mark.parametrize(
    "change",
    [
        scale_the_product,
        read_a_value_twice,
        leave_the_exponential_out,
        another_constant_type,
        subtract_another_number,
        let_negative_logarithms_through,
        constants_unpacked,
        a_dangling_dequantizer,
    ],
)
def test_other_graphs_leave_it(
    model: onnx.ModelProto, change: Callable[[onnx.ModelProto], None]
) -> None:
    change(model)
    assert reason(model) is not None


def test_a_layer_with_a_zero_point_leaves_it() -> None:
    assert "QuantizeLinear" in (reason(make_int8_decoder_model(18, 8, 2)) or "")


@pytest.mark.parametrize(
    ("name", "value"),
    [("z1", np.uint8(1)), ("t1", np.full(8, 0.1, np.float32)), ("step1", np.float32(2))],
)
def test_int8_scales_that_do_not_belong_together_leave_it(name: str, value: np.ndarray) -> None:
    model = make_int8_decoder_model(18, 8, 2, in_profile=True)
    replace(model, name, value)
    assert reason(model) is not None


def test_two_scales_for_one_value_leave_it() -> None:
    model = make_int8_decoder_model(18, 8, 2, in_profile=True)
    model.graph.initializer.append(numpy_helper.from_array(np.float32(0.5), "other"))
    node = next(n for n in model.graph.node if n.op_type == "DequantizeLinear")
    node.input[1] = "other"
    assert "two scales" in (reason(model) or "")


def test_saturating_weights_are_named() -> None:
    for largest, names in ((64, []), (127, ["w0", "w1", "w2"])):
        model = make_int8_decoder_model(18, 64, 2, largest=largest, in_profile=True)
        assert saturating_weights(read_model(memoryview(model.SerializeToString()))) == names
