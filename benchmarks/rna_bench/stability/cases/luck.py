"""Trainings that differ in their random numbers alone."""

from matplotlib.figure import FigureBase

from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.fixtures import Fixtures
from rna_bench.stability.view_errors import scores_of
from rna_export.training.checkpoint import Trained
from rna_export.training.presets import Preset

SPREAD = 0.3  # the mark, dB
SEEDS = 5


def measure(fixtures: Fixtures) -> list[Row]:
    dataset, views = fixtures.dataset, fixtures.dataset.validation_views()
    preset = fixtures.preset(dataset.kind)
    rows = []
    for seed in range(SEEDS):
        trained = _seeded(fixtures, preset, seed)
        scores = scores_of(trained.model, views)
        rows.append({"seed": seed, "psnr": scores.psnr_without_noise.db, "flip": scores.flip})
    return rows


def _seeded(fixtures: Fixtures, preset: Preset, seed: int) -> Trained:
    if seed == 0:
        return fixtures.base
    return fixtures.train(f"seed-{seed}", fixtures.dataset, preset, seed)


def judge(rows: list[Row]) -> Verdict:
    psnr = values(rows, "psnr")
    spread = max(psnr) - min(psnr)
    return Verdict(spread <= SPREAD, f"{spread:.2f} dB between best and worst seed")


def draw(figure: FigureBase, rows: list[Row]) -> None:
    axes = figure.subplots()
    psnr = values(rows, "psnr")
    axes.plot(values(rows, "seed"), psnr, "o")
    axes.axhspan(max(psnr) - SPREAD, max(psnr), color="C2", alpha=0.15, label="0.3 dB")
    axes.set_xlabel("seed")
    axes.set_ylabel("PSNR without noise, dB")
    axes.set_xticks(values(rows, "seed"))
    axes.legend()


CASE = Case(
    name="luck",
    title="Luck",
    varies="five seeds of the training",
    mark="at most 0.3 dB between the best and the worst",
    measure=measure,
    judge=judge,
    draw=draw,
    needs=("dataset",),
)
