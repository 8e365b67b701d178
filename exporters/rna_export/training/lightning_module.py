"""The training loop's parts that Lightning calls."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import lightning
import torch
from torch import Tensor

from rna_export.capture.validation_view import EmissionView, ValidationView
from rna_export.training.emission_batches import EmissionBatches
from rna_export.training.losses import sample_loss
from rna_export.training.model import NeuralAsset
from rna_export.training.pace import Pace, StepPace
from rna_export.training.presets import Preset
from rna_export.training.samples import columns
from rna_export.training.validation import score, shade, shade_emission, write_images


class NeuralAssetTraining(lightning.LightningModule):
    """Fits a `NeuralAsset`; the loss sees only the output that matches the visibility."""

    def __init__(
        self,
        preset: Preset,
        bounds: Tensor,
        ceiling: float,
        unit: float,
        pace: Pace,
        fields: dict[str, int],
        views: list[ValidationView],
        out: Path,
        record: dict[str, Any],
        emission: EmissionBatches | None = None,
        emission_views: list[EmissionView] | None = None,
    ):
        super().__init__()
        self.save_hyperparameters({"preset": preset.model_dump(mode="json"), **record})
        self.model = NeuralAsset(preset.model, bounds)
        self.model.ceiling.fill_(ceiling)
        self.model.unit.fill_(unit)
        self._config, self._pace, self._fields = preset.training, pace, fields
        self._views, self._out = views, out
        self._emission, self._emission_views = emission, emission_views or []
        if emission is not None:
            self.model.emission.ceiling.fill_(1.5 * emission.table.largest_radiance)
            self.model.emission.unit.fill_(emission.table.usual_radiance)

    @property
    def progress(self) -> float:
        """How much of the run is done, 0 to 1."""
        return self._pace.progress(self.global_step)

    def on_save_checkpoint(self, checkpoint: dict[str, Any]) -> None:
        """Add how far a run is whose steps are not known before its end."""
        if not isinstance(self._pace, StepPace):
            checkpoint["pace"] = self._pace.state()
            checkpoint["hyper_parameters"]["steps"] = self.global_step

    def training_step(self, rows: Tensor, _: int) -> Tensor:
        # From `blur` texels to 1 over the first fifth: the paper, section 4.2.
        blur = 1.0 + (self._config.blur - 1.0) * max(0.0, 1.0 - 5.0 * self.progress)
        at = columns(rows, self._fields)
        loss = sample_loss(self.model, at, blur, self._config.loss)
        self.log("loss", loss)
        if self._emission is None:
            return loss
        of_emission = self._emission.loss(self.model.emission, self.model.triplane, blur)
        self.log("emission_loss", of_emission)
        return loss + of_emission

    def validation_step(self, *_: object) -> None:
        radiance = [shade(self.model, view) for view in self._views]
        scores = score(radiance, self._views)
        for name in ("psnr", "flip", "relative_mse"):
            self.log(name, getattr(scores, name), prog_bar=name == "psnr", batch_size=1)
        write_images(self._out / "validation", radiance, self._views)
        if self._emission_views:
            emitted = [shade_emission(self.model, view) for view in self._emission_views]
            self.log("emission_psnr", score(emitted, self._emission_views).psnr, batch_size=1)
            write_images(self._out / "emission", emitted, self._emission_views)

    def configure_optimizers(self) -> dict[str, Any]:
        config = self._config
        groups = [
            {"params": self.model.decoder.parameters(), "lr": config.learning_rate},
            {"params": self.model.triplane.parameters(), "lr": config.plane_learning_rate},
        ]
        if self.model.emission is not None:
            of_emission = self.model.emission.parameters()
            groups.append({"params": of_emission, "lr": config.learning_rate})
        optimizer = torch.optim.Adam(groups, fused=True)
        rate = torch.optim.lr_scheduler.LambdaLR(optimizer, self._rate)
        return {"optimizer": optimizer, "lr_scheduler": {"scheduler": rate, "interval": "step"}}

    def _rate(self, step: int) -> float:
        progress = self._pace.progress(step)
        if self._config.schedule == "halving":
            return 0.5 ** min(int(5.0 * progress), 4)
        return 0.5 * (1.0 + math.cos(math.pi * progress)) + 1e-3
