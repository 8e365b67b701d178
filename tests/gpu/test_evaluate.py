"""The GPU answers as the runtime does, to the conformance kit and to any rows."""

from pathlib import Path

import numpy as np
import pytest

import rna_gpu
from rna_gpu import Device, GpuSurface, conformance_reader
from rna_gpu.decoder_packing import pack_decoder
from rna_gpu.evaluator import Evaluator
from rna_gpu.shaders import compose
from rna_sdk import runtime
from rna_sdk.conformance.kit import Kit, load_kit
from rna_sdk.conformance.rna_conform import run_levels
from rna_sdk.errors import QueryError
from rna_sdk.package import ProfileDecoder, ProfileLayer
from tests.conformance.conftest import KIT, InProcess
from tests.conftest import REPOSITORY
from tests.package.builders import make_tiny_package
from tests.package.carriers import make_carrier

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
BALL = REPOSITORY / "examples" / "fibers" / "curly_ball.rna"


def rows(count: int, bounds: np.ndarray) -> list[np.ndarray]:
    """Positions within the bounds, three unit directions, and base colours."""
    rng = np.random.default_rng(0)
    directions = rng.normal(size=(3, count, 3))
    directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    rows = rng.uniform(*bounds, (count, 3)), *directions, rng.random((count, 3))
    return [a.astype(np.float32) for a in rows]


def test_the_conformance_kit(device):
    kit: Kit = load_kit(KIT)
    of_gpu = conformance_reader
    reader = InProcess(
        of_gpu.evaluate,
        of_gpu.visibility,
        of_gpu.normals,
        base_color=of_gpu.base_color,
        nearby=of_gpu.evaluate,
    )
    levels = "evaluate", "nearby", "visibility", "normals", "base-color"
    scores = list(run_levels(reader, kit, levels))
    cases = kit.evaluate, kit.nearby, kit.visibility, kit.normals, kit.base_color
    assert len(scores) == sum(map(len, cases))
    assert [score for score in scores if not score.passed] == []


def test_results_do_not_depend_on_the_batch(device, monkeypatch):
    gpu = rna_gpu.load(TOY, device=device)
    assert isinstance(gpu, GpuSurface)
    whole = np.hstack(gpu.evaluate(*rows(1000, runtime.load(TOY).bounds)))
    monkeypatch.setattr(gpu.transport[0], "batch", 192)
    assert np.array_equal(np.hstack(gpu.evaluate(*rows(1000, runtime.load(TOY).bounds))), whole)
    none = gpu.evaluate(*(a[:0] for a in rows(1, np.zeros((2, 3)))))
    assert none[0].shape == (0, 3)


def test_a_carrier_has_the_same_bits(device, tmp_path):
    package = make_tiny_package(tmp_path / "tiny.rna")
    carrier = make_carrier(package, tmp_path / "tiny.glb")
    queries = rows(256, runtime.load(package).bounds)
    one, other = (rna_gpu.load(path, device=device) for path in (package, carrier))
    assert isinstance(one, GpuSurface) and isinstance(other, GpuSurface)
    assert np.array_equal(np.hstack(one.evaluate(*queries)), np.hstack(other.evaluate(*queries)))


def evaluated_on_gpu(device: Device, gpu: GpuSurface, queries: list[np.ndarray], count: int):
    """(n, 2, 4) of buffers of 128 rows, of which `count` are evaluated."""
    *vectors, color = queries
    packed = np.zeros((len(color), 5, 4), np.float32)
    for k, values in enumerate(vectors):
        packed[:, k, :3] = values
    packed[:, 1:4, 3] = color
    on_gpu = gpu.new_rows(128)
    device.write(on_gpu.rows, packed)
    device.write(on_gpu.count, np.array([count], np.uint32))
    gpu.evaluate_on_gpu(on_gpu, len(color))
    return device.read(on_gpu.results, 128 * 32).view(np.float32).reshape(128, 2, 4)


def test_results_that_stay_on_the_gpu(device):
    gpu = rna_gpu.load(TOY, device=device)
    assert isinstance(gpu, GpuSurface)
    queries = rows(100, runtime.load(TOY).bounds)
    actual = evaluated_on_gpu(device, gpu, queries, 90)
    expected = np.stack(gpu.evaluate(*queries), axis=1)
    assert np.array_equal(actual[:90, :, :3], expected[:90])
    assert not actual[90:].any()  # rows beyond the count are left alone


@pytest.mark.parametrize(("queries_per_second", "times"), [(1e6, 1), (1e7, 1), (2e7, 2), (1e9, 4)])
def test_dispatches_grow_until_they_take_20_ms(device, monkeypatch, queries_per_second, times):
    gpu = rna_gpu.load(TOY, device=device)
    assert isinstance(gpu, GpuSurface)
    transport = gpu.transport[0]
    batch, most = transport.batch, 4 * transport.batch
    assert transport.short(most) == batch  # software drivers are not measured
    monkeypatch.setattr(device, "is_software", False)
    monkeypatch.setattr(Evaluator, "_seconds", lambda self, rows: rows / queries_per_second)
    assert transport.short(most) == times * batch
    assert transport.short(100) == 100


def test_one_line_says_what_is_wrong(device):
    gpu = rna_gpu.load(TOY, device=device)
    assert isinstance(gpu, GpuSurface)
    x, n, wo, wi, color = rows(4, np.array([[0, 0, 0], [1, 1, 1]]))
    with pytest.raises(QueryError, match=r"wi: expected a \(4, 3\) float32 array, found \(3, 3\)"):
        gpu.evaluate(x, n, wo, wi[:3], color)
    with pytest.raises(QueryError, match="no tier 'none'"):
        rna_gpu.load(TOY, "none", device)
    with pytest.raises(rna_gpu.GpuError, match=r"planes: 1,099,511,627,776 bytes, and "):
        device.buffer(1 << 40, "STORAGE", what="planes")


def test_a_decoder_that_is_too_large():
    def layer(inputs: int, outputs: int) -> ProfileLayer:
        weight = np.zeros((inputs, outputs), np.int8)
        return ProfileLayer(weight, np.zeros(outputs), 1.0, np.ones(outputs, np.float32), False)

    def decoder(*layers: ProfileLayer) -> ProfileDecoder:
        return ProfileDecoder(-1, 1, None, None, layers, 1, 1, None)

    with pytest.raises(QueryError, match="toy: found an int8 layer of 516 inputs"):
        pack_decoder(decoder(layer(8, 516), layer(516, 6)), ("features",), 8, "toy")
    with pytest.raises(QueryError, match="toy: found 33 layers"):
        pack_decoder(decoder(*[layer(8, 8)] * 33), ("features",), 8, "toy")


def test_the_shaders_are_composed_of_whole_files():
    folder = Path(rna_gpu.__file__).parent / "wgsl"
    source = compose({"RNA_GROUPS": 16}, "weights_uniform.wgsl", "surface")
    assert source.startswith("const RNA_GROUPS: u32 = 16u;\n")
    for name in ("part.wgsl", "planes.wgsl", "decoder.wgsl"):
        assert (folder / name).read_text("utf-8") in source
