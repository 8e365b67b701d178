"""What kernels calculate with on lanes, against numpy."""

import numpy as np

from rna_sdk.machine.compiled import compiled
from rna_sdk.runtime.kernels.lane_memory import load_lanes, load_vectors, store_lanes
from rna_sdk.runtime.kernels.lane_vectors import between, exp, log2, unit
from rna_sdk.runtime.kernels.lanes import LANES


def in_lanes(values: list[float]) -> np.ndarray:
    return np.resize(np.array(values, np.float32), LANES)


@compiled()
def _functions(x, results):
    lanes = load_lanes(x, np.uintp(0))
    for k, values in enumerate((log2(lanes), exp(lanes), between(lanes, 0.5, 2.0))):
        store_lanes(results, np.uintp(k * LANES), values)


def test_functions_of_numbers():
    x = in_lanes([1e-8, 1e-4, 0.1, 0.70710677, 0.7071068, 1, 1.5, 2, 17, 50, 87.9, 88.5, 88.73, 99])
    results = np.empty((3, LANES), np.float32)
    _functions(x, results.reshape(-1))
    wide = x.astype(np.float64)
    np.testing.assert_allclose(results[0], np.log2(wide), rtol=2e-7, atol=1e-7)
    with np.errstate(over="ignore"):
        expected = np.exp(wide).astype(np.float32)
    assert np.isinf(expected).any()
    np.testing.assert_allclose(results[1], expected, rtol=3e-7)
    np.testing.assert_array_equal(results[2], np.clip(x, 0.5, 2.0))


def test_nothing_is_between_as_the_lower_limit():
    results = np.empty((3, LANES), np.float32)
    _functions(in_lanes([np.nan, np.inf, -np.inf]), results.reshape(-1))
    np.testing.assert_array_equal(results[2, :3], [0.5, 2.0, 0.5])


@compiled()
def _unit(rows, results):
    for k, values in enumerate(unit(load_vectors(rows, np.uintp(0)))):
        store_lanes(results, np.uintp(k * LANES), values)


def test_directions_of_any_length_become_unit_vectors():
    rng = np.random.default_rng(0)
    for lengths in (np.ones(LANES), 10.0 ** np.linspace(-37, 37, LANES)):
        rows = rng.normal(size=(LANES, 3))
        rows *= (lengths / np.linalg.norm(rows, axis=1))[:, None]
        rows = rows.astype(np.float32)
        results = np.empty((3, LANES), np.float32)
        _unit(rows, results.reshape(-1))
        wide = rows.astype(np.float64)
        expected = wide / np.linalg.norm(wide, axis=1, keepdims=True)
        np.testing.assert_allclose(results.T, expected, atol=6e-8)
    _unit(np.zeros((LANES, 3), np.float32), results.reshape(-1))
    assert np.isnan(results).all()
