"""Volume rendering of a signed distance, after NeuS (Wang et al. 2021) as NRHints uses it.

Rays are rows: places (n, m) along them, distances there (n, m), lengths of their sections (n, m).
"""

from collections.abc import Callable

import torch
from torch import Tensor

Distance = Callable[[Tensor], Tensor]
"""Points (k, 3) -> signed distances (k,)."""

STEPS = 4
"""In which importance samples are added."""

_FIRST_SHARPNESS = 64.0  # of the importance samples' first step; doubled in each
_EPSILON = 1e-5
_STEEPEST = 1e3


def opacities(
    distance: Tensor, cosine: Tensor, lengths: Tensor, sharpness: Tensor, anneal: float
) -> Tensor:
    """Opacity of sections by the distance in their middle, in [0, 1].

    cosine: of the ray and the gradient. anneal: 0 lets all orientations count, 1 only those that
    face the ray.
    """
    facing = torch.relu(-cosine)
    slope = facing if anneal >= 1.0 else _annealed(cosine, facing, anneal)
    half = 0.5 * slope * lengths
    before = torch.sigmoid((distance + half) * sharpness)
    after = torch.sigmoid((distance - half) * sharpness)
    return ((before - after + _EPSILON) / (before + _EPSILON)).clamp(0.0, 1.0)


def _annealed(cosine: Tensor, facing: Tensor, anneal: float) -> Tensor:
    return torch.relu(0.5 - 0.5 * cosine) * (1.0 - anneal) + facing * anneal


def transmittances(opacity: Tensor) -> Tensor:
    """Before each section, (n, m)."""
    through = torch.cumprod(1.0 - opacity + 1e-7, dim=1)
    return torch.cat([torch.ones_like(through[:, :1]), through[:, :-1]], dim=1)


def lengths_of(places: Tensor, last: Tensor) -> Tensor:
    """Lengths of the sections that begin at sorted places; last: (n, 1), length of the last one."""
    return torch.cat([places.diff(dim=1), last.expand(len(places), 1)], dim=1)


def points_on(origins: Tensor, directions: Tensor, places: Tensor) -> Tensor:
    """(n, m, 3)."""
    return origins[:, None] + directions[:, None] * places[..., None]


@torch.no_grad()
def importance_samples(
    origins: Tensor, directions: Tensor, places: Tensor, count: int, distance: Distance
) -> Tensor:
    """The places with `count` more where the surface may be, sorted: (n, m + count)."""
    there = _distances(origins, directions, places, distance)
    for step in range(STEPS):
        sharpness = _FIRST_SHARPNESS * 2**step
        weights = _coarse_weights(origins, directions, places, there, sharpness)
        added = inverse_cdf(places, weights, count // STEPS)
        if step + 1 < STEPS:
            more = _distances(origins, directions, added, distance)
            there = torch.cat([there, more], dim=1)
        places, order = torch.cat([places, added], dim=1).sort(dim=1)
        if step + 1 < STEPS:
            there = there.gather(1, order)
    return places


def _distances(origins: Tensor, directions: Tensor, places: Tensor, distance: Distance) -> Tensor:
    points = points_on(origins, directions, places)
    return distance(points.reshape(-1, 3)).reshape(places.shape)


def _coarse_weights(
    origins: Tensor, directions: Tensor, places: Tensor, there: Tensor, sharpness: float
) -> Tensor:
    """Weights (n, m - 1) of the sections, by the slopes in each section and the one before."""
    inside = points_on(origins, directions, places).norm(dim=2) < 1.0
    lengths = places.diff(dim=1)
    slope = there.diff(dim=1) / (lengths + _EPSILON)
    before = torch.cat([torch.zeros_like(slope[:, :1]), slope[:, :-1]], dim=1)
    steepest = torch.minimum(slope, before).clamp(-_STEEPEST, 0.0)
    steepest = steepest * (inside[:, :-1] | inside[:, 1:])
    middle = 0.5 * (there[:, :-1] + there[:, 1:])
    known = torch.tensor(sharpness, device=there.device)
    opacity = opacities(middle, steepest, lengths, known, 1.0)
    return opacity * transmittances(opacity)


def inverse_cdf(edges: Tensor, weights: Tensor, count: int) -> Tensor:
    """`count` places of a piecewise constant density, at even steps of its integral: (n, count).

    edges: (n, m) sorted. weights: (n, m - 1).
    """
    density = weights + _EPSILON
    cdf = torch.cumsum(density / density.sum(dim=1, keepdim=True), dim=1)
    cdf = torch.cat([torch.zeros_like(cdf[:, :1]), cdf], dim=1)
    u = torch.linspace(0.0, 1.0, count, device=edges.device).expand(len(edges), count)
    above = torch.searchsorted(cdf, u.contiguous(), right=True).clamp(1, cdf.shape[1] - 1)
    low, high = cdf.gather(1, above - 1), cdf.gather(1, above)
    first, last = edges.gather(1, above - 1), edges.gather(1, above)
    width = high - low
    share = (u - low) / torch.where(width < _EPSILON, torch.ones_like(width), width)
    return first + share * (last - first)
