"""What the integrator does with light that was found: which of it counts, its weight, its sum."""

from __future__ import annotations

import numpy as np

from rna_render.light_sampling import LightChoice
from rna_render.lights import LightSamples
from rna_sdk.compiled import compiled


def worth_tracing(
    samples: LightSamples, choice: LightChoice, instance: np.ndarray, own_light: np.ndarray
) -> np.ndarray:
    """Which samples bring any light that is not part of the transport of what it falls on.

    instance: (m,) int32, of the points. own_light: as of World. Returns (k,) int64, ascending.
    """
    result = np.empty(len(choice.row), np.int64)
    at = choice.row, choice.light, instance, own_light
    return result[: _worth_tracing(samples.pdf, samples.radiance, *at, result)]


def rows_with_light(colours: np.ndarray) -> np.ndarray:
    """Which rows of (n, 1) or (n, 3) float32 are not all 0: (k,) int64, ascending."""
    result = np.empty(len(colours), np.int64)
    return result[: _rows_with_light(colours, result)]


def power_share(pdf: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Power heuristic: the part of the estimate that belongs to the first way, (n, 1) float32."""
    ratio = np.divide(other, pdf, out=np.full(len(pdf), np.inf), where=pdf > 0.0)
    return (1.0 / (1.0 + np.square(ratio))).astype(np.float32)[:, None]


@compiled(fastmath=())
def _worth_tracing(pdf, radiance, row, light, instance, own_light, result):
    count = 0
    for i in range(len(row)):
        bright = radiance[i, 0] != 0.0 or radiance[i, 1] != 0.0 or radiance[i, 2] != 0.0
        if pdf[i] > 0.0 and bright and own_light[instance[row[i]]] != light[i]:
            result[count] = i
            count += 1
    return count


@compiled(fastmath=())
def _rows_with_light(colours, result):
    count = 0
    for i in range(len(colours)):
        bright = colours[i, 0] != 0.0
        for channel in range(1, colours.shape[1]):
            bright = bright or colours[i, channel] != 0.0
        if bright:
            result[count] = i
            count += 1
    return count


@compiled(fastmath=())
def weigh_samples(transport, radiance, found, kept, pdf, own_pdf, delta):
    """Multiply transport, (k, 3) float32, by the radiance of samples and by their weights.

    radiance: (n, 3) float32, of all samples, and found: (k,) which of them. kept: (k, 1) or (k, 3)
    float32. pdf, own_pdf: (k,), densities of the light and of rays. delta: (k,) bool, lights that
    rays cannot find.
    """
    for i in range(len(found)):
        ratio = own_pdf[i] / pdf[i]
        share = np.float32(1.0) if delta[i] else np.float32(1.0 / (1.0 + ratio * ratio))
        weight = np.float32(share / pdf[i])
        for channel in range(3):
            left = kept[i, min(channel, kept.shape[1] - 1)]
            transport[i, channel] *= radiance[found[i], channel] * weight * left


@compiled(fastmath=())
def add_rows(target, row, values):
    """target[row, :3] += values, where a row may be there more than once."""
    for i in range(len(row)):
        for channel in range(3):
            target[row[i], channel] += values[i, channel]
