"""The loss of lobes under random lights, and its gradient: compiled, a point at a time."""

import math
from typing import Any, NamedTuple

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from rna_export.lobes.directions import even_directions
from rna_export.lobes.view_points import Rows
from rna_sdk.machine.compiled import compiled
from rna_sdk.runtime.kernels.lane_memory import load_lanes, store_lanes
from rna_sdk.runtime.kernels.lane_vectors import between, exp
from rna_sdk.runtime.kernels.lanes import LANES

LIGHTS = 16  # of a point
EPSILON = 0.1  # of the relative error; radiance under a light of radiance 1
_KAPPA = (0.5, 30.0)  # of the lights
_STRIDE = 7  # in concentrations between neighbouring lights: none has a part of the sphere alone

LIMIT = 80.0  # of exponents: exp, compiled, knows no smaller ones than -174

_SUMS = ("contract", "reassoc", "nsz")  # sums in any order, several at a time
SMALLEST_KAPPA = 0.01
"""Least length of an axis: `spec/RNA.md`, 12.1."""

_SMALLEST, _TWO_PI = np.float32(SMALLEST_KAPPA), np.float32(2.0 * math.pi)
_ZERO, _ONE, _TWO = np.float32(0.0), np.float32(1.0), np.float32(2.0)


class Targets(NamedTuple):
    """Transport at n points along D directions each, a multiple of LANES.

    directions, transport: (n, 3, D) float32. share: (n, D) float32, what solid angle a direction
    stands for. rotation: (n, 3, 3) float32, of the point's lights.
    """

    directions: Rows
    transport: Rows
    share: Rows
    rotation: Rows


def even_lights() -> NDArray[np.float32]:
    """(LIGHTS, 3): axes of von Mises-Fisher distributions about even directions."""
    place = np.arange(LIGHTS) * _STRIDE % LIGHTS / (LIGHTS - 1)
    kappa = _KAPPA[0] * (_KAPPA[1] / _KAPPA[0]) ** place
    return (kappa[:, None] * even_directions(LIGHTS)).astype(np.float32)


class LobeLoss(torch.autograd.Function):
    """Mean squared relative error of lobes under lights, of amplitudes and axes (m, L, 3).

    row: (m,) which points of the targets. lights: (k, 3) axes. Lobes and truth are taken along the
    same directions, so that only what the lobes do not explain is noise; a light's weights over
    them add up to 1. An error is relative to what the lobes answer, plus EPSILON.
    """

    @staticmethod
    def forward(
        ctx: Any,
        amplitude: Tensor,
        axis: Tensor,
        row: NDArray[np.int64],
        targets: Targets,
        lights: NDArray[np.float32],
    ) -> Tensor:
        a, b = (x.detach().contiguous().numpy() for x in (amplitude, axis))
        of_a, of_b, loss = np.empty_like(a), np.empty_like(b), np.empty(len(row), np.float32)
        _loss_rows(a, b, row, *targets, lights, loss, of_a, of_b)
        scale = 1.0 / (3 * len(lights) * len(row))
        ctx.gradients = [torch.from_numpy(scale * x) for x in (of_a, of_b)]
        return amplitude.new_tensor(scale * loss.sum(dtype=np.float64))

    @staticmethod
    def backward(ctx: Any, gradient: Tensor) -> tuple[Tensor | None, ...]:
        return *(gradient * factor for factor in ctx.gradients), None, None, None


@compiled(fastmath=_SUMS)
def _loss_rows(
    amplitude: Rows,
    axis: Rows,
    row: NDArray[np.int64],
    directions: Rows,
    transport: Rows,
    share: Rows,
    rotation: Rows,
    lights: Rows,
    loss: Rows,
    of_amplitude: Rows,
    of_axis: Rows,
) -> None:
    """loss[i]: sum of squared relative errors; and its gradients."""
    along = directions.shape[2]
    density = np.empty((amplitude.shape[1], along), np.float32)
    weight = np.empty((len(lights), along), np.float32)
    answer, slope = np.empty((3, along), np.float32), np.empty((3, along), np.float32)
    for i in range(len(row)):
        k = row[i]
        _weigh(lights, rotation[k], directions[k], share[k], weight)
        _answer(amplitude[i], axis[i], directions[k], density, answer)
        loss[i] = _compare(answer, transport[k], weight, slope)
        _pull(amplitude[i], axis[i], directions[k], density, slope, of_amplitude[i], of_axis[i])


@compiled(fastmath=_SUMS)
def _exponentials(rows: Rows) -> None:
    """exp of rows in place; arguments beyond LIMIT count as LIMIT."""
    flat = rows.reshape(rows.size)
    for start in range(0, rows.size, LANES):
        x = between(load_lanes(flat, start), -LIMIT, LIMIT)
        store_lanes(flat, start, exp(x))


@compiled(fastmath=_SUMS)
def _weigh(lights: Rows, rotation: Rows, d: Rows, share: Rows, weight: Rows) -> None:
    """weight: of directions under each light, turned; each light's sum is 1."""
    for j in range(len(lights)):
        x, y, z = lights[j, 0], lights[j, 1], lights[j, 2]
        kappa = math.sqrt(x * x + y * y + z * z)
        a = rotation[0, 0] * x + rotation[0, 1] * y + rotation[0, 2] * z
        b = rotation[1, 0] * x + rotation[1, 1] * y + rotation[1, 2] * z
        c = rotation[2, 0] * x + rotation[2, 1] * y + rotation[2, 2] * z
        for k in range(len(share)):
            weight[j, k] = a * d[0, k] + b * d[1, k] + c * d[2, k] - kappa
    _exponentials(weight)
    for j in range(len(lights)):
        total = _ZERO
        for k in range(len(share)):
            weight[j, k] *= share[k]
            total += weight[j, k]
        scale = _ONE / total
        for k in range(len(share)):
            weight[j, k] *= scale


@compiled(fastmath=_SUMS)
def _answer(amplitude: Rows, axis: Rows, d: Rows, density: Rows, answer: Rows) -> None:
    """density: of each lobe along directions, as `lobe_model.densities`; answer: their sum."""
    for j in range(len(axis)):
        a, b, c = axis[j, 0], axis[j, 1], axis[j, 2]
        kappa: Any = max(math.sqrt(a * a + b * b + c * c), _SMALLEST)
        log_c = math.log(kappa / _TWO_PI) - math.log1p(-math.exp(-_TWO * kappa)) - kappa
        for k in range(d.shape[1]):
            density[j, k] = a * d[0, k] + b * d[1, k] + c * d[2, k] + log_c
    _exponentials(density)
    answer[:] = _ZERO
    for j in range(len(axis)):
        for c in range(3):
            a = amplitude[j, c]
            for k in range(d.shape[1]):
                answer[c, k] += a * density[j, k]


@compiled(fastmath=_SUMS)
def _compare(answer: Rows, transport: Rows, weight: Rows, slope: Rows) -> float:
    """The sum of squared relative errors; slope: its gradient by the answer."""
    total, epsilon = _ZERO, np.float32(EPSILON)
    slope[:] = _ZERO
    for c in range(3):
        for j in range(len(weight)):
            sent, error = _ZERO, _ZERO
            for k in range(answer.shape[1]):
                sent += weight[j, k] * answer[c, k]
                error += weight[j, k] * (answer[c, k] - transport[c, k])
            scale = _ONE / (max(sent, _ZERO) + epsilon)
            error *= scale
            total += error * error
            pull = _TWO * error * scale
            for k in range(answer.shape[1]):
                slope[c, k] += pull * weight[j, k]
    return float(total)


@compiled(fastmath=_SUMS)
def _pull(
    amplitude: Rows,
    axis: Rows,
    d: Rows,
    density: Rows,
    slope: Rows,
    of_amplitude: Rows,
    of_axis: Rows,
) -> None:
    """Gradients by amplitudes and axes, from the one by the answer."""
    for j in range(len(axis)):
        for c in range(3):
            total = _ZERO
            for k in range(d.shape[1]):
                total += density[j, k] * slope[c, k]
            of_amplitude[j, c] = total
        r, g, b = amplitude[j, 0], amplitude[j, 1], amplitude[j, 2]
        x, y, z, whole = _ZERO, _ZERO, _ZERO, _ZERO
        for k in range(d.shape[1]):
            pull = density[j, k] * (r * slope[0, k] + g * slope[1, k] + b * slope[2, k])
            whole += pull
            x += pull * d[0, k]
            y += pull * d[1, k]
            z += pull * d[2, k]
        a, b, c = axis[j, 0], axis[j, 1], axis[j, 2]
        kappa = math.sqrt(a * a + b * b + c * c)
        towards = _ZERO
        if kappa > _SMALLEST:  # d log_c / d kappa, over kappa
            both = math.exp(-_TWO * kappa)
            towards = whole * (_ONE / kappa - _TWO * both / (_ONE - both) - _ONE) / kappa
        of_axis[j, 0], of_axis[j, 1] = x + towards * a, y + towards * b
        of_axis[j, 2] = z + towards * c
