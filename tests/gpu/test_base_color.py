"""Base colour on the GPU: as a factor of transport, and looked up at hits."""

import numpy as np
import pytest

import rna_gpu
from rna_gpu import GpuSurface
from rna_sdk import runtime
from rna_sdk.errors import QueryError
from tests.gpu.scenes import assert_same_numbers, on_cpu, on_gpu
from tests.gpu.test_evaluate import evaluated_on_gpu, rows
from tests.package.prints import LABEL, STAMP, image_bytes, make_print


@pytest.fixture(scope="module")
def printed(tmp_path_factory):
    rng = np.random.default_rng(3)
    label = rng.integers(0, 256, (5, 12, 4)).astype(np.uint8)
    label[:2, :, 3] = 0
    stamp = rng.integers(0, 256, (8, 8, 3)).astype(np.uint8)
    files = {LABEL: image_bytes(label), STAMP: image_bytes(stamp, "WEBP", lossless=True)}
    return make_print(tmp_path_factory.mktemp("printed") / "printed.rna", files)


def test_results_of_two_decoders_that_stay_on_the_gpu(printed, device):
    gpu = rna_gpu.load(printed, "hq", device)
    assert isinstance(gpu, GpuSurface)
    queries = rows(64, runtime.load(printed).bounds)
    actual = evaluated_on_gpu(device, gpu, queries, 64)[:64]
    expected = np.stack(gpu.evaluate(*queries), axis=1)
    assert np.array_equal(actual[..., :3], expected)


def test_queries_without_a_base_color(printed, device):
    gpu = rna_gpu.load(printed, device=device)
    assert isinstance(gpu, GpuSurface)
    *queries, _ = rows(4, runtime.load(printed).bounds)
    with pytest.raises(QueryError, match=r"base_color: expected a \(4, 3\) float32 array"):
        gpu.evaluate(*queries)


SCENE = """
assets:
  - {path: print.rna, tier: TIER}
  - path: print.rna
    tier: TIER
    transform: {translation: [1.7, 0, -0.4], rotation_deg: [0, 70, 0], scale: -0.8}
    maps: {label: noise.png}
    tint: [0.4, 1.5, 1]
ground: {height: -0.6, material: {type: diffuse, color: [0.7, 0.7, 0.7]}}
camera: {position: [1.2, 1.6, 4.2], look_at: [0.6, -0.1, 0], vertical_fov_deg: 40}
lights:
  - {type: directional, direction: [0.5, 0.9, 0.3], irradiance: [0.5, 0.4, 0.4]}
  - {type: environment, radiance: [0.1, 0.1, 0.2]}
resolution: [32, 24]
samples: 2
max_depth: 2
"""


@pytest.mark.parametrize("tier", ["small", "hq"], ids=["one decoder", "two decoders"])
def test_the_image_of_the_cpu(scene, device, tmp_path, tier):
    """Fine print, another print and a tint, and light that bounces."""
    rng = np.random.default_rng(9)
    noise = [rng.integers(0, 256, (128, 128, 3)).astype(np.uint8) for _ in range(2)]
    label, other = (image_bytes(np.repeat(one, 2, axis=1)) for one in noise)
    make_print(tmp_path / "print.rna", {LABEL: label, STAMP: image_bytes(noise[1][:7, :9])})
    (tmp_path / "noise.png").write_bytes(other)
    scene_file, world = scene(SCENE.replace("TIER", tier))
    actual = on_gpu(scene_file, world, lambda: device).channels()
    assert_same_numbers(actual, on_cpu(scene_file, world).channels())
