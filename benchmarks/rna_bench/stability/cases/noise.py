"""Few paths a sample, many samples, or the other way round."""

import numpy as np
from matplotlib.figure import FigureBase

from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.fixtures import Fixtures
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.training.optimization.losses import with_fitting_loss
from rna_export.training.validation import score, shade

BIAS, FROM_PATHS = 0.02, 4  # the mark

PATHS = (1, 4, 16, 64)
LOSSES = ("log", "unbiased")
_RAYS_OF_ONE_PATH = 16384  # a light: what all captures spend; 0.13 M samples of 64 paths


def measure(fixtures: Fixtures) -> list[Row]:
    views = fixtures.capture_white().validation_views()
    rows = []
    for paths in PATHS:
        dataset = fixtures.capture(
            f"noise-{paths}",
            "white.py",
            lights=fixtures.some(512),
            rays=_RAYS_OF_ONE_PATH // paths,
            samples=paths,
            validation_views=1,
            validation_resolution=32,
            validation_samples=2,
        )
        preset = fixtures.preset("surface", resolution=64)
        models = {
            loss: fixtures.train(loss, dataset, preset.with_training(loss=loss)).model
            for loss in LOSSES
        }
        unit = float(models["log"].unit)
        fitting = with_fitting_loss(preset, dataset, unit).training.loss
        for loss, model in models.items():
            row = row_of([shade(model, view) for view in views], views)
            rows.append({"paths": paths, "loss": loss, "chosen": loss == fitting, **row})
    return rows


def row_of(radiance: list[np.ndarray], views: list[ValidationView]) -> Row:
    """PSNR without noise, and the relative error of the sum of all radiance."""
    scores = score(radiance, views)
    true = np.concatenate([view.samples["radiance"] for view in views]).mean(dtype=np.float64)
    bias = float(np.concatenate(radiance).mean(dtype=np.float64) / true) - 1.0
    return {"psnr": scores.psnr_without_noise.db, "bias": bias}


def judge(rows: list[Row]) -> Verdict:
    used = [r for r in rows if r["paths"] >= FROM_PATHS]
    chosen = max((r["bias"] for r in used if r["chosen"]), key=abs)
    log = max((r["bias"] for r in used if r["loss"] == "log"), key=abs)
    one = {loss: values(rows, "bias", loss=loss, paths=1)[0] for loss in LOSSES}
    return Verdict(
        abs(chosen) <= BIAS,
        f"from 4 paths on {chosen:+.1%}, with only the log loss {log:+.1%}; "
        f"at 1 path log {one['log']:+.1%}, unbiased {one['unbiased']:+.1%}",
    )


def draw(figure: FigureBase, rows: list[Row]) -> None:
    left, right = figure.subplots(1, 2)
    for loss in LOSSES:
        paths = values(rows, "paths", loss=loss)
        left.plot(paths, values(rows, "psnr", loss=loss), "o-", label=f"{loss} loss")
        bias = [100.0 * b for b in values(rows, "bias", loss=loss)]
        right.plot(paths, bias, "o-", label=f"{loss} loss")
    for axes in (left, right):
        axes.set_xscale("log", base=4)
        axes.set_xlabel("paths a sample, equal paths in all")
    right.axhspan(-100 * BIAS, 100 * BIAS, color="C2", alpha=0.15)
    left.set_ylabel("PSNR without noise, dB")
    right.set_ylabel("too bright by, %")
    left.legend()


CASE = Case(
    name="noise",
    title="Noise in training data",
    varies="1 to 64 paths a sample at equal total paths, two losses; the suite's white asset",
    mark="brightness off by at most 2% from 4 paths on, with the loss that the presets choose",
    measure=measure,
    judge=judge,
    draw=draw,
)
