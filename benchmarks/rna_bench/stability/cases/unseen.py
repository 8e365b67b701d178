"""Directions that no sample of the training has."""

from itertools import pairwise

import numpy as np
from matplotlib.figure import FigureBase

from rna_bench.stability.answers import Answers, of_model, picked
from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.chosen import ChosenSamples, Samples, rows_of
from rna_bench.stability.fixtures import Fixtures
from rna_bench.stability.view_errors import joined_views, relative_error
from rna_export.capture.dataset.validation_view import queries_of
from rna_export.capture.rays.capture_directions import sphere

FACTOR = 1.5  # the mark: of the largest trained value

_EDGES_DEG = (-90, -60, -40, -20, -10, 0, 10, 20, 40, 60, 90)
_ANYWHERE = 200_000  # queries in random directions


def measure(fixtures: Fixtures) -> list[Row]:
    dataset = fixtures.dataset
    upper = ChosenSamples(dataset, upper_half)
    preset = fixtures.preset(dataset.kind)
    model = fixtures.train("hemisphere", upper, preset).model
    answers, largest = of_model(model), float(upper.training_samples()["radiance"].max())
    rows = by_elevation(answers, *joined_views(dataset.validation_views()))
    samples, _ = joined_views(dataset.validation_views())
    rows.append(anywhere(answers, samples, fixtures.some(_ANYWHERE)))
    return [{**row, "largest_trained": largest} for row in rows]


def upper_half(samples: Samples) -> Samples:
    """Samples whose directions both point upwards."""
    return rows_of(samples, (samples["wo"][:, 1] >= 0.0) & (samples["wi"][:, 1] >= 0.0))


def by_elevation(answers: Answers, samples: Samples, halves: np.ndarray) -> list[Row]:
    """Error in bins of the elevation of the lower one of wo and wi; below 0 nothing was trained."""
    radiance, rows = picked(answers, samples), []
    lower = np.minimum(samples["wo"][:, 1], samples["wi"][:, 1])
    elevation = np.degrees(np.arcsin(np.clip(lower, -1.0, 1.0)))
    for low, high in pairwise(_EDGES_DEG):
        inside = (elevation >= low) & (elevation < high)
        if inside.any():
            row: Row = {"low_deg": low, "high_deg": high, "samples": int(inside.sum())}
            row["error"] = relative_error(radiance[inside], halves[:, inside])
            rows.append(row | bounds(radiance[inside]))
    return rows


def anywhere(answers: Answers, samples: Samples, count: int) -> Row:
    """Statistics of the output in random directions, including those from inside the asset."""
    rng = np.random.default_rng(5)
    chosen = rows_of(samples, rng.integers(len(samples["visible"]), size=count))
    queries = queries_of(chosen) | {name: sphere(rng.random((count, 2))) for name in ("wo", "wi")}
    whole = {"low_deg": None, "high_deg": None, "samples": count, "error": None}
    return whole | bounds(np.concatenate(answers(queries)))


def bounds(radiance: np.ndarray) -> dict[str, float | int]:
    """The largest value, and how many are negative or not finite."""
    finite = np.isfinite(radiance)
    bad = int((~finite | (radiance < 0.0)).sum())
    return {"largest": float(radiance[finite].max(initial=0.0)), "bad": bad}


def judge(rows: list[Row]) -> Verdict:
    over = max(row["largest"] / row["largest_trained"] for row in rows)
    bad = sum(row["bad"] for row in rows)
    found = f"at most {over:.2f} times the largest trained value, {bad} negative or not finite"
    return Verdict(over <= FACTOR * (1.0 + 1e-5) and not bad, found)


def draw(figure: FigureBase, rows: list[Row]) -> None:
    left, right = figure.subplots(1, 2)
    binned = [row for row in rows if row["low_deg"] is not None]
    middle = [(row["low_deg"] + row["high_deg"]) / 2 for row in binned]
    left.plot(middle, values(binned, "error"), "o-")
    right.plot(middle, values(binned, "largest"), "o-", label="in the validation views")
    right.axhline(rows[-1]["largest"], color="C1", label="anywhere")
    right.axhline(FACTOR * rows[-1]["largest_trained"], color="grey", label="1.5 x trained")
    for axes in (left, right):
        axes.axvspan(-90, 0, color="C3", alpha=0.08)
        axes.set_yscale("log")
        axes.set_xlabel("elevation of the lower of wo, wi, deg.")
    left.set_ylabel("relative error; red: not trained")
    right.set_ylabel("largest radiance")
    right.legend()


CASE = Case(
    name="unseen",
    title="Unseen directions",
    varies="trained on the upper hemisphere, queried on the sphere",
    mark="finite, and at most 1.5 times the largest trained value",
    measure=measure,
    judge=judge,
    draw=draw,
    needs=("dataset",),
)
