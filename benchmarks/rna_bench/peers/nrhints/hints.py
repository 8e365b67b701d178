"""The hints of NRHints: how visible a point's light is, and highlights of four roughnesses."""

import math
from collections.abc import Callable

import torch
from torch import Tensor
from torch.nn.functional import normalize

from rna_bench.peers.neus import (
    Distance,
    importance_samples,
    lengths_of,
    opacities,
    points_on,
    transmittances,
)

ROUGHNESSES = (0.02, 0.05, 0.13, 0.34)
_OFFSET = 1e-2  # share of the way from the light that is left out before the point
_F0 = 0.04

Field = Callable[[Tensor], tuple[Tensor, Tensor]]
"""Points (k, 3) -> signed distances (k,) and their gradients (k, 3)."""


@torch.no_grad()
def visibilities(
    lights: Tensor,
    points: Tensor,
    distance: Distance,
    field: Field,
    sharpness: Tensor,
    anneal: float,
    counts: tuple[int, int],
    jitter: Tensor | None = None,
    near: float | None = None,
) -> Tensor:
    """Transmittance from lights to points, (n, 1): 1 is visible. lights, points: (n, 3).

    counts: uniform and importance samples. jitter: (n, count) in [0, 1), of the uniform ones.
    near: how far before the points the samples begin; None, as published: at the lights.
    """
    uniform, importance = counts
    way = points - lights
    length = way.norm(dim=1, keepdim=True)
    directions = way / length
    start = torch.zeros_like(length) if near is None else (length - near).clamp(min=0.0)
    spread = torch.linspace(0.0, 1.0, uniform, device=lights.device)[None]
    places = start + spread * (length * (1 - _OFFSET) - start)
    if jitter is not None:
        middle = 0.5 * (places[:, 1:] + places[:, :-1])
        upper = torch.cat([middle, places[:, -1:]], dim=1)
        lower = torch.cat([places[:, :1], middle], dim=1)
        places = lower + (upper - lower) * jitter
    places = importance_samples(lights, directions, places, importance, distance)
    lengths = lengths_of(places, (length - start) / uniform)
    middles = points_on(lights, directions, places + 0.5 * lengths)
    there, gradient = field(middles.reshape(-1, 3))
    cosine = (gradient.reshape(middles.shape) * directions[:, None]).sum(dim=2)
    opacity = opacities(there.reshape(places.shape), cosine, lengths, sharpness, anneal)
    return transmittances(opacity)[:, -1:]


def highlights(normals: Tensor, to_viewer: Tensor, to_light: Tensor) -> Tensor:
    """A GGX term for each of `ROUGHNESSES`, (n, 4), of unit vectors (n, 3)."""
    half = normalize(to_light + to_viewer, dim=1)
    n_l, n_v, n_h = ((normals * w).sum(dim=1).clamp(0, 1) for w in (to_light, to_viewer, half))
    h_v = (half * to_viewer).sum(dim=1).clamp(0, 1)
    fresnel = _F0 + (1.0 - _F0) * (1.0 - h_v) ** 5
    terms = []
    for roughness in ROUGHNESSES:
        k = (roughness + 1.0) ** 2 / 8.0
        shadowing = n_v / (n_v * (1.0 - k) + k) * n_l / (n_l * (1.0 - k) + k)
        a = roughness**2
        density = a / (math.pi * (n_h**2 * (a - 1.0) + 1.0) ** 2)
        terms.append(density * shadowing * fresnel / (4.0 * n_v + 1e-3))
    return torch.stack(terms, dim=1)
