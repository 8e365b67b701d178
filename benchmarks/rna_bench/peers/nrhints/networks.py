"""The two networks of NRHints, with sizes and initialisation as its authors published them.

Zeng et al., "Relighting Neural Radiance Fields with Shadow and Highlight Hints", 2023,
github.com/iamNCJ/NRHints.
"""

import math
from itertools import pairwise

import torch
from torch import Tensor, nn
from torch.nn.utils.parametrizations import weight_norm

from rna_bench.frontier.trials.feature_network import (
    ENCODED_DIRECTIONS,
    SKIP,
    FeatureNetwork,
    octaves,
)

WIDTH, FEATURES = 256, 256
RADIUS = 0.5
"""Radius of the sphere whose signed distance the untrained network returns."""

COLOUR_INPUTS = 361

_SCALE = 3.0  # of positions before their encoding, and of the distance after it
_OCTAVES = 4
_COLOUR_LAYERS = 4


class DistanceNetwork(FeatureNetwork):
    """Signed distance and features of a point in the unit sphere.

    The trunk is the one in `rna-bench frontier`'s `nrhints`; here it starts as a sphere (Atzmon
    and Lipman 2020), and a distance stands before its features.
    """

    def __init__(self) -> None:
        one = torch.ones(3)
        super().__init__(WIDTH, 1 + FEATURES + ENCODED_DIRECTIONS, -one, one)
        *hidden, last = (layer for layer in self.layers if isinstance(layer, nn.Linear))
        waves = hidden[0].in_features - 3
        for k, layer in enumerate(hidden):
            weight = torch.randn(layer.weight.shape) * math.sqrt(2.0 / layer.out_features)
            if k in (0, SKIP):  # only the position itself counts
                weight[:, -waves:] = 0.0
            _set(layer, weight, 0.0)
        mean = math.sqrt(math.pi / (FEATURES + 1))
        _set(last, mean + 1e-4 * torch.randn(last.weight.shape), -RADIUS * _SCALE)

    def both(self, points: Tensor) -> tuple[Tensor, Tensor]:
        """Distances (n,) and features (n, 256) of points (n, 3)."""
        result = self.of_position(points)
        return result[:, 0] / _SCALE, result[:, 1:]

    def distance(self, points: Tensor) -> Tensor:
        """(n,) of points (n, 3)."""
        return self.both(points)[0]

    def with_gradient(self, points: Tensor, create_graph: bool) -> tuple[Tensor, Tensor, Tensor]:
        """Distances (n,), gradients (n, 3) and features (n, 256).

        create_graph: whether the gradient itself is differentiated later; without, nothing is.
        """
        with torch.enable_grad():
            points = points.detach().requires_grad_()
            distance, features = self.both(points)
            (gradient,) = torch.autograd.grad(distance.sum(), points, create_graph=create_graph)
        if create_graph:
            return distance, gradient, features
        return distance.detach(), gradient, features.detach()


class ColourNetwork(nn.Module):
    """Radiance in [0, 1] of points with their hints."""

    def __init__(self) -> None:
        super().__init__()
        widths = [COLOUR_INPUTS, *[WIDTH] * _COLOUR_LAYERS, 3]
        sizes = pairwise(widths)
        self.layers = nn.ModuleList(weight_norm(nn.Linear(*size)) for size in sizes)

    def forward(
        self,
        points: Tensor,
        directions: Tensor,
        normals: Tensor,
        lights: Tensor,
        features: Tensor,
        visibility: Tensor,
        highlights: Tensor,
    ) -> Tensor:
        """(n, 3). points, directions of rays, unit normals, places of lights: (n, 3); features:
        (n, 256); visibility: (n, 1); highlights: (n, 4).
        """
        hints = _encoded(visibility), _encoded(highlights)
        inputs = points, _encoded(directions), normals, _encoded(lights), features, *hints
        x = torch.cat(inputs, dim=1)
        *hidden, last = self.layers
        for layer in hidden:
            x = torch.relu(layer(x))
        return torch.sigmoid(last(x))


def _encoded(x: Tensor) -> Tensor:
    return torch.cat([x, octaves(x, _OCTAVES)], dim=1)


def _set(layer: nn.Linear, weight: Tensor, bias: float) -> None:
    """Weights of a layer with weight normalisation, as if it had been applied after them."""
    with torch.no_grad():
        layer.weight = weight
        layer.bias.fill_(bias)
