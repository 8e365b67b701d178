"""The decoder as an ONNX graph (spec/RNA.md, Decoder), and the check that it is the trained one."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
import onnxruntime
import torch
from torch import Tensor

from rna_export.export.int8_decoder import Int8Decoder
from rna_export.training.model.inputs import Points, assemble, in_box
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.model.shadow import ShadowDecoder
from rna_export.training.model.triplane import Triplane
from rna_sdk.errors import ExportError
from rna_sdk.package import Agreement, ProfileDecoder, ProfileLayer, decoder_to_bytes
from rna_sdk.package.decoder.decoder_form import EMISSION, SHADOWED, TRANSPORT, VISIBLE
from rna_sdk.runtime.engine.agreement import ABSOLUTE, RELATIVE, TIES, close_rows

LARGEST_INPUT = 65504.0  # keeps sums finite whatever is asked
_RANDOM_QUERIES = 20_000
_FAR = 10.0  # factor on extreme queries and positions


class Answering(Protocol):
    """A model that is exported: an MLP that gives y = log(x / unit + 1) of sums of outputs."""

    @property
    def output(self) -> str: ...

    @property
    def colour_sums(self) -> tuple[tuple[int, ...], ...]: ...

    @property
    def decoder(self) -> torch.nn.Sequential: ...

    @property
    def unit(self) -> Tensor: ...

    @property
    def ceiling(self) -> Tensor: ...

    def transport(self, y: Tensor) -> Tensor: ...


@dataclass(frozen=True, eq=False)
class DecoderModel:
    """A decoder of a model, in the form in which the functions below take one.

    Attributes:
        output: name of its form.
        inputs: its input blocks.
        triplane: the planes that it reads.
        decoder: its layers.
        colour_sums: weights of the colours that it gives, in each of its outputs.
        unit, ceiling: see `NeuralAsset`.
    """

    output: str
    inputs: tuple[str, ...]
    triplane: Triplane
    decoder: torch.nn.Sequential
    colour_sums: tuple[tuple[int, ...], ...]
    unit: Tensor
    ceiling: Tensor

    def queries(self, at: Points) -> Tensor:
        """The decoder's queries, (k, K)."""
        grid = self.triplane
        p = in_box(at["position"], grid.low, grid.high)
        return assemble(self.inputs, grid(at["position"]), p, at)

    def transport(self, y: Tensor) -> Tensor:
        """Its outputs, (k, outputs, 3), from y = log(x / unit + 1) of its colours."""
        highest = torch.log1p(self.ceiling / self.unit)
        colours = self.unit * torch.expm1(y.clamp(min=0.0).minimum(highest))
        sums = torch.tensor(self.colour_sums, dtype=y.dtype, device=y.device)
        return torch.einsum("sc,kcr->ksr", sums, colours)


def decoders_of(model: NeuralAsset) -> list[DecoderModel]:
    """The decoders of a model; the first is for transport, or for visible light."""
    config, triplane = model.config, model.triplane
    assert isinstance(triplane, Triplane)
    terms = np.eye(2 if config.uses_base_color else 1, dtype=int)

    def of(
        output: str, owner: NeuralAsset | ShadowDecoder, sums: Sequence[Sequence[int]]
    ) -> DecoderModel:
        inputs = config.inputs if isinstance(owner, NeuralAsset) else owner.inputs
        # Of nearby light, those that count it: the last ones.
        counting = np.array(sums)[:, -min(len(sums), len(sums[0])) :]
        sets = [np.kron(terms, of_set) for of_set in (sums, *[counting] * len(config.nearby))]
        both = tuple(map(tuple, torch.block_diag(*map(torch.tensor, sets)).tolist()))
        return DecoderModel(
            output, inputs, triplane, owner.decoder, both, owner.unit, model.ceiling
        )

    visible, shadowed = config.colour_sums
    if model.shadow is None:
        models = [of(TRANSPORT.name, model, (visible, shadowed))]
    else:
        models = [
            of(VISIBLE.name, model, (visible[:-1],)),
            of(SHADOWED.name, model.shadow, ((1,),)),
        ]
    if model.emission is not None:
        emission, planes = model.emitting
        models.append(
            DecoderModel(
                *(EMISSION.name, emission.inputs, planes, emission.decoder),
                *(((1,),), emission.unit, emission.ceiling),
            )
        )
    return models


def export_decoder(model: Answering, int8: Int8Decoder | None = None) -> bytes:
    """The ONNX file of the model's decoder.

    int8: the model's layers in integers, to be written in place of its own.
    """
    sums, unit, matrix = np.array(model.colour_sums), float(model.unit), None
    if not np.array_equal(sums, np.eye(len(sums))):
        unit, matrix = 1.0, (unit * np.kron(sums.T, np.eye(3))).astype(np.float32)
    decoder = ProfileDecoder(
        low=-LARGEST_INPUT,
        high=LARGEST_INPUT,
        gain=None if int8 is None else int8.gain.numpy(),
        offset=None if int8 is None else int8.offset.numpy(),
        layers=_float_layers(model) if int8 is None else _int8_layers(int8),
        top=float(torch.log1p(model.ceiling / model.unit)),
        unit=unit,
        matrix=matrix,
        output=model.output,
    )
    return decoder_to_bytes(decoder, "rna-export")


def _float_layers(model: Answering) -> tuple[ProfileLayer, ...]:
    linear = [layer for layer in model.decoder if isinstance(layer, torch.nn.Linear)]
    return tuple(
        ProfileLayer(
            layer.weight.detach().numpy().T,
            layer.bias.detach().numpy(),
            step=0.0,
            scale=None,
            relu=layer is not linear[-1],
        )
        for layer in linear
    )


def _int8_layers(int8: Int8Decoder) -> tuple[ProfileLayer, ...]:
    return tuple(
        ProfileLayer(
            layer.weight.numpy().T,
            layer.bias.numpy(),
            step=float(layer.input_scale),
            scale=layer.weight_scale.numpy(),
            relu=False,
        )
        for layer in int8.layers
    )


def compare_decoder(decoder: bytes, model: DecoderModel) -> Agreement:
    """Compare ONNX with PyTorch on random and extreme queries; `ExportError` beyond tolerance."""
    usual = random_queries(model, _RANDOM_QUERIES, seed=0)
    return compare_answers(decoder, model, usual, extreme_queries(model, seed=0))


@torch.no_grad()
def compare_answers(decoder: bytes, model: Answering, usual: Tensor, extreme: Tensor) -> Agreement:
    """Compare ONNX with PyTorch on queries (n, K) each; `ExportError` beyond tolerance.

    Where a query is larger than usual ones are, its tolerance is as many times larger.
    """
    queries = torch.cat([usual, extreme])
    actual, expected = _run(decoder, queries), _transport(model, model.decoder(queries))
    absolute, relative = _differences(actual, expected)
    sizes = queries.abs().amax(dim=1).numpy()
    reach = np.maximum(sizes / sizes[: len(usual)].max(), 1.0)
    if not close_rows(actual, expected, reach).all():
        raise ExportError(
            f"the ONNX decoder differs from PyTorch by up to {absolute:.2e} "
            f"absolute, {relative:.2e} relative; expected at most {ABSOLUTE:g} + "
            f"{RELATIVE:g} |x|"
        )
    return Agreement(max_absolute=absolute, max_relative=relative)


@torch.no_grad()
def compare_int8_decoder(
    decoder: bytes, model: DecoderModel, int8: Int8Decoder, queries: Tensor
) -> Agreement:
    """Compare ONNX with the twin in PyTorch; `ExportError` beyond tolerance.

    The twin computes the same integers, except for sums that fall next to the middle between two
    steps, which float32 rounds either way: those rows may differ, and must be few.

    Returns how far ONNX is from the trained decoder on the real `queries`, (n, K).
    """
    inputs = torch.cat([queries, extreme_queries(model, seed=0)])
    actual, twin = _run(decoder, inputs), _transport(model, int8(inputs))
    differing = 1.0 - float(close_rows(actual, twin).mean())
    if differing > TIES:
        raise ExportError(
            f"the int8 ONNX decoder differs from its PyTorch reference in {differing:.1%} of the "
            f"rows; expected at most {TIES:.1%}"
        )
    expected = _transport(model, model.decoder(queries))
    absolute, relative = _differences(_run(decoder, queries), expected)
    return Agreement(max_absolute=absolute, max_relative=relative)


def _run(decoder: bytes, queries: Tensor) -> np.ndarray:
    session = onnxruntime.InferenceSession(decoder, providers=["CPUExecutionProvider"])
    (actual,) = session.run(None, {"queries": queries.numpy()})
    return np.asarray(actual, np.float64)


def _transport(model: Answering, y: Tensor) -> np.ndarray:
    return model.transport(y.unflatten(1, (-1, 3))).flatten(1).numpy()


def _differences(actual: np.ndarray, expected: np.ndarray) -> tuple[float, float]:
    """Largest absolute difference, and largest relative one of values above ABSOLUTE / RELATIVE."""
    difference = np.abs(actual - expected)
    large = np.abs(expected) > ABSOLUTE / RELATIVE
    relative = (difference[large] / np.abs(expected[large])).max(initial=0.0)
    return float(difference.max()), float(relative)


def random_queries(model: DecoderModel, n: int, seed: int) -> torch.Tensor:
    """Decoder inputs for random positions in the bounds and random directions, (n, K)."""
    generator = torch.Generator().manual_seed(seed)
    low, high = model.triplane.low, model.triplane.high
    position = low + (high - low) * torch.rand(n, 3, generator=generator)
    frame, wo, wi = torch.nn.functional.normalize(torch.randn(3, n, 3, generator=generator), dim=2)
    return model.queries(_points(position, frame, wo, wi, 2.0 * wo[:, 0]))


def extreme_queries(model: DecoderModel, seed: int) -> torch.Tensor:
    """Corners of the box and beyond, aligned and opposite directions, features far out of range."""
    queries = random_queries(model, 600, seed + 1)
    low, high = model.triplane.low, model.triplane.high
    axis = torch.eye(3).repeat(100, 1)
    far = high + _FAR * (high - low)
    h = axis[:, 0]
    corners = [
        model.queries(_points(low.expand(300, 3), axis, axis, axis, h)),
        model.queries(_points(high.expand(300, 3), axis, axis, -axis, -h)),
        model.queries(_points(far.expand(300, 3), axis, -axis, -axis, h)),
    ]
    return torch.cat([torch.zeros_like(queries[:1]), _FAR * queries, -_FAR * queries, *corners])


def _points(
    position: torch.Tensor, frame: torch.Tensor, wo: torch.Tensor, wi: torch.Tensor, h: torch.Tensor
) -> Points:
    """Points of either kind: `frame` is the normal or the tangent."""
    named = {"position": position, "normal": frame, "tangent": frame, "wo": wo, "wi": wi}
    return named | {"h": h}
