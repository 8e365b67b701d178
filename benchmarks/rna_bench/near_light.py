"""A package in the light of a point that comes near, beside Cycles with the original.

The light stands towards (1, 1, 1) as the camera sees it; its distance counts from the asset's
middle, in sizes, the longest side of the bounding box: at 0.87 sizes it is a corner of the cube
about the asset. Its intensity goes with the square of the distance.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from rna_bench.beside_cycles import Beside, CyclesScene, OurScene
from rna_bench.stage import Stage
from rna_export.capture.worker import BlenderWorker


@dataclass(frozen=True)
class NearLight:
    """One distance: errors as `Beside` has them, ours over Cycles' mean, and the pictures."""

    distance: float
    psnr: float
    flip: float
    brightness: float
    strip: np.ndarray


def near_lights(
    stage: Stage,
    worker: BlenderWorker,
    distances: Iterable[float],
    samples: int,
    cycles_samples: int,
    bounces: int | None = None,
) -> Iterator[NearLight]:
    """Both renders at each distance; `cycles_samples` are those of each of two references."""
    covered = OurScene(stage.scene()).channels(8)["A"] > 0.0
    for distance in distances:
        scene = stage.scene(_light(stage, distance))
        cycles = CyclesScene(worker, scene, bounces)
        halves = [cycles.render(cycles_samples, seed).pixels for seed in (2, 3)]
        beside = Beside.of(np.stack(halves), covered)
        ours = OurScene(scene).render(samples).pixels
        brightness = float(ours[covered].mean() / beside.reference[covered].mean())
        error = beside.psnr(ours).db, beside.flip(ours)[0]
        yield NearLight(distance, *error, brightness, beside.strip(ours))


def _light(stage: Stage, distance: float) -> dict[str, Any]:
    length = distance * stage.size
    # As seen from the camera: (1, 1, 1) is to the right, above and in front.
    camera = np.asarray(stage.camera["position"]) - stage.centre
    front = np.array([camera[0], 0.0, camera[2]]) / np.hypot(camera[0], camera[2])
    right = np.cross([0.0, 1.0, 0.0], front)
    towards = (front + right + [0.0, 1.0, 0.0]) / np.sqrt(3.0)
    position = stage.centre + length * towards
    intensity = (np.pi * length**2,) * 3
    return {"type": "point", "position": tuple(position.tolist()), "intensity": intensity}
