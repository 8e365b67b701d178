"""Whether directions follow a density: Pearson's chi-squared test over cells of a cone."""

from collections.abc import Callable

import numpy as np

ROWS, COLUMNS = 12, 16
FINE = 20  # a side, points of the quadrature in each cell
MIN_EXPECTED = 10.0  # cells with fewer samples are put together
SIGMAS = 5.0

Density = Callable[[np.ndarray], np.ndarray]


def assert_directions_follow(
    d_world: np.ndarray,
    density: Density,
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0),
    angle: float = np.pi,
    integral_tolerance: float = 5e-3,
) -> None:
    """The directions (n, 3) are samples of `density`, which integrates to 1.

    density: from directions (k, 3) float32 to (k,), per steradian. axis, angle: of a cone that
    holds them all; the finer it fits, the sharper the test.
    """
    frame = _frame(axis)
    top = 2.0 * np.sin(angle / 2.0) ** 2  # 1 - cos
    lengths = np.linalg.norm(d_world, axis=1)
    np.testing.assert_allclose(lengths, 1.0, atol=1e-6)
    cells = _cells(np.asarray(d_world, np.float64) @ frame.T, top)
    counts = np.bincount(cells, minlength=ROWS * COLUMNS)

    grid = _grid(top) @ frame
    values = np.asarray(density(grid.astype(np.float32)), np.float64)
    assert np.isfinite(values).all() and (values >= 0.0).all()
    blocks = values.reshape(ROWS, FINE, COLUMNS, FINE).swapaxes(1, 2).reshape(-1, FINE * FINE)
    scale = len(d_world) * 2.0 * np.pi * top / len(grid)
    expected = blocks.sum(axis=1) * scale
    integral = expected.sum() / len(d_world)
    assert abs(integral - 1.0) < integral_tolerance, f"integral {integral}"
    # A cell on a light's outline is known no better than its few points within tell.
    quadrature = blocks.var(axis=1) * blocks.shape[1] * scale**2
    _assert_close(counts, expected / integral, quadrature)


def _assert_close(counts: np.ndarray, expected: np.ndarray, variance: np.ndarray) -> None:
    """variance: of `expected`."""
    rare = expected < MIN_EXPECTED
    counts, expected, variance = (
        np.append(values[~rare], values[rare].sum()) for values in (counts, expected, variance)
    )
    chi_squared = np.sum((counts - expected) ** 2 / np.maximum(expected + variance, 1.0))
    freedom = max(len(counts) - 2, 1)
    limit = freedom + SIGMAS * np.sqrt(2.0 * freedom) + SIGMAS
    assert chi_squared < limit, f"chi-squared {chi_squared:.1f} of {freedom} degrees of freedom"


def _frame(axis: tuple[float, float, float]) -> np.ndarray:
    """Rows x, y, z of a frame about z = axis."""
    z = np.asarray(axis, np.float64) / np.linalg.norm(axis)
    x = np.cross(z, np.eye(3)[np.argmin(np.abs(z))])
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z])


def _cells(local: np.ndarray, top: float) -> np.ndarray:
    # 1 - cos as half of a squared chord: narrow cones would lose it to rounding.
    height = np.sum((local - [0.0, 0.0, 1.0]) ** 2, axis=1) / 2.0
    assert height.max() < top * (1.0 + 1e-4), "a direction outside of the cone"
    row = np.minimum((height / top * ROWS).astype(int), ROWS - 1)
    turn = np.arctan2(local[:, 1], local[:, 0]) / (2.0 * np.pi) % 1.0
    return row * COLUMNS + np.minimum((turn * COLUMNS).astype(int), COLUMNS - 1)


def _grid(top: float) -> np.ndarray:
    """Points of equal solid angle, jittered, rows first."""
    rng = np.random.default_rng(1)
    rows, columns = ROWS * FINE, COLUMNS * FINE
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    height = (i.ravel() + rng.random(i.size)) / rows * top
    phi = 2.0 * np.pi * (j.ravel() + rng.random(i.size)) / columns
    radius = np.sqrt(height * (2.0 - height))
    return np.stack([radius * np.cos(phi), radius * np.sin(phi), 1.0 - height], axis=1)
