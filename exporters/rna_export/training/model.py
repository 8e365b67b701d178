"""The neural asset in PyTorch: planes, input blocks, decoder."""

from __future__ import annotations

import torch
from torch import Tensor, nn

from rna_export.training.inputs import assemble
from rna_export.training.presets import ModelConfig
from rna_export.training.triplane import Triplane
from rna_sdk.package import query_width


class NeuralAsset(nn.Module):
    """T(x, wo, wi) as a triplane and an MLP with two RGB outputs (the paper, section 3).

    The decoder's last layer gives y = log(x / unit + 1); `transport` inverts that. `bounds` is
    (2, 3). `unit` is a radiance: 1 in the paper, what is usual on the asset in our presets.
    `ceiling` bounds what it can answer: nothing brighter was seen in training.
    """

    def __init__(self, config: ModelConfig, bounds: Tensor):
        super().__init__()
        self.config = config
        self.triplane = Triplane(config.resolution, config.channels, bounds[0], bounds[1])
        width, layers = config.width, []
        columns = query_width(config.inputs, config.channels)
        for _ in range(config.hidden_layers):
            layers += [nn.Linear(columns, width), nn.ReLU()]
            columns = width
        self.decoder = nn.Sequential(*layers, nn.Linear(columns, 6))
        self.register_buffer("ceiling", torch.tensor(100.0))
        self.register_buffer("unit", torch.tensor(1.0))

    def forward(
        self, position: Tensor, n: Tensor, wo: Tensor, wi: Tensor, blur: float = 1.0
    ) -> Tensor:
        """y = log(x / unit + 1), (k, 2, 3): visible, shadowed. Inputs (k, 3) each."""
        return self.decoder(self.queries(position, n, wo, wi, blur)).view(-1, 2, 3)

    def queries(
        self, position: Tensor, n: Tensor, wo: Tensor, wi: Tensor, blur: float = 1.0
    ) -> Tensor:
        """What the decoder is asked, (k, K)."""
        grid = self.triplane
        features = grid(position, blur)
        p = ((position - grid.low) / (grid.high - grid.low)).clamp(0.0, 1.0)
        return assemble(self.config.inputs, features, 2.0 * p - 1.0, n, wo, wi)

    def transport(self, y: Tensor) -> Tensor:
        """Radiance from y: the inverse of log(x / unit + 1), between 0 and the ceiling."""
        highest = torch.log1p(self.ceiling / self.unit)
        return self.unit * torch.expm1(y.clamp(min=0.0).minimum(highest))
