"""Measure known failure modes of relightable neural assets, each with a pass threshold.

    rna-bench stability toy.rays/ --source toy.py --out bench/stability

One chart per failure mode: see docs/stability.md.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from rna_sdk.cores import core_count
from rna_sdk.errors import CaptureError
from rna_work.cluster.cluster_option import add_cluster_option
from rna_work.executors import open_executor

# As in `suite.CASES`, which takes seconds to import: not for --help.
CASE_NAMES = (
    "sharp",
    "grazing",
    "near-light",
    "unseen",
    "shadow-edges",
    "thin",
    "zoom",
    "noise",
    "little-data",
    "luck",
    "numbers",
    "energy",
    "motion",
)
MOVING = ("figure", "slab", "flag", "tail")  # assets of `motion`


def add_options(p: argparse.ArgumentParser) -> None:
    """The options of the command."""
    p.add_argument(
        "dataset",
        nargs="?",
        type=Path,
        help="dataset of the asset (path, default: only the suite's own assets)",
    )
    p.add_argument("--package", type=Path, help="package of the asset (path, default: train one)")
    p.add_argument("--tier", help="tier of the package (text, default: its first)")
    p.add_argument(
        "--source",
        type=Path,
        help="model the asset was captured from (path, default: without Cycles)",
    )
    p.add_argument(
        "--out", type=Path, required=True, help="folder for results, runs and captures (path)"
    )
    p.add_argument(
        "--work", type=Path, help="folder for runs and captures (path, default: OUT/work)"
    )
    p.add_argument(
        "--cases",
        nargs="+",
        choices=CASE_NAMES,
        metavar="CASE",
        help=", ".join(CASE_NAMES) + " (default: all)",
    )
    p.add_argument(
        "--moving",
        nargs="+",
        choices=MOVING,
        metavar="ASSET",
        help=f"assets of `motion`: {', '.join(MOVING)} (default: all)",
    )
    p.add_argument(
        "--steps",
        type=int,
        default=3000,
        help="steps per training, three times as many for `sharp` (int, default: %(default)s)",
    )
    p.add_argument(
        "--workers",
        type=int,
        default=core_count(),
        help="Blender processes (int, default: one per core, here %(default)s)",
    )
    add_cluster_option(p)
    p.add_argument(
        "--short",
        action="store_true",
        help="trial run with 1/8 of samples and steps (default: off)",
    )
    p.add_argument(
        "--again", action="store_true", help="measure finished cases again (default: off)"
    )
    p.add_argument(
        "--redraw",
        nargs="+",
        type=Path,
        metavar="JSON",
        help="only redraw results of earlier runs, together (paths, default: measure)",
    )


def run(args: argparse.Namespace) -> None:
    """Measure."""
    from rna_bench.stability.stability_page import read_results, write_page
    from rna_bench.stability.suite import CASES, run_cases

    if args.redraw is not None:
        write_page(args.out, *read_results(args.redraw, CASES))
    else:
        fixtures = _fixtures(args)
        settings = {"steps": fixtures.steps, "short": args.short, "tier": args.tier or "default"}
        if args.moving is not None:
            settings["moving"] = args.moving
        cases = [case for case in CASES if args.cases is None or case.name in args.cases]
        with open_executor(args.cluster) as executor:
            folder = args.out / "cases"
            results = run_cases(cases, fixtures, folder, settings, args.again, print, executor)
        write_page(args.out, args.stamp, fixtures.name, settings, results)
    print(f"wrote {args.out / 'index.html'}, {args.out / 'summary.md'}")


def _fixtures(args: argparse.Namespace) -> Any:
    from rna_bench.stability.fixtures import Fixtures, Subject
    from rna_export.capture.blender_process.blender_process import Source
    from rna_export.capture.dataset.dataset_folder import Dataset

    for name in ("dataset", "package", "source", "out", "work") if args.cluster else ():
        if (path := getattr(args, name)) is not None:
            setattr(args, name, path.absolute())  # for workers on other machines
    for path in (args.package, args.source):
        if path is not None and not path.is_file():
            raise CaptureError(f"{path}: no such file")
    dataset = Dataset(args.dataset).only if args.dataset else None
    arguments = dataset.manifest.arguments if dataset else ()
    source = Source(args.source, arguments) if args.source else None
    subject = Subject(dataset, args.package, args.tier, source)
    folder = args.work or args.out / "work"
    moving = tuple(args.moving or MOVING)
    return Fixtures(folder, subject, args.steps, args.workers, args.short, moving)
