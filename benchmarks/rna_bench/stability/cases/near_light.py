"""Light from so near that its direction differs within the way it travels inside the asset.

The light stands towards (1, 1, 1) as the camera sees it; its distance counts from the asset's
middle, in sizes, the longest side of the bounding box: at 0.87 sizes it is a corner of the cube
about the asset. Its intensity goes with the square of the distance.
"""

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
from matplotlib.figure import FigureBase

from rna_bench.scenes.beside_cycles import Beside, CyclesScene, OurScene
from rna_bench.scenes.stage import Stage
from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.fixtures import Fixtures
from rna_export.capture.blender_process.blender_worker import BlenderWorker

LOST_DB = 3.0  # the mark

DISTANCES = (10.0, 5.0, 2.0, 1.0, 0.7, 0.5)  # of the asset's size
_RESOLUTION, _SAMPLES, _CYCLES_SAMPLES = (128, 96), 32, 64


def measure(fixtures: Fixtures) -> list[Row]:
    view = {"turn_deg": 0.0, "resolution": _RESOLUTION, "margin": 0.95}
    stage = Stage.of(fixtures.asset, fixtures.package.resolve(), fixtures.subject.tier, **view)
    samples, cycles_samples = fixtures.some(_SAMPLES), fixtures.some(_CYCLES_SAMPLES)
    with fixtures.cycles(fixtures.source) as worker:
        return list(_near_lights(stage, worker, DISTANCES, samples, cycles_samples))


def _near_lights(
    stage: Stage,
    worker: BlenderWorker,
    distances: Iterable[float],
    samples: int,
    cycles_samples: int,
) -> Iterator[Row]:
    """Errors and brightness over Cycles'; `cycles_samples`: of each of two references."""
    covered = OurScene(stage.scene()).channels(8)["A"] > 0.0
    for distance in distances:
        scene = stage.scene(_light(stage, distance))
        cycles = CyclesScene(worker, scene)
        halves = [cycles.render(cycles_samples, seed).pixels for seed in (2, 3)]
        beside = Beside.of(np.stack(halves), covered)
        ours = OurScene(scene).render(samples).pixels
        yield {
            "distance": distance,
            "psnr": beside.psnr(ours).db,
            "flip": beside.flip(ours).mean,
            "brightness": float(ours[covered].mean() / beside.reference[covered].mean()),
        }


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


def judge(rows: list[Row]) -> Verdict:
    far, near = (values(rows, "psnr", distance=d)[0] for d in (max(DISTANCES), min(DISTANCES)))
    return Verdict(far - near <= LOST_DB, f"{far - near:+.1f} dB lost at half a size")


def draw(figure: FigureBase, rows: list[Row]) -> None:
    axes = figure.subplots()
    distance = values(rows, "distance")
    axes.plot(distance, values(rows, "psnr"), "o-")
    axes.set_xscale("log")
    axes.set_xticks(distance, [f"{d:g}" for d in distance])
    axes.minorticks_off()
    axes.invert_xaxis()
    axes.set_xlabel("distance of the light, sizes of the asset")
    axes.set_ylabel("PSNR without noise, dB")
    brightness = axes.twinx()
    brightness.plot(distance, values(rows, "brightness"), "s:", color="C1")
    brightness.set_ylabel("brightness over Cycles'", color="C1")


CASE = Case(
    name="near-light",
    title="Near light",
    varies="a point light at 10 sizes from the middle down to half a size",
    mark="at half a size at most 3 dB less than at 10",
    measure=measure,
    judge=judge,
    draw=draw,
    needs=("package", "source"),
)
