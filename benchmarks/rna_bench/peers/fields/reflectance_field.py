"""Neural Reflectance Fields: a volume with a BRDF, trained with the light at the camera.

Bi et al. 2020. There, what passes to the camera and what comes from the light are one, so a ray's
radiance is the sum of tau^2 f L (1 - exp(-density length)): a single bounce. Another light is seen
by a camera of its own, `light_volume.py`. Not published, and NeRF's here (Mildenhall et al. 2020):
squared error of pixels, 4,096 rays a step, 64 even and 128 importance samples, Adam at 5e-4 that
falls to a tenth. One network serves both kinds of samples, where NeRF has two.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from torch import Tensor, nn

from rna_bench.peers.fields.field_network import FieldNetwork
from rna_bench.peers.fields.light_volume import LightVolume, transmittances
from rna_bench.peers.learned_method import LearnedMethod, Rays, Targets
from rna_bench.peers.method import Budget, Training
from rna_bench.peers.methods import Setting
from rna_bench.peers.neus import inverse_cdf, points_on
from rna_bench.peers.views import PeerCamera, Views
from rna_sdk.errors import TrainingError

RATE, LAST_RATE = 5e-4, 0.1
_TOGETHER = 1e-4  # of light and camera


@dataclass(frozen=True)
class Sampling:
    """Even and importance samples of a ray; rays a step; side and sections of a light's volume."""

    ray: tuple[int, int]
    batch: int
    light: tuple[int, int]


FULL = Sampling((64, 128), 4096, (256, 192))
REDUCED = Sampling((16, 24), 64, (64, 64))
"""For a CPU: a step takes a 300th."""


class _Model(nn.Module):
    """The network, and the intensity of the lights that its reflectance goes with, W/sr."""

    intensity: Tensor

    def __init__(self, is_fur: bool):
        super().__init__()
        self.field = FieldNetwork(is_fur)
        self.register_buffer("intensity", torch.tensor(1.0))


class ReflectanceField(LearnedMethod):
    """The method; is_fur: with Kajiya's and Kay's reflectance."""

    chunk = 1024
    model: _Model

    def __init__(self, setting: Setting, is_fur: bool = False):
        torch.manual_seed(setting.seed)
        self.sampling = FULL if setting.full else REDUCED
        self._lit: LightVolume | None = None
        batch = self.sampling.batch
        super().__init__(_Model(is_fur), batch, RATE, setting.seed, setting.device)

    def rate_factor(self, progress: float, steps: int) -> float:
        """Exponential, to `LAST_RATE`."""
        return float(LAST_RATE**progress)

    def train(self, data: Views, budget: Budget, work: Path) -> Training:
        """As `Method.train`; TrainingError where a light is not at its camera."""
        apart = np.linalg.norm(data.lights - data.to_world[:, :3, 3], axis=1)
        if apart.max() > _TOGETHER:
            raise TrainingError(
                f"view {apart.argmax()}: found the light {apart.max():.3g} from the camera, "
                "expected both in one place (collocated views)"
            )
        self.model.intensity.fill_(data.shown_intensity)
        return super().train(data, budget, work)

    def render(self, camera: PeerCamera, light: np.ndarray) -> np.ndarray:
        """As `Method.render`."""
        self._lit = None
        if np.linalg.norm(camera.to_world[:3, 3] - light) > _TOGETHER:
            place = torch.tensor(light, dtype=torch.float32, device=self.device)
            with torch.no_grad():
                self._lit = LightVolume(self._density, place, *self.sampling.light)
        return super().render(camera, light)

    def loss(self, targets: Targets, progress: float) -> Tensor:
        """Squared error of displayed values."""
        result = self._rendered(targets.rays, None, is_training=True)
        return (result - targets.colour.clamp(max=1.0)).square().mean()

    def radiance(self, rays: Rays) -> Tensor:
        """As `LearnedMethod.radiance`, of the light that `render` has made a volume of."""
        return self._rendered(rays, self._lit, is_training=False)

    def _density(self, points: Tensor) -> Tensor:
        density: Tensor = self.model.field(points).density
        return density

    def _rendered(self, rays: Rays, lit: LightVolume | None, is_training: bool) -> Tensor:
        """Radiance (n, 3). lit: of the light; None where it is at the camera."""
        middle = -(rays.origins * rays.directions).sum(dim=1)
        nearest = rays.origins + middle[:, None] * rays.directions
        half = torch.sqrt((1.0 - nearest.square().sum(dim=1)).clamp(min=0.0))
        radiance = torch.zeros_like(rays.origins)
        met = half > 0.0
        if met.any():
            within = Rays(rays.origins[met], rays.directions[met], rays.lights[met])
            edges = self._edges(within, middle[met], half[met], is_training)
            radiance[met] = self._of_sections(within, edges, lit)
        return radiance

    def _edges(self, rays: Rays, middle: Tensor, half: Tensor, is_training: bool) -> Tensor:
        """Ends of sections of rays through the sphere, sorted, (n, m + 1)."""
        even, importance = self.sampling.ray
        places = torch.linspace(-1.0, 1.0, even + 1, device=self.device).expand(len(half), -1)
        if is_training:
            noise = torch.rand(places.shape, generator=self.generator).to(self.device) - 0.5
            places = (places + noise * 2.0 / even).clamp(-1.0, 1.0)
        edges = middle[:, None] + half[:, None] * places
        with torch.no_grad():
            points, lengths = sections(rays, edges)
            density = self._density(points.reshape(-1, 3)).reshape(lengths.shape)
            tau = transmittances(density, lengths)
            more = inverse_cdf(edges, tau[:, :-1] - tau[:, 1:], importance)
        return torch.cat([edges, more], dim=1).sort(dim=1).values

    def _of_sections(self, rays: Rays, edges: Tensor, lit: LightVolume | None) -> Tensor:
        """Radiance (n, 3) of rays cut into sections."""
        points, lengths = sections(rays, edges)
        flat = points.reshape(-1, 3)
        at = self.model.field(flat)
        to_light = rays.lights[:, None] - points
        squared = to_light.square().sum(dim=2, keepdim=True)
        wi = (to_light / torch.sqrt(squared)).reshape(-1, 3)
        wo = -rays.directions[:, None].expand_as(points).reshape(-1, 3)
        arriving = self.model.intensity / squared
        emitted = self.model.field.reflected(at, wo, wi).reshape(points.shape) * arriving
        to_points = None if lit is None else lit.at(flat).reshape(lengths.shape)
        return single_bounce(emitted, at.density.reshape(lengths.shape), lengths, to_points)


def sections(rays: Rays, edges: Tensor) -> tuple[Tensor, Tensor]:
    """Points in the middle of sections (n, m, 3), and their lengths (n, m)."""
    middles = 0.5 * (edges[:, 1:] + edges[:, :-1])
    return points_on(rays.origins, rays.directions, middles), edges.diff(dim=1)


def single_bounce(
    emitted: Tensor, density: Tensor, lengths: Tensor, from_light: Tensor | None
) -> Tensor:
    """Radiance of rays, (n, 3), from unweakened reflected light of their sections, (n, m, 3).

    from_light: transmittance from the light (n, m); None: the ray's own, whose light is at its
    origin.
    """
    tau = transmittances(density, lengths)
    to_camera = tau[:, :-1]
    opacity = 1.0 - torch.exp(-density * lengths)
    weights = to_camera * (to_camera if from_light is None else from_light) * opacity
    return (weights[..., None] * emitted).sum(dim=1)


def make(setting: Setting) -> ReflectanceField:
    """With a GGX reflectance."""
    return ReflectanceField(setting)


def make_of_fur(setting: Setting) -> ReflectanceField:
    """With the reflectance of fur."""
    return ReflectanceField(setting, is_fur=True)
