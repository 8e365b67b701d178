"""Packages whose decoder leaves the chain of the profile at one node."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import onnx
from onnx import helper, numpy_helper

from rna_sdk.package import decoder_to_bytes
from tests.package.builders import random_decoder, random_int8_decoder
from tests.package.corpus.content_cases import in_decoder, with_profile
from tests.package.corpus.registry import DECODER, Breaker, Corpus, tier_part, with_entry

CASES = Corpus("surface")


def _of(model: onnx.ModelProto, operator: str) -> list[onnx.NodeProto]:
    return [node for node in model.graph.node if node.op_type == operator]


def _skip_a_node(model: onnx.ModelProto) -> None:
    """The second layer reads what the first gives, before its Relu."""
    first, second = _of(model, "Gemm")[:2]
    second.input[0] = first.output[0]


def in_int8_decoder(edit: Callable[[onnx.ModelProto], object]) -> Breaker:
    model = onnx.load_from_string(decoder_to_bytes(random_int8_decoder(largest=64)))
    edit(model)
    data = model.SerializeToString()
    return lambda entries: with_entry(
        entries, DECODER, data, lambda m: tier_part(m).update(decoderPrecision="int8")
    )


def _turn_weights(model: onnx.ModelProto) -> None:
    """Scales of a layer's weights lie along its inputs, which are as many."""
    weight = _of(model, "Gemm")[0].input[1]
    (maker,) = (node for node in model.graph.node if node.output[0] == weight)
    del maker.attribute[:]
    maker.attribute.append(helper.make_attribute("axis", 0))


def _restore_otherwise(model: onnx.ModelProto) -> None:
    steps = _of(model, "QuantizeLinear")[0].output[0]
    maker = next(node for node in _of(model, "DequantizeLinear") if node.input[0] == steps)
    maker.input[1] = "restored"
    model.graph.initializer.append(numpy_helper.from_array(np.float32(0.5), "restored"))


CASES.add(
    "DECODER_PROFILE",
    decoder_whose_layer_passes_over_a_node=in_decoder(_skip_a_node),
    decoder_with_a_node_of_nothing=in_decoder(
        lambda m: m.graph.node.append(helper.make_node("Relu", [], ["spare"]))
    ),
    decoder_whose_last_value_has_another_name=in_decoder(
        lambda m: m.graph.node[-1].output.__setitem__(0, "light")
    ),
    decoder_with_an_axis_of_its_clamp=in_decoder(
        lambda m: _of(m, "Clip")[0].attribute.append(helper.make_attribute("axis", 1))
    ),
    decoder_with_a_layer_without_bias=in_decoder(lambda m: _of(m, "Gemm")[0].input.pop()),
    int8_decoder_with_scales_along_inputs=in_int8_decoder(_turn_weights),
    int8_decoder_with_a_layer_without_bias=in_int8_decoder(lambda m: _of(m, "Gemm")[0].input.pop()),
    int8_decoder_that_restores_by_another_scale=in_int8_decoder(_restore_otherwise),
)
CASES.add(
    "DECODER_RESULT",
    decoder_that_clips_to_infinity=lambda e: with_profile(
        e, replace(random_decoder(), low=-np.inf)
    ),
)
