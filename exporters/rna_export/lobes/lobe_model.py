"""The decoder of a part's lobes in PyTorch, and the meaning of its outputs."""

import math

import torch
from torch import Tensor, nn

from rna_export.lobes.lobe_loss import SMALLEST_KAPPA
from rna_export.lobes.lobe_queries import LobeInputs, QueryRows
from rna_export.lobes.view_points import LobesAt, Rows, ViewPoints
from rna_export.training.model.layers import new_layers, through
from rna_sdk.runtime.kernels.lobe_kernels import NARROW, SHIFT, WIDE

LOBES = 8
WIDTH, HIDDEN_LAYERS = 88, 2  # of the decoder

_UNIT = 0.1
_CEILING = 300.0
_FURNACE = 0.5  # of all amplitudes together, at first


class LobeModel(nn.Module):
    """Lobes with the asset's own shadows in them.

    A decoder of the profile with 9 outputs a lobe, none of them negative: amplitudes where the
    mirror direction is free and where it is blocked, and an axis plus a shift.
    """

    ceiling: Tensor
    unit: Tensor
    output = "environment"
    colour_sums = tuple(tuple(row) for row in torch.eye(3 * LOBES, dtype=torch.int).tolist())

    def __init__(self, columns: int, width: int = WIDTH, hidden_layers: int = HIDDEN_LAYERS):
        """columns: K of the queries. width: of the hidden layers."""
        super().__init__()
        self.decoder = new_layers(columns, width, hidden_layers, 9 * LOBES)
        last = self.decoder[-1]
        assert isinstance(last, nn.Linear)
        last.weight.data *= 0.1
        of_lobe = torch.full((9,), math.log1p(_FURNACE / LOBES / _UNIT))
        of_lobe[6:] = math.log1p(SHIFT / _UNIT)
        last.bias.data = of_lobe.repeat(LOBES)
        self.register_buffer("ceiling", torch.tensor(_CEILING))
        self.register_buffer("unit", torch.tensor(_UNIT))

    @property
    def multiply_adds(self) -> int:
        """Multiply-adds of a query."""
        return sum(m.weight.numel() for m in self.decoder if isinstance(m, nn.Linear))

    def forward(self, inputs: LobeInputs) -> tuple[Tensor, Tensor]:
        """Amplitudes and axes, (n, LOBES, 3) each."""
        queries, wide, mirror, free = (torch.from_numpy(rows) for rows in inputs)
        values = self.transport(through(self.decoder, queries)).view(-1, LOBES, 3, 3)
        free = free[:, None, None]
        amplitude = free * values[:, :, 0] + (1.0 - free) * values[:, :, 1]
        base = [
            kappa * direction[:, None].expand(-1, LOBES // 2, -1)
            for kappa, direction in ((WIDE, wide), (NARROW, mirror))
        ]
        return amplitude, values[:, :, 2] - SHIFT + torch.cat(base, dim=1)

    def answering(self, queries: QueryRows) -> LobesAt:
        """Its lobes at points of the part that the queries are for."""

        def lobes(points: ViewPoints) -> tuple[Rows, Rows]:
            with torch.no_grad():
                amplitude, axis = self(queries.of(points))
            return amplitude.numpy(), axis.numpy()

        return lobes

    def transport(self, y: Tensor) -> Tensor:
        """The decoder's outputs from y = log(x / unit + 1): between 0 and the ceiling."""
        highest = torch.log1p(self.ceiling / self.unit)
        return self.unit * torch.expm1(y.clamp(min=0.0).minimum(highest))


def densities(axis: Tensor, directions: Tensor) -> Tensor:
    """Densities (n, L, D), 1 / sr, of lobes (n, L, 3) along directions (n or 1, 3, D).

    A lobe of axis a has the density c(|a|) exp(a.d), with c(k) = k / (4 pi sinh k).
    """
    kappa = axis.norm(dim=2).clamp_min(SMALLEST_KAPPA)
    log_c = torch.log(kappa / (2 * math.pi)) - torch.log1p(-torch.exp(-2 * kappa)) - kappa
    along = directions.expand(len(axis), -1, -1)
    return torch.exp(torch.baddbmm(log_c[..., None], axis, along))
