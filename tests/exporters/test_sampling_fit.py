"""Lobes for rays that are fitted to what an asset scatters."""

import numpy as np
import pytest

from rna_export.export.sampling_fit import fitted_sampling
from rna_export.export.sampling_places import Weighted, segments_of
from rna_export.export.sampling_shares import LOBES, fitted_shares, mixture_of
from rna_render.world.neural_sampling import Lobe, LobeMixture
from rna_sdk.package.limits import MAX_MIXTURES
from tests.package.builders import make_tiny_fiber_package, make_tiny_package
from tests.runtime.points import unit_vectors

POINTS, EACH = 240, 4


def scattered(widths: np.ndarray) -> Weighted:
    """Light of points that reflect only by GGX of these widths, (n,)."""
    n, rng, lobes = len(widths), np.random.default_rng(0), LOBES["surface"]
    axis, wo = unit_vectors(rng, n), unit_vectors(rng, n)
    axis = np.where(np.sum(axis * wo, axis=1, keepdims=True) < 0, -axis, axis)
    row = np.tile(np.repeat(np.arange(n), EACH), len(lobes))
    own, at = row[: n * EACH], (axis, axis, wo)
    wi = [lobe.everywhere.sample(*at, rng.random((n * EACH, 2)), own) for lobe in lobes]
    densities = np.stack([lobe.everywhere.pdf(*at, np.concatenate(wi), row) for lobe in lobes], 1)
    densities = densities.astype(np.float64)
    transport = np.zeros(len(row))
    for width in np.unique(widths):
        mine = widths[row] == width
        lobe = LobeMixture(mirror=(Lobe(1.0, width),)).everywhere
        transport[mine] = lobe.pdf(*at, np.concatenate(wi)[mine], row[mine])
    weight = transport**2 / (EACH * densities.sum(axis=1))
    lit = weight > 0.0
    return Weighted(row[lit], weight[lit], densities[lit], n)


@pytest.mark.parametrize("width", [0.001, 0.05])
def test_the_mixture_has_the_width_of_what_is_reflected(width):
    data = scattered(np.full(POINTS, width))
    shares = fitted_shares("surface", data.weight, data.densities)
    mixture = mixture_of("surface", shares)
    assert sum(lobe.share for lobe in mixture.mirror) > 0.9
    assert all(width / 2.0 < lobe.width < 2.0 * width for lobe in mixture.mirror)
    assert data.costs(shares).mean() < 1.2  # of an ideal mixture 1: no variance


def test_triangles_of_another_material_have_a_mixture_of_their_own():
    """Two meshes of 500 triangles; the second one begins where no corner is shared."""
    triangle = np.sort(np.random.default_rng(1).integers(0, 1000, POINTS))
    strip = np.arange(500)[:, None] + [0, 1, 2]
    triangles = np.concatenate([strip, strip + 502])
    data = scattered(np.where(triangle < 500, 0.3, 0.002))
    (first, rough), (second, smooth) = segments_of(data, triangle, triangles)
    assert (first, second) == (0, 500)
    assert all(lobe.width > 0.1 for lobe in mixture_of("surface", rough).mirror)
    assert all(lobe.width < 0.004 for lobe in mixture_of("surface", smooth).mirror)


def test_many_materials_get_no_more_mixtures_than_a_package_has():
    triangle, strip = np.arange(POINTS), np.arange(POINTS)[:, None] + [0, 1, 2]
    widths = np.where(triangle // 6 % 2, 0.3, 0.002)  # 40 runs
    segments = segments_of(scattered(widths), triangle, strip)
    assert 1 <= len(segments) <= MAX_MIXTURES


@pytest.mark.parametrize("make", [make_tiny_package, make_tiny_fiber_package])
def test_a_package_is_fitted(make, tmp_path):
    said: list[str] = []
    sampling = fitted_sampling(make(tmp_path / "tiny.rna"), said.append)
    assert sampling is not None and len(sampling.parts) == len(said) == 1
    (mixtures,) = sampling.parts
    assert mixtures and sum(share for share, _ in mixtures[0].lobes) <= 0.99
    assert fitted_sampling(tmp_path / "tiny.rna", said.append) == sampling
