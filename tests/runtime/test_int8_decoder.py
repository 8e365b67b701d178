"""int8 decoders in the form the runtime gives them."""

from dataclasses import replace

import numpy as np
import onnx
import pytest

from rna_sdk.package import ProfileDecoder
from rna_sdk.runtime.engine.decoder_graph import fast_graph
from rna_sdk.runtime.engine.decoder_sessions import Decoder
from tests.package.builders import random_int8_decoder
from tests.package.onnx_reference import onnx_result


def fused_operators(decoder: ProfileDecoder) -> list[str]:
    fused = fast_graph(decoder, np.inf)
    assert fused is not None
    return [node.op_type for node in onnx.load_from_string(fused[0]).graph.node]


def random_queries(n: int) -> np.ndarray:
    return np.random.default_rng(0).normal(size=(n, 22)).astype(np.float32)


@pytest.mark.parametrize(("width", "layers"), [(8, 1), (24, 2), (64, 4), (128, 3), (384, 2)])
def test_integers_equal_the_format(width, layers):
    model = random_int8_decoder(22, width, layers)
    queries = random_queries(2000)
    expected = onnx_result(model, queries)
    actual = Decoder(model).run(queries)
    close = np.isclose(actual, expected, rtol=1e-4, atol=1e-5).all(axis=1)
    # Sums in the middle between two steps may round either way; the next step is near.
    assert close.mean() > 0.98
    assert np.abs(np.log1p(actual) - np.log1p(expected)).max() < 0.05
    assert expected.std() > 0.5


@pytest.mark.parametrize(
    ("width", "convolutions", "products"), [(64, 3, 1), (256, 3, 1), (264, 0, 4)]
)
def test_each_layer_is_one_operator(width, convolutions, products):
    fused = fused_operators(random_int8_decoder(22, width, 3))
    assert (fused.count("QLinearConv"), fused.count("QGemm")) == (convolutions, products)
    assert not {"Gemm", "QuantizeLinear", "DequantizeLinear", "Add"} & set(fused)


@pytest.mark.parametrize("width", [8, 24, 64, 100, 256, 264])
def test_a_row_does_not_depend_on_place_or_number_of_rows(width):
    decoder = Decoder(random_int8_decoder(22, width, 4))
    queries = random_queries(2048)
    expected = decoder.run(queries)
    for rows in (1, 2, 3, 5, 7, 11, 13, 16, 48, 100, 1000):
        for start in (0, 1, 5, 17, 1001):
            part = slice(start, start + rows)
            np.testing.assert_array_equal(decoder.run(queries[part]), expected[part])


def test_any_finite_query_gives_finite_transport():
    decoder = Decoder(random_int8_decoder(22, 64, 4))
    odd = np.float32([0.0, -0.0, 3.4e38, -3.4e38, 1e-45, -1e-40, 65504.0, 1.0])
    transport = decoder.run(np.random.default_rng(0).choice(odd, (5000, 22)))
    assert np.isfinite(transport).all() and (transport >= 0).all()


def test_queries_may_have_another_step_than_one():
    one = random_int8_decoder(22, 64, 2)
    assert one.gain is not None and one.offset is not None and one.layers[0].scale is not None
    first = replace(one.layers[0], step=4.0, scale=one.layers[0].scale / 4)
    four = replace(one, gain=4 * one.gain, offset=4 * one.offset, layers=(first, *one.layers[1:]))
    decoder = Decoder(four)
    assert decoder._form._entry is not None
    queries = random_queries(500)
    np.testing.assert_array_equal(decoder.run(queries), Decoder(one).run(queries))
