"""Draws the picture of a frontier from its committed JSON.

    python benchmarks/frontier_chart.py benchmarks/results/frontier-toy.json \
        docs/images/frontier-toy.png
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from rna_bench.frontier.chart import draw


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report", type=Path, help="frontier.json of rna-bench")
    parser.add_argument("picture", type=Path, help="PNG to write")
    args = parser.parse_args()
    draw(json.loads(args.report.read_text()), args.picture)


if __name__ == "__main__":
    main()
