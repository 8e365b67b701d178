"""NRHints' networks on known geometry: one point a ray, with its exact normal and visibility.

The paper's first variant keeps its own data and inputs: that is the model `nrhints` of
`rna-bench frontier`, with the same trunk. This one learns from the same images as the other peers,
and gets the hints of NRHints.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn.functional import normalize

from rna_bench.peers.known_geometry import KnownGeometry
from rna_bench.peers.learned_method import LearnedMethod, Rays, Targets
from rna_bench.peers.methods import Setting
from rna_bench.peers.nrhints import BATCH, RATE, scheduled
from rna_bench.peers.nrhints_hints import highlights
from rna_bench.peers.nrhints_networks import ColourNetwork, DistanceNetwork
from rna_bench.peers.views import PeerCamera
from rna_sdk.errors import TrainingError

_SUBPIXELS = 2  # a side, of rendered images
_WHOLE = 0.999  # alpha from which a pixel shows one point


class _Model(nn.Module):
    def __init__(self) -> None:
        super().__init__()
        self.trunk, self.colour = DistanceNetwork(), ColourNetwork()


class KnownNRHints(LearnedMethod):
    """See the module; its distance is not used."""

    model: _Model

    def __init__(self, setting: Setting):
        if setting.geometry is None:
            raise TrainingError("nrhints-known needs --package, for the geometry")
        torch.manual_seed(setting.seed)
        self.geometry: KnownGeometry = setting.geometry
        super().__init__(_Model(), BATCH, RATE, setting.seed, setting.device)

    def rate_factor(self, progress: float) -> float:
        """As NRHints'."""
        return scheduled(progress)

    def loss(self, targets: Targets, progress: float) -> Tensor:
        """L1 of the pixels that the asset covers whole."""
        row, colour = self._shaded(targets.rays)
        whole = targets.alpha[row] > _WHOLE
        error = (colour - targets.colour[row].clamp(max=1.0)).abs().sum(dim=1)
        return (error * whole).sum() / len(targets.alpha)

    def radiance(self, rays: Rays) -> Tensor:
        """(n, 3)."""
        row, colour = self._shaded(rays)
        return torch.zeros_like(rays.origins).index_copy(0, row, colour)

    def render(self, camera: PeerCamera, light: np.ndarray) -> np.ndarray:
        """As `Method.render`, with several rays a pixel."""
        width, height = camera.size
        n = _SUBPIXELS
        fine = super().render(replace(camera, size=(n * width, n * height)), light)
        mean: Any = fine.reshape(height, n, width, n, 3).mean(axis=(1, 3))
        return np.asarray(mean, np.float32)

    def _shaded(self, rays: Rays) -> tuple[Tensor, Tensor]:
        """Rows of the rays that hit, (k,), and their colours, (k, 3)."""
        arrays = (a.cpu().numpy() for a in (rays.origins, rays.directions, rays.lights))
        hits = self.geometry.hits(*arrays)
        found = (hits.row, hits.points, hits.normals, hits.visible)
        row, points, normals, visible = (torch.from_numpy(a).to(self.device) for a in found)
        directions, lights = rays.directions[row], rays.lights[row]
        shine = highlights(normals, -directions, normalize(lights - points, dim=1))
        _, features = self.model.trunk.both(points)
        inputs = points, directions, normals, lights, features, visible[:, None], shine
        return row, self.model.colour(*inputs)
