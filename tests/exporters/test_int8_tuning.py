"""Tuning brings an int8 decoder's brightness back to the trained one's; weights stay."""

from dataclasses import replace

import pytest
import torch
from torch import Tensor

from rna_export.export.decoder import (
    DecoderModel,
    compare_int8_decoder,
    export_decoder,
    random_queries,
)
from rna_export.export.int8_decoder import Int8Decoder, int8_decoder
from rna_export.export.int8_tuning import Calibration, tuned
from tests.exporters.synthetic import hurried_packages
from tests.exporters.test_decoder_export import make_model


def make_calibration(model: DecoderModel, seed: int, channels: int) -> Calibration:
    """Random queries, of which half are lit; of three channels, each of its own."""
    generator = torch.Generator().manual_seed(seed)
    queries = random_queries(model, 20_000, seed)
    lit = torch.rand(len(queries), channels, generator=generator).round()
    return Calibration(queries, torch.stack([lit, 1.0 - lit], dim=1))


@torch.no_grad()
def brightness_error(model: DecoderModel, decoder: Int8Decoder, at: Calibration) -> float:
    """By how much a channel is off at most, over all samples."""

    def light(y: Tensor) -> Tensor:
        return (at.weights * model.transport(y.unflatten(1, (-1, 3)))).sum(dim=(0, 1))

    ratio = light(decoder(at.queries)) / light(model.decoder(at.queries))
    return float((ratio - 1.0).abs().max())


@pytest.mark.parametrize(("kind", "channels"), [("surface", 1), ("fiber", 3)])
def test_a_decoder_that_is_off_is_brought_back(kind, channels):
    model = make_model("small", kind)
    model.decoder[-1].bias.data += 1.0  # every channel has light
    calibration, others = (make_calibration(model, seed, channels) for seed in (7, 8))
    plain = int8_decoder(model.decoder, calibration.queries)
    *inner, last = plain.layers
    dim = replace(last, weight_scale=0.97 * last.weight_scale)
    off = replace(plain, layers=(*inner, dim))
    assert brightness_error(model, off, others) > 0.02
    better = tuned(off, model, calibration)
    assert brightness_error(model, better, others) < 0.003
    for layer, before in zip(better.layers, off.layers, strict=True):
        assert torch.equal(layer.weight, before.weight)  # pairs stay within their limit
    compare_int8_decoder(export_decoder(model, better), model, better, others.queries)


def test_tuning_repeats_itself():
    model = make_model()
    calibration = make_calibration(model, 7, 1)
    plain = int8_decoder(model.decoder, calibration.queries)
    with hurried_packages():
        first, second = (tuned(plain, model, calibration) for _ in range(2))
    for layer, again in zip(first.layers, second.layers, strict=True):
        assert torch.equal(layer.weight_scale, again.weight_scale)
        assert torch.equal(layer.bias, again.bias)
