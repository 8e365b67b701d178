"""The loss between the decoder's y = log(x + 1), (n, 3), and radiance targets x, (n, 3)."""

from __future__ import annotations

import torch
from torch import Tensor


def log_l2(y: Tensor, target: Tensor) -> Tensor:
    """Squared error of log(x + 1): the paper, section 4.2.

    Noise in the targets darkens it by about half their variance over (x + 1)^2: nothing for
    surfaces at 4 paths and more, much for hair at one (docs/decisions.md).
    """
    return (y - torch.log1p(target)).square().mean()
