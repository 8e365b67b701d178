"""Cases about directions: an exact model passes, one that is broken there fails."""

import numpy as np
import pytest

from rna_bench.stability.cases import grazing, sharp, unseen
from rna_bench.stability.view_errors import joined_views
from tests.exporters.synthetic import make_dataset, transport

Queries = dict[str, np.ndarray]


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    return make_dataset(tmp_path_factory.mktemp("ball"), views=6)


def exact(queries: Queries) -> tuple[np.ndarray, np.ndarray]:
    radiance, _ = transport(queries["normal"], queries["wo"], queries["wi"])
    return radiance, radiance


def slightly_off(queries: Queries) -> tuple[np.ndarray, np.ndarray]:
    return tuple(1.02 * values for values in exact(queries))


def wrong_at_grazing(queries: Queries) -> tuple[np.ndarray, np.ndarray]:
    grazes = np.sum(queries["normal"] * queries["wi"], axis=1) < np.cos(np.radians(85.0))
    return tuple(np.where(grazes[:, None], v + 0.1, 1.02 * v) for v in exact(queries))


@pytest.mark.parametrize(("answers", "passes"), [(slightly_off, True), (wrong_at_grazing, False)])
def test_grazing(dataset, answers, passes):
    rows = grazing.binned(answers, *joined_views(dataset.validation_views()))
    verdict = grazing.judge([{"model": "package", **row} for row in rows])
    assert verdict.passed == passes
    near = [r for r in rows if r["direction"] == "wo" and r["high_deg"] <= 60]
    assert near and all(row["error"] == pytest.approx(0.02, rel=0.6) for row in near if passes)


def test_visibility_may_have_a_colour(dataset):
    samples, halves = joined_views(dataset.validation_views())
    coloured = {**samples, "visible": np.repeat(np.float32(samples["visible"])[:, None], 3, axis=1)}
    rows, of_colours = (grazing.binned(slightly_off, s, halves) for s in (samples, coloured))
    assert rows and of_colours == rows


def test_unseen_directions_are_judged_by_bounds(dataset):
    samples, halves = joined_views(dataset.validation_views())
    largest = float(samples["radiance"].max())

    def rows_of(answers) -> list[dict]:
        rows = unseen.by_elevation(answers, samples, halves)
        rows.append(unseen.anywhere(answers, samples, 2000))
        return [{**row, "largest_trained": largest} for row in rows]

    def too_bright(queries: Queries) -> tuple[np.ndarray, np.ndarray]:
        down = queries["wi"][:, 1:2] < 0.0
        return tuple(np.where(down, 2.0 * largest, values) for values in exact(queries))

    def not_a_number(queries: Queries) -> tuple[np.ndarray, np.ndarray]:
        down = queries["wi"][:, 1:2] < -0.9
        return tuple(np.where(down, np.nan, values) for values in exact(queries))

    def bounded(queries: Queries) -> tuple[np.ndarray, np.ndarray]:
        return tuple(np.clip(values, 0.0, largest) for values in exact(queries))

    assert unseen.judge(rows_of(bounded)).passed
    assert not unseen.judge(rows_of(too_bright)).passed
    assert not unseen.judge(rows_of(not_a_number)).passed


def test_only_samples_of_the_upper_half_are_trained(dataset):
    upper = unseen.upper_half(dataset.training_samples())
    assert 0 < len(upper["visible"]) < len(dataset.training_samples()["visible"])
    assert upper["wo"][:, 1].min() >= 0.0 and upper["wi"][:, 1].min() >= 0.0


def lobe(half: np.ndarray, width_deg: float, peak: float) -> np.ndarray:
    gauss = peak * np.exp(-np.pi * (np.degrees(half) / width_deg) ** 2)
    return np.repeat(gauss[:, None], 3, axis=1)


def test_a_lobe_has_its_peak_and_width():
    half = np.radians(np.linspace(-20.0, 20.0, 4001))
    shape = sharp.lobe_shape(half, 0.1 + lobe(half, 2.5, 7.0), "")
    assert shape["width_deg"] == pytest.approx(2.5, rel=1e-3)
    assert shape["peak"] == pytest.approx(7.1, rel=1e-3)


@pytest.mark.parametrize(
    ("width", "peak", "albedo", "passes"),
    [
        (1.0, 5.0, 1.0, True),
        (2.0, 5.0, 1.0, False),
        (1.0, 2.0, 1.0, False),
        (1.0, 5.0, 0.96, False),
    ],
)
def test_a_wide_dim_or_cut_highlight_fails(width, peak, albedo, passes):
    half = np.radians(np.linspace(-20.0, 20.0, 4001))
    row = {
        "material": "coat",
        "inputs": "ours",
        "psnr_in": 30.0,
        "albedo": albedo,
        "albedo_at80": None,
        **sharp.lobe_shape(half, lobe(half, width, peak), ""),
        **sharp.lobe_shape(half, lobe(half, 1.0, 5.0), "_cycles"),
    }
    assert sharp.judge([row]).passed == passes


def test_a_model_that_cuts_its_highlights_returns_less(dataset):
    def cut(queries: Queries) -> tuple[np.ndarray, np.ndarray]:
        return tuple(np.minimum(values, 0.2) for values in exact(queries))

    whole, less = sharp.returned(exact, dataset), sharp.returned(cut, dataset)
    assert whole["albedo"] == pytest.approx(1.0, abs=0.02)
    assert less["albedo"] < 0.97


def test_error_in_the_highlight_is_told_apart(dataset):
    samples = dataset.training_samples()
    h = samples["wi"] + samples["wo"]
    h /= np.linalg.norm(h, axis=1, keepdims=True)
    inside = np.sum(h * samples["normal"], axis=1) > np.cos(0.2)
    dim = np.where(inside[:, None], 0.5, 1.0) * samples["radiance"]
    errors = sharp.in_and_out(dim, samples, 0.2)
    assert errors["psnr_in"] < 20.0 and errors["psnr_out"] > 100.0
