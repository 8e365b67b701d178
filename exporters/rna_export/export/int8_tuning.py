"""Scales and biases of an int8 decoder, tuned until its radiance is the trained decoder's.

Rounding flattens what a decoder gives: bright samples come out darker, others brighter, and the
asset's brightness moves by up to some percent. Scales and biases bring it back. The integers of the
weights stay as they are, and with them the limit of their pairs.
"""

from dataclasses import dataclass, replace
from typing import Any

import torch
from torch import Tensor, nn

from rna_export.export.decoder import DecoderModel
from rna_export.export.int8_decoder import Int8Decoder, TorchInt8Layer, bias_steps, stored
from rna_export.training.optimization.losses import unbiased_l2

_STEPS, _BATCH, _RATE = 300, 2048, 1e-3


@dataclass(frozen=True)
class Calibration:
    """The decoder's queries at samples of the training data.

    Attributes:
        queries: (n, K) float32.
        weights: (n, outputs, 1 or 3) float32: of the decoder's outputs in the sample's radiance.
    """

    queries: Tensor
    weights: Tensor


def tuned(decoder: Int8Decoder, model: DecoderModel, calibration: Calibration) -> Int8Decoder:
    """The decoder, as close in radiance to the model's as scales and biases bring it.

    Trained for a few hundred steps with the unbiased loss, the model's radiance as its target.
    """
    with torch.no_grad():
        entered = decoder.entered(calibration.queries)
        target = _radiance(model, model.decoder(calibration.queries), calibration.weights)
    layers = [_TunedLayer(layer) for layer in decoder.layers]
    y_of = nn.Sequential(*layers)
    optimizer = torch.optim.Adam(y_of.parameters(), lr=_RATE)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, _STEPS)
    generator = torch.Generator().manual_seed(0)
    for _ in range(_STEPS):
        rows = torch.randint(len(entered), (_BATCH,), generator=generator)
        radiance = _radiance(model, y_of(entered[rows]), calibration.weights[rows])
        optimizer.zero_grad()
        unbiased_l2(torch.log1p(radiance / model.unit), target[rows], model.unit).backward()
        optimizer.step()
        schedule.step()
    return replace(decoder, layers=tuple(layer.rounded() for layer in layers))


def _radiance(model: DecoderModel, y: Tensor, weights: Tensor) -> Tensor:
    """(n, 3) of y (n, 3 colours)."""
    return (weights * model.transport(y.unflatten(1, (-1, 3)))).sum(dim=1)


class _TunedLayer(nn.Module):
    """An int8 layer whose scale and bias have gradients; from and to real values."""

    def __init__(self, layer: TorchInt8Layer):
        super().__init__()
        self._layer = layer
        self._weight = layer.weight.float().T
        self._step = layer.weight_scale * layer.input_scale
        self.log_gain = nn.Parameter(torch.zeros_like(self._step))
        self.bias = nn.Parameter(layer.bias * self._step)

    def forward(self, values: Tensor) -> Tensor:
        q: Tensor = _Stored.apply(values / self._layer.input_scale)  # type: ignore[no-untyped-call]
        return q @ self._weight * (self._step * self.log_gain.exp()) + self.bias

    @torch.no_grad()
    def rounded(self) -> TorchInt8Layer:
        """The layer with this scale and the closest integer bias."""
        scale = self._layer.weight_scale * self.log_gain.exp()
        bias = bias_steps(self.bias, scale * self._layer.input_scale)
        return replace(self._layer, weight_scale=scale, bias=bias)


class _Stored(torch.autograd.Function):
    """Rounding to uint8, with the gradient of clamping alone.

    Bengio et al., "Estimating or Propagating Gradients Through Stochastic Neurons for Conditional
    Computation", 2013.
    """

    @staticmethod
    def forward(ctx: Any, values: Tensor) -> Tensor:
        ctx.save_for_backward((values > 0.0) & (values < 255.0))
        return stored(values)

    @staticmethod
    def backward(ctx: Any, gradient: Tensor) -> Tensor:
        inside: Tensor
        (inside,) = ctx.saved_tensors
        return gradient * inside
