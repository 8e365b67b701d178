"""The feature grid: three planes, channel-last, summed. Twin of `rna_sdk.runtime`'s gather."""

from functools import lru_cache
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn

from rna_export.training.optimization import plane_kernels

# planes[0] = XY, planes[1] = YZ, planes[2] = ZX: (column axis, row axis); spec/RNA.md, Planes.
PLANE_AXES = ((0, 1), (1, 2), (2, 0))

# Of the texels at first. Texels are touched rarely: what noise they begin with, they keep. On the
# toy, 0.5 cost 1.8 dB, 0.1 half a decibel.
INITIAL_DEVIATION = 0.003


class Triplane(nn.Module):
    """Planes (3, R, R, C) float32 over the object-space box `low`..`high`, (3,) each."""

    low: Tensor
    high: Tensor

    def __init__(self, resolution: int, channels: int, low: Tensor, high: Tensor):
        super().__init__()
        shape = (3, resolution, resolution, channels)
        self.planes = nn.Parameter(INITIAL_DEVIATION * torch.randn(shape))
        self.register_buffer("low", low.float())
        self.register_buffer("high", high.float())

    def forward(self, position: Tensor, blur: float | Tensor = 1.0) -> Tensor:
        """Features (n, C) at positions (n, 3); `blur` is a footprint in texels, 1 for none.

        Positions get no gradient.
        """
        p = (position - self.low) / (self.high - self.low)
        if not isinstance(blur, Tensor) and self.planes.device.type == "cpu":
            features: Tensor = _Gather.apply(self.planes, p, blur)  # type: ignore[no-untyped-call]
            return features
        is_blurred = isinstance(blur, Tensor) or blur > 1.0
        return gathered(blurred(self.planes, blur) if is_blurred else self.planes, p)

    @torch.no_grad()
    def smooth(self, share: float) -> None:
        """Exchange a share, at most 0.25, of the difference between neighbouring texels."""
        if self.planes.device.type == "cpu":
            plane_kernels.diffuse(self.planes.numpy(), np.float32(share))
        else:
            self.planes.copy_(diffused(self.planes, share))


def diffused(planes: Tensor, share: float) -> Tensor:
    """Planes (3, R, R, C) after an explicit step of diffusion along each axis, in plain PyTorch."""
    for axis in (2, 1):
        difference = share * planes.diff(dim=axis)
        none = torch.zeros_like(planes.narrow(axis, 0, 1))
        planes = planes + torch.cat([difference, none], axis) - torch.cat([none, difference], axis)
    return planes


def gathered(planes: Tensor, p: Tensor) -> Tensor:
    """Features (n, C) at p (n, 3) in [0, 1], in plain PyTorch: for GPUs, and the kernels' twin."""
    resolution, channels = planes.shape[1], planes.shape[3]
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
    texels = planes.reshape(-1, channels).index_select(0, torch.stack(rows, dim=1).flatten())
    weighed = texels.view(len(p), -1, channels) * torch.stack(weights, dim=1)[..., None]
    return weighed.sum(dim=1)


def blurred(planes: Tensor, footprint: float | Tensor) -> Tensor:
    """Planes (3, R, R, C) under a Gaussian of standard deviation (footprint - 1) / 2 texels.

    Normalised where the kernel leaves the plane. In plain PyTorch, as `gathered`; a footprint in a
    tensor is read on its device alone.
    """
    texels = torch.arange(planes.shape[1], device=planes.device)
    distance = (texels[:, None] - texels[None, :]).abs()
    sigma = (torch.as_tensor(footprint, device=planes.device) - 1.0) / 2.0
    matrix = torch.exp(-0.5 * (distance / sigma.clamp(min=1e-3)).square())
    matrix = matrix * (distance <= (2.5 * sigma).round().clamp(min=1.0))
    matrix = matrix / matrix.sum(dim=1, keepdim=True)
    return torch.einsum("ab,kbcf,dc->kadf", matrix, planes, matrix)


@lru_cache(maxsize=1)
def _blur(resolution: int, footprint: float) -> tuple[np.ndarray, np.ndarray]:
    """Kernel of the blur, and by texel 1 / its sum inside the plane; float32."""
    if footprint <= 1.0:
        return np.ones(1, np.float32), np.ones(resolution, np.float32)
    sigma = (footprint - 1.0) / 2.0
    radius = max(1, round(2.5 * sigma))
    kernel = np.exp(-0.5 * (np.arange(-radius, radius + 1) / max(sigma, 1e-3)) ** 2)
    kernel = (kernel / kernel.sum()).astype(np.float32)
    inside = np.convolve(np.ones(resolution), kernel)[radius : radius + resolution]
    return kernel, (1.0 / inside).astype(np.float32)


class _Gather(torch.autograd.Function):
    """`gathered(blurred(planes, blur), p)`, without a blurred copy: it weighs more texels.

    The gradient is added to `planes.grad` in place, where there is one.
    """

    @staticmethod
    def forward(ctx: Any, planes: Tensor, p: Tensor, blur: float) -> Tensor:
        resolution, channels = planes.shape[1], planes.shape[3]
        kernel, normalisation = _blur(resolution, blur)
        first = np.empty((len(p), 3), np.int32)
        weights = np.empty((len(p), 3, min(len(kernel) + 1, resolution)), np.float32)
        plane_kernels.footprints(p.contiguous().numpy(), kernel, normalisation, first, weights)
        features = torch.empty(len(p), channels)
        plane_kernels.gather(planes.detach().numpy(), first, weights, features.numpy())
        ctx.planes, ctx.first, ctx.weights = planes, first, weights
        return features

    @staticmethod
    def backward(ctx: Any, gradient: Tensor) -> tuple[Tensor | None, None, None]:
        into = ctx.planes.grad
        added = torch.zeros_like(ctx.planes) if into is None else into
        plane_kernels.scatter(gradient.contiguous().numpy(), ctx.first, ctx.weights, added.numpy())
        return (added if into is None else None), None, None
