"""`rna-fit`: the cheapest model within an error limit, or the best within a cost limit."""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from rna_export.export.credit import add_credit
from rna_export.training.training_options import add_trainings
from rna_sdk.console import command_line, command_parser, run_command
from rna_sdk.errors import TrainingError
from rna_sdk.outputs import check_outputs, check_outside
from rna_sdk.owned_folder import owned
from rna_work.executors import Executor, open_executor

if TYPE_CHECKING:
    from rna_export.capture.dataset.dataset_part import DatasetPart
    from rna_export.fit.fit_run import Fit
    from rna_export.fit.goal import Goal


def parser() -> argparse.ArgumentParser:
    """The options of `rna-fit`."""
    p = command_parser(
        "rna-fit",
        "Find, train and export the cheapest model that meets a limit on its error.",
        "rna-fit helmet.rays/ --max-error 0.02 --out helmet.rna",
        epilog="Trainings are kept in the work folder: the same command resumes after an "
        "interruption,\nand a run with another limit reuses them.",
    )
    p.add_argument("dataset", type=Path, help="dataset written by rna-capture (path)")
    limit = p.add_mutually_exclusive_group(required=True)
    limit.add_argument(
        "--max-error",
        type=_positive,
        metavar="FLIP",
        help="limit on the mean FLIP of the validation images (float, no default: one of the three "
        "limits is required)",
    )
    limit.add_argument(
        "--min-psnr",
        type=_positive,
        metavar="DB",
        help="limit on their PSNR, dB (float, no default)",
    )
    limit.add_argument(
        "--budget-us",
        type=_positive,
        metavar="US",
        help="most accurate model within this cost, microseconds per query on all cores of this "
        "machine (float, no default)",
    )
    p.add_argument("--out", type=Path, required=True, help="output package (path, required)")
    p.add_argument(
        "--work",
        type=Path,
        help="folder for trainings and the report (path, default: OUT with suffix .fit)",
    )
    p.add_argument(
        "--steps",
        type=int,
        default=40_000,
        help="steps of the final training (int, default: %(default)s)",
    )
    p.add_argument(
        "--grid",
        choices=("short", "full"),
        help="candidate models, as in rna-bench frontier (default: full on a GPU, else short)",
    )
    add_trainings(p)
    add_credit(p)
    return p


def main(argv: list[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    args = parser().parse_args(argv)
    go_on = "run the same command again to resume"
    return run_command(lambda: _in_place(args), args.debug, go_on, "train")


def goal_of(args: argparse.Namespace) -> Goal:
    """The goal that the options set."""
    from rna_export.fit.goal import Goal

    if args.max_error is not None:
        return Goal("max_error", args.max_error)
    if args.min_psnr is not None:
        return Goal("min_psnr", args.min_psnr)
    return Goal("budget", 1e3 * args.budget_us)


def _in_place(args: argparse.Namespace) -> None:
    with open_executor(args.cluster) as executor:
        _run(args, executor)


def _run(args: argparse.Namespace, executor: Executor) -> None:
    from rna_export.capture.dataset.dataset_folder import Dataset
    from rna_export.fit.fit_run import fit, is_work_folder
    from rna_export.trials.grid import full_grid, short_grid
    from rna_export.trials.trial_pool import TrialWorkers

    if args.steps < 16:
        raise TrainingError(f"--steps: found {args.steps}, expected at least 16")
    dataset = Dataset(args.dataset).only
    workers = TrialWorkers.usual(args.device, args.workers, executor, args.store, dataset.folder)
    grid = args.grid or ("full" if workers.device == "cuda" else "short")
    models = {"full": full_grid, "short": short_grid}[grid](dataset.kind, args.steps)
    ours = [trial for trial in models if trial.family == "ours"]
    work = args.work or args.out.with_suffix(".fit")
    check_outputs([args.out], [])
    check_outside(work, [args.out, args.dataset])
    with owned(work, "rna-fit", is_work_folder):
        found = fit(dataset, ours, goal_of(args), args.steps, workers, work, print)
        _write(args, found, dataset, work)


def _write(args: argparse.Namespace, found: Fit, dataset: DatasetPart, work: Path) -> None:
    """The package of the chosen model, and the report."""
    from rna_export.export.package_build import build_package
    from rna_export.fit.fit_page import write_page
    from rna_export.training.checkpoint import load_checkpoint
    from rna_export.trials.trial_packages import TRIAL_PRECISIONS

    build_package(
        [load_checkpoint(found.checkpoint)],
        dataset.dataset,
        args.out,
        args.source,
        args.license,
        print,
        [TRIAL_PRECISIONS[found.chosen.precision]],
        max_loss=math.inf,  # the chosen model already meets the goal
    )
    write_page(found, dataset.manifest.name, work / "index.html")
    print(
        f"chosen: {found.chosen.name}, {found.chosen.ns:.0f} ns/query; "
        f"{found.seconds:.0f} s of training in total\n"
        f"wrote {args.out}, {work / 'index.html'}\n"
        f"next: {command_line('rna-validate', args.out)}"
    )


def _positive(text: str) -> float:
    value = float(text)
    if not value > 0.0:
        raise argparse.ArgumentTypeError(f"expected more than 0, found {text}")
    return value


if __name__ == "__main__":
    sys.exit(main())
