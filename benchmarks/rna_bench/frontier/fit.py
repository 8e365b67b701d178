"""rna-fit against the full grid: cost of the model found, and training time.

    rna-bench fit toy.rays bench/toy --min-psnr 30 33 --max-error 0.05 \\
        --work fits/toy --out benchmarks/results/fit-toy.json

The grid is that of a finished `rna-bench frontier`; both costs that are compared are its own. A
limit's search takes trainings of full length from the grid's folder where it wants the same ones,
and counts their time as if it had done them.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

from rna_bench.bench_options import add_out
from rna_bench.frontier.chart_points import label_of
from rna_bench.results import publish
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.fit.fit_page import write_page
from rna_export.fit.fit_run import Fit, fit
from rna_export.fit.goal import Goal
from rna_export.training.training_options import add_device
from rna_export.trials.trial import Trial
from rna_export.trials.trial_pool import TrialWorkers
from rna_export.trials.trial_record import Record


def run(args: argparse.Namespace) -> None:
    grid = json.loads((args.grid / "frontier.json").read_text())["points"]
    goals = [Goal("min_psnr", psnr) for psnr in args.min_psnr]
    goals += [Goal("max_error", flip) for flip in args.max_error]
    rows = [_compare(goal, grid, args) for goal in goals]
    publish({"dataset": args.dataset.name, "limits": rows}, args)


def _compare(goal: Goal, grid: list[dict[str, Any]], args: argparse.Namespace) -> dict[str, Any]:
    """Compares the chosen model with the best of the grid."""
    ours = [p for p in grid if p["family"] == "ours" and p["ns"] is not None]
    records = {p["name"]: _record(args.grid / "trials" / p["name"]) for p in ours}
    good = [p for p in ours if goal.met_by(records[p["name"]].points[p["precision"]].scores)]
    found = _fit(goal, [record.trial for record in records.values()], ours[0]["steps"], args)
    chosen = label_of(found.chosen.trial.name, found.chosen.precision)
    ns = {label_of(p["name"], p["precision"]): p["ns"] for p in ours}
    best = min(good, key=lambda p: p["ns"])
    whole = sum({p["name"]: p["training_seconds"] for p in grid}.values())
    write_page(found, str(args.dataset.name), args.work / f"{goal.metric}-{goal.value:g}.html")
    return {
        "limit": str(goal),
        "chosen": chosen,
        "best_of_grid": label_of(best["name"], best["precision"]),
        "cost_over_best": ns[chosen] / best["ns"],
        "training_seconds": found.seconds,
        "grid_training_seconds": whole,
        "share_of_grid": found.seconds / whole,
    }


def _record(folder: Path) -> Record:
    return Record.model_validate_json((folder / "record.json").read_bytes())


def _fit(goal: Goal, trials: list[Trial], steps: int, args: argparse.Namespace) -> Fit:
    args.work.mkdir(parents=True, exist_ok=True)
    longest = args.work / str(steps)
    if not longest.exists():
        longest.symlink_to((args.grid / "trials").resolve())
    workers = TrialWorkers.usual(args.device, args.workers)
    return fit(Dataset(args.dataset).only, trials, goal, steps, workers, args.work, print)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("dataset", type=Path, help="dataset written by rna-capture")
    parser.add_argument("grid", type=Path, help="folder of rna-bench frontier")
    parser.add_argument("--min-psnr", type=float, nargs="*", default=[], help="limits, dB")
    parser.add_argument("--max-error", type=float, nargs="*", default=[], help="limits, mean FLIP")
    parser.add_argument("--work", type=Path, required=True, help="folder for shorter trainings")
    parser.add_argument("--workers", type=int, help="concurrent trainings")
    add_device(parser, "trainings")
    add_out(parser)
