"""The decoder of an asset's lobes in PyTorch, on the planes of a tier of its package."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn

from rna_bench.lobes.lobe_kernels import answer, difference, gradients
from rna_bench.lobes.spherical_harmonics import COUNT
from rna_export.training.model.inputs import assemble
from rna_export.training.model.layers import through
from rna_export.training.model.triplane import Triplane
from rna_sdk.package import Package, float_planes, query_width, read_profile_decoder

LOBES = 8
CONCENTRATIONS = (2.0, 10.0)
"""kappa of a lobe that the decoder leaves as it is: of the first half of them, and of the rest."""

_UNIT = 0.1
_SHIFT = 8.0  # of axes, since a decoder of the profile gives nothing negative
_TOP = 8.0  # of logarithms
_FURNACE = 0.5  # of all amplitudes together, at first
_TRAINED_ON = ("lights", "directions", "transport", "weights")
_EPSILON = 0.1  # of the relative error; radiance under a light of radiance 1


class LobeModel(nn.Module):
    """Lobes with the asset's own shadows in them.

    A decoder of the profile with 9 outputs a lobe, none of them negative: amplitudes where the
    direction `about[1]` is free and where it is blocked, and an axis less a shift. It is asked with
    the input blocks of transport, wi being that direction, and, behind them, the harmonics of the
    visibility. Planes are those of transport and stay as they are; hidden layers begin as those of
    transport where they have the same sizes.
    """

    def __init__(self, package: Package, tier: str, width: int, hidden_layers: int):
        super().__init__()
        part = package.tier(tier).parts[0]
        decoder, planes = read_profile_decoder(package.decoder(tier), tier), package.planes(tier)
        self._inputs, self.kind = part.inputs, package.manifest.parts[0].kind
        bounds = torch.from_numpy(package.manifest.parts[0].bounds.corners())
        self._triplane = Triplane(part.resolution, part.channels, *bounds)
        self._triplane.planes.data = torch.from_numpy(np.array(float_planes(planes)))
        self._triplane.planes.requires_grad_(False)
        columns = query_width(part.inputs, part.channels) + COUNT
        layers: list[nn.Module] = []
        for _ in range(hidden_layers):
            layers += [nn.Linear(columns, width), nn.ReLU()]
            columns = width
        last = nn.Linear(columns, 9 * LOBES)
        last.weight.data *= 0.1
        of_lobe = torch.full((9,), math.log1p(_FURNACE / LOBES / _UNIT))
        of_lobe[6:] = math.log1p(_SHIFT / _UNIT)
        last.bias.data = of_lobe.repeat(LOBES)
        self.decoder = nn.Sequential(*layers, last)
        of_transport = [] if decoder.is_int8 else decoder.layers[:-1]
        if [len(layer.bias) for layer in of_transport] == [width] * hidden_layers:
            self._begin_as([(layer.weight, layer.bias) for layer in of_transport])

    def _begin_as(self, layers: list[tuple[Any, Any]]) -> None:
        hidden = [layer for layer in self.decoder if isinstance(layer, nn.Linear)][:-1]
        for own, (weight, bias) in zip(hidden, layers, strict=True):
            own.weight.data[:, : len(weight)] = torch.from_numpy(np.array(weight.T))
            own.bias.data = torch.from_numpy(np.array(bias))

    @property
    def multiply_adds(self) -> int:
        """Of a query."""
        return sum(m.weight.numel() for m in self.decoder if isinstance(m, nn.Linear))

    def forward(self, rows: dict[str, Tensor]) -> tuple[Tensor, Tensor]:
        """Amplitudes and axes, (n, L, 3) each. rows: of `ViewPoints.rows`."""
        grid, position = self._triplane, rows["position"]
        at = {"position": position, "wo": rows["wo"], "wi": rows["asked"], "h": rows["h"]}
        at["normal" if self.kind == "surface" else "tangent"] = rows["axis"]
        p = ((position - grid.low) / (grid.high - grid.low)).clamp(0.0, 1.0)
        blocks = assemble(self._inputs, grid(position), p, at)
        y = through(self.decoder, torch.cat([blocks, rows["visibility"]], dim=1))
        values = _UNIT * torch.expm1(y.view(-1, LOBES, 3, 3).clamp(0.0, _TOP))
        free = rows["free"][:, None, None]
        amplitude = free * values[:, :, 0] + (1.0 - free) * values[:, :, 1]
        about = [
            k * rows[name][:, None].expand(-1, LOBES // 2, -1)
            for k, name in zip(CONCENTRATIONS, ("untouched", "asked"), strict=True)
        ]
        return amplitude, values[:, :, 2] - _SHIFT + torch.cat(about, dim=1)


class LightLoss(torch.autograd.Function):
    """Mean squared relative error of lobes under lights."""

    @staticmethod
    def forward(ctx: Any, amplitude: Tensor, axis: Tensor, rows: dict[str, Tensor]) -> Tensor:
        """rows: lights (n, K, 3), their axes; and what `difference` takes."""
        a, x = amplitude.detach().contiguous().numpy(), axis.detach().contiguous().numpy()
        lights, d, transport, weights = (rows[name].numpy() for name in _TRAINED_ON)
        answers, differences = np.empty_like(lights), np.empty_like(lights)
        shares = np.empty((*lights.shape[:2], x.shape[1], 4), np.float32)
        answer(a, x, lights, answers, shares)
        difference(a, x, d, transport, weights, differences)
        weight = 1 / (answers + np.float32(_EPSILON)) ** 2
        ctx.state = a, shares, np.float32(2 / answers.size) * weight * differences
        return torch.tensor(float((weight * differences**2).mean()))

    @staticmethod
    def backward(ctx: Any, gradient: Tensor) -> tuple[Tensor | None, ...]:
        a, shares, of_answers = ctx.state
        of_amplitude, of_axis = np.empty_like(a), np.empty_like(a)
        gradients(a, of_answers, shares, of_amplitude, of_axis)
        return torch.from_numpy(of_amplitude) * gradient, torch.from_numpy(of_axis) * gradient, None
