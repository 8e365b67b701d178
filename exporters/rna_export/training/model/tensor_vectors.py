"""Vectors (k, 3) and numbers (k, 1) in PyTorch: the functions that formulas of input blocks call.

No derivative is NaN or infinite where `where` and `at_least` of a formula set a value aside.
"""

import torch
from torch import Tensor

log2, sqrt, where = torch.log2, torch.sqrt, torch.where


def dot(a: Tensor, b: Tensor) -> Tensor:
    """Dot products of rows, (k, 1)."""
    return (a * b).sum(dim=1, keepdim=True)


def cross(a: Tensor, b: Tensor) -> Tensor:
    return torch.cross(a, b, dim=1)


def length(v: Tensor) -> Tensor:
    """(k, 1), with a derivative of 0 at 0."""
    norm: Tensor = v.norm(dim=1, keepdim=True)
    return norm


def largest(v: Tensor) -> Tensor:
    """The largest absolute component, (k, 1); a constant to derivatives, as a scale."""
    return v.detach().abs().amax(dim=1, keepdim=True)


def at_least(x: Tensor, low: float) -> Tensor:
    return x.clamp(min=low)


def clamped(x: Tensor) -> Tensor:
    """x, moved into [-1, 1]."""
    return x.clamp(-1.0, 1.0)
