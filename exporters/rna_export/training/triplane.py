"""The feature grid: three planes, channel-last, summed. Twin of `rna_sdk.runtime`'s gather."""

from __future__ import annotations

import numpy as np
import torch
import torch.nn.functional as F
from torch import Tensor, nn

from rna_export.training import plane_kernels

# planes[0] = XY, planes[1] = YZ, planes[2] = ZX: (column axis, row axis); spec/RNA.md, Planes.
PLANE_AXES = ((0, 1), (1, 2), (2, 0))

# Of the texels at first. Texels are touched rarely: what noise they begin with, they keep. On the
# toy, 0.5 cost 1.8 dB, 0.1 half a decibel.
INITIAL_DEVIATION = 0.003


class Triplane(nn.Module):
    """Planes (3, R, R, C) float32 over the object-space box `low`..`high`, (3,) each."""

    def __init__(self, resolution: int, channels: int, low: Tensor, high: Tensor):
        super().__init__()
        shape = (3, resolution, resolution, channels)
        self.planes = nn.Parameter(INITIAL_DEVIATION * torch.randn(shape))
        self.register_buffer("low", low.float())
        self.register_buffer("high", high.float())

    def forward(self, position: Tensor, blur: float = 1.0) -> Tensor:
        """Features (n, C) at positions (n, 3); `blur` is a footprint in texels, 1 for none.

        Positions get no gradient.
        """
        p = (position - self.low) / (self.high - self.low)
        planes = self.planes
        on_cpu = planes.device.type == "cpu"
        if blur > 1.0:
            planes = _Blur.apply(planes, blur) if on_cpu else blurred(planes, blur)
        return _Gather.apply(planes, p) if on_cpu else gathered(planes, p)


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
    return F.embedding_bag(
        torch.stack(rows, dim=1),
        planes.reshape(-1, channels),
        per_sample_weights=torch.stack(weights, dim=1),
        mode="sum",
    )


def blurred(planes: Tensor, footprint: float) -> Tensor:
    """Planes (3, R, R, C) under a Gaussian of standard deviation (footprint - 1) / 2 texels.

    Normalised where the kernel leaves the plane. In plain PyTorch, as `gathered`.
    """
    matrix = torch.from_numpy(_blur_matrix(planes.shape[1], footprint)).to(planes.device)
    return torch.einsum("ab,kbcf,dc->kadf", matrix, planes, matrix)


def _blur_kernel(footprint: float) -> np.ndarray:
    sigma = (footprint - 1.0) / 2.0
    radius = max(1, round(2.5 * sigma))
    kernel = np.exp(-0.5 * (np.arange(-radius, radius + 1) / max(sigma, 1e-3)) ** 2)
    return (kernel / kernel.sum()).astype(np.float32)


def _blur_matrix(resolution: int, footprint: float) -> np.ndarray:
    """(R, R) float32: the blur along one axis."""
    kernel = _blur_kernel(footprint)
    radius = len(kernel) // 2
    matrix = sum(np.eye(resolution, k=d - radius) * kernel[d] for d in range(len(kernel)))
    return (matrix / matrix.sum(axis=1, keepdims=True)).astype(np.float32)


class _Gather(torch.autograd.Function):
    @staticmethod
    def forward(ctx, planes: Tensor, p: Tensor) -> Tensor:
        p = p.contiguous()
        features = torch.empty(len(p), planes.shape[3])
        plane_kernels.gather(planes.detach().numpy(), p.numpy(), features.numpy())
        ctx.p, ctx.shape = p, planes.shape
        return features

    @staticmethod
    def backward(ctx, gradient: Tensor) -> tuple[Tensor, None]:
        planes = torch.zeros(ctx.shape)
        plane_kernels.scatter(gradient.contiguous().numpy(), ctx.p.numpy(), planes.numpy())
        return planes, None


class _Blur(torch.autograd.Function):
    """D K p, with K the zero-padded convolution and D its normalisation; transposed, K D g."""

    @staticmethod
    def forward(ctx, planes: Tensor, footprint: float) -> Tensor:
        kernel = _blur_kernel(footprint)
        ctx.kernel = kernel
        # What of the kernel lies inside the plane, at each place along an axis.
        ones = np.ones(planes.shape[1])
        inside = np.convolve(ones, kernel)[len(kernel) // 2 :][: len(ones)]
        normalise = (1.0 / np.outer(inside, inside)).astype(np.float32)
        ctx.normalise = torch.from_numpy(normalise)[..., None]
        return _convolved(planes.detach(), kernel) * ctx.normalise

    @staticmethod
    def backward(ctx, gradient: Tensor) -> tuple[Tensor, None]:
        return _convolved(gradient * ctx.normalise, ctx.kernel), None


def _convolved(planes: Tensor, kernel: np.ndarray) -> Tensor:
    source = planes.contiguous()
    along_columns, result = torch.empty_like(source), torch.empty_like(source)
    plane_kernels.blur_columns(source.numpy(), kernel, along_columns.numpy())
    plane_kernels.blur_rows(along_columns.numpy(), kernel, result.numpy())
    return result
