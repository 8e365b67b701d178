"""How every command writes what it measured: JSON with the stamp first, written atomically."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from rna_sdk.atomic_file import write_atomically


def write_results(
    path: Path, stamp: dict[str, Any] | None, report: dict[str, Any], indent: int | None = 1
) -> None:
    """Write the report, stamped; folders are made.

    stamp: None for results of before there were stamps. indent: None for one long line.
    """
    separators = (",", ":") if indent is None else None
    text = json.dumps({"stamp": stamp, **report}, indent=indent, separators=separators)
    path.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(path, f"{text}\n".encode())


def publish(report: dict[str, Any], args: argparse.Namespace) -> None:
    """Print a command's report; write it to `args.out`, too, if that is given."""
    print(json.dumps({"stamp": args.stamp, **report}, indent=1))
    if args.out is not None:
        write_results(args.out, args.stamp, report)
        print(f"wrote {args.out}", file=sys.stderr)
