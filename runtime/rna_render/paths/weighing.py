"""Weights of found light in the integrator: its selection, its weight, its sum."""

from typing import NamedTuple

import numpy as np

from rna_render.lights import LightSamples
from rna_render.paths.light_sampling import LightChoice
from rna_render.world.world import Vertices, World
from rna_sdk.machine.compiled import compiled
from rna_trace.vectors import dot, vector_at


class Tried(NamedTuple):
    """Samples of lights for which shadow rays are traced, k of n.

    sample: (k,) int64, which samples, ascending. row: (k,) int64, the points that they are for.
    light: (k,) int64. wi_world, distance: (k, 3) and (k,) float32, see LightSamples.
    start_instance: (k,) int32, see Vertices.
    """

    sample: np.ndarray
    row: np.ndarray
    light: np.ndarray
    wi_world: np.ndarray
    distance: np.ndarray
    start_instance: np.ndarray

    def where_visible(self, visibility: np.ndarray) -> tuple["Tried", np.ndarray]:
        """Samples that are not fully blocked, and their transmittance: (j, 1) or (j, 3) float32.

        visibility: (k, 1) or (k, 3) float32, see LightSampling.visibility.
        """
        row = np.flatnonzero(visibility.any(axis=1))
        if len(row) == len(visibility):
            return self, visibility
        return Tried(*(values.take(row, axis=0) for values in self)), visibility.take(row, axis=0)


def worth_tracing(
    samples: LightSamples, choice: LightChoice, vertices: Vertices, world: World
) -> Tried:
    """The samples that bring any light that the points may scatter to the viewer.

    Skips lights already included in the asset's own transport, and those behind a surface that is
    lit from one side.
    """
    n = len(choice.row)
    sample, row, light = (np.empty(n, np.int64) for _ in range(3))
    wi_world, distance = np.empty((n, 3), np.float32), np.empty(n, np.float32)
    result = Tried(sample, row, light, wi_world, distance, np.empty(n, np.int32))
    count = _worth_tracing(
        samples,
        choice.row,
        choice.light,
        vertices.wo_world,
        vertices.ng_world,
        vertices.instance,
        vertices.start_instance,
        world.same_light,
        world.one_sided,
        result,
    )
    return Tried(*(values[:count] for values in result))


@compiled(fastmath=())
def _worth_tracing(
    samples: LightSamples,
    row: np.ndarray,
    light: np.ndarray,
    wo_world: np.ndarray,
    ng_world: np.ndarray,
    instance: np.ndarray,
    start_instance: np.ndarray,
    same_light: np.ndarray,
    one_sided: np.ndarray,
    result: Tried,
) -> int:
    pdf, radiance, wi_world = samples.pdf, samples.radiance, samples.wi_world
    count = 0
    for i in range(len(row)):
        at, k = row[i], instance[row[i]]
        bright = radiance[i, 0] != 0.0 or radiance[i, 1] != 0.0 or radiance[i, 2] != 0.0
        if not (pdf[i] > 0.0 and bright and same_light[k] != light[i]):
            continue
        g, wi = vector_at(ng_world, at), vector_at(wi_world, i)
        if one_sided[k] and not dot(g, wi) * dot(g, vector_at(wo_world, at)) > 0.0:
            continue
        result.sample[count], result.row[count], result.light[count] = i, at, light[i]
        for axis in range(3):
            result.wi_world[count, axis] = wi_world[i, axis]
        result.distance[count] = samples.distance[i]
        result.start_instance[count] = start_instance[at]
        count += 1
    return count


@compiled(fastmath=())
def weigh_samples(
    transport: np.ndarray,
    seen: np.ndarray,
    samples: LightSamples,
    tried: Tried,
    visibility: np.ndarray,
    light_pdf: np.ndarray,
    probability: np.ndarray,
    delta: np.ndarray,
    beta: np.ndarray,
) -> None:
    """Make of transport, (k, 3) float32, the radiance that samples bring along their paths.

    seen: (k,) float32, multiplied by the mean of what is kept. samples: n, from which those tried
    are. visibility: (k, 1) or (k, 3) float32. light_pdf: (k,), density of rays. probability,
    delta: of each light, and whether no ray can find it. beta: (m, 3) float32, throughput of the
    rows' paths.
    """
    channels = visibility.shape[1]
    for i in range(len(tried.sample)):
        at, light, row = tried.sample[i], tried.light[i], tried.row[i]
        density = samples.pdf[at] * probability[light]
        ratio = light_pdf[i] / density
        share = np.float32(1.0) if delta[light] else np.float32(1.0 / (1.0 + ratio * ratio))
        weight = np.float32(share / density)
        mean = np.float32(0.0)
        for channel in range(3):
            left = visibility[i, min(channel, channels - 1)]
            value = transport[i, channel] * (samples.radiance[at, channel] * weight * left)
            transport[i, channel] = beta[row, channel] * value
        for channel in range(channels):
            mean += visibility[i, channel]
        seen[i] *= mean / np.float32(channels)


@compiled(fastmath=())
def weigh_hit(
    radiance: np.ndarray,
    pdf: np.ndarray,
    probability: np.ndarray,
    light_pdf: np.ndarray | None,
    row: np.ndarray,
    beta: np.ndarray,
) -> np.ndarray:
    """Contribution of radiance that rays of paths hit, with MIS weights: (k, 3) float32.

    radiance: (k, 3) float32. pdf: (k,) float32, density with which each of `probability` samples,
    (k,) float64, finds the light there. light_pdf: (n,) float32, of all rays; None if rays alone
    find light. row: (k,) which rays these are. beta: (n, 3) float32, throughput of all paths.
    """
    result = np.empty_like(radiance)
    for i in range(len(row)):
        share = np.float32(1.0)
        if light_pdf is not None:
            density = light_pdf[row[i]]
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
def clamp_paths(
    radiance: np.ndarray, limit: np.ndarray, path: np.ndarray, taken: np.ndarray
) -> None:
    """Scale the rows of radiance, (n, 3) float32, whose largest channel is above their limit.

    limit: (n,) float32. path: (n,) which rows of taken, (m,) float32, get the mean of RGB of what
    is taken away.
    """
    for i in range(len(radiance)):
        largest = max(radiance[i, 0], radiance[i, 1], radiance[i, 2])
        if largest > limit[i]:
            kept = limit[i] / largest
            mean = (radiance[i, 0] + radiance[i, 1] + radiance[i, 2]) / np.float32(3.0)
            taken[path[i]] += mean * (np.float32(1.0) - kept)
            for channel in range(3):
                radiance[i, channel] *= kept


@compiled(fastmath=())
def add_rows(target: np.ndarray, row: np.ndarray, values: np.ndarray) -> None:
    """target[row, :3] += values, where a row may be there more than once."""
    for i in range(len(row)):
        for channel in range(3):
            target[row[i], channel] += values[i, channel]
