"""What the speed benchmarks share: their options, and how they hand out their JSON."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any


def report_parser(description: str, epilog: str) -> argparse.ArgumentParser:
    """A parser with --repeats and --out."""
    parser = argparse.ArgumentParser(
        description=description,
        epilog=epilog,
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("--repeats", type=int, default=9, help="runs that a median is taken of")
    parser.add_argument("--out", type=Path, help="file for the JSON")
    return parser


def publish(report: dict[str, Any], out: Path | None) -> None:
    """Print the report as JSON; write it to `out`, too, if given."""
    text = json.dumps(report, indent=2)
    print(text)
    if out:
        out.write_text(text + "\n")
        print(f"wrote {out}", file=sys.stderr)
