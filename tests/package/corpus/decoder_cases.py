"""Packages whose decoder leaves the chain of the profile at one node."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import onnx
from onnx import helper, numpy_helper

from rna_sdk.package import decoder_to_bytes
from tests.package.builders import random_decoder, random_int8_decoder
from tests.package.corpus.content_cases import in_decoder, with_profile
from tests.package.corpus.registry import (
    DECODER,
    Breaker,
    Corpus,
    Entries,
    tier_part,
    with_entry,
)

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


def _rename_an_axis(model: onnx.ModelProto) -> None:
    """The attribute that says along which axis scales lie."""
    maker = next(n for n in _of(model, "DequantizeLinear") if n.attribute)
    maker.attribute[0].name = "block_size"


def _with_bytes_for_an_axis(entries: Entries) -> bytes:
    """No bytes where the number 0 is expected."""
    data = decoder_to_bytes(random_int8_decoder(largest=64))
    assert b"axis\x18\x00" in data
    data = data.replace(b"axis\x18\x00", b"axis\x1a\x00", 1)
    return with_entry(
        entries, DECODER, data, lambda m: tier_part(m).update(decoderPrecision="int8")
    )


def _end_before_the_outputs(model: onnx.ModelProto) -> None:
    """The last node is left out, and there is one output more."""
    last = model.graph.node.pop()
    model.graph.node[-1].output[0] = last.output[0]
    used = {name for node in model.graph.node for name in node.input}
    for constant in [c for c in model.graph.initializer if c.name not in used]:
        model.graph.initializer.remove(constant)
    model.graph.output[0].type.tensor_type.shape.dim[1].dim_value += 1


def _make_a_layer_of_nothing(model: onnx.ModelProto) -> None:
    """The first layer has no outputs, the second no inputs."""
    first, second = _of(model, "Gemm")[:2]
    constants = {constant.name: constant for constant in model.graph.initializer}
    for name, axis in ((first.input[1], 1), (first.input[2], 0), (second.input[1], 0)):
        constants[name].dims[axis] = 0
        constants[name].raw_data = b""


CASES.add(
    "DECODER_PROFILE",
    decoder_whose_input_has_another_name=in_decoder(
        lambda m: setattr(m.graph.input[0], "name", "light")
    ),
    decoder_that_ends_before_its_outputs=in_decoder(_end_before_the_outputs),
    decoder_with_a_layer_of_nothing=in_decoder(_make_a_layer_of_nothing),
    int8_decoder_with_another_attribute=in_int8_decoder(_rename_an_axis),
    int8_decoder_with_bytes_for_an_axis=_with_bytes_for_an_axis,
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
