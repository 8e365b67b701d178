"""int8 decoders in the form the runtime gives them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import onnx
import pytest
from onnx import helper, numpy_helper
from onnx.reference import ReferenceEvaluator

from rna_sdk.package.decoder.profile_decoder import read_profile_decoder
from rna_sdk.runtime.engine.decoder_graph import fast_graph
from rna_sdk.runtime.engine.decoder_sessions import Decoder, _fast_form
from tests.package.builders import make_int8_decoder_model

Change = Callable[[onnx.ModelProto], None]


def fused_operators(model: onnx.ModelProto) -> list[str]:
    fused = fast_graph(read_profile_decoder(model.SerializeToString(), "decoder"), np.inf)
    assert fused is not None
    return [node.op_type for node in onnx.load_from_string(fused[0]).graph.node]


def make_model(*sizes: int) -> onnx.ModelProto:
    return make_int8_decoder_model(*sizes, opset=19, in_profile=True)


def random_queries(n: int) -> np.ndarray:
    return np.random.default_rng(0).normal(size=(n, 22)).astype(np.float32)


@pytest.mark.parametrize(("width", "layers"), [(8, 1), (24, 2), (64, 4), (128, 3), (384, 2)])
def test_integers_equal_the_format(width: int, layers: int) -> None:
    model = make_model(22, width, layers)
    queries = random_queries(2000)
    (expected,) = ReferenceEvaluator(model).run(None, {"queries": queries})
    found = Decoder(model.SerializeToString()).run(queries)
    close = np.isclose(found, expected, rtol=1e-4, atol=1e-5).all(axis=1)
    # Sums in the middle between two steps may round either way; the next step is near.
    assert close.mean() > 0.98
    assert np.abs(np.log1p(found) - np.log1p(expected)).max() < 0.05
    assert expected.std() > 0.5


@pytest.mark.parametrize(
    ("width", "convolutions", "products"), [(64, 3, 1), (256, 3, 1), (264, 0, 4)]
)
def test_each_layer_is_one_operator(width: int, convolutions: int, products: int) -> None:
    fused = fused_operators(make_model(22, width, 3))
    assert (fused.count("QLinearConv"), fused.count("QGemm")) == (convolutions, products)
    assert not {"Gemm", "QuantizeLinear", "DequantizeLinear", "Add"} & set(fused)


@pytest.mark.parametrize("width", [8, 24, 64, 100, 256, 264])
def test_a_row_does_not_depend_on_place_or_number_of_rows(width: int) -> None:
    decoder = Decoder(make_model(22, width, 4).SerializeToString())
    queries = random_queries(2048)
    expected = decoder.run(queries)
    for rows in (1, 2, 3, 5, 7, 11, 13, 16, 48, 100, 1000):
        for start in (0, 1, 5, 17, 1001):
            part = slice(start, start + rows)
            np.testing.assert_array_equal(decoder.run(queries[part]), expected[part])


def test_any_finite_query_gives_finite_transport() -> None:
    decoder = Decoder(make_model(22, 64, 4).SerializeToString())
    odd = np.float32([0.0, -0.0, 3.4e38, -3.4e38, 1e-45, -1e-40, 65504.0, 1.0])
    transport = decoder.run(np.random.default_rng(0).choice(odd, (5000, 22)))
    assert np.isfinite(transport).all() and (transport >= 0).all()


def replace_constant(model: onnx.ModelProto, name: str, value: np.ndarray) -> None:
    (tensor,) = (t for t in model.graph.initializer if t.name == name)
    tensor.CopyFrom(numpy_helper.from_array(value, name))


def shift_the_weights(model: onnx.ModelProto) -> None:
    zeros = numpy_helper.from_array(np.full(64, 3, np.int8), "shift")
    model.graph.initializer.append(zeros)
    next(node for node in model.graph.node if node.output[0] == "v0").input.append("shift")


def scale_the_bias_otherwise(model: onnx.ModelProto) -> None:
    replace_constant(model, "t0", np.full(64, 1e-3, np.float32))


def multiply_the_product(model: onnx.ModelProto) -> None:
    gemm = next(node for node in model.graph.node if node.op_type == "Gemm")
    gemm.attribute.append(helper.make_attribute("alpha", 2.0))


def store_signed(model: onnx.ModelProto) -> None:
    replace_constant(model, "z0", np.int8(0))


def give_out_the_sums(model: onnx.ModelProto) -> None:
    model.graph.node.append(helper.make_node("Relu", ["y0"], ["seen"]))


def read_the_queries_steps_twice(model: onnx.ModelProto) -> None:
    model.graph.node.append(helper.make_node("DequantizeLinear", ["q0", "step0", "z0"], ["seen"]))


@pytest.mark.parametrize(
    "change",
    [
        shift_the_weights,
        scale_the_bias_otherwise,
        multiply_the_product,
        store_signed,
        give_out_the_sums,
        read_the_queries_steps_twice,
    ],
)
def test_graphs_outside_the_profile_run_as_they_are(change: Change) -> None:
    model = make_model(22, 64, 2)
    change(model)
    assert _fast_form(model.SerializeToString(), np.inf) is None
    queries = random_queries(500)
    (expected,) = ReferenceEvaluator(model).run(None, {"queries": queries})
    found = Decoder(model.SerializeToString()).run(queries)
    assert np.isclose(found, expected, rtol=1e-4, atol=1e-5).all(axis=1).mean() > 0.95


def test_queries_may_have_another_step_than_one() -> None:
    model = make_model(22, 64, 2)
    for name in ("gain", "offset", "step0", "s0", "t0"):
        (tensor,) = (t for t in model.graph.initializer if t.name == name)
        factor = np.float32(4.0 if name in ("gain", "offset", "step0") else 0.25)
        factor = np.float32(1) if name == "t0" else factor
        replace_constant(model, name, numpy_helper.to_array(tensor) * factor)
    decoder = Decoder(model.SerializeToString())
    assert decoder._form._entry is not None
    queries = random_queries(500)
    expected = Decoder(make_model(22, 64, 2).SerializeToString()).run(queries)
    np.testing.assert_array_equal(decoder.run(queries), expected)
