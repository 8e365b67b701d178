"""Emission of an asset: a separate decoder on the planes of the transport."""

import torch
from torch import Tensor, nn

from rna_export.training.model.inputs import Points, assemble, in_box
from rna_export.training.model.layers import new_layers, through
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
        self.decoder = new_layers(query_width(inputs, channels), width, HIDDEN_LAYERS, 3)
        self.register_buffer("ceiling", torch.tensor(100.0))
        self.register_buffer("unit", torch.tensor(1.0))

    def queries(self, triplane: Triplane, at: Points, blur: float | Tensor = 1.0) -> Tensor:
        """The decoder's queries, (k, K)."""
        position = at["position"]
        p = in_box(position, triplane.low, triplane.high)
        return assemble(self.inputs, triplane(position, blur), p, at)

    def forward(self, triplane: Triplane, at: Points, blur: float | Tensor = 1.0) -> Tensor:
        """y, (k, 3)."""
        return through(self.decoder, self.queries(triplane, at, blur))

    def radiance(self, y: Tensor) -> Tensor:
        """L_e from y, (k, 3): between 0 and the ceiling."""
        highest = torch.log1p(self.ceiling / self.unit)
        return self.unit * torch.expm1(y.clamp(min=0.0).minimum(highest))
