"""int8 weights that engines may sum two by two in 16 bits: found from the weights, and exact."""

import itertools
from dataclasses import replace

import numpy as np
import onnx
import pytest
from onnx import numpy_helper

from rna_sdk.package import ProfileDecoder
from rna_sdk.package.decoder.saturation import PAIR_LIMIT, can_saturate, pair_sums
from rna_sdk.runtime.engine.decoder_graph import int8_graph
from rna_sdk.runtime.engine.decoder_sessions import Decoder
from tests.package.builders import random_int8_decoder
from tests.package.onnx_reference import onnx_result


def column(*weights: int) -> np.ndarray:
    return np.array(weights, np.int8)[:, None]


@pytest.mark.parametrize(
    ("pair", "saturates"),
    [
        ((64, 64), False),
        ((65, 64), True),
        ((127, 1), False),
        ((127, 2), True),
        ((127, -128), False),
        ((-64, -64), False),
        ((-65, -64), True),
        ((-128, 0), False),
        ((-128, -1), True),
    ],
)
def test_a_pair_of_one_sign_may_add_up_to_the_limit(pair, saturates):
    assert can_saturate(column(*pair)) == saturates
    products = [q0 * pair[0] + q1 * pair[1] for q0, q1 in itertools.product((0, 255), repeat=2)]
    assert (min(products) < -(2**15) or max(products) >= 2**15) == saturates


def test_pairs_are_rows_2k_and_2k_plus_1_of_one_output():
    assert not can_saturate(column(0, 100, 100, 0))
    assert not can_saturate(np.array([[100, 0], [0, 100]], np.int8))
    np.testing.assert_array_equal(pair_sums(column(100, 20, -90)), [[120], [90]])


def with_weights(decoder: ProfileDecoder, low: int, high: int) -> ProfileDecoder:
    """The decoder with all weights taken from these two numbers, in random order."""
    rng, ends = np.random.default_rng(0), np.array([low, high], np.int8)
    layers = [replace(a, weight=rng.choice(ends, a.weight.shape)) for a in decoder.layers]
    return replace(decoder, layers=tuple(layers))


@pytest.mark.parametrize(("low", "high"), [(-64, 64), (-127, 127), (-128, 127)])
@pytest.mark.parametrize(("width", "columns"), [(16, 22), (64, 24), (130, 33), (264, 22)])
def test_sums_are_exact(low, high, width, columns):
    """Queries at both ends of their range make the largest products of all."""
    model = with_weights(random_int8_decoder(columns, width, 2), low, high)
    queries = np.random.default_rng(1).choice(np.float32([-9, 9]), (1001, columns))
    expected = onnx_result(model, queries)
    decoder = Decoder(model)
    for rows in (1, 2, 7, 16, 1001):
        actual = decoder.run(queries[:rows])
        close = np.isclose(actual, expected[:rows], rtol=1e-4, atol=1e-5)
        assert close.all(axis=1).mean() > 0.98
    assert len(np.unique(expected)) > 100


def test_weights_that_cannot_saturate_stay_int8():
    for limit, dtype in ((PAIR_LIMIT // 2, np.int8), (127, np.uint8)):
        decoder = with_weights(random_int8_decoder(22, 64, 2), -limit, limit)
        fused = onnx.load_from_string(int8_graph(decoder, 24))
        shapes = {(64, 24, 1, 1), (64, 64, 1, 1), (64, 6)}
        weights = [t for t in fused.graph.initializer if tuple(t.dims) in shapes]
        assert len(weights) == 3
        assert {numpy_helper.to_array(t).dtype for t in weights} == {np.dtype(dtype)}
