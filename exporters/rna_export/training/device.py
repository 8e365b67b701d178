"""The device of a training."""

from __future__ import annotations

import torch

from rna_sdk.errors import TrainingError


def chosen_device(device: str) -> str:
    """`cpu` or `cuda` for these or `auto`. Raises `TrainingError` for a GPU that is not there."""
    if device == "cuda" and not torch.cuda.is_available():
        raise TrainingError("--device cuda: PyTorch finds no CUDA device")
    if device == "auto":
        return "cuda" if torch.cuda.is_available() else "cpu"
    return device
