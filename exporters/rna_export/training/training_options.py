"""Options of commands that train."""

import argparse

from rna_export.training.presets import NEARBY_MODES
from rna_sdk.errors import TrainingError


def add_nearby(parser: argparse.ArgumentParser) -> None:
    """Add `--nearby` for trainings."""
    parser.add_argument(
        "--nearby",
        choices=NEARBY_MODES,
        default="auto",
        help="count light that enters beside a point, for the edges of shadows on translucent "
        "assets; auto: where light enters a material, two short trainings decide; never in "
        "presets of the paper (default: %(default)s)",
    )


def add_device(parser: argparse.ArgumentParser, what: str) -> None:
    """Add `--device` for trainings."""
    parser.add_argument(
        "--device",
        choices=("auto", "cpu", "cuda"),
        default="auto",
        help=f"device for {what} (default: %(default)s, the GPU if available)",
    )


def device_name(device: str) -> str:
    """Name of a device of PyTorch for the user."""
    if device == "cpu":
        return "the CPU"
    import torch

    return f"the GPU ({torch.cuda.get_device_name()})"


def chosen_device(device: str) -> str:
    """`cpu` or `cuda` for these or `auto`. Raises `TrainingError` for a GPU that is not there."""
    import torch

    if device == "cuda" and not torch.cuda.is_available():
        raise TrainingError("--device cuda: PyTorch finds no CUDA device")
    if device == "auto":
        return "cuda" if torch.cuda.is_available() else "cpu"
    return device


def add_incomplete(parser: argparse.ArgumentParser) -> None:
    """The option to use a dataset that is not whole."""
    parser.add_argument(
        "--incomplete",
        action="store_true",
        help="accept a dataset with missing, replaced or uncaptured files, and use the others "
        "(default: refuse it)",
    )
