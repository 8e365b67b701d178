"""Few light directions, few samples."""

import numpy as np
import torch
from matplotlib.figure import FigureBase

from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.chosen import ChosenSamples, Samples, light_numbers, rows_of
from rna_bench.stability.fixtures import Fixtures
from rna_bench.stability.view_errors import scores_of
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.training.checkpoint import Trained
from rna_export.training.optimization.losses import sample_loss

LOSS_DB, GAP_DB = 1.0, 1.0  # the mark

LIGHTS = (30, 100, 300, 1000, 3000)
POINTS = (100_000, 1_000_000, 10_000_000)  # the first with each number of lights
_HELD_OUT = 0.05  # share of the lights that no subset has
_TESTED = 50_000


def measure(fixtures: Fixtures) -> list[Row]:
    dataset = fixtures.dataset
    samples = dataset.training_samples()
    light = light_numbers(samples)
    order = np.random.default_rng(11).permutation(light[-1] + 1)
    count = round(_HELD_OUT * len(order))
    held_out = _tested(rows_of(samples, np.isin(light, order[:count])))
    most = max(n for n in LIGHTS if n <= len(order) - count)
    plans = [("lights", lights, POINTS[0]) for lights in LIGHTS if lights <= most]
    plans += [("points", most, points) for points in POINTS]
    rows = []
    for series, lights, points in plans:
        chosen = subset(light, order[count : count + lights], fixtures.some(points))
        row = {"series": series, "lights": lights, "points": len(chosen)}
        rows.append(row | _trained(fixtures, dataset, row, chosen, samples, held_out))
    return rows


def subset(light: np.ndarray, chosen: np.ndarray, points: int) -> np.ndarray:
    """Row numbers of samples of the chosen lights, at most `points`, ascending."""
    rows = np.flatnonzero(np.isin(light, chosen))
    picked = np.random.default_rng(12).permutation(len(rows))[:points]
    return np.sort(rows[picked])


def _trained(
    fixtures: Fixtures,
    dataset: DatasetPart,
    row: Row,
    chosen: np.ndarray,
    samples: Samples,
    held_out: Samples,
) -> Row:
    some = ChosenSamples(dataset, lambda every: rows_of(every, chosen))
    name = f"little-{row['lights']}-{row['points']}"
    trained = fixtures.train(name, some, fixtures.preset(dataset.kind))
    views = dataset.validation_views()
    scores = scores_of(trained.model, views)
    training_loss = loss_of(trained, _tested(rows_of(samples, chosen)))
    gap = 10.0 * np.log10(loss_of(trained, held_out) / training_loss)
    return {"psnr": scores.psnr_without_noise.db, "flip": scores.flip, "gap_db": float(gap)}


def _tested(samples: Samples) -> Samples:
    count = len(samples["visible"])
    rows = np.random.default_rng(13).permutation(count)[:_TESTED]
    return rows_of(samples, rows)


@torch.no_grad()
def loss_of(trained: Trained, samples: Samples) -> float:
    """The training's loss of samples: between known and unknown lights it tells overfitting."""
    at = {k: torch.from_numpy(np.ascontiguousarray(v)) for k, v in samples.items()}
    return float(sample_loss(trained.model, at, 1.0, trained.preset.training.loss))


def judge(rows: list[Row]) -> Verdict:
    few = sorted((r for r in rows if r["series"] == "lights"), key=lambda r: r["lights"])
    most, fewer = few[-1], few[-2] if len(few) > 1 else few[-1]
    lost = most["psnr"] - fewer["psnr"]
    gap = max(rows, key=lambda r: r["points"])["gap_db"]
    result = (
        f"{fewer['lights']:,} lights cost {lost:.2f} dB against {most['lights']:,}; "
        f"overfitting gap {gap:.2f} dB with all samples"
    )
    return Verdict(lost <= LOSS_DB and gap <= GAP_DB, result)


def draw(figure: FigureBase, rows: list[Row]) -> None:
    for axes, series in zip(figure.subplots(1, 2, sharey=True), ("lights", "points"), strict=True):
        at = values(rows, series, series=series)
        axes.plot(at, values(rows, "psnr", series=series), "o-", label="PSNR")
        axes.set_xscale("log")
        axes.set_xlabel("lights, 0.1 M samples" if series == "lights" else "samples, most lights")
        axes.set_ylabel("PSNR without noise, dB")
        gap = axes.twinx()
        gap.plot(at, values(rows, "gap_db", series=series), "s:", color="C3")
        gap.set_ylabel("overfitting gap, dB", color="C3")


CASE = Case(
    name="little-data",
    title="Too little data",
    varies="30 to 3,000 lights at 0.1 M samples; 0.1 to 10 M samples",
    mark="the second most lights within 1 dB of the most; gap at most 1 dB with all samples",
    measure=measure,
    judge=judge,
    draw=draw,
    needs=("dataset",),
)
