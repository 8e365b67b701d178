"""A model and its optimizers: a step of training."""

import math
from typing import Any

import torch
from torch import Tensor

from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.model.shadow import RELATIVE_UNIT
from rna_export.training.optimization.emission_batches import EmissionBatches
from rna_export.training.optimization.losses import sample_loss
from rna_export.training.optimization.muon import Muon
from rna_export.training.optimization.optimizers import load_states, optimizers_of, set_rates
from rna_export.training.optimization.samples import columns
from rna_export.training.optimization.step_graphs import StepGraphs
from rna_export.training.presets import Preset, TrainingConfig
from rna_sdk.machine.cpu import multiplies_bfloat16

_SMOOTHED_TOGETHER = 16  # steps
_WIDE = 128  # neurons, from where bfloat16 is faster


class Fitting:
    """Fits a `NeuralAsset`; the loss sees only the output that matches the visibility.

    bounds: (2, 3) of the planes. ceiling, unit: see `NeuralAsset`. fields: of the batches' rows,
    see `SampleTable`. emission: batches of what the asset emits, if it does. model_class: of the
    model. lit: see `SampleTable`; read where shadowed light has a decoder of its own.
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
        model_class: type[NeuralAsset] = NeuralAsset,
        lit: int | None = None,
    ):
        self._config, self._fields, self._emission = preset.training, fields, emission
        self.model = model_class(preset.model, bounds)
        self.lit = None if self.model.shadow is None else lit
        self.model.ceiling.fill_(ceiling)
        self.model.unit.fill_(unit)
        if self.model.shadow is not None:
            self.model.shadow.unit.fill_(RELATIVE_UNIT * unit)
        if emission is not None:
            emitting, _ = self.model.emitting
            emitting.ceiling.fill_(1.5 * emission.table.largest_radiance)
            emitting.unit.fill_(emission.table.usual_radiance)
        self.model.to(device)
        self.model.multiplies_in_bfloat16 = multiplies_in_bfloat16(preset, device)
        self._optimizers = optimizers_of(self.model, preset.training)
        self._done = 0  # steps
        is_cuda = device == "cuda"
        self._graphs = StepGraphs(self._descend) if is_cuda else None
        # Of the blur, in texels; what a graph reads is a tensor.
        self._footprint: float | Tensor = torch.ones((), device=device) if is_cuda else 1.0

    def step(self, rows: Tensor, progress: float) -> Tensor:
        """One step on a batch of rows (n, columns); returns the loss, still on the device.

        progress: how much of the run is done, 0 to 1.
        """
        factor = rate(self._config, progress)
        set_rates(self._optimizers, factor)
        is_ending = progress >= 1.0 - self._config.unbiased_share
        kind = "unbiased" if is_ending else self._config.loss, self._blur(progress)
        batches = [rows] if self._emission is None else [rows, next(self._emission.rows)]
        run = self._descend if self._graphs is None else self._graphs.run
        loss = run(kind, *batches)
        self._done += 1
        self._smooth(factor)
        return loss

    def _blur(self, progress: float) -> bool:
        """Set the footprint of the blur; whether there is any.

        It falls from the preset's to 1 over the first fifth: the paper, section 4.2.
        """
        footprint = 1.0 + (self._config.blur - 1.0) * max(0.0, 1.0 - 5.0 * progress)
        if isinstance(self._footprint, Tensor):
            self._footprint.fill_(footprint)
        else:
            self._footprint = footprint
        return footprint > 1.0

    def _descend(
        self, kind: tuple[str, bool], rows: Tensor, emission_rows: Tensor | None = None
    ) -> Tensor:
        """A step of all optimizers down the gradient of the batches' loss, which it returns.

        kind: the loss of transport, and whether planes are blurred.
        """
        name, is_blurred = kind
        blur, weight = self._footprint if is_blurred else 1.0, self._config.shadow_weight
        at = columns(rows, self._fields)
        loss = sample_loss(self.model, at, blur, name, weight, self.lit)
        if self._emission is not None and emission_rows is not None:
            loss = loss + self._emission.loss(emission_rows, *self.model.emitting, blur)
        loss.backward()
        for optimizer in self._optimizers:
            optimizer.step()
            optimizer.zero_grad()
        return loss.detach()

    def _smooth(self, factor: float) -> None:
        """Diffusion of planes, several steps' worth at a time: it passes over all texels."""
        config = self._config
        if config.smoothing and self._done % _SMOOTHED_TOGETHER == 0:
            share = config.smoothing * config.plane_learning_rate * factor * _SMOOTHED_TOGETHER
            self.model.triplane.smooth(min(share, 0.25))

    def stacks(self) -> list[Tensor]:
        """Like those of matrices that a step orthogonalises: see `Muon`."""
        return [s for o in self._optimizers if isinstance(o, Muon) for s in o.stacks()]

    def state(self) -> dict[str, Any]:
        """State of model and optimizers for a checkpoint."""
        return {
            "model": self.model.state_dict(),
            "optimizers": [optimizer.state_dict() for optimizer in self._optimizers],
            "steps": self._done,
        }

    def start_from(self, model: NeuralAsset) -> None:
        """Take over the weights of a trained model that have a place of the same shape here."""
        found = dict(model.named_parameters())
        with torch.no_grad():
            for name, values in self.model.named_parameters():
                if name in found and found[name].shape == values.shape:
                    values.copy_(found[name])

    def load(self, state: dict[str, Any]) -> None:
        """Go on from a `state`."""
        self.model.load_state_dict(state["model"])
        load_states(self._optimizers, state["optimizers"])
        self._done = state["steps"]


def multiplies_in_bfloat16(preset: Preset, device: str) -> bool:
    """Whether wide layers multiply in bfloat16 there: see `TrainingConfig.products`."""
    if preset.training.products == "float32" or preset.model.width < _WIDE:
        return False
    return torch.cuda.is_bf16_supported() if device == "cuda" else multiplies_bfloat16()


def rate(config: TrainingConfig, progress: float) -> float:
    """Learning rate over the initial rate."""
    if config.schedule == "halving":
        return 0.5 ** min(int(5.0 * progress), 4)
    return 0.5 * (1.0 + math.cos(math.pi * progress)) + 1e-3
