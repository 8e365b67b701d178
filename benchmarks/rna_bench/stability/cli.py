"""`rna-bench stability`: a chart for each way that such methods are known to fail."""

from __future__ import annotations

import argparse

NAME = "stability"
SENTENCE = "Measure each way that relightable neural assets are known to fail, with a pass mark."
EXAMPLE = "rna-bench stability --out bench/stability"
WHEN_STOPPED = "finished cases are kept: run the same command to go on"


def add_options(p: argparse.ArgumentParser) -> None:
    """The options of the command."""


def run(args: argparse.Namespace) -> None:
    """Measure."""
