"""The device of a training."""

from __future__ import annotations

import torch

from rna_sdk.errors import TrainingError


def chosen_device(asked: str) -> str:
    """`cpu` or `cuda` for these or `auto`. Raises `TrainingError` for a GPU that is not there."""
    if asked == "cuda" and not torch.cuda.is_available():
        raise TrainingError("--device cuda: PyTorch finds no CUDA device")
    if asked == "auto":
        return "cuda" if torch.cuda.is_available() else "cpu"
    return asked
