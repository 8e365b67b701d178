"""What the integrator does with light that was found: which of it counts, its weight, its sum."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rna_render.lights import LightSamples
from rna_render.paths.light_sampling import LightChoice
from rna_render.world.world import Vertices, World
from rna_sdk.compiled import compiled
from rna_trace.vectors import dot, vector_at


@dataclass(frozen=True, slots=True)
class Tried:
    """Samples of lights for which shadow rays are traced, k of n.

    sample: (k,) int64, which samples, ascending. row: (k,) int64, the points that they are for.
    light: (k,) int64. wi_world, distance: (k, 3) and (k,) float32, see LightSamples. own: (k,)
    int32, see Vertices.
    """

    sample: np.ndarray
    row: np.ndarray
    light: np.ndarray
    wi_world: np.ndarray
    distance: np.ndarray
    own: np.ndarray

    def where_kept(self, kept: np.ndarray) -> tuple[Tried, np.ndarray]:
        """Samples that are not fully blocked, and their transmittance: (j, 1) or (j, 3) float32.

        kept: (k, 1) or (k, 3) float32, see LightSampling.kept.
        """
        left = _like(self), np.empty_like(kept)
        count = _take_kept(_arrays(self), kept, _arrays(left[0]), left[1])
        return left[0].first(count), left[1][:count]

    def first(self, count: int) -> Tried:
        return Tried(*(values[:count] for values in _arrays(self)))


def worth_tracing(
    samples: LightSamples, choice: LightChoice, vertices: Vertices, world: World
) -> Tried:
    """The samples that bring any light that the points may scatter to the viewer.

    None that is part of the transport of what it falls on, and none from behind a surface that is
    lit from one side.
    """
    n = len(choice.row)
    sample, row, light = (np.empty(n, np.int64) for _ in range(3))
    wi_world, distance = np.empty((n, 3), np.float32), np.empty(n, np.float32)
    result = Tried(sample, row, light, wi_world, distance, np.empty(n, np.int32))
    found = samples.pdf, samples.radiance, samples.wi_world, samples.distance
    points = vertices.wo_world, vertices.ng_world, vertices.instance, vertices.own
    instances = world.own_light, world.one_sided
    chosen = choice.row, choice.light
    return result.first(_worth_tracing(found, chosen, points, instances, _arrays(result)))


def _arrays(tried: Tried) -> tuple[np.ndarray, ...]:
    own = tried.wi_world, tried.distance, tried.own
    return tried.sample, tried.row, tried.light, *own


def _like(tried: Tried) -> Tried:
    return Tried(*(np.empty_like(values) for values in _arrays(tried)))


@compiled(fastmath=())
def _worth_tracing(
    found: tuple[np.ndarray, ...],
    chosen: tuple[np.ndarray, ...],
    points: tuple[np.ndarray, ...],
    instances: tuple[np.ndarray, ...],
    result: tuple[np.ndarray, ...],
) -> int:
    pdf, radiance, wi, distance = found
    row, light = chosen
    wo, ng, instance, own = points
    own_light, one_sided = instances
    count = 0
    for i in range(len(row)):
        at, k = row[i], instance[row[i]]
        bright = radiance[i, 0] != 0.0 or radiance[i, 1] != 0.0 or radiance[i, 2] != 0.0
        if not (pdf[i] > 0.0 and bright and own_light[k] != light[i]):
            continue
        g = vector_at(ng, at)
        if one_sided[k] and not dot(g, vector_at(wi, i)) * dot(g, vector_at(wo, at)) > 0.0:
            continue
        result[0][count], result[1][count], result[2][count] = i, at, light[i]
        for axis in range(3):
            result[3][count, axis] = wi[i, axis]
        result[4][count], result[5][count] = distance[i], own[at]
        count += 1
    return count


@compiled(fastmath=())
def _take_kept(
    tried: tuple[np.ndarray, ...],
    kept: np.ndarray,
    result: tuple[np.ndarray, ...],
    left: np.ndarray,
) -> int:
    count = 0
    for i in range(len(kept)):
        bright = False
        for channel in range(kept.shape[1]):
            bright = bright or kept[i, channel] != 0.0
            left[count, channel] = kept[i, channel]
        if not bright:
            continue
        for axis in range(3):
            result[3][count, axis] = tried[3][i, axis]
        result[0][count], result[1][count], result[2][count] = tried[0][i], tried[1][i], tried[2][i]
        result[4][count], result[5][count] = tried[4][i], tried[5][i]
        count += 1
    return count


@compiled(fastmath=())
def weigh_samples(
    transport: np.ndarray,
    seen: np.ndarray,
    samples: tuple[np.ndarray, ...],
    tried: tuple[np.ndarray, ...],
    kept: np.ndarray,
    own_pdf: np.ndarray,
    lights: tuple[np.ndarray, ...],
    beta: np.ndarray,
) -> None:
    """Make of transport, (k, 3) float32, the radiance that samples bring along their paths.

    seen: (k,) float32, multiplied by the mean of what is kept. samples: radiance (n, 3) and pdf
    (n,) float32 of all samples. tried: samples, rows and lights of Tried. kept: (k, 1) or (k, 3)
    float32. own_pdf: (k,), density of rays. lights: probability of each light, and whether no ray
    can find it. beta: (m, 3) float32, throughput of the rows' paths.
    """
    radiance, pdf = samples
    sample, row, light = tried
    probability, delta = lights
    channels = kept.shape[1]
    for i in range(len(sample)):
        density = pdf[sample[i]] * probability[light[i]]
        ratio = own_pdf[i] / density
        share = np.float32(1.0) if delta[light[i]] else np.float32(1.0 / (1.0 + ratio * ratio))
        weight = np.float32(share / density)
        mean = np.float32(0.0)
        for channel in range(3):
            left = kept[i, min(channel, channels - 1)]
            value = transport[i, channel] * (radiance[sample[i], channel] * weight * left)
            transport[i, channel] = beta[row[i], channel] * value
        for channel in range(channels):
            mean += kept[i, channel]
        seen[i] *= mean / np.float32(channels)


@compiled(fastmath=())
def weigh_hit(
    radiance: np.ndarray,
    pdf: np.ndarray,
    probability: np.ndarray,
    own_pdf: np.ndarray | None,
    row: np.ndarray,
    beta: np.ndarray,
) -> np.ndarray:
    """Contribution of radiance that rays of paths hit, with MIS weights: (k, 3) float32.

    radiance: (k, 3) float32. pdf: (k,) float32, density with which each of `probability` samples,
    (k,) float64, finds the light there. own_pdf: (n,) float32, of all rays; None if rays alone find
    light. row: (k,) which rays these are. beta: (n, 3) float32, throughput of all paths.
    """
    result = np.empty_like(radiance)
    for i in range(len(row)):
        share = np.float32(1.0)
        if own_pdf is not None:
            density = own_pdf[row[i]]
            ratio = probability[i] * pdf[i] / density if density > 0.0 else np.inf
            share = np.float32(1.0 / (1.0 + ratio * ratio))
        for channel in range(3):
            result[i, channel] = beta[row[i], channel] * share * radiance[i, channel]
    return result


@compiled(fastmath=())
def weigh_rays(
    transport: np.ndarray,
    pdf: np.ndarray,
    passed: np.ndarray | None,
    row: np.ndarray,
    beta: np.ndarray,
) -> None:
    """Make of transport, (k, 3) float32, the throughput of paths that go on along rays.

    pdf: (k,) float32, density of the rays' directions. passed: (k, 3) float32, what is left by all
    that the rays went through; None for 1. row: (k,) rows of beta, (m, 3) float32, the throughput
    so far.
    """
    for i in range(len(row)):
        scale = np.float32(1.0) / pdf[i] if pdf[i] > 0.0 else np.float32(0.0)
        for channel in range(3):
            value = transport[i, channel] * beta[row[i], channel] * scale
            transport[i, channel] = value if passed is None else value * passed[i, channel]


@compiled(fastmath=())
def clamp_paths(radiance: np.ndarray, limit: np.ndarray) -> None:
    """Scale the rows of radiance, (n, 3) float32, whose largest channel is above their limit.

    limit: (n,) float32.
    """
    for i in range(len(radiance)):
        largest = max(radiance[i, 0], radiance[i, 1], radiance[i, 2])
        if largest > limit[i]:
            for channel in range(3):
                radiance[i, channel] *= limit[i] / largest


@compiled(fastmath=())
def add_rows(target: np.ndarray, row: np.ndarray, values: np.ndarray) -> None:
    """target[row, :3] += values, where a row may be there more than once."""
    for i in range(len(row)):
        for channel in range(3):
            target[row[i], channel] += values[i, channel]
