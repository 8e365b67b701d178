"""A model with features from NRHints' network instead of planes, the paper's baseline.

Sizes are those that its authors published: Zeng et al., "Relighting Neural Radiance Fields with
Shadow and Highlight Hints", 2023, github.com/iamNCJ/NRHints, `SDFNetConfig` and
`ReflectanceNetConfig`. The decoder of such a model is their reflectance network, 4 layers of 256.
"""

import math
from typing import Any

import torch
from torch import Tensor, nn
from torch.nn.utils.parametrizations import weight_norm

from rna_export.training.model.inputs import Points
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.presets import ModelConfig

_LAYERS = 8
SKIP = 4
"""The layer that has the encoded position beside the layer before."""

_POSITION_OCTAVES, _DIRECTION_OCTAVES = 6, 4
_SCALE = 3.0  # of positions, -1 to 1 in the bounds

ENCODED_DIRECTIONS = 2 * 3 * 2 * _DIRECTION_OCTAVES
"""Channels that are not of the network: encodings of wo and wi."""


class FeatureNetwork(nn.Module):
    """`channels` features: a network's of the position, then encodings of both directions.

    width: of the hidden layers. `low` and `high` are the asset's box.
    """

    low: Tensor
    high: Tensor

    def __init__(self, width: int, channels: int, low: Tensor, high: Tensor):
        super().__init__()
        encoded = 3 + 3 * 2 * _POSITION_OCTAVES
        columns, widths = [encoded, *[width] * _LAYERS], [width] * _LAYERS
        widths[SKIP - 1] -= encoded  # the layer after it has the encoded position beside
        sizes = zip(columns, [*widths, channels - ENCODED_DIRECTIONS], strict=True)
        self.layers = nn.ModuleList(weight_norm(nn.Linear(*size)) for size in sizes)
        self.register_buffer("low", low.float())
        self.register_buffer("high", high.float())

    def hidden_matrices(self) -> list[Tensor]:
        """Directions of the weights of all layers but the last."""
        layers: list[Any] = [*self.layers]
        return [layer.parametrizations.weight.original1 for layer in layers[:-1]]

    def forward(self, position: Tensor, wo: Tensor, wi: Tensor, bfloat16: bool) -> Tensor:
        """Features (n, C) of points and directions, (n, 3) each; bfloat16: as in `of_position`."""
        directions = [octaves(w, _DIRECTION_OCTAVES) for w in (wo, wi)]
        return torch.cat([self.of_position(position, bfloat16), *directions], dim=1)

    def of_position(self, position: Tensor, bfloat16: bool = False) -> Tensor:
        """The network's own outputs of points (n, 3).

        bfloat16: of the layers after the first, whose inputs resolve the position.
        """
        p = 2.0 * (position - self.low) / (self.high - self.low) - 1.0
        encoded = torch.cat([_SCALE * p, octaves(_SCALE * p, _POSITION_OCTAVES)], dim=1)
        first, *layers, last = self.layers
        x = _activated(first(encoded))
        with torch.autocast(x.device.type, torch.bfloat16, enabled=bfloat16):
            for k, layer in enumerate(layers, start=1):
                if k == SKIP:
                    x = torch.cat([x, encoded], dim=1) / math.sqrt(2.0)
                x = _activated(layer(x))
            features: Tensor = last(x).float()
        return features


def _activated(x: Tensor) -> Tensor:
    return nn.functional.softplus(x, beta=100.0)


def octaves(x: Tensor, count: int) -> Tensor:
    """Sines and cosines of x (n, k) times 1, 2, 4, ...: (n, 2 k count)."""
    scaled = x[:, :, None] * 2.0 ** torch.arange(count, device=x.device)
    return torch.cat([torch.sin(scaled), torch.cos(scaled)], dim=2).flatten(1)


class NetworkAsset(NeuralAsset):
    """A neural asset with such features; no package holds it. Its planes are not used."""

    def __init__(self, config: ModelConfig, bounds: Tensor):
        super().__init__(config, bounds)
        self.network = FeatureNetwork(config.width, config.channels, *bounds)

    @property
    def multiply_adds(self) -> int:
        """Multiply-adds of all matrix products of a query."""
        layers: list[Any] = [*self.network.layers]
        return super().multiply_adds + sum(layer.weight.numel() for layer in layers)

    def hidden_matrices(self) -> list[Tensor]:
        """As of `NeuralAsset`, and those of the network."""
        return [*super().hidden_matrices(), *self.network.hidden_matrices()]

    def _features(self, at: Points, blur: float | Tensor) -> Tensor:
        features: Tensor = self.network(at["position"], at["wo"], at["wi"], self._in_bfloat16)
        return features
