"""Embree's kernels for other processors: the same hits, up to a few last bits.

Of 20,000 rays, the distance to a triangle differs by at most 3 units in the last place, to a round
curve by 170; half of the distances are the same to the bit.
"""

import gc
from pathlib import Path

import numpy as np
import pytest

from rna_sdk.errors import SceneError
from rna_sdk.package import Curves
from rna_trace.embree import TriangleScene
from rna_trace.embree import library as embree_library
from rna_trace.parts_scene import PartsScene
from tests.render.assets import EMBREE_ROUNDING, sphere
from tests.runtime.points import unit_vectors

CPUINFO = Path("/proc/cpuinfo")
HAS_AVX512 = CPUINFO.is_file() and "avx512f" in CPUINFO.read_text().split()
PROCESSORS = [
    pytest.param(
        "avx512",
        marks=pytest.mark.skipif(not HAS_AVX512, reason="needs a processor with AVX-512"),
    ),
    *("avx2", "avx", "sse4.2"),
]


@pytest.fixture
def set_up(monkeypatch):
    """Settings for the devices that come after the call."""

    def set_up_(config: str) -> None:
        monkeypatch.setenv(embree_library.CONFIG_VARIABLE, config)
        monkeypatch.setattr(embree_library, "_current_device", None)

    yield set_up_
    gc.collect()


@pytest.fixture(scope="module")
def rays():
    rng = np.random.default_rng(1)
    origins = 3 * unit_vectors(rng, 20_000)
    directions = 0.9 * unit_vectors(rng, 20_000) - origins
    return origins.astype(np.float32), directions.astype(np.float32)


@pytest.mark.parametrize("processor", PROCESSORS)
def test_triangles_are_hit_where_the_default_kernels_hit_them(set_up, rays, processor):
    ball = sphere(4)
    expected = TriangleScene([(ball.positions, ball.triangles)]).intersect(*rays)
    set_up(f"isa={processor}")
    hits = TriangleScene([(ball.positions, ball.triangles)]).intersect(*rays)
    same = hits.primitive == expected.primitive
    assert same.mean() > 0.999 and (hits.primitive >= 0).mean() > 0.5
    np.testing.assert_allclose(hits.t[same], expected.t[same], rtol=EMBREE_ROUNDING)
    np.testing.assert_allclose(hits.u[same], expected.u[same], atol=2e-5)


@pytest.mark.parametrize("processor", PROCESSORS)
def test_curves_are_hit_where_the_default_kernels_hit_them(set_up, rays, processor):
    steps = np.random.default_rng(2).normal(size=(40, 6, 3)) * 0.2
    points = np.cumsum(steps, axis=1).reshape(-1, 3).astype(np.float32)
    radii = np.full(len(points), 0.02, np.float32)
    offsets = np.arange(0, len(points) + 1, 6, dtype=np.uint32)
    curves = Curves(points, radii, offsets)
    expected = PartsScene([curves]).intersect(*rays)
    set_up(f"isa={processor}")
    hits = PartsScene([curves]).intersect(*rays)
    same = hits.primitive == expected.primitive
    assert same.mean() > 0.999 and (hits.primitive >= 0).mean() > 0.1
    np.testing.assert_allclose(hits.t[same], expected.t[same], rtol=5e-5)
    np.testing.assert_allclose(hits.ng[same], expected.ng[same], atol=5e-3)


def test_settings_reach_embree(set_up, capfd):
    set_up("isa=sse4.2,verbose=1")
    embree_library.shared_device()
    enabled = capfd.readouterr().out.split("Config")[1]
    assert "SSE4.2" in enabled and "AVX2 " not in enabled.split("Targets")[0]


def test_a_library_that_makes_no_device_is_an_error(set_up, monkeypatch):
    monkeypatch.setattr(embree_library.library(), "rtcNewDevice", lambda config: None)
    set_up("isa=other")
    with pytest.raises(SceneError, match="made no device with RNA_EMBREE_CONFIG=isa=other"):
        embree_library.shared_device()
