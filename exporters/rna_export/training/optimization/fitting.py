"""A model and its optimizers: what a step of training does."""

from __future__ import annotations

import math
from typing import Any

import torch
from torch import Tensor

from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.model.triplane import Triplane
from rna_export.training.optimization.emission_batches import EmissionBatches
from rna_export.training.optimization.losses import sample_loss
from rna_export.training.optimization.plane_adam import PlaneAdam
from rna_export.training.optimization.samples import columns
from rna_export.training.presets import Preset, TrainingConfig
from rna_sdk.cpu import multiplies_bfloat16

_SMOOTHED_TOGETHER = 16  # steps
_WIDE = 128  # neurons, from where bfloat16 is faster


class Fitting:
    """Fits a `NeuralAsset`; the loss sees only the output that matches the visibility.

    bounds: (2, 3) of the planes. ceiling, unit: see `NeuralAsset`. fields: of the batches' rows,
    see `SampleTable`. emission: batches of what the asset emits, if it does.
    """

    def __init__(
        self,
        preset: Preset,
        bounds: Tensor,
        ceiling: float,
        unit: float,
        fields: dict[str, int],
        emission: EmissionBatches | None = None,
        device: str = "cpu",
    ):
        self._config, self._fields, self._emission = preset.training, fields, emission
        self.model = NeuralAsset(preset.model, bounds)
        self.model.ceiling.fill_(ceiling)
        self.model.unit.fill_(unit)
        if emission is not None:
            emitting, _ = self.model.emitting
            emitting.ceiling.fill_(1.5 * emission.table.largest_radiance)
            emitting.unit.fill_(emission.table.usual_radiance)
        self.model.to(device)
        self.model.multiplies_in_bfloat16 = multiplies_in_bfloat16(preset, device)
        self._optimizers = _optimizers(self.model, preset.training)
        self._first_rates = [o.param_groups[0]["lr"] for o in self._optimizers]

    def step(self, rows: Tensor, progress: float) -> Tensor:
        """One step on a batch of rows (n, columns); returns the loss, still on the device.

        progress: how much of the run is done, 0 to 1.
        """
        for optimizer, first in zip(self._optimizers, self._first_rates, strict=True):
            optimizer.param_groups[0]["lr"] = first * rate(self._config, progress)
        loss = self.loss(rows, progress)
        loss.backward()
        for optimizer in self._optimizers:
            optimizer.step()
            optimizer.zero_grad()
        self._smooth()
        return loss.detach()

    def _smooth(self) -> None:
        """Diffusion of planes, several steps' worth at a time: it passes over all texels."""
        planes = self.model.triplane
        if not (self._config.smoothing and isinstance(planes, Triplane)):
            return
        of_decoders, of_features = self._optimizers
        steps = int(next(iter(of_decoders.state.values()))["step"])
        if steps % _SMOOTHED_TOGETHER == 0:
            share = self._config.smoothing * of_features.param_groups[0]["lr"] * _SMOOTHED_TOGETHER
            planes.smooth(min(share, 0.25))

    @property
    def learning_rate(self) -> float:
        """Learning rate of the decoder in the last step."""
        return float(self._optimizers[0].param_groups[0]["lr"])

    def loss(self, rows: Tensor, progress: float) -> Tensor:
        """Loss of a batch, plus that of the next emission batch."""
        # From `blur` texels to 1 over the first fifth: the paper, section 4.2.
        blur = 1.0 + (self._config.blur - 1.0) * max(0.0, 1.0 - 5.0 * progress)
        at = columns(rows, self._fields)
        is_ending = progress >= 1.0 - self._config.unbiased_share
        kind = "unbiased" if is_ending else self._config.loss
        loss = sample_loss(self.model, at, blur, kind, self._config.shadow_weight)
        if self._emission is None:
            return loss
        return loss + self._emission.loss(*self.model.emitting, blur)

    def state(self) -> dict[str, Any]:
        """State of model and optimizers for a checkpoint."""
        return {
            "model": self.model.state_dict(),
            "optimizers": [optimizer.state_dict() for optimizer in self._optimizers],
        }

    def load(self, state: dict[str, Any]) -> None:
        """Go on from a `state`."""
        self.model.load_state_dict(state["model"])
        for optimizer, saved in zip(self._optimizers, state["optimizers"], strict=True):
            optimizer.load_state_dict(saved)


def multiplies_in_bfloat16(preset: Preset, device: str) -> bool:
    """What `TrainingConfig.products` comes to here."""
    wide = preset.model.width >= _WIDE
    return preset.training.products == "auto" and wide and device == "cpu" and multiplies_bfloat16()


def rate(config: TrainingConfig, progress: float) -> float:
    """Learning rate over that of the start."""
    if config.schedule == "halving":
        return 0.5 ** min(int(5.0 * progress), 4)
    return 0.5 * (1.0 + math.cos(math.pi * progress)) + 1e-3


def _optimizers(model: NeuralAsset, config: TrainingConfig) -> list[torch.optim.Optimizer]:
    """Optimizers of the decoders and of the features."""
    decoders = [*model.decoder.parameters()]
    if model.emission is not None:
        decoders += model.emission.parameters()
    of_decoders = torch.optim.Adam(decoders, lr=config.learning_rate, fused=True)
    features = [*model.triplane.parameters()]
    if isinstance(model.triplane, Triplane) and features[0].device.type == "cpu":
        return [of_decoders, PlaneAdam(features[0], lr=config.plane_learning_rate)]
    of_features = torch.optim.Adam(features, lr=config.plane_learning_rate, fused=True)
    return [of_decoders, of_features]
