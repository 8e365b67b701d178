"""The feature grid: three planes, channel-last, summed. Twin of `rna_sdk.runtime`'s gather."""

from __future__ import annotations

import torch
import torch.nn.functional as F
from torch import Tensor, nn

# planes[0] = XY, planes[1] = YZ, planes[2] = ZX: (column axis, row axis); RNA-1.0, Planes.
PLANE_AXES = ((0, 1), (1, 2), (2, 0))


class Triplane(nn.Module):
    """Planes (3, R, R, C) float32 over the object-space box `low`..`high`, (3,) each."""

    def __init__(self, resolution: int, channels: int, low: Tensor, high: Tensor):
        super().__init__()
        self.planes = nn.Parameter(0.1 * torch.randn(3, resolution, resolution, channels))
        self.register_buffer("low", low.float())
        self.register_buffer("high", high.float())

    def forward(self, position: Tensor, blur: float = 1.0) -> Tensor:
        """Features (n, C) at positions (n, 3); `blur` is a footprint in texels, 1 for none."""
        planes = self.planes if blur <= 1.0 else blurred(self.planes, blur)
        resolution, channels = planes.shape[1], planes.shape[3]
        p = (position - self.low) / (self.high - self.low)
        texel = (p * resolution - 0.5).clamp(0.0, resolution - 1.0)
        first = texel.floor().clamp(max=resolution - 2.0)
        fraction = texel - first
        first = first.long()
        rows, weights = [], []
        for k, (a, b) in enumerate(PLANE_AXES):
            corner = (k * resolution + first[:, b]) * resolution + first[:, a]
            rows += [corner, corner + 1, corner + resolution, corner + resolution + 1]
            u, v = fraction[:, a], fraction[:, b]
            weights += [(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v]
        return F.embedding_bag(
            torch.stack(rows, dim=1),
            planes.reshape(-1, channels),
            per_sample_weights=torch.stack(weights, dim=1),
            mode="sum",
        )


def blurred(planes: Tensor, footprint: float) -> Tensor:
    """Planes (3, R, R, C) under a Gaussian of standard deviation (footprint - 1) / 2 texels."""
    sigma = (footprint - 1.0) / 2.0
    radius = max(1, round(2.5 * sigma))
    offset = torch.arange(-radius, radius + 1, device=planes.device, dtype=planes.dtype)
    kernel = torch.exp(-0.5 * (offset / sigma) ** 2)
    kernel = kernel / kernel.sum()
    channels = planes.shape[3]
    image = planes.permute(0, 3, 1, 2)
    image = F.pad(image, (radius,) * 4, mode="replicate")
    image = F.conv2d(image, kernel.view(1, 1, 1, -1).expand(channels, 1, 1, -1), groups=channels)
    image = F.conv2d(image, kernel.view(1, 1, -1, 1).expand(channels, 1, -1, 1), groups=channels)
    return image.permute(0, 2, 3, 1)
