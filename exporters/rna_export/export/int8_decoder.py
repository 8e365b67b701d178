"""The decoder's layers in int8, calibrated on queries of the training data.

Activations are uint8, one scale a layer; weights int8, one scale an output; sums int32. Zero is
the smallest activation, so that storing one in uint8 is the ReLU, too. No two weights that an
engine may multiply as a pair can saturate 16 bits (`rna_sdk/package/decoder/saturation.py`).
"""

from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor, nn

from rna_sdk.package.decoder.saturation import PAIR_LIMIT, pair_sums

_CLIPS = torch.linspace(0.3, 1.0, 36)
"""Candidates for the end of a layer's range, as parts of its largest activation."""


@dataclass(frozen=True)
class TorchInt8Layer:
    """An int8 layer: sum = weight @ q + bias, in units of input_scale * weight_scale.

    Attributes:
        weight: (outputs, inputs) int8; inputs 2k and 2k + 1 of one sign add up to PAIR_LIMIT at
            most.
        weight_scale: (outputs,) float32.
        bias: (outputs,) int32.
        input_scale: what one step of the uint8 inputs q means.
    """

    weight: Tensor
    weight_scale: Tensor
    bias: Tensor
    input_scale: float

    def __call__(self, q: Tensor) -> Tensor:
        """Real-valued sums (n, outputs) for inputs q (n, inputs)."""
        sums = q.double() @ self.weight.double().T + self.bias
        return sums * (self.input_scale * self.weight_scale.double())


@dataclass(frozen=True)
class Int8Decoder:
    """The layers of a decoder; calling it is the twin, in PyTorch, of the exported graph.

    Attributes:
        gain, offset: (K,) float32; column x of the queries enters as uint8 x * gain + offset.
    """

    gain: Tensor
    offset: Tensor
    layers: tuple[TorchInt8Layer, ...]

    def entered(self, queries: Tensor) -> Tensor:
        """Queries (n, K) as the first layer has them, 0 to 255."""
        return stored(queries * self.gain + self.offset)

    def __call__(self, queries: Tensor) -> Tensor:
        """y as the model's decoder gives it, (n, outputs) float32, for queries (n, K)."""
        q = self.entered(queries)
        for layer, following in zip(self.layers, self.layers[1:], strict=False):
            q = stored(layer(q) / following.input_scale)
        return self.layers[-1](q).float()


def stored(steps: Tensor) -> Tensor:
    """Activations, in steps of their scale, as uint8 holds them: 0 to 255."""
    return steps.round().clamp(0, 255)


def _pair_scale(weight: Tensor) -> Tensor:
    """(outputs,), the smallest steps: no weight above 127, no pair of inputs above PAIR_LIMIT."""
    largest = weight.abs().amax(dim=1).clamp(min=1e-9)
    paired = torch.nn.functional.pad(weight, (0, weight.shape[1] % 2)).unflatten(1, (-1, 2))
    sums = torch.maximum(paired.clamp(min=0).sum(2), -paired.clamp(max=0).sum(2)).amax(dim=1)
    scale = torch.maximum(largest / 127.0, sums / PAIR_LIMIT)
    while (over := _pairs_over(weight, scale)).any():  # both of a pair were rounded up
        scale = torch.where(over, scale * (1 + 1 / PAIR_LIMIT), scale)
    return scale


def _pairs_over(weight: Tensor, scale: Tensor) -> Tensor:
    rounded = (weight / scale[:, None]).round().to(torch.int8)
    return torch.from_numpy((pair_sums(rounded.T.numpy()) > PAIR_LIMIT).any(axis=0))


@torch.no_grad()
def int8_decoder(decoder: nn.Sequential, queries: Tensor) -> Int8Decoder:
    """A decoder's layers in integers, with ranges that suit these queries, (n, K)."""
    linear = [layer for layer in decoder if isinstance(layer, nn.Linear)]
    weights = [layer.weight.detach().clone() for layer in linear]
    biases = [layer.bias.detach().clone() for layer in linear]
    _equalize(weights, biases, queries)
    expected = _sums(weights, biases, queries)
    low, high = queries.amin(dim=0), queries.amax(dim=0)
    step = (high - low).clamp(min=1e-6) / 255.0
    gain, offset = 1.0 / step, -low / step
    # In steps above `low`, which the bias takes up: q = (x - low) / step.
    biases[0] = biases[0] + weights[0] @ low
    weights[0] = weights[0] * step
    q, scale = stored(queries * gain + offset), 1.0
    layers = []
    for weight, bias, exact in zip(weights, biases, expected, strict=True):
        layers.append(_layer(weight, _pair_scale(weight), bias, scale, q, exact))
        sums = layers[-1](q).float()
        scale = _scale(torch.relu(sums))
        q = stored(sums / scale)
    return Int8Decoder(gain, offset, tuple(layers))


def _sums(weights: list[Tensor], biases: list[Tensor], queries: Tensor) -> list[Tensor]:
    """Sums of each layer before its ReLU, (n, outputs)."""
    values, every = queries, []
    for weight, bias in zip(weights, biases, strict=True):
        every.append(values @ weight.T + bias)
        values = torch.relu(every[-1])
    return every


def _equalize(weights: list[Tensor], biases: list[Tensor], queries: Tensor) -> None:
    """Scale neurons so that one range fits the activations of a whole layer.

    ReLU lets a positive factor through, so the function stays the same (Nagel et al. 2019,
    Data-Free Quantization Through Weight Equalization and Bias Correction).
    """
    for k, sums in enumerate(_sums(weights, biases, queries)[:-1]):
        reach = sums.amax(dim=0).clamp(min=0.0)
        # A neuron that hardly fires on these queries may do so on others.
        factor = reach.clamp(min=max(0.1 * float(reach.mean()), 1e-6))
        weights[k] /= factor[:, None]
        biases[k] /= factor
        weights[k + 1] *= factor


def _scale(values: Tensor) -> float:
    """The step with which uint8 holds these activations with the least squared error."""
    sample, largest = values.flatten()[::7], max(float(values.max()), 1e-6)
    steps = largest * _CLIPS / 255.0
    errors = [(((sample / s).round().clamp(max=255.0) * s - sample) ** 2).mean() for s in steps]
    return float(steps[int(torch.stack(errors).argmin())])


def _layer(
    weight: Tensor, scale: Tensor, bias: Tensor, input_scale: float, q: Tensor, expected: Tensor
) -> TorchInt8Layer:
    """The layer for inputs q (n, inputs), in steps of `input_scale`; weights in steps of `scale`.

    expected: its sums (n, outputs) in the trained decoder. The bias makes their means equal, so
    that rounding, here and in the layers before, moves no output as a whole.
    """
    rounded = (weight / scale[:, None]).round()
    moved = expected.mean(dim=0) - (q @ rounded.T * (scale * input_scale) + bias).mean(dim=0)
    steps = bias_steps(bias + moved, scale * input_scale)
    return TorchInt8Layer(rounded.to(torch.int8), scale, steps, input_scale)


def bias_steps(bias: Tensor, step: Tensor) -> Tensor:
    """A layer's bias (outputs,) in int32, each in steps of `step`."""
    limit = np.iinfo(np.int32).max // 2
    return (bias.double() / step.double()).round().clamp(-limit, limit).to(torch.int32)
