"""Shadows for alpha: how much of the light a surface receives that it would in an empty scene."""

from __future__ import annotations

import numpy as np

from rna_render.paths.light_sampling import LightChoice, LightSampling
from rna_render.paths.sampling import PathNumbers
from rna_render.world.world import Vertices


def caught_light(
    lighting: LightSampling, vertices: Vertices, d_world: np.ndarray, numbers: PathNumbers
) -> np.ndarray:
    """Light that arrives, and what would if nothing were in the way: (n, 2) float32.

    Irradiance, mean of RGB, on the side that rays along d hit: no sky shines up through a floor.
    d_world: (n, 3) float32, of the rays that hit the vertices.
    """
    result = np.zeros((len(vertices), 2))
    choices, probability = lighting.choose(numbers)
    for choice in choices:
        light = _one_light(lighting, vertices, d_world, choice, probability)
        for column in range(2):
            result[:, column] += np.bincount(choice.row, light[:, column], len(vertices))
    return result.astype(np.float32)


def _one_light(
    lighting: LightSampling,
    vertices: Vertices,
    d_world: np.ndarray,
    choice: LightChoice,
    probability: np.ndarray,
) -> np.ndarray:
    row = choice.row
    samples = lighting.sample(choice, vertices.x_world[row])
    kept = lighting.kept(vertices, row, samples.wi_world, samples.distance, None)
    cosine = np.abs(np.sum(vertices.n_world[row] * samples.wi_world, axis=1))
    side = np.sum(vertices.ng_world * d_world, axis=1)[row]
    side *= np.sum(vertices.ng_world[row] * samples.wi_world, axis=1)
    cosine = np.where(side < 0.0, cosine, np.float32(0.0))
    pdf = samples.pdf * probability[choice.light]
    weight = np.divide(cosine, pdf, out=np.zeros_like(cosine), where=pdf > 0.0)
    received = (samples.radiance * kept).mean(axis=1) * weight
    return np.column_stack([received, samples.radiance.mean(axis=1) * weight])
