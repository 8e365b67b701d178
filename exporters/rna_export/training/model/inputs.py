"""Decoder input blocks: on the CPU the runtime's compiled ones, else in PyTorch; spec 6.3."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import torch
from torch import Tensor

from rna_export.training.model.input_kernels import Inputs
from rna_sdk.runtime.kernels.fiber_blocks import ETA
from rna_sdk.runtime.kernels.surface_blocks import BEND

_OF_FIBERS = {"tangent", "h", "fiber_angles", "fiber_lobes"}

Points = dict[str, Tensor]
"""Queries by name: position, wo, wi and normal or tangent, (k, 3) each; for fibers also h, (k,)."""


def dot(a: Tensor, b: Tensor) -> Tensor:
    """Dot products of rows, (k, 1)."""
    return (a * b).sum(dim=1, keepdim=True)


def in_box(position: Tensor, low: Tensor, high: Tensor) -> Tensor:
    """Positions (k, 3) in the box of the planes, from 0 to 1."""
    return ((position - low) / (high - low)).clamp(0.0, 1.0)


def assemble(blocks: tuple[str, ...], features: Tensor, p: Tensor, at: Points) -> Tensor:
    """The decoder's input (k, K). `features`: (k, C). `p`: position in the bounds, 0 to 1."""
    if features.device.type != "cpu":
        return assembled(blocks, features, p, at)
    if _OF_FIBERS.isdisjoint(blocks):
        axis, h = at["normal"], None
    else:
        axis, h = at["tangent"], at["h"]
    columns = blocks, features, p, axis, h, at["wo"], at.get("wi")
    queries: Tensor = Inputs.apply(*columns)  # type: ignore[no-untyped-call]
    return queries


def assembled(blocks: tuple[str, ...], features: Tensor, p: Tensor, at: Points) -> Tensor:
    """`assemble` in plain PyTorch: for GPUs, and the kernels' twin."""
    frame = cache(lambda: fiber_frame(at["tangent"], at["wo"], at["wi"]))
    m = cache(lambda: halfway(at["wo"], at["wi"]))
    columns = {
        "features": lambda: features,
        "position": lambda: 2.0 * p - 1.0,
        "normal": lambda: at["normal"],
        "tangent": lambda: at["tangent"],
        "h": lambda: at["h"].clamp(-1.0, 1.0)[:, None],
        "wo": lambda: at["wo"],
        "wi": lambda: at["wi"],
        "half_vector": lambda: half_vector(at["normal"], at["wo"], at["wi"], m()),
        "highlight": lambda: highlight(at["normal"], m()),
        "learned_normal": lambda: learned_normal(at["normal"], features, m()),
        "fiber_angles": lambda: fiber_angles(frame()),
        "fiber_lobes": lambda: fiber_lobes(at["h"], frame()),
    }
    return torch.cat([columns[b]() for b in blocks], dim=1)


def half_vector(n: Tensor, wo: Tensor, wi: Tensor, m: Tensor) -> Tensor:
    """n.m, log2(1 - n.m + 1e-4) / 6, n.wi, n.wo, wi.m: (k, 5)."""
    return torch.cat([_along(n, m), dot(n, wi), dot(n, wo), dot(wi, m)], dim=1)


def _along(n: Tensor, m: Tensor) -> Tensor:
    """n.m and log2(1 - n.m + 1e-4) / 6, (k, 2)."""
    cosine = dot(n, m)
    sharp = torch.log2(1.0 - cosine.clamp(max=1.0) + 1e-4) / 6.0
    return torch.cat([cosine, sharp], dim=1)


def learned_normal(n: Tensor, features: Tensor, m: Tensor) -> Tensor:
    """q.m and log2(1 - q.m + 1e-4) / 6, (k, 2), with q along n + BEND (f0, f1, f2)."""
    bend = torch.nn.functional.pad(features[:, :3], (0, max(0, 3 - features.shape[1])))
    q = n + BEND * bend
    length = q.norm(dim=1, keepdim=True)
    q = torch.where(length < 1e-6, n, q / length.clamp(min=1e-6))
    return _along(q, m)


def highlight(n: Tensor, m: Tensor) -> Tensor:
    """log2(|n x m|^2 + 1e-8) / 12, (k, 1): a sine keeps the digits that 1 - n.m loses."""
    aside = torch.cross(n, m, dim=1)
    opposite = (m == 0).all(dim=1, keepdim=True)
    return torch.log2(torch.where(opposite, 1.0, dot(aside, aside)) + 1e-8) / 12.0


def halfway(wo: Tensor, wi: Tensor) -> Tensor:
    """m, unit, (k, 3); 0 where directions are opposite, whose m is across n, q and wi."""
    total = wi + wo
    length = total.norm(dim=1, keepdim=True)
    return torch.where(length < 1e-6, 0.0, total / length.clamp(min=1e-6))


class FiberFrame(NamedTuple):
    """Directions about a fiber, (k, 1) each."""

    s_o: Tensor  # sines of the inclinations
    s_i: Tensor
    c_o: Tensor
    cos_phi: Tensor  # phi: azimuth of wi about the tangent, counted from wo's
    sin_phi: Tensor


def fiber_frame(t: Tensor, wo: Tensor, wi: Tensor) -> FiberFrame:
    """The frame of tangents and directions, (k, 3) each; phi is 0 where there is no azimuth."""
    s_o, s_i = dot(t, wo).clamp(-1.0, 1.0), dot(t, wi).clamp(-1.0, 1.0)
    c_o, c_i = (torch.sqrt((1.0 - s**2).clamp(min=0.0)) for s in (s_o, s_i))
    d = c_o * c_i
    no_azimuth, safe = d < 1e-6, d.clamp(min=1e-6)
    cos_phi = torch.where(no_azimuth, 1.0, (dot(wo, wi) - s_o * s_i) / safe).clamp(-1.0, 1.0)
    sin_phi = torch.where(no_azimuth, 0.0, dot(t, torch.cross(wo, wi, dim=1)) / safe)
    return FiberFrame(s_o, s_i, c_o, cos_phi, sin_phi.clamp(-1.0, 1.0))


def fiber_angles(frame: FiberFrame) -> Tensor:
    """s_i, s_o, s_i + s_o, log2((s_i + s_o)^2 + 1e-3) / 6, cos phi, sin phi: (k, 6)."""
    total = frame.s_i + frame.s_o
    sharp = torch.log2(total**2 + 1e-3) / 6.0
    return torch.cat([frame.s_i, frame.s_o, total, sharp, frame.cos_phi, frame.sin_phi], dim=1)


def fiber_lobes(h: Tensor, frame: FiberFrame) -> Tensor:
    """cos(phi - Phi_p) for p = 0, 1, 2: how near wi is to the lobes R, TT and TRT, (k, 3).

    Phi_p = 2 g_o - 2 p g_t - p pi is where p passes through a smooth cylinder lead: Marschner et
    al., "Light Scattering from Human Hair Fibers", 2003.
    """
    s_o, _, c_o, cos_phi, sin_phi = frame
    sin_o = h.clamp(-1.0, 1.0)[:, None]
    sin_t = sin_o * c_o / torch.sqrt(ETA**2 - s_o**2)
    step = _doubled(torch.sqrt((1.0 - sin_t**2).clamp(min=0.0)), sin_t)  # 2 g_t
    lobe = _doubled(torch.sqrt((1.0 - sin_o**2).clamp(min=0.0)), sin_o)  # 2 g_o
    columns = []
    for _ in range(3):
        columns.append(cos_phi * lobe[0] + sin_phi * lobe[1])
        cos, sin = lobe
        # Minus 2 g_t and minus pi: the latter is a change of sign.
        lobe = -(cos * step[0] + sin * step[1]), -(sin * step[0] - cos * step[1])
    return torch.cat(columns, dim=1)


def _doubled(cos: Tensor, sin: Tensor) -> tuple[Tensor, Tensor]:
    """Cosine and sine of twice the angle."""
    return cos**2 - sin**2, 2.0 * sin * cos
