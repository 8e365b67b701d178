"""NRHints: a volume-rendered signed distance; inputs of its colours are shadow and highlight.

Zeng et al. 2023. Facts are from the paper and the authors' published code; differences are in
docs/peers.md.
"""

import math
from dataclasses import dataclass

import torch
from torch import Tensor, nn
from torch.nn.functional import normalize

from rna_bench.peers.learned_method import LearnedMethod, Rays, Targets
from rna_bench.peers.methods import Setting
from rna_bench.peers.neus import (
    importance_samples,
    lengths_of,
    opacities,
    points_on,
    transmittances,
)
from rna_bench.peers.nrhints.hints import highlights, visibilities
from rna_bench.peers.nrhints.networks import ColourNetwork, DistanceNetwork

STEPS, BATCH, RATE = 1_000_000, 512, 5e-4
WARM_UP = 5_000
"""Steps in which the rate grows, in short trainings as well: the features of the initial sphere are
all alike, and a rate that is whole after some hundred steps drives the colour network into black.
"""

ANNEALED = 50_000 / STEPS
"""Share of the training in which back faces lose their weight."""

_LEAST_RATE = 0.05
_EIKONAL = 0.1
_SHARPNESS = 0.3  # times 10 in the exponent
_SEEN = 1e-3  # opacity of a ray below which its hints change nothing


@dataclass(frozen=True)
class Sampling:
    """Uniform and importance samples of a ray, and of a ray from the light; pixels a step.

    light_near: how far before the point the latter begin; None: at the light.
    """

    ray: tuple[int, int]
    light: tuple[int, int]
    batch: int
    light_near: float | None = None


FULL = Sampling((64, 64), (64, 64), BATCH)
REDUCED = Sampling((8, 16), (16, 16), 32, light_near=2.0)
"""For a CPU: a step takes a hundredth. Fewer samples from the light shadow lit points: a sphere of
radius 0.7 had a mean visibility of 0.23 with 4 + 4 from the light, 1.00 with these.
"""


@dataclass(frozen=True)
class GeometryLosses:
    """Weights of the losses by rendered alpha and depth: the paper's variant; it names no weights.

    alpha: of the binary cross entropy, as in NeuS with masks. depth: of the L1 of the depth where
    the image has one.
    """

    alpha: float
    depth: float


class _Model(nn.Module):
    def __init__(self) -> None:
        super().__init__()
        self.distance, self.colour = DistanceNetwork(), ColourNetwork()
        self.variance = nn.Parameter(torch.tensor(_SHARPNESS))

    @property
    def sharpness(self) -> Tensor:
        return torch.exp(10.0 * self.variance).clamp(1e-6, 1e6)


@dataclass(frozen=True)
class _Rendered:
    """colour: (n, 3) over black. alpha, depth: (n,). eikonal: the mean squared error of the
    gradient's length in the unit sphere.
    """

    colour: Tensor
    alpha: Tensor
    depth: Tensor
    eikonal: Tensor


class NRHints(LearnedMethod):
    """As published, or with losses by known geometry."""

    chunk = 1024
    model: _Model

    def __init__(self, setting: Setting, geometry: GeometryLosses | None = None):
        torch.manual_seed(setting.seed)
        self.sampling = FULL if setting.full else REDUCED
        self.geometry = geometry
        super().__init__(_Model(), self.sampling.batch, RATE, setting.seed, setting.device)

    def rate_factor(self, progress: float, steps: int) -> float:
        """See `scheduled`."""
        return scheduled(progress, steps)

    def loss(self, targets: Targets, progress: float) -> Tensor:
        """L1 over white, as in the authors' synthetic scenes, and eikonal; then of geometry."""
        result = self._render(targets.rays, min(1.0, progress / ANNEALED), is_training=True)
        wanted = targets.colour.clamp(max=1.0) + (1.0 - targets.alpha[:, None])
        shown = result.colour + (1.0 - result.alpha[:, None])
        loss = (shown - wanted).abs().sum(dim=1).mean() + _EIKONAL * result.eikonal
        if self.geometry is None:
            return loss
        alpha = result.alpha.clamp(1e-3, 1.0 - 1e-3)
        loss = loss + self.geometry.alpha * nn.functional.binary_cross_entropy(alpha, targets.alpha)
        if targets.depth is None:
            return loss
        known = (targets.depth > 0.0) & (targets.alpha > 0.999)
        error = ((result.depth - targets.depth).abs() * known).sum() / known.sum().clamp(min=1)
        return loss + self.geometry.depth * error

    def radiance(self, rays: Rays) -> Tensor:
        """(n, 3)."""
        return self._render(rays, 1.0, is_training=False).colour

    def _render(self, rays: Rays, anneal: float, is_training: bool) -> _Rendered:
        model, (uniform, importance) = self.model, self.sampling.ray
        origins, directions = rays.origins, rays.directions
        middle = -(origins * directions).sum(dim=1, keepdim=True)
        places = middle + torch.linspace(-1.0, 1.0, uniform, device=self.device)
        if is_training:
            places = places + (self._random(len(origins), 1) - 0.5) * 2.0 / uniform
        distance = model.distance.distance
        places = importance_samples(origins, directions, places, importance, distance)
        lengths = lengths_of(places, torch.full_like(middle, 2.0 / uniform))
        middles = places + 0.5 * lengths
        points = points_on(origins, directions, middles)
        n, m, _ = points.shape
        flat = points.reshape(-1, 3)
        there, gradient, features = model.distance.with_gradient(flat, is_training)
        cosine = (gradient.reshape(n, m, 3) * directions[:, None]).sum(dim=2)
        opacity = opacities(there.reshape(n, m), cosine, lengths, model.sharpness, anneal)
        weights = opacity * transmittances(opacity)
        normals = normalize(gradient, dim=1)
        alpha, depth = weights.sum(dim=1), (weights * middles).sum(dim=1)
        visible, shine = self._hints(rays, weights, depth, normals, anneal, is_training)
        colour = model.colour(
            flat,
            _of_samples(directions, m),
            normals,
            _of_samples(rays.lights, m),
            features,
            _of_samples(visible, m),
            _of_samples(shine, m),
        )
        inside = flat.norm(dim=1) < 1.0
        lengths_off = (gradient.norm(dim=1) - 1.0) ** 2 * inside
        return _Rendered(
            (colour.reshape(n, m, 3) * weights[..., None]).sum(dim=1),
            alpha,
            depth,
            lengths_off.sum() / (inside.sum() + 1e-5),
        )

    @torch.no_grad()
    def _hints(
        self,
        rays: Rays,
        weights: Tensor,
        depth: Tensor,
        normals: Tensor,
        anneal: float,
        is_training: bool,
    ) -> tuple[Tensor, Tensor]:
        """Visibility (n, 1) and highlights (n, 4) of the rays' mean points."""
        n, m = weights.shape
        points = rays.origins + rays.directions * depth[:, None]
        seen = weights.sum(dim=1) > _SEEN
        visible = torch.ones(n, 1, device=self.device)
        uniform = self.sampling.light[0]
        if seen.any():
            count = int(seen.sum())
            visible[seen] = visibilities(
                rays.lights[seen],
                points[seen],
                self.model.distance.distance,
                lambda p: self.model.distance.with_gradient(p, create_graph=False)[:2],
                self.model.sharpness,
                anneal,
                self.sampling.light,
                self._random(count, uniform) if is_training else None,
                self.sampling.light_near,
            )
        mean = (normals.reshape(n, m, 3) * weights[..., None]).sum(dim=1)
        to_light = normalize(rays.lights - points, dim=1)
        return visible, highlights(normalize(mean, dim=1), -rays.directions, to_light)

    def _random(self, *shape: int) -> Tensor:
        return torch.rand(shape, generator=self.generator).to(self.device)


def scheduled(progress: float, steps: int) -> float:
    """Factor of the rate: a cosine over the training, times a linear rise over the first steps."""
    cosine = 0.5 * (1.0 + math.cos(math.pi * progress))
    return min(1.0, steps / WARM_UP) * (_LEAST_RATE + (1.0 - _LEAST_RATE) * cosine)


def _of_samples(rows: Tensor, count: int) -> Tensor:
    """Each row repeated for the samples of its ray, (n m, k)."""
    return rows[:, None].expand(-1, count, -1).reshape(len(rows) * count, -1)


def make(setting: Setting) -> NRHints:
    """As published."""
    return NRHints(setting)


def make_with_geometry(setting: Setting) -> NRHints:
    """With a mask's weight as published neighbours have it."""
    return NRHints(setting, GeometryLosses(1.0, 1.0))


def make_with_less_geometry(setting: Setting) -> NRHints:
    """With a tenth of it."""
    return NRHints(setting, GeometryLosses(0.1, 0.1))
