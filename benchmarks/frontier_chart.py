"""Draws frontiers from their committed JSON, below one another.

    python benchmarks/frontier_chart.py benchmarks/results/frontier-toy.json \
        --out docs/images/frontier-toy.png
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from rna_bench.frontier.chart import draw


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("reports", type=Path, nargs="+", help="frontier.json of rna-bench")
    parser.add_argument("--out", type=Path, required=True, help="PNG to write")
    args = parser.parse_args()
    draw([json.loads(report.read_text()) for report in args.reports], args.out)


if __name__ == "__main__":
    main()
