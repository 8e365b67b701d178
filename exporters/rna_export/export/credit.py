"""Credit options of commands that write a package."""

from __future__ import annotations

import argparse


def add_credit(p: argparse.ArgumentParser) -> None:
    """Add --source and --license."""
    p.add_argument(
        "--source",
        help="credit of the original model: name, author, URL (text, default: file name and "
        "SHA-256)",
    )
    p.add_argument(
        "--license",
        default="NOASSERTION",
        help="SPDX license expression of the asset (text, default: %(default)s)",
    )
