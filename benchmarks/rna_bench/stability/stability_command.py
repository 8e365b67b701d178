"""Measure known failure modes of relightable neural assets, each with a pass threshold.

    rna-bench stability toy.rays/ --source toy.py --out bench/stability

One chart per failure mode: see docs/stability.md.
"""

import argparse
from pathlib import Path
from typing import Any

from rna_bench.stability.cases import CASE_NAMES
from rna_sdk.errors import CaptureError
from rna_sdk.machine.cores import core_count


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
        "--cases",
        nargs="+",
        choices=CASE_NAMES,
        metavar="CASE",
        help=", ".join(CASE_NAMES) + " (default: all)",
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
        type=Path,
        metavar="JSON",
        help="only redraw the results of an earlier run (path, default: measure)",
    )


def run(args: argparse.Namespace) -> None:
    """Measure."""
    from rna_bench.stability.stability_report import read_results, write_report
    from rna_bench.stability.suite import CASES, run_cases
    from rna_export.machine import keep_freed_memory

    if args.redraw is not None:
        write_report(args.out, *read_results(args.redraw, CASES))
    else:
        keep_freed_memory()
        fixtures = _fixtures(args)
        settings = {"steps": fixtures.steps, "short": args.short, "tier": args.tier or "default"}
        cases = [case for case in CASES if args.cases is None or case.name in args.cases]
        results = run_cases(cases, fixtures, args.out / "cases", settings, args.again, print)
        write_report(args.out, args.stamp, fixtures.name, settings, results)
    print(f"wrote {args.out / 'results.json'}, {args.out / 'summary.md'} and a chart a case")


def _fixtures(args: argparse.Namespace) -> Any:
    from rna_bench.stability.fixtures import Fixtures, Subject
    from rna_export.capture.blender_process.blender_process import Source
    from rna_export.capture.dataset.dataset_folder import Dataset

    for path in (args.package, args.source):
        if path is not None and not path.is_file():
            raise CaptureError(f"{path}: no such file")
    dataset = Dataset(args.dataset).only if args.dataset else None
    arguments = dataset.manifest.arguments if dataset else ()
    source = Source(args.source, arguments) if args.source else None
    subject = Subject(dataset, args.package, args.tier, source)
    return Fixtures(args.out / "work", subject, args.steps, args.workers, args.short)
