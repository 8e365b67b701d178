"""Features in one texture over an unwrapped surface, the paper's alternative to the triplane."""

from __future__ import annotations

import torch
import torch.nn.functional as F
from torch import Tensor, nn

from rna_export.training.model.triplane import INITIAL_DEVIATION


class UvTexture(nn.Module):
    """Texels (1, C, R, R) float32 over uv in [0, 1]; `low` and `high` are the asset's box.

    It is not blurred at first, as a triplane is: across the seams of charts a blur would mix
    places that are not near each other.
    """

    low: Tensor
    high: Tensor

    def __init__(self, resolution: int, channels: int, low: Tensor, high: Tensor):
        super().__init__()
        shape = (1, channels, resolution, resolution)
        self.texels = nn.Parameter(INITIAL_DEVIATION * torch.randn(shape))
        self.register_buffer("low", low.float())
        self.register_buffer("high", high.float())

    def forward(self, uv: Tensor, blur: float | Tensor = 1.0) -> Tensor:
        """Features (n, C) at uv (n, 2)."""
        grid = (2.0 * uv - 1.0)[None, :, None]
        found = F.grid_sample(self.texels, grid, padding_mode="border", align_corners=False)
        return found[0, :, :, 0].T
