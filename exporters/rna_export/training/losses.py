"""Losses between the decoder's y = log(x + 1), (n, 3), and noisy radiance targets, (n, 3)."""

from __future__ import annotations

import torch
from torch import Tensor

_FLOOR = 0.3  # of the magnitude that relative_l2 divides by; about display white under irradiance pi


def log_l2(y: Tensor, target: Tensor) -> Tensor:
    """Squared error of log(x + 1): the paper, section 4.2. Noise in the target darkens it."""
    return (y - torch.log1p(target)).square().mean()


def relative_l2(y: Tensor, target: Tensor) -> Tensor:
    """Squared error over the prediction's own magnitude, which gets no gradient.

    Its minimum is the mean of the targets, so noise does not bias it (Lehtinen et al.,
    "Noise2Noise", 2018, section 3.2).
    """
    x = torch.expm1(y.clamp(max=5.0))
    weight = 1.0 / (x.detach().clamp(min=0.0) + _FLOOR)
    return ((x - target) * weight).square().mean()


LOSSES = {"log_l2": log_l2, "relative_l2": relative_l2}
