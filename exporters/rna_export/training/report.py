"""Validation during training: metrics and written files."""

import csv
import gc
import io
from math import inf, isnan
from pathlib import Path
from time import monotonic

from rna_export.albedo import albedo
from rna_export.brightness import Brightness, brightness
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.training.asset_error import asset_error, worse_error
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.validation import (
    mean_psnr,
    shade,
    shade_emission,
    write_images,
    write_sheet,
)
from rna_sdk.errors import TrainingError
from rna_sdk.files.atomic_file import write_atomically

_COLUMNS = ("step", "loss", "psnr", "flip", "albedo", "emission_psnr")
"""step: steps done. loss: the mean since the row before. The others: see `Report`."""


_ALBEDO_ERROR = 0.01  # of the measured light in a white world


def error_of(row: dict[str, float]) -> float:
    """Error of a row of `Curves`, by which models are chosen; infinity where it has no FLIP.

    FLIP ends at display white. So the light in a white world counts, too, by what it is off beyond
    its own error: before the unbiased end of a training highlights are too weak.
    """
    off = max(abs(1.0 - row.get("albedo", 1.0)) - _ALBEDO_ERROR, 0.0)
    return row.get("flip", inf) + off


class Curves:
    """Rows of `<folder>/metrics.csv`, from before step `done` on."""

    def __init__(self, folder: Path, done: int = 0):
        self._folder = folder
        self.rows = [row for row in read_curves(folder) if row["step"] <= done]

    @property
    def least_error(self) -> float:
        """Least `error_of` a row; infinity if there are none."""
        return min(map(error_of, self.rows), default=inf)

    def add(self, row: dict[str, float]) -> None:
        """Write the file with one more row."""
        self.rows.append(row)
        text = io.StringIO()
        writer = csv.DictWriter(text, _COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(self.rows)
        write_atomically(self._folder / "metrics.csv", text.getvalue().encode())

    def draw(self) -> None:
        """Write `<folder>/curves.png`."""
        import matplotlib

        matplotlib.use("Agg")
        import matplotlib.pyplot as plt

        figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.5), layout="constrained")
        steps = [row["step"] for row in self.rows]
        left.semilogy(steps, [row["loss"] for row in self.rows], marker=".")
        left.set(xlabel="step", ylabel="training loss")
        right.plot(steps, [row["psnr"] for row in self.rows], marker="o")
        right.set(xlabel="step", ylabel="validation PSNR (dB, irradiance pi, [0, 1])")
        picture = io.BytesIO()
        figure.savefig(picture, format="png", dpi=100)
        write_atomically(self._folder / "curves.png", picture.getvalue())
        plt.close(figure)
        gc.collect()  # matplotlib's reference cycles hold all callers' frames, and their samples


def read_curves(folder: Path) -> list[dict[str, float]]:
    """The rows of `<folder>/metrics.csv`; none where there is no such file.

    Raises `TrainingError` for another kind of file.
    """
    path = folder / "metrics.csv"
    if not path.is_file():
        return []
    try:
        with path.open(newline="") as file:
            rows = [{k: float(v) for k, v in row.items() if v} for row in csv.DictReader(file)]
        return [{**row, "step": int(row["step"]), "psnr": row["psnr"]} for row in rows]
    except (KeyError, TypeError, ValueError) as error:
        raise TrainingError(f"{path}: not the curves of rna-train: {error!r}") from error


_SHARE = 0.02  # of the time, for FLIP and pictures; those at the end come in any case
_USUAL_SECONDS = 1.0  # that they take


class Report:
    """Scores of a model against the validation images, and pictures beside them."""

    def __init__(self, dataset: DatasetPart, out: Path):
        self._views, self._out = dataset.validation_views(), out
        self._emission_views, self._white = dataset.emission_views(), dataset.white_view()
        self._pictured, self._seconds = monotonic(), _USUAL_SECONDS
        self.brightness: Brightness | None = None  # when the last pictures were made

    def of(self, model: NeuralAsset, is_last: bool) -> dict[str, float]:
        """A row of `Curves`; with FLIP, and pictures in `<out>/validation`, where time allows.

        Raises `TrainingError` for a model that gives no numbers.
        """
        views = self._views
        radiance = [shade(model, view) for view in views]
        row = {"psnr": mean_psnr(radiance, views)}
        if isnan(row["psnr"]):
            raise TrainingError(
                f"{self._out}: the model diverged, the PSNR of its validation images is not a "
                "number; try another --seed or --loss"
            )
        emitted = []
        if self._emission_views:
            emitted = [shade_emission(model, view) for view in self._emission_views]
            row["emission_psnr"] = mean_psnr(emitted, self._emission_views)
        begun = monotonic()
        if not is_last and self._seconds > _SHARE * (begun - self._pictured):
            return row
        glowing = list(zip(emitted, self._emission_views, strict=True))
        row["flip"] = worse_error(asset_error(radiance, views), glowing).mean
        if self._white is not None:
            returned = albedo([(shade(model, self._white), self._white)])
            row |= {} if returned is None else {"albedo": returned.ratio}
        self.brightness = brightness(
            (r, view.reference, view.visible) for r, view in zip(radiance, views, strict=True)
        )
        write_images(self._out / "validation", radiance, views)
        write_sheet(self._out / "sheet.png", radiance, views)
        if self._emission_views:
            write_images(self._out / "emission", emitted, self._emission_views)
        self._pictured = monotonic()
        self._seconds = self._pictured - begun
        return row
