"""Asset.evaluate: right, the same to the bit however it is called, and safe for any input."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from pathlib import Path

import numpy as np
import onnxruntime as ort
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import Package
from rna_sdk.runtime import Asset, load
from rna_sdk.runtime.decoder import Decoder
from rna_sdk.runtime.queries_reference import queries_reference
from tests.runtime.points import Points, random_points

FLOAT_MAX = float(np.finfo(np.float32).max)
NAMES = ("positions", "normals", "wo", "wi")


def both(asset: Asset, points: Points) -> np.ndarray:
    """(n, 6): visible and shadowed side by side."""
    return np.concatenate(asset.evaluate(*points), axis=1)


def test_equals_the_package_evaluated_by_hand(asset_path: Callable[..., Path]) -> None:
    path = asset_path(resolution=16, channels=8)
    points = random_points(3000)
    with Package.open(path) as package:
        tier = package.manifest.tiers[0]
        bounds = np.array([package.manifest.bounds.min, package.manifest.bounds.max])
        queries = queries_reference(package.planes(tier.name), bounds, tier.inputs, *points)
        session = ort.InferenceSession(
            bytes(package.decoder(tier.name)), providers=["CPUExecutionProvider"]
        )
    (expected,) = session.run(["transport"], {"queries": queries})
    assert (expected > 0).mean() > 0.2
    np.testing.assert_allclose(both(load(path), points), expected, rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize("width", [8, 16, 64, 128])
def test_result_depends_on_the_row_alone(asset_path: Callable[..., Path], width: int) -> None:
    path = asset_path(width, layers=4, resolution=16, channels=8)
    points = random_points(5003)
    expected = both(load(path, threads=1), points)
    for threads in (1, 2, 3):
        asset = load(path, threads=threads)
        for size in (7, 1000, 2049, 5003):
            parts = [both(asset, points[i : i + size]) for i in range(0, 5003, size)]
            np.testing.assert_array_equal(np.concatenate(parts), expected)
    alone = [both(asset, points[i : i + 1]) for i in range(0, 5003, 41)]
    np.testing.assert_array_equal(np.concatenate(alone), expected[::41])
    order = np.random.default_rng(3).permutation(5003)
    np.testing.assert_array_equal(both(asset, points[order]), expected[order])


def test_bad_neighbours_change_nothing(asset: Asset) -> None:
    points = random_points(1000)
    expected = both(asset, points)
    points.wi[::3] = np.nan
    found = both(asset, points)
    np.testing.assert_array_equal(found[1::3], expected[1::3])
    assert not found[::3].any() and expected[::3].any()


def test_an_empty_batch_is_legal(asset: Asset) -> None:
    visible, shadowed = asset.evaluate(*random_points(0))
    assert visible.shape == shadowed.shape == (0, 3)
    assert visible.dtype == shadowed.dtype == np.float32


def test_threads_may_call_at_the_same_time(asset: Asset) -> None:
    batches = [random_points(3001, seed) for seed in range(8)]
    expected = [both(asset, points) for points in batches]
    with ThreadPoolExecutor(8) as pool:
        for found, want in zip(pool.map(lambda p: both(asset, p), batches), expected, strict=True):
            np.testing.assert_array_equal(found, want)


def test_each_tile_is_evaluated_once(
    asset_path: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    rows: list[int] = []
    run = Decoder.run

    def counted(decoder: Decoder, queries: np.ndarray) -> np.ndarray:
        rows.append(len(queries))
        return run(decoder, queries)

    monkeypatch.setattr(Decoder, "run", counted)
    load(asset_path(64), threads=3).evaluate(*random_points(10_000))
    assert sorted(rows) == [1808, 2048, 2048, 2048, 2048]


def test_any_mix_of_odd_numbers_gives_finite_and_non_negative_transport(asset: Asset) -> None:
    odd = [0.0, -0.0, np.nan, np.inf, -np.inf, FLOAT_MAX, -FLOAT_MAX, 1e-45, -1e-40, 1.0, -0.5]
    rng = np.random.default_rng(0)
    points = Points(*rng.choice(np.float32(odd), (4, 20_000, 3)))
    result = both(asset, points)
    assert np.isfinite(result).all() and (result >= 0).all()
    bad = np.zeros(20_000, bool)
    for array in points:
        bad |= ~np.isfinite(array).all(axis=1)
    for array in (points.normals, points.wo, points.wi):
        bad |= ~array.any(axis=1)
    assert not result[bad].any()
    assert 10 < np.count_nonzero(~bad) and result[~bad].any(axis=1).all()


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize(("argument", "component"), list(product(range(4), range(3))))
def test_a_number_that_is_not_finite_gives_black(
    asset: Asset, argument: int, component: int, value: float
) -> None:
    points = random_points(20)
    assert both(asset, points)[7].any()
    list(points)[argument][7, component] = value
    assert not both(asset, points)[7].any()


@pytest.mark.parametrize("argument", [1, 2, 3])
def test_a_direction_without_length_gives_black(asset: Asset, argument: int) -> None:
    points = random_points(20)
    assert both(asset, points)[7].any()
    list(points)[argument][7] = 0
    assert not both(asset, points)[7].any()


def test_positions_outside_are_moved_to_the_bounds(asset: Asset) -> None:
    points = random_points(500, reach=5.0)
    inside = Points(np.clip(points.positions, -1, 1), points.normals, points.wo, points.wi)
    np.testing.assert_array_equal(both(asset, points), both(asset, inside))
    far = Points(points.positions * np.float32(1e37), points.normals, points.wo, points.wi)
    corner = Points(np.sign(points.positions), points.normals, points.wo, points.wi)
    np.testing.assert_array_equal(both(asset, far), both(asset, corner))


@pytest.mark.parametrize("argument", range(4))
@pytest.mark.parametrize(
    ("bad", "found"),
    [
        (np.zeros((5, 3), np.float64), r"\(5, 3\) float64"),
        (np.zeros((5, 4), np.float32), r"\(5, 4\) float32"),
        (np.zeros(15, np.float32), r"\(15,\) float32"),
        (np.zeros((5, 3), ">f4"), r"\(5, 3\) >f4"),
        ([[0.0, 0.0, 1.0]] * 5, "list"),
        (None, "NoneType"),
    ],
)
def test_a_wrong_array_is_named(asset: Asset, argument: int, bad: object, found: str) -> None:
    arguments: list[object] = list(random_points(5))
    arguments[argument] = bad
    with pytest.raises(QueryError, match=f"^{NAMES[argument]}: expected .*float32.* found {found}"):
        asset.evaluate(*arguments)  # type: ignore[arg-type]


def test_arrays_of_different_length_are_refused(asset: Asset) -> None:
    points = random_points(5)
    with pytest.raises(QueryError, match=r"^wo: expected a \(5, 3\) .* found \(4, 3\)"):
        asset.evaluate(points.positions, points.normals, points.wo[:4], points.wi)


def test_arrays_with_gaps_and_read_only_arrays_are_taken(asset: Asset) -> None:
    points = random_points(300)
    expected = both(asset, points)
    gaps = Points(*(np.repeat(array, 2, axis=0)[::2] for array in points))
    assert not gaps.positions.flags.c_contiguous
    np.testing.assert_array_equal(both(asset, gaps), expected)
    for array in points:
        array.flags.writeable = False
    np.testing.assert_array_equal(both(asset, points), expected)


def test_results_can_be_written_into_arrays_of_the_caller(asset: Asset) -> None:
    points = random_points(5000)
    out = np.full((5000, 3), np.nan, np.float32), np.full((5000, 3), np.nan, np.float32)
    returned = asset.evaluate(*points, out=out)
    assert returned[0] is out[0] and returned[1] is out[1]
    for written, fresh in zip(out, asset.evaluate(*points), strict=True):
        np.testing.assert_array_equal(written, fresh)


@pytest.mark.parametrize(
    ("bad", "found"),
    [
        (np.zeros((7, 3), np.float32), "found ndarray"),
        ((np.zeros((7, 3), np.float32), np.zeros((6, 3), np.float32)), r"out\[1\]: .*\(6, 3\)"),
        ((np.zeros((7, 3)), np.zeros((7, 3), np.float32)), r"out\[0\]: .*float64"),
        ((np.zeros((7, 6), np.float32)[:, ::2], np.zeros((7, 3), np.float32)), "contiguous"),
    ],
)
def test_results_that_cannot_be_written_are_refused(asset: Asset, bad: object, found: str) -> None:
    with pytest.raises(QueryError, match=found):
        asset.evaluate(*random_points(7), out=bad)
