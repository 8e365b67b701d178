"""The training loop's parts that Lightning calls."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import lightning
import torch
from torch import Tensor

from rna_export.capture.validation_view import ValidationView
from rna_export.training.losses import sample_loss
from rna_export.training.model import NeuralAsset
from rna_export.training.pace import Pace, StepPace
from rna_export.training.presets import Preset
from rna_export.training.samples import columns
from rna_export.training.validation import score, shade, write_images


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
    ):
        super().__init__()
        self.save_hyperparameters({"preset": preset.model_dump(mode="json"), **record})
        self.model = NeuralAsset(preset.model, bounds)
        self.model.ceiling.fill_(ceiling)
        self.model.unit.fill_(unit)
        self._config, self._pace, self._fields = preset.training, pace, fields
        self._views, self._out = views, out

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
        return loss

    def validation_step(self, *_: object) -> None:
        radiance = [shade(self.model, view) for view in self._views]
        scores = score(radiance, self._views)
        for name in ("psnr", "flip", "relative_mse"):
            self.log(name, getattr(scores, name), prog_bar=name == "psnr", batch_size=1)
        write_images(self._out / "validation", radiance, self._views)

    def configure_optimizers(self) -> dict[str, Any]:
        config = self._config
        groups = [
            {"params": self.model.decoder.parameters(), "lr": config.learning_rate},
            {"params": self.model.triplane.parameters(), "lr": config.plane_learning_rate},
        ]
        optimizer = torch.optim.Adam(groups, fused=True)
        rate = torch.optim.lr_scheduler.LambdaLR(optimizer, self._rate)
        return {"optimizer": optimizer, "lr_scheduler": {"scheduler": rate, "interval": "step"}}

    def _rate(self, step: int) -> float:
        progress = self._pace.progress(step)
        if self._config.schedule == "halving":
            return 0.5 ** min(int(5.0 * progress), 4)
        return 0.5 * (1.0 + math.cos(math.pi * progress)) + 1e-3
