"""Decoders of the kit: random layers, in float32 or in int8, their float64 reading, their file."""

from dataclasses import dataclass

import numpy as np

from rna_sdk.package.decoder.decoder_form import FORMS
from rna_sdk.package.decoder.decoder_writer import decoder_to_bytes
from rna_sdk.package.decoder.profile_decoder import ProfileDecoder, ProfileLayer

LARGEST_INPUT = 65504.0
OUTPUTS = {form.name: form.width(None) for form in FORMS}
TOP = 5.0  # the largest log of a colour
UNIT = 0.05  # what a log near 0 counts in


def short(values: np.ndarray, bits: int = 12) -> np.ndarray:
    """Rounded to so many bits, in float32: products of two are exact, and hardly any difference
    between two machines' libraries shows in the file."""
    fraction, exponent = np.frexp(np.asarray(values, np.float64))
    return np.ldexp(np.round(fraction * 2.0**bits), exponent - bits).astype(np.float32)


@dataclass(frozen=True)
class Layer:
    """A layer of float32: weight (inputs, outputs), bias (outputs,)."""

    weight: np.ndarray
    bias: np.ndarray


@dataclass(frozen=True)
class KitInt8Layer:
    """weight (inputs, outputs) int8, scale (outputs,) float32, bias (outputs,) int32, in units of
    input_scale * scale; input_scale: what a step of the uint8 inputs means."""

    weight: np.ndarray
    scale: np.ndarray
    bias: np.ndarray
    input_scale: np.float32


@dataclass(frozen=True)
class Decoder:
    """Float64 reading and file of the same numbers.

    ends: what the last layer's outputs become colours by: a factor, or a matrix (outputs, width).
    output: of OUTPUTS.
    """

    layers: list[Layer]
    ends: np.ndarray
    output: str = "transport"

    def __call__(self, blocks: np.ndarray) -> np.ndarray:
        """(n, width) float64 for blocks (n, K) float64."""
        x = np.clip(blocks, -LARGEST_INPUT, LARGEST_INPUT)
        for k, layer in enumerate(self.layers):
            x = np.maximum(x, 0) if k else x
            x = _product(x, layer.weight) + layer.bias.astype(np.float64)
        return _closed(x, self.ends)

    def file(self) -> bytes:
        last = self.layers[-1]
        layers = [ProfileLayer(a.weight, a.bias, 0.0, None, a is not last) for a in self.layers]
        return _file(layers, self.ends, self.output)


@dataclass(frozen=True)
class Int8Decoder:
    """The like in int8; gain and offset (K,) float32 make the columns of the blocks steps."""

    gain: np.ndarray
    offset: np.ndarray
    layers: list[KitInt8Layer]
    ends: np.ndarray
    output: str = "transport"

    def __call__(self, blocks: np.ndarray) -> np.ndarray:
        return self.from_steps(self.steps(blocks))

    def steps(self, blocks: np.ndarray) -> np.ndarray:
        """What the first layer multiplies, (n, K) of whole numbers from 0 to 255."""
        x = np.clip(blocks, -LARGEST_INPUT, LARGEST_INPUT)
        x = x * self.gain.astype(np.float64) + self.offset.astype(np.float64)
        return _quantized(x, self.layers[0])

    def from_steps(self, steps: np.ndarray, first: int = 0) -> np.ndarray:
        """(n, 6) for the inputs of a layer; every sum is one of whole numbers, and exact."""
        x = _sums(steps, self.layers[first])
        for layer in self.layers[first + 1 :]:
            x = _sums(_quantized(x, layer), layer)
        return _closed(x, self.ends)

    def largest_step(self, blocks: np.ndarray) -> np.ndarray:
        """(n,) the most that one step of one activation, of any layer, changes an output."""
        steps, result = self.steps(blocks), np.zeros(len(blocks))
        expected = self.from_steps(steps)
        for k, layer in enumerate(self.layers):
            for column in range(steps.shape[1]):
                for move in (-1, 1):
                    moved = steps.copy()
                    moved[:, column] = np.clip(moved[:, column] + move, 0, 255)
                    change = np.abs(self.from_steps(moved, k) - expected).max(axis=1)
                    result = np.maximum(result, change)
            if k + 1 < len(self.layers):
                steps = _quantized(_sums(steps, layer), self.layers[k + 1])
        return result

    def file(self) -> bytes:
        layers = [
            ProfileLayer(a.weight, a.bias, float(a.input_scale), a.scale, False)
            for a in self.layers
        ]
        return _file(layers, self.ends, self.output, self.gain, self.offset)


def make_decoder(
    rng: np.random.Generator,
    blocks: np.ndarray,
    widths: tuple[int, ...],
    mixing: int = 0,
    first: np.ndarray | None = None,
    output: str = "transport",
    colours: int = 0,
) -> Decoder:
    """Random layers whose outputs on these (n, K) blocks are colours of 0.02 to 2 or so.

    mixing: outputs of the last layer that a matrix makes the colours of; 0 for none. first:
    (K, outputs), the first layer's weights up to a factor an output. colours: columns of the
    output, where its name does not say so.
    """
    colours = colours or OUTPUTS[output]
    sizes, layers, x = [blocks.shape[1], *widths, mixing or colours], [], blocks
    spread = blocks.std(axis=0)
    spread = np.where(spread > 1e-6, spread, 1)
    for k in range(len(sizes) - 1):
        weight = rng.uniform(-1, 1, (sizes[k], sizes[k + 1]))
        if k == 0:  # as if all columns had the same deviation
            weight = weight / spread[:, None] if first is None else first
        last = k == len(sizes) - 2
        deviation, mean = (0.5, 1.7) if last else (1.0, 0.3)
        weight = short(weight * (deviation / (x @ weight).std(axis=0)))
        layers.append(Layer(weight, short(mean - (x @ weight).mean(axis=0))))
        x = np.maximum(x @ layers[-1].weight + layers[-1].bias, 0)
    ends = _mixing(rng, mixing, colours) if mixing else np.float32(UNIT)
    return Decoder(layers, ends, output)


def make_int8_decoder(decoder: Decoder, blocks: np.ndarray, largest: int = 64) -> Int8Decoder:
    """The decoder in integers, calibrated on blocks (n, K); weights to +-largest.

    Up to 64, the products of two weights with uint8 add up to less than 2^15.
    """
    gain, offset = entry_steps(blocks)
    weights = [layer.weight.astype(np.float64) for layer in decoder.layers]
    biases = [layer.bias.astype(np.float64) for layer in decoder.layers]
    weights[0] = weights[0] / gain[:, None]
    biases[0] = biases[0] - offset @ weights[0]
    layers: list[KitInt8Layer] = []
    scale, x = np.float32(1), blocks * gain + offset
    for weight, bias in zip(weights, biases, strict=True):
        weight_scale = short(np.abs(weight).max(axis=0) / largest)
        steps = np.clip(np.round(weight / weight_scale), -largest, largest).astype(np.int8)
        unit = np.float64(scale) * weight_scale
        layers.append(
            KitInt8Layer(steps, weight_scale, np.round(bias / unit).astype(np.int32), scale)
        )
        x = _sums(_quantized(x, layers[-1]), layers[-1])
        scale = np.float32(short(np.maximum(x, 0).max() / 255.0))
    return Int8Decoder(gain, offset, layers, decoder.ends, decoder.output)


def entry_steps(blocks: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Gain and offset, (K,) float32, that spread the columns of blocks over 0 to 255."""
    low, high = np.percentile(blocks, [1, 99], axis=0)
    gain = short(255.0 / np.maximum(high - low, 0.05))
    return gain, short(-low * gain)


def saturating_weights(rng: np.random.Generator, blocks: np.ndarray, outputs: int) -> np.ndarray:
    """First layer (K, outputs) for `make_decoder`: in int8 at 127, all are +-127, in pairs.

    Of two neighbours of one sign and two large activations the products add up to more than
    2^15: an engine that adds pairs in 16 bits is wrong.
    """
    gain, _ = entry_steps(blocks)
    signs = np.repeat(rng.choice([-1.0, 1.0], ((len(gain) + 1) // 2, outputs)), 2, axis=0)
    return signs[: len(gain)] * gain[:, None]


def _mixing(rng: np.random.Generator, outputs: int, colours: int) -> np.ndarray:
    """(outputs, colours), of 6 and 6 as exporters have it: from a sum and a part of the other."""
    if outputs == colours == 6:
        return short(np.kron([[1.0, 0.25], [0.5, 1.0]], np.eye(3)) * UNIT)
    return short(rng.uniform(0, 0.5, (outputs, colours)) * UNIT)


def _product(x: np.ndarray, weight: np.ndarray) -> np.ndarray:
    return x @ weight.astype(np.float64)


def _sums(steps: np.ndarray, layer: KitInt8Layer) -> np.ndarray:
    unit = np.float64(layer.input_scale) * layer.scale
    return (_product(steps, layer.weight) + layer.bias) * unit


def _quantized(x: np.ndarray, layer: KitInt8Layer) -> np.ndarray:
    return np.clip(np.rint(x / np.float64(layer.input_scale)), 0, 255)


def _closed(x: np.ndarray, ends: np.ndarray) -> np.ndarray:
    colours = np.exp(np.clip(x, 0.0, TOP)) - 1.0
    wide = ends.astype(np.float64)
    return colours @ wide if wide.ndim else colours * wide


def _file(
    layers: list[ProfileLayer],
    ends: np.ndarray,
    output: str,
    gain: np.ndarray | None = None,
    offset: np.ndarray | None = None,
) -> bytes:
    """The decoder's file; gain, offset: of int8."""
    limits, has_matrix = (-LARGEST_INPUT, LARGEST_INPUT), np.ndim(ends) > 0
    unit, matrix = (1.0, ends) if has_matrix else (float(ends), None)
    decoder = ProfileDecoder(*limits, gain, offset, tuple(layers), TOP, unit, matrix, output)
    return decoder_to_bytes(decoder, "rna-conformance")
