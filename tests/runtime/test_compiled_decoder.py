"""The compiled decoder against ONNX's own evaluation of the same graph."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import onnx
import pytest
from onnx import helper, numpy_helper

from rna_sdk.package.decoder.profile_decoder import (
    ProfileDecoder,
    ProfileLayer,
    read_profile_decoder,
)
from rna_sdk.runtime.engine.compiled_decoder import CompiledDecoder
from rna_sdk.runtime.engine.decoder_sessions import COMPILED_WIDTH, Decoder, Graph, _fast_form
from tests.package.builders import make_decoder_model, make_int8_decoder_model

SIZES = [(22, 16, 4), (25, 32, 4), (36, 64, 3), (3, 8, 1), (16, 12, 2), (17, 24, 2), (48, 6, 1)]


def compiled(model: onnx.ModelProto) -> CompiledDecoder:
    return CompiledDecoder(read_profile_decoder(model.SerializeToString(), "decoder"))


def of_layers(*layers: tuple[np.ndarray, np.ndarray]) -> CompiledDecoder:
    """Queries between -2 and 3, and no bound of the exponents."""
    read = tuple(ProfileLayer(*layer, 0.0, None, k == 0) for k, layer in enumerate(layers))
    return CompiledDecoder(ProfileDecoder(-2.0, 3.0, None, None, read, 1e9, 1.0, None))


def plain(model: onnx.ModelProto, queries: np.ndarray) -> np.ndarray:
    return Graph(model.SerializeToString(), optimized=False).run(queries)


def random_queries(rows: int, columns: int) -> np.ndarray:
    return np.random.default_rng(0).normal(size=(rows, columns)).astype(np.float32)


def with_matrix(model: onnx.ModelProto, numbers: int) -> onnx.ModelProto:
    """The model with more numbers in its last layer and a matrix that makes colours of them."""
    rng, graph = np.random.default_rng(3), model.graph
    last = [node for node in graph.node if node.op_type == "Gemm"][-1]
    old = {tensor.name: numpy_helper.to_array(tensor) for tensor in graph.initializer}
    new = {
        last.input[1]: rng.normal(0, 0.3, (len(old[last.input[1]]), numbers)),
        last.input[2]: rng.normal(0, 0.1, numbers),
        "colours": rng.uniform(0, 1, (numbers, 6)),
    }
    for tensor in [t for t in graph.initializer if t.name in new]:
        graph.initializer.remove(tensor)
    for name, values in new.items():
        graph.initializer.append(numpy_helper.from_array(values.astype(np.float32), name))
    scaled = graph.node[-1]
    graph.node.remove(scaled)
    colours = [scaled.input[0], "colours"]
    graph.node.append(helper.make_node("MatMul", colours, [scaled.output[0]]))
    return model


@pytest.mark.parametrize(("columns", "width", "layers"), SIZES)
def test_equals_the_graph(columns: int, width: int, layers: int) -> None:
    model = make_decoder_model(columns, width, layers)
    queries = random_queries(1000, columns)
    expected = plain(model, queries)
    assert (expected > 0).mean() > 0.2
    np.testing.assert_allclose(compiled(model).run(queries), expected, rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize("numbers", [6, 9, 24])
def test_colours_by_a_matrix(numbers: int) -> None:
    model = with_matrix(make_decoder_model(20, 16, 2), numbers)
    queries = random_queries(300, 20)
    expected = plain(model, queries)
    np.testing.assert_allclose(compiled(model).run(queries), expected, rtol=1e-4, atol=1e-5)


def test_three_outputs_of_emission() -> None:
    model = make_decoder_model(20, 16, 2, outputs=3, output="emission")
    queries = random_queries(100, 20)
    expected = plain(model, queries)
    found = compiled(model).run(queries)
    assert found.shape == (100, 3)
    np.testing.assert_allclose(found, expected, rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize(("columns", "width", "layers"), SIZES)
def test_a_row_depends_on_nothing_else(columns: int, width: int, layers: int) -> None:
    decoder = compiled(make_decoder_model(columns, width, layers))
    queries = random_queries(400, columns)
    expected = decoder.run(queries)
    for rows in (0, 1, 5, 16, 17, 47, 48, 49, 100):
        for start in (0, 1, 17, 255):
            part = slice(start, start + rows)
            np.testing.assert_array_equal(decoder.run(queries[part]), expected[part])


def test_registers_of_either_width_give_the_same_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    model = make_decoder_model(22, 16, 2)
    queries = random_queries(200, 22)
    found = []
    for lanes in (8, 16):
        monkeypatch.setattr(
            "rna_sdk.runtime.engine.compiled_decoder.register_lanes", lambda n=lanes: n
        )
        found.append(compiled(model).run(queries))
    np.testing.assert_array_equal(*found)


def test_queries_are_clipped_and_results_may_be_infinite() -> None:
    weight = np.float32([[1.0, 0, 0, 0], [0, 1.0, 0, 0]])
    layers = [(weight, np.zeros(4, np.float32)), (np.eye(4, dtype=np.float32), np.zeros(4, "f4"))]
    decoder = of_layers(*layers)
    queries = np.float32([[5, -5], [1, 0.5], [0, 1e-6], [3, 2]])
    expected = np.expm1([[3, 0], [1, 0.5], [0, 1e-6], [3, 2]])
    np.testing.assert_allclose(decoder.run(queries)[:, :2], expected, rtol=1e-6, atol=1e-7)
    layers[1] = (np.float32(1000) * np.eye(4, dtype=np.float32), np.zeros(4, np.float32))
    decoder = of_layers(*layers)
    found = decoder.run(np.float32([[1, 0.05], [0.088, 0.0887]]))
    assert found[0, 0] == np.inf
    np.testing.assert_allclose(found[1, 0], np.exp(np.float64(np.float32(0.088)) * 1000), rtol=1e-5)


def test_other_graphs_are_none_of_its() -> None:
    int8 = make_int8_decoder_model(22, 16, 2, opset=19)
    model = make_decoder_model(22, 16, 2)
    relu = next(node for node in model.graph.node if node.op_type == "Relu")
    relu.op_type = "Sigmoid"
    for other in (int8, model):
        form = _fast_form(other.SerializeToString(), 1.0)
        assert not isinstance(form, CompiledDecoder)


def test_constants_that_nothing_reads_may_be_of_any_type() -> None:
    model = make_decoder_model(22, 16, 2)
    model.graph.initializer.append(numpy_helper.from_array(np.int8([[1, 2, 3]]), "idle"))
    queries = random_queries(16, 22)
    np.testing.assert_allclose(compiled(model).run(queries), plain(model, queries), atol=1e-5)


def test_narrow_decoders_run_in_it_and_wide_ones_do_not() -> None:
    narrow, wide = (
        Decoder(make_decoder_model(22, width, 4).SerializeToString())
        for width in (COMPILED_WIDTH, 2 * COMPILED_WIDTH)
    )
    assert isinstance(narrow._form, CompiledDecoder)
    assert isinstance(wide._form, Graph)


def test_later_processes_find_the_kernels_on_disk() -> None:
    program = (
        "from rna_sdk.runtime.engine.compiled_decoder import decoder_kernel, register_lanes\n"
        "from rna_sdk.runtime.kernels.query_kernel import query_kernel\n"
        "kernels = decoder_kernel(register_lanes()), query_kernel('surface', 8, 'float16')\n"
        "print(*(sum(kernel.stats.cache_hits.values()) for kernel in kernels))"
    )
    for _ in range(2):  # the first one may be the one that compiles
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout.split() == ["1", "1"], done.stderr
