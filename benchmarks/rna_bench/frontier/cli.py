"""`rna-bench frontier`: decode cost against accuracy over a grid of models."""

from __future__ import annotations

import argparse

NAME = "frontier"
SENTENCE = "Train and measure a grid of models on one dataset, and chart cost against accuracy."
EXAMPLE = "rna-bench frontier toy.rays/ --short --out bench/toy"
WHEN_STOPPED = "finished models are kept: run the same command to go on"


def add_options(p: argparse.ArgumentParser) -> None:
    """The options of the command."""


def run(args: argparse.Namespace) -> None:
    """Measure."""
