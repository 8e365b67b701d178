"""Emission of an asset: a separate decoder on the planes of the transport."""

from __future__ import annotations

from itertools import pairwise

import torch
from torch import Tensor, nn

from rna_export.training.model.inputs import Points, assemble
from rna_export.training.model.layers import through
from rna_export.training.model.triplane import Triplane
from rna_sdk.package import query_width

INPUTS = {"surface": ("features", "normal", "wo"), "fiber": ("features", "tangent", "h", "wo")}
"""Kind of part -> input blocks of a decoder of emission."""

HIDDEN_LAYERS = 2


class EmissionDecoder(nn.Module):
    """L_e(x, wo), as y = log(x / unit + 1); the planes are those of the transport.

    `unit` is a radiance that is usual, `ceiling` bounds what is answered, as in `NeuralAsset`.
    """

    ceiling: Tensor
    unit: Tensor

    def __init__(self, inputs: tuple[str, ...], channels: int, width: int):
        super().__init__()
        self.inputs = inputs
        sizes = [query_width(inputs, channels)] + [width] * HIDDEN_LAYERS
        layers: list[nn.Module] = []
        for columns_in, columns_out in pairwise(sizes):
            layers += [nn.Linear(columns_in, columns_out), nn.ReLU()]
        self.decoder = nn.Sequential(*layers, nn.Linear(sizes[-1], 3))
        self.register_buffer("ceiling", torch.tensor(100.0))
        self.register_buffer("unit", torch.tensor(1.0))

    def queries(self, triplane: Triplane, at: Points, blur: float | Tensor = 1.0) -> Tensor:
        """The decoder's queries, (k, K)."""
        position = at["position"]
        p = ((position - triplane.low) / (triplane.high - triplane.low)).clamp(0.0, 1.0)
        return assemble(self.inputs, triplane(position, blur), p, at)

    def forward(self, triplane: Triplane, at: Points, blur: float | Tensor = 1.0) -> Tensor:
        """y, (k, 3)."""
        return through(self.decoder, self.queries(triplane, at, blur))

    def radiance(self, y: Tensor) -> Tensor:
        """L_e from y, (k, 3): between 0 and the ceiling."""
        highest = torch.log1p(self.ceiling / self.unit)
        return self.unit * torch.expm1(y.clamp(min=0.0).minimum(highest))
