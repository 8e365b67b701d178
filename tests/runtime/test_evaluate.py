"""`evaluate` of either kind: right, the same to the bit however called, safe for any input."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import fields, replace

import numpy as np
import onnxruntime as ort
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import Package
from rna_sdk.runtime import Asset, load
from rna_sdk.runtime.engine.decoder_sessions import Decoder
from tests.reference.queries import fiber_queries_reference, queries_reference
from tests.runtime.points import Arrays, points_for, random_fiber_points, random_points

FLOAT_MAX = float(np.finfo(np.float32).max)
ANY_KIND = pytest.mark.parametrize("kind", ["surface", "fiber"])


def both(asset: Asset, points: Arrays) -> np.ndarray:
    """(n, 6): visible and shadowed side by side."""
    return np.concatenate(asset.evaluate(*points), axis=1)


@ANY_KIND
def test_equals_the_package_evaluated_by_hand(asset_path, kind):
    path = asset_path(resolution=16, channels=8, kind=kind)
    points = points_for(load(path), 3000)
    reference = fiber_queries_reference if kind == "fiber" else queries_reference
    with Package.open(path) as package:
        tier = package.manifest.tiers[0]
        bounds, inputs = package.manifest.parts[0].bounds.corners(), tier.parts[0].inputs
        queries = reference(package.planes(tier.name), bounds, inputs, *points)
        session = ort.InferenceSession(
            bytes(package.decoder(tier.name)), providers=["CPUExecutionProvider"]
        )
    (expected,) = session.run(["transport"], {"queries": queries})
    assert (expected > 0).mean() > 0.2
    np.testing.assert_allclose(both(load(path), points), expected, rtol=1e-4, atol=1e-5)


@ANY_KIND
@pytest.mark.parametrize("width", [8, 16, 64, 128])
def test_result_depends_on_the_row_alone(asset_path, width, kind):
    path = asset_path(width, layers=4, kind=kind, resolution=16, channels=8)
    points = points_for(load(path), 5003)
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


def test_bad_neighbours_change_nothing(asset):
    points = points_for(asset, 1000)
    expected = both(asset, points)
    points.wi[::3] = np.nan
    actual = both(asset, points)
    np.testing.assert_array_equal(actual[1::3], expected[1::3])
    assert not actual[::3].any() and expected[::3].any()


def test_an_empty_batch_is_legal(asset):
    visible, shadowed = asset.evaluate(*points_for(asset, 0))
    assert visible.shape == shadowed.shape == (0, 3)
    assert visible.dtype == shadowed.dtype == np.float32


def test_threads_may_call_at_the_same_time(asset):
    batches = [points_for(asset, 3001, seed) for seed in range(8)]
    expected = [both(asset, points) for points in batches]
    with ThreadPoolExecutor(8) as pool:
        for actual, want in zip(pool.map(lambda p: both(asset, p), batches), expected, strict=True):
            np.testing.assert_array_equal(actual, want)


def test_each_tile_is_evaluated_once(asset_path, monkeypatch):
    rows: list[int] = []
    run = Decoder.run

    def counted(decoder: Decoder, queries: np.ndarray) -> np.ndarray:
        rows.append(len(queries))
        return run(decoder, queries)

    monkeypatch.setattr(Decoder, "run", counted)
    load(asset_path(64), threads=3).evaluate(*random_points(10_000))
    assert sorted(rows) == [1600, 1680, 1680, 1680, 1680, 1680]


def test_any_mix_of_odd_numbers_gives_finite_and_non_negative_transport(asset):
    odd = [0.0, -0.0, np.nan, np.inf, -np.inf, FLOAT_MAX, -FLOAT_MAX, 1e-45, -1e-40, 1.0, -0.5]
    rng = np.random.default_rng(0)
    points = points_for(asset, 20_000)
    for array in points:
        array[:] = rng.choice(np.float32(odd), array.shape)
    result = both(asset, points)
    assert np.isfinite(result).all() and (result >= 0).all()
    bad = np.zeros(20_000, bool)
    for array in points:
        bad |= ~np.isfinite(array.reshape(20_000, -1)).all(axis=1)
    for array in (list(points)[1], points.wo, points.wi):
        bad |= ~array.any(axis=1)
    assert not result[bad].any()
    assert 10 < np.count_nonzero(~bad) and result[~bad].any(axis=1).all()


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_a_number_that_is_not_finite_gives_black(asset, value):
    points = points_for(asset, 20)
    expected = both(asset, points)
    assert expected.any(axis=1).all()
    for array in points:
        numbers = array.reshape(20, -1)
        for component in range(numbers.shape[1]):
            before = numbers[7, component]
            numbers[7, component] = value
            assert not both(asset, points)[7].any()
            numbers[7, component] = before
    np.testing.assert_array_equal(both(asset, points), expected)


@pytest.mark.parametrize("which", ["axis", "wo", "wi"])
def test_a_direction_without_length_gives_black(asset, which):
    points = points_for(asset, 20)
    assert both(asset, points)[7].any()
    direction = list(points)[1] if which == "axis" else getattr(points, which)
    direction[7] = 0
    assert not both(asset, points)[7].any()


def test_positions_outside_are_moved_to_the_bounds(asset):
    points = points_for(asset, 500, reach=5.0)
    inside = replace(points, positions=np.clip(points.positions, -1, 1))
    np.testing.assert_array_equal(both(asset, points), both(asset, inside))
    far = replace(points, positions=points.positions * np.float32(1e37))
    corner = replace(points, positions=np.sign(points.positions))
    np.testing.assert_array_equal(both(asset, far), both(asset, corner))


def test_h_beyond_the_edge_is_at_the_edge(asset_path):
    asset = load(asset_path(kind="fiber"))
    points = random_fiber_points(100)
    points.h[:] = [1, -1] * 50
    expected = both(asset, points)
    assert not np.array_equal(expected, both(asset, replace(points, h=0.9 * points.h)))
    for factor in (1 + 2**-23, 2.0, FLOAT_MAX):
        beyond = replace(points, h=points.h * np.float32(factor))
        np.testing.assert_array_equal(both(asset, beyond), expected)


@pytest.mark.parametrize(
    ("bad", "actual"),
    [
        (np.zeros((5, 3), np.float64), r"\(5, 3\) float64"),
        (np.zeros((5, 4), np.float32), r"\(5, 4\) float32"),
        (np.zeros((5, 1, 3), np.float32), r"\(5, 1, 3\) float32"),
        (np.zeros(15, np.float32), r"\(15,\) float32"),
        (np.zeros((5, 3), ">f4"), r"\(5, 3\) >f4"),
        (np.zeros((), np.float32), r"\(\) float32"),
        (np.float32(0.5), "float32"),
        ([[0.0, 0.0, 1.0]] * 5, "list"),
        (None, "NoneType"),
    ],
)
def test_a_wrong_array_is_named(asset, bad, actual):
    points = points_for(asset, 5)
    for place, field in enumerate(fields(points)):
        arguments: list[object] = list(points)
        arguments[place] = bad
        message = f"^{field.name}: expected .*float32.* found {actual}"
        with pytest.raises(QueryError, match=message):
            asset.evaluate(*arguments)


def test_arrays_of_different_length_are_refused(asset):
    points = points_for(asset, 5)
    for place, field in list(enumerate(fields(points)))[1:]:
        arguments = list(points)
        arguments[place] = arguments[place][:4]
        shapes = r"\(5,( 3)?\) .* found \(4,( 3)?\)"
        with pytest.raises(QueryError, match=f"^{field.name}: expected a {shapes}"):
            asset.evaluate(*arguments)


def test_arrays_with_gaps_and_read_only_arrays_are_taken(asset):
    points = points_for(asset, 300)
    expected = both(asset, points)
    gaps = type(points)(*(np.repeat(array, 2, axis=0)[::2] for array in points))
    assert not any(array.flags.c_contiguous for array in gaps)
    np.testing.assert_array_equal(both(asset, gaps), expected)
    for array in points:
        array.flags.writeable = False
    np.testing.assert_array_equal(both(asset, points), expected)


def test_results_can_be_written_into_arrays_of_the_caller(asset):
    points = points_for(asset, 5000)
    out = np.full((5000, 3), np.nan, np.float32), np.full((5000, 3), np.nan, np.float32)
    returned = asset.evaluate(*points, out=out)
    assert returned[0] is out[0] and returned[1] is out[1]
    for written, fresh in zip(out, asset.evaluate(*points), strict=True):
        np.testing.assert_array_equal(written, fresh)


@pytest.mark.parametrize(
    ("bad", "actual"),
    [
        (np.zeros((7, 3), np.float32), "found ndarray"),
        ((np.zeros((7, 3), np.float32), np.zeros((6, 3), np.float32)), r"out\[1\]: .*\(6, 3\)"),
        ((np.zeros((7, 3)), np.zeros((7, 3), np.float32)), r"out\[0\]: .*float64"),
        ((np.zeros((7, 6), np.float32)[:, ::2], np.zeros((7, 3), np.float32)), "contiguous"),
        ((np.zeros((7, 3), np.float32),) * 2, "out: expected arrays of their own memory"),
    ],
)
def test_results_that_cannot_be_written_are_refused(asset, bad, actual):
    with pytest.raises(QueryError, match=actual):
        asset.evaluate(*points_for(asset, 7), out=bad)


def test_results_in_the_place_of_the_query_are_refused(asset):
    """The second of two decoders would read the results of the first."""
    points = points_for(asset, 7)
    for array in points:
        if array.shape == (7, 3):
            with pytest.raises(QueryError, match="memory of the query"):
                asset.evaluate(*points, out=(array, np.empty((7, 3), np.float32)))
