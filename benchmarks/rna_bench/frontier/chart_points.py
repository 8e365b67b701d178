"""Points of a chart: every model at every precision, with its cost and its error, as JSON."""

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from rna_bench.frontier.trials.cost import Costs
from rna_bench.frontier.trials.trial_record import Point, Record

COSTS = {"ns": "ns/query, all threads", "bytes": "bytes of the package"}
"""Costs of the chart; member of a point -> its label."""


def points_of(records: list[Record], costs: Costs | None) -> list[dict[str, Any]]:
    """One object a trained model and precision."""
    result = []
    for record in records:
        for precision, point in record.points.items():
            result.append(_point(record, precision, point, costs))
    return result


def label_of(trial: str, precision: str) -> str:
    """The name of a point, and of its package in a run of timings."""
    return f"{trial}/{precision}"


def _point(record: Record, precision: str, point: Point, costs: Costs | None) -> dict[str, Any]:
    trial, model = record.trial, record.trial.preset.model
    cost = costs.of.get(label_of(trial.cost_as or trial.name, precision)) if costs else None
    share = None
    if cost and costs:
        share = 2.0 * point.multiply_adds / cost.ns / costs.gemm_gflops
    scores = point.scores
    return {
        "name": trial.name,
        "precision": precision,
        "family": trial.family,
        "tables": trial.tables,
        **model.model_dump(mode="json"),
        "nearby": record.nearby,
        "steps": trial.preset.training.steps,
        "training_seconds": record.seconds,
        "curve": record.curve,
        "last_tenth_db": last_tenth(record.curve, trial.preset.training.steps),
        "bytes": point.bytes,
        "multiply_adds": point.multiply_adds,
        "ns": cost.ns if cost else None,
        "ns_one_thread": cost.ns_one_thread if cost else None,
        "share_of_gemm": share,
        "psnr": scores.psnr,
        "psnr_without_noise": asdict(scores.psnr_without_noise),
        "flip": scores.flip,
        "flip_p95": scores.flip_p95,
        "p99": scores.p99,
    }


def last_tenth(curve: Sequence[tuple[int, float]], steps: int) -> float | None:
    """dB that the last tenth of a training won; None where it was not validated before.

    curve: steps done and PSNR of each validation, the last of them at the end.
    """
    before = [psnr for step, psnr in curve if step <= 0.9 * steps]
    return curve[-1][1] - before[-1] if before else None


def front(points: list[dict[str, Any]], cost: str) -> list[dict[str, Any]]:
    """Pareto front of cost and FLIP without ablations, cheapest point first."""
    known = [p for p in points if p["family"] != "ablation" and p[cost] is not None]
    best, cheapest = float("inf"), []
    for point in sorted(known, key=lambda p: (p[cost], p["flip"])):
        if point["flip"] < best:
            best = point["flip"]
            cheapest.append(point)
    return cheapest
