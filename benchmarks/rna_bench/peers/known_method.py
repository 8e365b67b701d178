"""A method on known geometry: one point a ray, with its exact normal and visibility."""

from abc import abstractmethod
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn

from rna_bench.peers.known_geometry import KnownGeometry
from rna_bench.peers.learned_method import LearnedMethod, Rays, Targets
from rna_bench.peers.methods import Setting
from rna_bench.peers.views import PeerCamera
from rna_sdk.errors import TrainingError

_SUBPIXELS = 2  # a side, of rendered images
_WHOLE = 0.999  # alpha from which a pixel shows one point


@dataclass(frozen=True)
class Points:
    """k points that rays hit, with the rays' directions and the lights' places; shapes as in
    `known_geometry.Hits`.
    """

    points: Tensor
    normals: Tensor
    tangents: Tensor
    visible: Tensor
    directions: Tensor
    lights: Tensor


class KnownMethod(LearnedMethod):
    """Trains on the pixels that the asset covers whole."""

    def __init__(self, name: str, setting: Setting, model: nn.Module, batch: int, rate: float):
        if setting.geometry is None:
            raise TrainingError(f"{name} needs --package, for the geometry")
        self.geometry: KnownGeometry = setting.geometry
        super().__init__(model, batch, rate, setting.seed, setting.device)

    @abstractmethod
    def shaded(self, at: Points) -> Tensor:
        """Radiance (k, 3) towards the rays' origins."""

    def loss(self, targets: Targets, progress: float) -> Tensor:
        """L1."""
        row, colour = self._of_hits(targets.rays)
        whole = targets.alpha[row] > _WHOLE
        error = (colour - targets.colour[row].clamp(max=1.0)).abs().sum(dim=1)
        return (error * whole).sum() / len(targets.alpha)

    def radiance(self, rays: Rays) -> Tensor:
        """(n, 3)."""
        row, colour = self._of_hits(rays)
        return torch.zeros_like(rays.origins).index_copy(0, row, colour)

    def render(self, camera: PeerCamera, light: np.ndarray) -> np.ndarray:
        """As `Method.render`, with several rays a pixel."""
        width, height = camera.size
        n = _SUBPIXELS
        fine = super().render(replace(camera, size=(n * width, n * height)), light)
        mean: Any = fine.reshape(height, n, width, n, 3).mean(axis=(1, 3))
        return np.asarray(mean, np.float32)

    def _of_hits(self, rays: Rays) -> tuple[Tensor, Tensor]:
        """Rows of the rays that hit, (k,), and their colours, (k, 3)."""
        arrays = (a.cpu().numpy() for a in (rays.origins, rays.directions, rays.lights))
        hits = self.geometry.hits(*arrays)
        result = (hits.row, hits.points, hits.normals, hits.tangents, hits.visible)
        row, x, n, t, visible = (torch.from_numpy(a).to(self.device) for a in result)
        at = Points(x, n, t, visible, rays.directions[row], rays.lights[row])
        return row, self.shaded(at)
