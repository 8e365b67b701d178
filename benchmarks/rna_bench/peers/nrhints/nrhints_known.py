"""NRHints' networks on known geometry: one point a ray, with its exact normal and visibility.

The paper's first variant keeps its own data and inputs: that is the model `nrhints` of
`rna-bench frontier`, with the same trunk. This one learns from the same images as the other peers,
and gets the hints of NRHints.
"""

import torch
from torch import Tensor, nn
from torch.nn.functional import normalize

from rna_bench.peers.known_method import KnownMethod, Points
from rna_bench.peers.methods import Setting
from rna_bench.peers.nrhints.hints import highlights
from rna_bench.peers.nrhints.networks import ColourNetwork, DistanceNetwork
from rna_bench.peers.nrhints.nrhints import BATCH, RATE, scheduled


class _Model(nn.Module):
    def __init__(self) -> None:
        super().__init__()
        self.trunk, self.colour = DistanceNetwork(), ColourNetwork()


class KnownNRHints(KnownMethod):
    """See the module; its distance is not used."""

    model: _Model

    def __init__(self, setting: Setting):
        torch.manual_seed(setting.seed)
        super().__init__("nrhints-known", setting, _Model(), BATCH, RATE)

    def rate_factor(self, progress: float, steps: int) -> float:
        """As NRHints'."""
        return scheduled(progress, steps)

    def shaded(self, at: Points) -> Tensor:
        """As `KnownMethod.shaded`."""
        to_light = normalize(at.lights - at.points, dim=1)
        shine = highlights(at.normals, -at.directions, to_light)
        _, features = self.model.trunk.both(at.points)
        colour: Tensor = self.model.colour(
            at.points, at.directions, at.normals, at.lights, features, at.visible[:, None], shine
        )
        return colour
