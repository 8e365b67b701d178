"""Light from so near that its direction differs within the way it travels inside the asset."""

from __future__ import annotations

from matplotlib.figure import FigureBase

from rna_bench.near_light import near_lights
from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.workshop import Workshop
from rna_bench.stage import Stage

LOST_DB = 3.0  # the mark

DISTANCES = (10.0, 5.0, 2.0, 1.0, 0.7, 0.5)  # of the asset's size
_RESOLUTION, _SAMPLES, _CYCLES_SAMPLES = (128, 96), 32, 64


def measure(workshop: Workshop) -> list[Row]:
    subject = workshop.subject
    view = {"turn_deg": 0.0, "resolution": _RESOLUTION, "margin": 0.95}
    stage = Stage.of(workshop.asset, workshop.package.resolve(), subject.tier, **view)
    spent = workshop.some(_SAMPLES), workshop.some(_CYCLES_SAMPLES)
    with workshop.cycles(subject.source) as worker:
        return [
            {name: getattr(near, name) for name in ("distance", "psnr", "flip", "brightness")}
            for near in near_lights(stage, worker, DISTANCES, *spent)
        ]


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
    advice="Transport was captured under distant light: what scatters far inside is lit wrongly.",
    measure=measure,
    judge=judge,
    draw=draw,
    needs=("package", "source"),
)
