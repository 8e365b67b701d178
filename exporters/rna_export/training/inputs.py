"""Decoder input blocks in PyTorch: twins of those in `rna_sdk.runtime`; RNA-1.0, Input blocks."""

from __future__ import annotations

import torch
from torch import Tensor


def assemble(
    blocks: tuple[str, ...], features: Tensor, position: Tensor, n: Tensor, wo: Tensor, wi: Tensor
) -> Tensor:
    """The decoder's input (k, K). `position`: 2 p - 1 in the bounds, (k, 3); others as named."""
    return torch.cat([_BLOCKS[b](features, position, n, wo, wi) for b in blocks], dim=1)


def half_vector(n: Tensor, wo: Tensor, wi: Tensor) -> Tensor:
    """n.h, log2(1 - n.h + 1e-4) / 6, n.wi, n.wo, wi.h: (k, 5)."""
    total = wi + wo
    length = total.norm(dim=1, keepdim=True)
    h = torch.where(length < 1e-6, n, total / length.clamp(min=1e-6))
    n_h = _dot(n, h)
    sharp = torch.log2(1.0 - n_h.clamp(max=1.0) + 1e-4) / 6.0
    return torch.cat([n_h, sharp, _dot(n, wi), _dot(n, wo), _dot(wi, h)], dim=1)


def _dot(a: Tensor, b: Tensor) -> Tensor:
    return (a * b).sum(dim=1, keepdim=True)


_BLOCKS = {
    "features": lambda features, position, n, wo, wi: features,
    "position": lambda features, position, n, wo, wi: position,
    "normal": lambda features, position, n, wo, wi: n,
    "wo": lambda features, position, n, wo, wi: wo,
    "wi": lambda features, position, n, wo, wi: wi,
    "half_vector": lambda features, position, n, wo, wi: half_vector(n, wo, wi),
}
