"""Importance-samples view rays by expected model error, with inverse weights.

A guide is a table of errors by where a sample lies: visibility, two angles, position, light. Rays
are drawn as without it, four times as many as wanted, and each is kept with a probability that
grows with the error in its cell; a kept sample weighs 1 over that probability. So sums over
weighted samples have the mean that they have without a guide (Horvitz and Thompson, 1952), whatever
the table says.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from safetensors.numpy import load_file

from rna_export.capture.asset_scene import AssetScene
from rna_export.capture.manifest import CapturedPart
from rna_export.capture.sample_files import write_arrays
from rna_export.capture.view_rays import ViewRays, sample_view_rays
from rna_sdk.package.manifest_fields import Region

UNIFORM = 0.5
"""Share of the rays that are chosen without regard to the error: no weight is above 2."""

_CANDIDATES = 4  # for each ray that is kept
_ANGLES, _VOXELS = (8, 6), 8  # cells along an angle, along a side of the bounds
_SHAPE = (2, _ANGLES[0] * _ANGLES[1], _VOXELS**3, 8)  # visibility, angles, position, octant of wi
_PRIOR = 8.0  # samples' worth that other cells say of one

Samples = Mapping[str, np.ndarray]
Cells = tuple[np.ndarray, ...]
"""A place on each axis of _SHAPE."""


@dataclass(frozen=True)
class Guide:
    """The expected error of each part by cells, over its mean: 1 is usual.

    parts: as the dataset has them. errors: of each, (2, angles, positions, lights) float32.
    """

    parts: tuple[CapturedPart, ...]
    errors: tuple[np.ndarray, ...]

    def rays(
        self,
        scene: AssetScene,
        wi: np.ndarray,
        n: int,
        wo: Region,
        rng: np.random.Generator,
    ) -> tuple[ViewRays, np.ndarray]:
        """About n rays for one light, and the weight of each, (k,) float32.

        More than n where the light is one of those that the model knows badly.
        """
        candidates = sample_view_rays(scene, wi, _CANDIDATES * n, wo, rng)
        expected = self._expected(scene, candidates, wi, rng)
        probability = (UNIFORM + (1.0 - UNIFORM) * expected) / _CANDIDATES
        kept, weight = thinned(np.minimum(probability, 1.0), rng)
        return candidates[kept], (weight / _CANDIDATES).astype(np.float32)

    def _expected(
        self, scene: AssetScene, rays: ViewRays, wi: np.ndarray, rng: np.random.Generator
    ) -> np.ndarray:
        points = scene.shade_points(rays.origins, rays.directions, rng)
        lights = np.ascontiguousarray(np.broadcast_to(wi.astype(np.float32), (len(rays), 3)))
        visible, expected = scene.visible(points, lights), np.ones(len(rays))
        for part, errors, on in zip(self.parts, self.errors, points.on, strict=True):
            at = {
                **on.fields,
                "wo": -rays.directions[on.rows],
                "wi": lights[on.rows],
                "visible": visible[on.rows],
            }
            expected[on.rows] = errors[_cells(part, at)]
        return expected

    def save(self, path: Path) -> None:
        """The file is written atomically."""
        named = zip(self.parts, self.errors, strict=True)
        write_arrays(path, {part.name: errors for part, errors in named})

    @classmethod
    def load(cls, path: Path, parts: Sequence[CapturedPart]) -> Guide:
        """What `save` wrote, of the same parts."""
        errors = load_file(path)
        return cls(tuple(parts), tuple(errors[part.name] for part in parts))


def thinned(probability: np.ndarray, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Rows kept with these probabilities (n,), none twice, and 1 over the probability of each.

    Systematic sampling: their number is the sum of the probabilities, rounded up or down.
    """
    until = np.cumsum(probability)
    marks = np.arange(rng.random(), until[-1], 1.0)
    kept = np.minimum(np.searchsorted(until, marks, side="right"), len(probability) - 1)
    return kept, 1.0 / probability[kept]


def relative_errors(part: CapturedPart, at: Samples, squared: np.ndarray) -> np.ndarray:
    """Of each cell, the root of its mean squared error over the mean of that over all samples.

    at: n samples, with their `weight` if they have one. squared: (n,) their squared errors. Of a
    cell with few samples, as most are, the axes say the most: errors of its angles, position and
    light, over the usual one, multiplied.
    """
    weight = np.asarray(at.get("weight", np.ones(len(squared))), np.float64)
    cells = _cells(part, at)
    of_whole = np.full(_SHAPE, np.average(squared, weights=weight))
    of_visibility = _mean(cells, (0,), weight, squared, of_whole)
    expected = of_visibility
    for axis in (1, 2, 3):
        own = _mean(cells, (0, axis), weight, squared, of_visibility)
        expected = expected * own / np.maximum(of_visibility, 1e-30)
    error = np.sqrt(_mean(cells, (0, 1, 2, 3), weight, squared, expected))
    usual = np.average(error[cells], weights=weight)
    return np.asarray(error / max(usual, 1e-12), np.float32)


def _mean(
    cells: Cells,
    axes: tuple[int, ...],
    weight: np.ndarray,
    squared: np.ndarray,
    expected: np.ndarray,
) -> np.ndarray:
    """Weighted mean over the samples that share a place on these axes, _SHAPE.

    Drawn towards what is expected, _SHAPE, which counts as much as a few samples.
    """
    size = tuple(_SHAPE[axis] if axis in axes else 1 for axis in range(len(_SHAPE)))
    place = np.ravel_multi_index(tuple(cells[axis] for axis in axes), [_SHAPE[a] for a in axes])
    total, count = (
        np.bincount(place, values, int(np.prod(size))).reshape(size)
        for values in (weight * squared, weight)
    )
    return np.asarray((total + _PRIOR * expected) / (count + _PRIOR))


def _cells(part: CapturedPart, at: Samples) -> Cells:
    """Where each sample lies on the axes of a table: visibility, angles, position, light."""
    visible = at["visible"] if at["visible"].ndim == 1 else at["visible"].mean(axis=1)
    spread, across = _surface_angles(at) if part.kind == "surface" else _fiber_angles(at)
    angles = _place(spread, _ANGLES[0]) * _ANGLES[1] + _place(across, _ANGLES[1])
    low, high = np.array(part.bounds, np.float32)
    voxel = _place((at["position"] - low) / np.maximum(high - low, 1e-9), _VOXELS)
    octant = (at["wi"] > 0.0) @ np.array([4, 2, 1])
    lit = (visible > 0.5).astype(np.int64)
    return lit, angles, voxel @ np.array([_VOXELS**2, _VOXELS, 1]), octant


def _place(x: np.ndarray, count: int) -> np.ndarray:
    """Which of `count` equal parts of [0, 1] x lies in."""
    return np.clip((x * count).astype(np.int64), 0, count - 1)


def _surface_angles(at: Samples) -> tuple[np.ndarray, np.ndarray]:
    """n.wi, and how far n is from the half vector, finest where it is near; both in [0, 1]."""
    half = at["wi"] + at["wo"]
    half = half / np.maximum(np.linalg.norm(half, axis=1, keepdims=True), 1e-6)
    away = np.arccos(np.clip(np.sum(at["normal"] * half, axis=1), 0.0, 1.0)) / (np.pi / 2.0)
    return 0.5 + 0.5 * np.sum(at["normal"] * at["wi"], axis=1), np.sqrt(away)


def _fiber_angles(at: Samples) -> tuple[np.ndarray, np.ndarray]:
    """wo.wi, and how far wo is from the cone of wi's mirror images; both in [0, 1]."""
    sines = np.sum(at["tangent"] * (at["wi"] + at["wo"]), axis=1)
    return 0.5 + 0.5 * np.sum(at["wo"] * at["wi"], axis=1), np.sqrt(np.abs(sines) / 2.0)
