"""The decoder of a part's lobes in PyTorch, and what its outputs mean."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor, nn

from rna_bench.lobes.view_points import Rows, ViewPoints
from rna_export.training.model.layers import through
from rna_sdk.package import Package, query_width
from rna_sdk.runtime.engine.batch import Batch
from rna_sdk.runtime.engine.tiles import QueryFiller

LOBES = 8
CONCENTRATIONS = (2.0, 10.0)
"""kappa of a lobe that the decoder leaves as it is: of the first half of them, and of the rest."""

SHIFT = 8.0
"""Of axes: a decoder of the profile gives nothing negative."""

SMALLEST_KAPPA = 0.01

_UNIT = 0.1
_TOP = 8.0  # of logarithms
_FURNACE = 0.5  # of all amplitudes together, at first


class LobeInputs(NamedTuple):
    """What lobes are made of: queries (n, K); wide, mirror (n, 3) and free (n,), of ViewPoints."""

    queries: Rows
    wide: Rows
    mirror: Rows
    free: Rows


class QueryRows:
    """Makes the decoder's queries for a part: blocks of inputs, then the visibility.

    Attributes:
        inputs: names of the blocks: those of transport, wi being the mirror direction.
        columns: K, of blocks and visibility.
    """

    def __init__(self, package: Package, tier: str, part: int, visibility_columns: int) -> None:
        """package: open. visibility_columns: of ViewPoints.visibility, or 0 to leave it out."""
        own, record = package.tier(tier).parts[part], package.manifest.parts[part]
        self._filler = QueryFiller(package.planes(tier, part), record.bounds, own, record.kind)
        self._blocks, self._visibility = query_width(own.inputs, own.channels), visibility_columns
        self.inputs, self.columns = own.inputs, self._blocks + visibility_columns

    def of(self, points: ViewPoints) -> LobeInputs:
        """The inputs of points."""
        arrays = {"position": points.position, "axis": points.axis, "h": points.h}
        batch = Batch.of(arrays | {"wo": points.wo, "wi": points.mirror}, ())
        blocks = np.zeros((len(points), self._blocks), np.float32)
        self._filler.fill(batch, slice(None), blocks, np.empty(len(points), np.bool_))
        queries = np.hstack([blocks, points.visibility[:, : self._visibility]])
        return LobeInputs(queries, points.wide, points.mirror, points.free)


class LobeModel(nn.Module):
    """Lobes with the asset's own shadows in them.

    A decoder of the profile with 9 outputs a lobe, none of them negative: amplitudes where the
    mirror direction is free and where it is blocked, and an axis plus a shift.
    """

    def __init__(self, columns: int, width: int, hidden_layers: int) -> None:
        """columns: K of the queries. width: of the hidden layers."""
        super().__init__()
        layers: list[nn.Module] = []
        for _ in range(hidden_layers):
            layers += [nn.Linear(columns, width), nn.ReLU()]
            columns = width
        last = nn.Linear(columns, 9 * LOBES)
        last.weight.data *= 0.1
        of_lobe = torch.full((9,), math.log1p(_FURNACE / LOBES / _UNIT))
        of_lobe[6:] = math.log1p(SHIFT / _UNIT)
        last.bias.data = of_lobe.repeat(LOBES)
        self.decoder = nn.Sequential(*layers, last)

    @property
    def multiply_adds(self) -> int:
        """Of a query."""
        return sum(m.weight.numel() for m in self.decoder if isinstance(m, nn.Linear))

    def forward(self, inputs: LobeInputs) -> tuple[Tensor, Tensor]:
        """Amplitudes and axes, (n, LOBES, 3) each."""
        queries, wide, mirror, free = (torch.from_numpy(rows) for rows in inputs)
        y = through(self.decoder, queries).view(-1, LOBES, 3, 3)
        values = _UNIT * torch.expm1(y.clamp(0.0, _TOP))
        free = free[:, None, None]
        amplitude = free * values[:, :, 0] + (1.0 - free) * values[:, :, 1]
        base = [
            kappa * direction[:, None].expand(-1, LOBES // 2, -1)
            for kappa, direction in zip(CONCENTRATIONS, (wide, mirror), strict=True)
        ]
        return amplitude, values[:, :, 2] - SHIFT + torch.cat(base, dim=1)


def densities(axis: Tensor, directions: Tensor) -> Tensor:
    """Of lobes (n, L, 3) along directions (n or 1, 3, D): (n, L, D), 1 / sr.

    A lobe of axis a has the density c(|a|) exp(a.d), with c(k) = k / (4 pi sinh k).
    """
    kappa = axis.norm(dim=2).clamp_min(SMALLEST_KAPPA)
    log_c = torch.log(kappa / (2 * math.pi)) - torch.log1p(-torch.exp(-2 * kappa)) - kappa
    along = directions.expand(len(axis), -1, -1)
    return torch.exp(torch.baddbmm(log_c[..., None], axis, along))
