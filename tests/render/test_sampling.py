"""Random numbers and directions against their densities."""

from __future__ import annotations

import numpy as np
import pytest

from rna_render.sampling import Sampler, sample_sphere_mixture, sphere_mixture_pdf

PIXELS = np.arange(64, dtype=np.uint32)


def squares(count: int, seed: int = 0, dimension: int = 0) -> np.ndarray:
    """(samples, pixels, 2)."""
    return np.stack([Sampler(seed, k).square(PIXELS, dimension) for k in range(count)])


def test_numbers_depend_on_all_four_and_on_nothing_else():
    first = squares(2)
    np.testing.assert_array_equal(first, squares(2))
    np.testing.assert_array_equal(
        first[:, 5], np.stack([Sampler(0, k).square(PIXELS[5:6], 0)[0] for k in (0, 1)])
    )
    for other in (squares(2, seed=1), squares(2, dimension=1)):
        assert not np.isclose(first, other).any()
    assert len(np.unique(first)) == first.size


@pytest.mark.parametrize("log2", [1, 4, 6])
def test_every_power_of_two_of_samples_is_a_net(log2):
    """A (0, k, 2)-net: every elementary rectangle of area 2^-k holds exactly one of 2^k points."""
    count = 1 << log2
    points = squares(count)
    assert points.min() >= 0 and points.max() < 1
    for bits in range(log2 + 1):
        columns, rows = 1 << bits, 1 << (log2 - bits)
        cell = (points[..., 0] * columns).astype(int) * rows + (points[..., 1] * rows).astype(int)
        assert (np.sort(cell, axis=0) == np.arange(count)[:, None]).all()


def test_pixels_and_dimensions_are_uncorrelated():
    many = np.arange(20_000, dtype=np.uint32)
    u, v = Sampler(7, 0).square(many, 0), Sampler(7, 0).square(many, 1)
    columns = np.column_stack([u[:-1], u[1:], v[:-1]])
    correlation = np.corrcoef(columns, rowvar=False) - np.eye(6)
    assert np.abs(correlation).max() < 5 / np.sqrt(len(many))


NORMALS = [(0, 1, 0), (0, 0, -1), (0.6, 0, -0.8), (0, 0, 0)]


@pytest.mark.parametrize("normal", NORMALS)
def test_directions_follow_their_density(normal):
    """Chi-squared of counts in cells of z and phi against the integral of the density."""
    n, columns, rows, fine = 200_000, 16, 12, 16
    n_world = np.tile(np.float32(normal), (n, 1))
    wi_world = sample_sphere_mixture(n_world, np.random.default_rng(5).random((n, 2)))
    np.testing.assert_allclose(np.linalg.norm(wi_world, axis=1), 1, atol=1e-6)
    column = ((np.arctan2(wi_world[:, 1], wi_world[:, 0]) / (2 * np.pi) + 0.5) * columns).astype(
        int
    )
    row = ((wi_world[:, 2].astype(np.float64) / 2 + 0.5) * rows).astype(int)
    cells = np.minimum(row, rows - 1) * columns + np.minimum(column, columns - 1)
    counts = np.bincount(cells, minlength=rows * columns)

    z = (np.arange(rows * fine) + 0.5) / (rows * fine) * 2 - 1
    phi = ((np.arange(columns * fine) + 0.5) / (columns * fine) - 0.5) * 2 * np.pi
    z, phi = (a.ravel() for a in np.meshgrid(z, phi, indexing="ij"))
    radius = np.sqrt(1 - z * z)
    grid = np.column_stack([radius * np.cos(phi), radius * np.sin(phi), z]).astype(np.float32)
    pdf = sphere_mixture_pdf(np.tile(np.float32(normal), (len(grid), 1)), grid)
    solid_angle = 4 * np.pi / len(grid)
    assert pdf.sum() * solid_angle == pytest.approx(1, abs=1e-3)
    blocks = pdf.reshape(rows, fine, columns, fine).sum(axis=(1, 3)).ravel()
    expected = blocks * solid_angle * n
    chi_squared = np.sum((counts - expected) ** 2 / expected)
    freedom = rows * columns - 1
    assert abs(chi_squared - freedom) < 5 * np.sqrt(2 * freedom)


def test_no_directions_are_legal():
    none = np.zeros((0, 3), np.float32)
    assert sample_sphere_mixture(none, np.zeros((0, 2))).shape == (0, 3)
