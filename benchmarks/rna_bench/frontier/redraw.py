"""Draw frontiers from their committed JSON: one row per asset, shorter trainings as hollow markers.

    rna-bench frontier-chart benchmarks/results/frontier-{toy,fox,curls,helmet}.json \\
        --out docs/images/frontier.svg

Reports of one asset share a row.
"""

import argparse
import json
from pathlib import Path

from rna_bench.frontier.frontier_chart import draw


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("reports", type=Path, nargs="+", help="frontier.json of rna-bench")
    parser.add_argument("--out", type=Path, required=True, help="PNG to write")


def run(args: argparse.Namespace) -> None:
    draw([json.loads(report.read_text()) for report in args.reports], args.out)
