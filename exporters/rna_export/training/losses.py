"""The loss between the decoder's y = log(x / unit + 1) and radiance targets x, (n, 3) each."""

from __future__ import annotations

import torch
from torch import Tensor

from rna_export.training.model import NeuralAsset
from rna_export.training.samples import columns


def sample_loss(model: NeuralAsset, rows: Tensor, blur: float) -> Tensor:
    """The loss of a batch of `SampleTable`, of the outputs alone that match the visibility."""
    at = columns(rows)
    both = model(at["position"], at["normal"], at["wo"], at["wi"], blur)
    y = torch.where(at["visible"][:, None] > 0.5, both[:, 0], both[:, 1])
    return log_l2(y, at["radiance"], model.unit)


def log_l2(y: Tensor, target: Tensor, unit: Tensor | float = 1.0) -> Tensor:
    """Squared error of log(x / unit + 1): the paper, section 4.2, where the unit is 1.

    Noise in the targets darkens it by about half their variance over (x + unit)^2: nothing for
    surfaces at 4 paths and more, much for hair at one (docs/decisions.md).
    """
    return (y - torch.log1p(target / unit)).square().mean()
