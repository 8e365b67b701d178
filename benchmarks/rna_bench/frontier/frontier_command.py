"""Train and measure a grid of models on one dataset, and chart cost against accuracy.

    rna-bench frontier toy.rays/ --short --source toy.py --out bench/toy

Decode cost against accuracy of our models, the paper's and ablations: see docs/frontier.md.
"""

import argparse
from pathlib import Path

from rna_export.training.training_options import add_device
from rna_work.cluster.cluster_option import add_cluster_option
from rna_work.executors import Executor, open_executor

_PARTS = ("train", "cost", "cycles", "chart")


def add_options(p: argparse.ArgumentParser) -> None:
    """The options of the command."""
    p.add_argument("dataset", type=Path, help="dataset written by rna-capture (path)")
    p.add_argument(
        "--out",
        type=Path,
        required=True,
        help="folder for models, records and report (path, required)",
    )
    p.add_argument(
        "--short",
        action="store_true",
        help="about 20 models with short trainings: 40 minutes on 2 cores (default: off)",
    )
    p.add_argument(
        "--steps", type=int, help="steps per training (int, default: 20,000; with --short 5,000)"
    )
    p.add_argument(
        "--source",
        type=Path,
        help="captured model, to add Cycles to the chart (path, default: without Cycles)",
    )
    p.add_argument(
        "--only",
        choices=_PARTS,
        help="run only this step; `cost` needs an idle machine (default: all)",
    )
    p.add_argument(
        "--trials",
        nargs="+",
        metavar="NAME",
        help="train only these models or groups of the grid (ours, paper, opponent, "
        "ablation, and the tables: architecture, channels, ...; default: all)",
    )
    add_device(p, "trainings")
    p.add_argument(
        "--workers",
        type=int,
        help="concurrent trainings (int, default: one per core, or one per GPU)",
    )
    add_cluster_option(p)


def run(args: argparse.Namespace) -> None:
    """Train, measure and chart; resumes and skips completed steps."""
    with open_executor(args.cluster) as executor:
        _run(args, executor)


def _run(args: argparse.Namespace, executor: Executor) -> None:
    from rna_bench.frontier.frontier_study import Study

    study = Study.of(args, executor)
    parts = [args.only] if args.only else _PARTS
    if "train" in parts:
        study.train()
    if "cost" in parts:
        study.time(again=args.only is not None)
    if "cycles" in parts and args.source is not None:
        study.render_cycles(args.source)
    if "chart" in parts:
        study.write()
