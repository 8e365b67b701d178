"""The compiled decoder against ONNX's own evaluation of the same graph."""

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from rna_sdk.package import ProfileDecoder, ProfileLayer, decoder_to_bytes
from rna_sdk.runtime.engine.compiled_decoder import CompiledDecoder
from rna_sdk.runtime.engine.decoder_sessions import COMPILED_WIDTH, Decoder, Graph
from tests.package.builders import random_decoder

SIZES = [(22, 16, 4), (25, 32, 4), (36, 64, 3), (3, 8, 1), (16, 12, 2), (17, 24, 2), (48, 6, 1)]


def of_layers(*layers: tuple[np.ndarray, np.ndarray]) -> CompiledDecoder:
    """Queries between -2 and 3, and no bound of the exponents."""
    read = tuple(ProfileLayer(*layer, 0.0, None, k == 0) for k, layer in enumerate(layers))
    return CompiledDecoder(ProfileDecoder(-2.0, 3.0, None, None, read, 1e9, 1.0, None))


def plain(decoder: ProfileDecoder, queries: np.ndarray) -> np.ndarray:
    return Graph(decoder_to_bytes(decoder), optimized=False).run(queries)


def random_queries(rows: int, columns: int) -> np.ndarray:
    return np.random.default_rng(0).normal(size=(rows, columns)).astype(np.float32)


def with_matrix(decoder: ProfileDecoder, numbers: int) -> ProfileDecoder:
    """The decoder with more numbers in its last layer and a matrix that makes colours of them."""
    rng, (*layers, last) = np.random.default_rng(3), decoder.layers
    weight = rng.normal(0, 0.3, (len(last.weight), numbers)).astype(np.float32)
    bias = rng.normal(0, 0.1, numbers).astype(np.float32)
    matrix = rng.uniform(0, 1, (numbers, 6)).astype(np.float32)
    layers.append(replace(last, weight=weight, bias=bias))
    return replace(decoder, layers=tuple(layers), matrix=matrix)


@pytest.mark.parametrize(("columns", "width", "layers"), SIZES)
def test_equals_the_graph(columns, width, layers):
    model = random_decoder(columns, width, layers)
    queries = random_queries(1000, columns)
    expected = plain(model, queries)
    assert (expected > 0).mean() > 0.2
    np.testing.assert_allclose(CompiledDecoder(model).run(queries), expected, rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize("numbers", [6, 9, 24])
def test_colours_by_a_matrix(numbers):
    model = with_matrix(random_decoder(20, 16, 2), numbers)
    queries = random_queries(300, 20)
    expected = plain(model, queries)
    np.testing.assert_allclose(CompiledDecoder(model).run(queries), expected, rtol=1e-4, atol=1e-5)


def test_three_outputs_of_emission():
    model = random_decoder(20, 16, 2, outputs=3, output="emission")
    queries = random_queries(100, 20)
    expected = plain(model, queries)
    actual = CompiledDecoder(model).run(queries)
    assert actual.shape == (100, 3)
    np.testing.assert_allclose(actual, expected, rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize(("columns", "width", "layers"), SIZES)
def test_a_row_depends_on_nothing_else(columns, width, layers):
    decoder = CompiledDecoder(random_decoder(columns, width, layers))
    queries = random_queries(400, columns)
    expected = decoder.run(queries)
    for rows in (0, 1, 5, 16, 17, 47, 48, 49, 100):
        for start in (0, 1, 17, 255):
            part = slice(start, start + rows)
            np.testing.assert_array_equal(decoder.run(queries[part]), expected[part])


def test_registers_of_either_width_give_the_same_bits(monkeypatch):
    model = random_decoder(22, 16, 2)
    queries = random_queries(200, 22)
    actual = []
    for lanes in (8, 16):
        monkeypatch.setattr(
            "rna_sdk.runtime.engine.compiled_decoder.register_lanes", lambda n=lanes: n
        )
        actual.append(CompiledDecoder(model).run(queries))
    np.testing.assert_array_equal(*actual)


def test_queries_are_clipped_and_results_may_be_infinite():
    weight = np.float32([[1.0, 0, 0, 0], [0, 1.0, 0, 0]])
    layers = [(weight, np.zeros(4, np.float32)), (np.eye(4, dtype=np.float32), np.zeros(4, "f4"))]
    decoder = of_layers(*layers)
    queries = np.float32([[5, -5], [1, 0.5], [0, 1e-6], [3, 2]])
    expected = np.expm1([[3, 0], [1, 0.5], [0, 1e-6], [3, 2]])
    np.testing.assert_allclose(decoder.run(queries)[:, :2], expected, rtol=1e-6, atol=1e-7)
    layers[1] = (np.float32(1000) * np.eye(4, dtype=np.float32), np.zeros(4, np.float32))
    decoder = of_layers(*layers)
    actual = decoder.run(np.float32([[1, 0.05], [0.088, 0.0887]]))
    assert actual[0, 0] == np.inf
    np.testing.assert_allclose(
        actual[1, 0], np.exp(np.float64(np.float32(0.088)) * 1000), rtol=1e-5
    )


def test_narrow_decoders_run_in_it_and_wide_ones_do_not():
    narrow, wide = (
        Decoder(random_decoder(22, width, 4)) for width in (COMPILED_WIDTH, 2 * COMPILED_WIDTH)
    )
    assert isinstance(narrow._form, CompiledDecoder)
    assert isinstance(wide._form, Graph)


def test_later_processes_find_the_kernels_on_disk():
    program = (
        "from rna_sdk.runtime.engine.compiled_decoder import decoder_kernel, register_lanes\n"
        "from rna_sdk.runtime.kernels.query_kernel import query_kernel\n"
        "kernels = decoder_kernel(register_lanes()), query_kernel('surface', 8, 'float16')\n"
        "for kernel in kernels:\n"
        "    kernel._compile_for_args()  # as for a first call\n"
        "print(*(sum(kernel.stats.cache_hits.values()) for kernel in kernels))"
    )
    for _ in range(2):  # the first one may be the one that compiles
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout.split() == ["1", "1"], done.stderr
