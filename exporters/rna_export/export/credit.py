"""Options of every command that writes a package: whose model it is."""

from __future__ import annotations

import argparse


def add_credit(p: argparse.ArgumentParser) -> None:
    """Add --source and --license."""
    p.add_argument(
        "--source",
        help="name, author and address of the original model (text, default: the captured file "
        "and its SHA-256)",
    )
    p.add_argument(
        "--license",
        default="NOASSERTION",
        help="SPDX expression of the asset's terms (default: %(default)s)",
    )
