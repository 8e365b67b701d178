"""Directions along the surface, or along the fiber."""

from itertools import pairwise

import numpy as np
from matplotlib.figure import FigureBase

from rna_bench.stability.answers import Answers, of_model, picked
from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.fixtures import Fixtures
from rna_bench.stability.view_errors import joined_views, relative_error
from rna_export.capture.dataset.validation_view import is_lit
from rna_export.metrics import display

FACTOR = 3.0  # the mark
EDGES_DEG = (*range(0, 80, 10), 80, 85, 90)

_FEWEST = 50  # samples that a bin's error is taken of


def measure(fixtures: Fixtures) -> list[Row]:
    dataset = fixtures.dataset
    kind = dataset.kind
    preset = fixtures.preset(kind, inputs=fixtures.paper_inputs(kind))
    paper = fixtures.train("paper-inputs", dataset, preset).model
    angles = {
        "package": fixtures.answers(),
        "the paper's inputs": of_model(paper),
        "ours, as long": of_model(fixtures.base.model),
    }
    samples, halves = joined_views(dataset.validation_views())
    return [
        {"model": name, **row}
        for name, answers in angles.items()
        for row in binned(answers, samples, halves)
    ]


def binned(answers: Answers, samples: dict[str, np.ndarray], halves: np.ndarray) -> list[Row]:
    """The error in each bin of the angle of wo, and of wi, to the axis.

    `error` is relative to the bin's mean radiance, `of_all` to the mean of all bins: along a
    surface there is next to no light, and a part of nothing is not seen. The axis is the normal,
    where the light is visible and above the surface; for fibers the plane across the tangent. 90
    degrees are along the surface, or along the fiber.
    """
    radiance, rows = picked(answers, samples), []
    lit = is_lit(samples["visible"])
    mean = float(display(halves[:, lit]).mean())
    for direction in ("wo", "wi"):
        angle = _angle_deg(samples, direction)
        for low, high in pairwise(EDGES_DEG):
            inside = lit & (angle >= low) & (angle < high)
            if inside.sum() >= _FEWEST:
                error = relative_error(radiance[inside], halves[:, inside])
                share = float(display(halves[:, inside]).mean()) / mean
                bin_ = {"low_deg": low, "high_deg": high, "samples": int(inside.sum())}
                errors = {"error": error, "of_all": error * share}
                rows.append({"direction": direction, **bin_, **errors})
    return rows


def _angle_deg(samples: dict[str, np.ndarray], direction: str) -> np.ndarray:
    fibers = "tangent" in samples
    axis = samples["tangent" if fibers else "normal"]
    along = np.clip(np.sum(axis * samples[direction], axis=1), -1.0, 1.0)
    return np.degrees(np.arcsin(np.abs(along)) if fibers else np.arccos(along))


def judge(rows: list[Row]) -> Verdict:
    factors = {
        direction: last_over_median([r for r in rows if r["model"] == "package"], direction)
        for direction in ("wo", "wi")
    }
    figures = ", ".join(f"{k} {v:.1f} times" for k, v in factors.items())
    return Verdict(max(factors.values()) <= FACTOR, f"85 to 90 degrees: {figures} the median bin")


def last_over_median(rows: list[Row], direction: str) -> float:
    """Error of the bin from 85 to 90 degrees over the median bin's."""
    errors = values(rows, "of_all", direction=direction)
    last = values(rows, "of_all", direction=direction, low_deg=85)
    return last[0] / max(float(np.median(errors)), 1e-6) if last else 0.0


def draw(figure: FigureBase, rows: list[Row]) -> None:
    for axes, direction in zip(figure.subplots(1, 2, sharey=True), ("wo", "wi"), strict=True):
        for model in dict.fromkeys(values(rows, "model")):
            where = {"model": model, "direction": direction}
            low, high = values(rows, "low_deg", **where), values(rows, "high_deg", **where)
            middle = [(a + b) / 2 for a, b in zip(low, high, strict=True)]
            axes.plot(middle, values(rows, "of_all", **where), "o-", label=model)
        axes.set_yscale("log")
        axes.set_xlabel(f"angle of {direction}, degrees; 90: grazing")
        axes.set_ylabel("error over the mean radiance of all angles")
    axes.legend()


CASE = Case(
    name="grazing",
    title="Grazing directions",
    varies="angle of wo and of wi to the surface (fibers: along the strand), 0 to 90 degrees",
    mark="error at 85 to 90 degrees at most 3 times the median bin's",
    measure=measure,
    judge=judge,
    draw=draw,
    needs=("dataset",),
)
