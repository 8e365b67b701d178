"""Shadowed light of an asset: a small decoder on the planes of the transport.

Light that comes through or around an asset has no highlight of the surface that it leaves. A
decoder that gives both cases puts a rest of the highlight into this one: a ghost that is seen
from behind. So this one is not given what tells highlights (docs/decisions/model.md).
"""

import torch
from torch import Tensor, nn

from rna_export.training.model.layers import new_layers, through
from rna_sdk.package import query_width

HIDDEN_LAYERS = 3

RELATIVE_UNIT = 0.1
"""The unit of its loss over the unit of visible light's loss: shadows are dark."""


class ShadowDecoder(nn.Module):
    """y = log(x / unit + 1) of shadowed light, with factors of the base colour behind it or not."""

    unit: Tensor

    def __init__(self, inputs: tuple[str, ...], channels: int, width: int, outputs: int):
        super().__init__()
        self.inputs = inputs
        columns = query_width(inputs, channels)
        self.decoder = new_layers(columns, width, HIDDEN_LAYERS, outputs)
        self.register_buffer("unit", torch.tensor(RELATIVE_UNIT))

    def forward(self, queries: Tensor) -> Tensor:
        """y (k, outputs) of queries (k, K)."""
        return through(self.decoder, queries)
