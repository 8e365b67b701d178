"""The decoder in the form the runtime gives it."""

import numpy as np
import onnx
import pytest

from rna_sdk.package import ProfileDecoder, decoder_to_bytes
from rna_sdk.runtime.engine import decoder_sessions as decoder_module
from rna_sdk.runtime.engine.decoder_graph import float_graph
from rna_sdk.runtime.engine.decoder_sessions import Decoder, DecoderWarning, Graph, _fast_form
from rna_sdk.runtime.engine.tiles import QueryFiller
from tests.package.builders import make_part, make_tier_part, random_decoder, random_int8_decoder
from tests.package.onnx_reference import onnx_result


def operators(model: bytes) -> list[str]:
    return [node.op_type for node in onnx.load_from_string(model).graph.node]


def convolved(decoder: ProfileDecoder, largest_query: float = np.inf) -> bytes:
    graph = float_graph(decoder, largest_query)
    assert graph is not None
    return graph


def run(model: bytes, queries: np.ndarray) -> np.ndarray:
    """Transport by onnxruntime, for a graph in either form."""
    graph = Graph(model)
    padded = np.zeros((len(queries), graph.columns), np.float32)
    padded[:, : queries.shape[1]] = queries
    return graph.run(padded)


def random_queries(n: int, columns: int = 22) -> np.ndarray:
    return np.random.default_rng(0).normal(size=(n, columns)).astype(np.float32)


@pytest.mark.parametrize("columns", [3, 16, 22, 25])
@pytest.mark.parametrize(("width", "layers"), [(16, 1), (32, 2), (64, 4), (128, 3)])
def test_convolutions_equal_the_layers(columns, width, layers):
    model = random_decoder(columns, width, layers)
    converted = convolved(model)
    assert operators(converted).count("Conv") == layers + 1
    assert "Gemm" not in operators(converted)
    queries = random_queries(1000, columns)
    plain = onnx_result(model, queries)
    np.testing.assert_allclose(run(converted, queries), plain, rtol=1e-4, atol=1e-5)
    onnx.checker.check_model(onnx.load_from_string(converted))


def test_padding_columns_do_not_count():
    decoder = Graph(convolved(random_decoder(22, 32, 2)))
    assert decoder.columns == 24
    queries = np.zeros((64, 24), np.float32)
    queries[:, :22] = random_queries(64)
    expected = decoder.run(queries)
    queries[:, 22:] = 1e3
    np.testing.assert_array_equal(decoder.run(queries), expected)


def test_layers_that_fill_no_blocks_stay_as_they_are():
    assert float_graph(random_decoder(22, 24, 2)) is None
    assert _fast_form(random_decoder(22, 150, 2), 100.0) is None


@pytest.mark.parametrize("as_it_is", [False, True])
@pytest.mark.parametrize("width", [8, 16, 24, 64, 100, 256])
def test_a_row_does_not_depend_on_place_or_number_of_rows(width, as_it_is):
    """What tiles rely on, of onnxruntime itself, and for row counts that tiles never have."""
    decoder = random_decoder(22, width, 4)
    graph = None if as_it_is else float_graph(decoder)
    model = graph or decoder_to_bytes(decoder)
    queries = random_queries(2048)
    expected = run(model, queries)
    for rows in (1, 2, 3, 5, 7, 11, 13, 16, 48, 100, 1000):
        for start in (0, 1, 5, 17, 1001):
            part = slice(start, start + rows)
            np.testing.assert_array_equal(run(model, queries[part]), expected[part])


def test_larger_decoders_take_fewer_rows_at_once():
    sizes = [Decoder(random_decoder(22, width, 4)).tile_rows for width in (64, 128, 192, 512)]
    assert sizes == [8192, 8192, 1024, 512]  # up to 128 compiled


@pytest.mark.parametrize(("largest", "clips"), [(100.0, 1), (65504.0, 1), (65505.0, 2)])
def test_a_clip_that_changes_no_query_is_left_out(largest, clips):
    model = random_decoder(22, 32, 2)
    converted = convolved(model, largest)
    assert operators(converted).count("Clip") == clips
    queries = random_queries(100)
    np.testing.assert_array_equal(run(converted, queries), run(convolved(model), queries))


@pytest.mark.parametrize("precision", ["float16", "float32"])
def test_no_query_exceeds_the_bound_that_the_decoder_is_told(precision):
    planes = np.full((3, 8, 8, 4), -40.0, precision)
    planes[0, 0, 0, 0] = 30
    part = make_tier_part(plane_precision=precision)
    bounds = make_part().bounds
    assert 120 <= QueryFiller(planes, bounds, part, "surface").largest_query < 121
    assert QueryFiller(planes / 1000, bounds, part, "surface").largest_query == 4


@pytest.mark.parametrize("make", [random_decoder, random_int8_decoder])
def test_a_fast_form_that_differs_gives_way_to_the_graph(make, monkeypatch):
    model = make(22, 160, 2)
    queries = random_queries(200)
    expected = onnx_result(model, queries)
    other = make(22, 160, 2, seed=5)
    fast_graph = decoder_module.fast_graph
    monkeypatch.setattr(decoder_module, "fast_graph", lambda _, reach: fast_graph(other, reach))
    with pytest.warns(DecoderWarning, match="runs as it is"):
        decoder = Decoder(model)
    assert decoder.columns == 22
    np.testing.assert_allclose(decoder.run(queries), expected, rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize("width", [16, 64, 256, 512])
@pytest.mark.parametrize("make", [random_decoder, random_int8_decoder])
def test_a_fast_form_that_agrees_stays(make, width):
    Decoder(make(22, width, 4))  # a warning would be an error


@pytest.mark.parametrize(("columns", "width", "layers"), [(20, 160, 1), (36, 256, 2), (22, 256, 4)])
def test_rounding_of_large_queries_is_no_difference(columns, width, layers):
    """Queries of 100 make sums whose terms cancel: the graph itself is as far from exact."""
    for seed in (0, 5):  # a warning would be an error
        Decoder(random_decoder(columns, width, layers, seed=seed))
