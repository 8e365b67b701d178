"""The loss between the decoder's y = log(x / unit + 1) and radiance targets x, (n, 3) each."""

from __future__ import annotations

import torch
from torch import Tensor


def log_l2(y: Tensor, target: Tensor, unit: Tensor | float = 1.0) -> Tensor:
    """Squared error of log(x / unit + 1): the paper, section 4.2, where the unit is 1.

    Noise in the targets darkens it by about half their variance over (x + unit)^2: nothing for
    surfaces at 4 paths and more, much for hair at one (docs/decisions.md).
    """
    return (y - torch.log1p(target / unit)).square().mean()
