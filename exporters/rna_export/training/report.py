"""Validation during training: metrics and written files."""

from __future__ import annotations

from math import isnan
from pathlib import Path
from time import monotonic

from rna_export.brightness import Brightness, brightness
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.validation import (
    mean_flip,
    mean_psnr,
    shade,
    shade_emission,
    write_images,
    write_sheet,
)
from rna_sdk.errors import TrainingError

_SHARE = 0.02  # of the time, for FLIP and pictures; those at the end come in any case
_USUAL_SECONDS = 1.0  # that they take


class Report:
    """Scores of a model against the validation images, and pictures beside them."""

    def __init__(self, dataset: DatasetPart, out: Path):
        self._views, self._out = dataset.validation_views(), out
        self._emission_views = dataset.emission_views()
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
        if self._emission_views:
            emitted = [shade_emission(model, view) for view in self._emission_views]
            row["emission_psnr"] = mean_psnr(emitted, self._emission_views)
        begun = monotonic()
        if not is_last and self._seconds > _SHARE * (begun - self._pictured):
            return row
        row["flip"] = mean_flip(radiance, views)
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
