"""Packages whose mesh, planes or decoder is wrong, though declared with its true hash."""

import json
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

from rna_sdk.package import ProfileDecoder, decoder_to_bytes
from rna_sdk.package.container.glb_chunks import CHUNK, CHUNK_BIN, HEADER, pack_glb
from rna_sdk.package.container.tensor_file import tensors_to_bytes
from rna_sdk.package.decoder.onnx_writer import GraphWriter
from rna_sdk.package.decoder.onnx_writer import value as value_info
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from rna_sdk.package.textures.planes import planes_to_bytes
from tests.package.builders import (
    LIMIT,
    make_mesh,
    make_planes,
    random_decoder,
    random_int8_decoder,
)
from tests.package.corpus.registry import (
    DECODER,
    MESH,
    PLANES,
    Corpus,
    Entries,
    breaks_by,
    tier_part,
    with_entry,
)

CASES = Corpus("surface")


def with_gltf(entries: Entries, edit: Callable[[dict[str, Any]], object]) -> bytes:
    """The package with an edited JSON chunk in its geometry."""
    glb = entries[MESH]
    size = CHUNK.unpack_from(glb, HEADER.size)[0]
    start = HEADER.size + CHUNK.size
    document = json.loads(glb[start : start + size])
    edit(document)
    blob = glb[start + size + CHUNK.size :]
    return with_entry(entries, MESH, pack_glb(json.dumps(document).encode(), blob))


in_gltf = breaks_by(with_gltf)


def with_decoder(entries: Entries, edit: Callable[[onnx.ModelProto], object]) -> bytes:
    """The package with an edited decoder."""
    model = onnx.load_from_string(entries[DECODER])
    edit(model)
    return with_entry(entries, DECODER, model.SerializeToString())


in_decoder = breaks_by(with_decoder)


def with_profile(entries: Entries, decoder: ProfileDecoder, precision: str = "float32") -> bytes:
    """The package with another decoder, of this precision by the manifest."""

    def declare(manifest: dict[str, Any]) -> None:
        tier_part(manifest).update(decoderPrecision=precision)

    return with_entry(entries, DECODER, decoder_to_bytes(decoder), declare)


def with_planes_header(entries: Entries, header: dict[str, Any], pad: int = 64) -> bytes:
    text = json.dumps(header).encode()
    text += b" " * (-(8 + len(text)) % pad)
    data = len(text).to_bytes(8, "little") + text + make_planes().tobytes()
    return with_entry(entries, PLANES, data)


# Geometry


CASES.add(
    "GEOMETRY_CONTAINER",
    glb_truncated=lambda e: with_entry(e, MESH, e[MESH][:-8]),
    glb_of_three_bytes=lambda e: with_entry(e, MESH, b"glT"),
    glb_of_version_1=lambda e: with_entry(e, MESH, e[MESH][:4] + b"\1" + e[MESH][5:]),
    glb_without_json=lambda e: with_entry(e, MESH, pack_glb(b"no json", bytes(64))),
    glb_with_half_a_surrogate_pair=in_gltf(lambda g: g["nodes"][0].update(name="\ud800")),
)


@CASES.case("GEOMETRY_CONTAINER")
def glb_chunk_past_the_end(entries: Entries) -> bytes:
    data = bytearray(entries[MESH])
    data[HEADER.size : HEADER.size + 4] = b"\xff\xff\xff\x7f"
    return with_entry(entries, MESH, bytes(data))


@CASES.case("GEOMETRY_CONTAINER")
def glb_of_an_odd_size(entries: Entries) -> bytes:
    glb = bytearray(entries[MESH] + b"\0")
    glb[8:12] = len(glb).to_bytes(4, "little")
    chunk = bytes(glb).index(CHUNK_BIN) - 4
    glb[chunk : chunk + 4] = (len(glb) - chunk - CHUNK.size).to_bytes(4, "little")
    return with_entry(entries, MESH, bytes(glb))


CASES.add(
    "GEOMETRY_PROFILE",
    glb_with_an_empty_scene=in_gltf(lambda g: g["scenes"][0].pop("nodes")),
    glb_with_a_node_without_mesh=in_gltf(lambda g: g["nodes"][0].pop("mesh")),
    glb_with_a_null=in_gltf(lambda g: g["asset"].update(generator=None)),
    glb_with_a_moved_node=in_gltf(lambda g: g["nodes"][0].update(translation=[1, 0, 0])),
    glb_with_an_outside_buffer=in_gltf(lambda g: g["buffers"][0].update(uri="file:///etc/passwd")),
    glb_with_short_indices=in_gltf(lambda g: g["accessors"][3].update(componentType=5123)),
    glb_with_float_indices=in_gltf(lambda g: g["accessors"][3].update(componentType=5126)),
)
CASES.add(
    "GEOMETRY_RANGE",
    glb_accessor_of_no_view=in_gltf(lambda g: g["accessors"][0].update(bufferView=4)),
    glb_accessor_past_its_view=in_gltf(lambda g: g["accessors"][0].update(count=13)),
    glb_view_past_the_buffer=in_gltf(lambda g: g["bufferViews"][3].update(byteOffset=10**9)),
    glb_buffer_past_its_chunk=in_gltf(lambda g: g["buffers"][0].update(byteLength=10**9)),
    glb_without_the_accessor=in_gltf(lambda g: g["accessors"].pop()),
    glb_with_an_accessor_at_an_odd_byte=in_gltf(lambda g: g["accessors"][0].update(byteOffset=2)),
    glb_with_a_view_at_an_odd_byte=in_gltf(lambda g: g["bufferViews"][0].update(byteOffset=2)),
)
CASES.add(
    "GEOMETRY_ARRAY",
    glb_with_fewer_normals=in_gltf(lambda g: g["accessors"][1].update(count=11)),
    glb_with_part_of_a_triangle=in_gltf(lambda g: g["accessors"][3].update(count=11)),
)


@CASES.case("GEOMETRY_NOT_FINITE")
def glb_with_nan(entries: Entries) -> bytes:
    mesh = make_mesh()
    uvs = np.full_like(mesh.uvs, np.nan)
    return with_entry(entries, MESH, mesh_to_glb(replace(mesh, uvs=uvs)))


@CASES.case("GEOMETRY_INDEX")
def glb_index_out_of_range(entries: Entries) -> bytes:
    mesh = make_mesh()
    return with_entry(entries, MESH, mesh_to_glb(replace(mesh, triangles=mesh.triangles + 1)))


@CASES.case("GEOMETRY_NORMAL")
def glb_with_zero_normals(entries: Entries) -> bytes:
    mesh = make_mesh()
    return with_entry(entries, MESH, mesh_to_glb(replace(mesh, normals=mesh.normals * 0)))


CASES.add(
    "GEOMETRY_BOUNDS",
    glb_with_wrong_bounds=in_gltf(lambda g: g["accessors"][0].update(max=[1e300, 1, 1])),
    glb_with_bounds_of_two_axes=in_gltf(lambda g: g["accessors"][0].update(min=[0, 0])),
    glb_without_bounds=in_gltf(lambda g: g["accessors"][0].pop("min")),
)


@CASES.case("GEOMETRY_OUTSIDE")
def mesh_outside_the_bounds(entries: Entries) -> bytes:
    mesh = make_mesh()
    return with_entry(entries, MESH, mesh_to_glb(replace(mesh, positions=mesh.positions * 2)))


# Planes


CASES.add(
    "PLANES_HEADER",
    planes_of_three_bytes=lambda e: with_entry(e, PLANES, b"abc"),
    planes_header_past_the_end=lambda e: with_entry(e, PLANES, b"\xff" * 8 + e[PLANES][8:]),
    planes_header_no_json=lambda e: with_entry(e, PLANES, (56).to_bytes(8, "little") + b"x" * 56),
    planes_cut_short=lambda e: with_entry(e, PLANES, e[PLANES][:-2]),
)


@CASES.case("PLANES_HEADER")
def planes_header_after_a_space(entries: Entries) -> bytes:
    data = entries[PLANES]
    start = 8 + int.from_bytes(data[:8], "little")
    assert data[start - 1 : start] == b" "
    moved = data[:8] + b" " + data[8 : start - 1] + data[start:]
    return with_entry(entries, PLANES, moved)


@CASES.case("PLANES_TENSOR")
def planes_with_metadata_that_is_no_object(entries: Entries) -> bytes:
    tensor = {"dtype": "F16", "shape": [3, 8, 8, 4], "data_offsets": [0, 1536]}
    return with_planes_header(entries, {"__metadata__": 1, "planes": tensor})


CASES.add(
    "PLANES_TENSOR",
    planes_by_another_name=lambda e: with_planes_header(
        e, {"weights": {"dtype": "F16", "shape": [3, 8, 8, 4], "data_offsets": [0, 1536]}}
    ),
    int8_planes_without_scales=lambda e: with_int8_planes(
        e, tensors_to_bytes({"planes": make_planes(precision="int8").texels})
    ),
    planes_that_are_a_number=lambda e: with_planes_header(e, {"planes": 5}),
)


@CASES.case("PLANES_TENSOR")
def planes_and_another_tensor(entries: Entries) -> bytes:
    tensor = {"dtype": "F16", "shape": [3, 8, 8, 4], "data_offsets": [0, 1536]}
    return with_planes_header(entries, {"planes": tensor, "more": tensor})


CASES.add(
    "PLANES_DTYPE",
    planes_of_another_dtype=lambda e: with_entry(
        e, PLANES, planes_to_bytes(make_planes(precision="float32"))
    ),
)


def with_int8_planes(entries: Entries, data: bytes) -> bytes:
    def edit(manifest: dict[str, Any]) -> None:
        tier_part(manifest)["planePrecision"] = "int8"

    return with_entry(entries, PLANES, data, edit)


@CASES.case("PLANES_HEADER")
def int8_planes_before_their_scales(entries: Entries) -> bytes:
    planes = make_planes(precision="int8")
    tensors = {"planes": planes.texels, "scales": planes.scales}
    return with_int8_planes(entries, tensors_to_bytes(tensors))


@CASES.case("PLANES_DTYPE")
def int8_planes_that_are_uint32(entries: Entries) -> bytes:
    planes = make_planes(precision="int8")
    tensors = {"scales": planes.scales, "planes": planes.texels.astype(np.uint32)}
    return with_int8_planes(entries, tensors_to_bytes(tensors))


@CASES.case("PLANES_SHAPE")
def int8_planes_with_a_scale_a_channel(entries: Entries) -> bytes:
    planes = make_planes(precision="int8")
    return with_int8_planes(entries, planes_to_bytes(replace(planes, scales=planes.scales[:1])))


@CASES.case("PLANES_NOT_FINITE")
def int8_planes_with_an_infinite_scale(entries: Entries) -> bytes:
    planes = make_planes(precision="int8")
    planes.scales[2, 3] = np.inf
    return with_int8_planes(entries, planes_to_bytes(planes))


@CASES.case("PLANES_HEADER")
def planes_without_offsets(entries: Entries) -> bytes:
    planes = {"dtype": "F16", "shape": list(make_planes().shape)}
    return with_planes_header(entries, {"planes": planes})


@CASES.case("PLANES_DTYPE")
def planes_without_a_dtype(entries: Entries) -> bytes:
    planes = {"shape": list(make_planes().shape), "data_offsets": [0, make_planes().nbytes]}
    return with_planes_header(entries, {"planes": planes})


@CASES.case("PLANES_SHAPE")
def planes_without_a_shape(entries: Entries) -> bytes:
    planes = {"dtype": "F16", "data_offsets": [0, make_planes().nbytes]}
    return with_planes_header(entries, {"planes": planes})


CASES.add(
    "PLANES_SHAPE",
    planes_of_another_shape=lambda e: with_entry(
        e, PLANES, planes_to_bytes(make_planes(resolution=16))
    ),
    planes_channel_first=lambda e: with_entry(
        e, PLANES, planes_to_bytes(np.moveaxis(make_planes(), -1, 1).copy())
    ),
)
CASES.add(
    "PLANES_ALIGNMENT",
    planes_unaligned=lambda e: with_planes_header(
        e, {"planes": {"dtype": "F16", "shape": [3, 8, 8, 4], "data_offsets": [0, 1536]}}, pad=1
    ),
)


@CASES.case("PLANES_NOT_FINITE")
def planes_with_nan(entries: Entries) -> bytes:
    planes = make_planes()
    planes[2, 7, 7, 3] = np.nan
    return with_entry(entries, PLANES, planes_to_bytes(planes))


@CASES.case("PLANES_NOT_FINITE")
def planes_too_large_for_sums(entries: Entries) -> bytes:
    planes = make_planes(precision="float32")
    planes[0, 0, 0, 0] = 1.001e18
    return with_entry(
        entries,
        PLANES,
        planes_to_bytes(planes),
        lambda m: tier_part(m).update(planePrecision="float32"),
    )


@CASES.case("PLANES_NOT_FINITE")
def planes_with_infinity(entries: Entries) -> bytes:
    planes = make_planes()
    planes[0, 0, 0, 0] = -np.inf
    return with_entry(entries, PLANES, planes_to_bytes(planes))


# Decoder


CASES.add("DECODER_TOO_LARGE", decoder_too_large=lambda e: with_entry(e, DECODER, bytes(2**26 + 1)))
CASES.add(
    "DECODER_PROFILE",
    decoder_garbage=lambda e: with_entry(e, DECODER, bytes(range(255, 0, -1))),
    decoder_truncated=lambda e: with_entry(e, DECODER, e[DECODER][:-20]),
    decoder_of_countless_fields=lambda e: with_entry(
        e, DECODER, e[DECODER] + b"\x28\x01" * 300_000
    ),
    decoder_with_a_field_of_no_number=lambda e: with_entry(e, DECODER, e[DECODER] + b"\x02\x00"),
    decoder_with_a_group=lambda e: with_entry(  # as long as the field before it
        e, DECODER, e[DECODER] + b"\x32\x04abcd" + b"\xa3\x06abcd"
    ),
    decoder_opset_too_new=in_decoder(lambda m: setattr(m.opset_import[0], "version", 22)),
    decoder_without_an_operator_set=in_decoder(lambda m: m.ClearField("opset_import")),
    decoder_of_two_operator_sets=in_decoder(
        lambda m: m.opset_import.append(helper.make_opsetid("ai.onnx.ml", 3))
    ),
    decoder_without_a_version=in_decoder(lambda m: m.ClearField("ir_version")),
    decoder_with_a_constant_of_no_type=in_decoder(
        lambda m: setattr(m.graph.initializer[0], "data_type", 0)
    ),
    decoder_node_of_a_custom_domain=in_decoder(
        lambda m: setattr(m.graph.node[0], "domain", "evil")
    ),
    decoder_with_a_function=in_decoder(lambda m: m.functions.add(name="f")),
    decoder_with_a_constant_named_twice=in_decoder(
        lambda m: m.graph.initializer.append(m.graph.initializer[0])
    ),
    decoder_with_other_columns=lambda e: with_profile(e, random_decoder(columns=17)),
    decoder_with_one_colour=lambda e: with_profile(e, random_decoder(outputs=3)),
)


@CASES.case("DECODER_PROFILE")
def decoder_with_two_graphs(entries: Entries) -> bytes:
    """Protobuf merges the two; a reader that takes the last sees another model."""
    return with_entry(entries, DECODER, entries[DECODER] + b"\x3a\x00")


@CASES.case("DECODER_PROFILE")
def decoder_with_a_number_for_an_operator_set(entries: Entries) -> bytes:
    model = onnx.load_from_string(entries[DECODER])
    model.ClearField("opset_import")
    return with_entry(entries, DECODER, model.SerializeToString() + b"\x40\x01")


@CASES.case("DECODER_PROFILE")
def decoder_with_a_size_named_in_no_utf8(entries: Entries) -> bytes:
    data = entries[DECODER]
    assert data.count(b"\x12\x01N") == 2
    return with_entry(entries, DECODER, data.replace(b"\x12\x01N", b"\x12\x01\xb7"))


@CASES.case("DECODER_PROFILE")
def decoder_with_a_constant_cut_short(entries: Entries) -> bytes:
    def cut(model: onnx.ModelProto) -> None:
        constant = model.graph.initializer[0]
        constant.raw_data = constant.raw_data[:-1]

    return with_decoder(entries, cut)


@CASES.case("DECODER_PROFILE")
def decoder_with_a_branch(entries: Entries) -> bytes:
    branch = helper.make_graph([], "branch", [], [])
    return with_decoder(
        entries, lambda m: m.graph.node[0].attribute.append(helper.make_attribute("body", branch))
    )


@CASES.case("DECODER_PROFILE")
def decoder_with_external_data(entries: Entries) -> bytes:
    def edit(model: onnx.ModelProto) -> None:
        tensor = model.graph.initializer[-1]
        tensor.data_location = TensorProto.EXTERNAL
        tensor.external_data.add(key="location", value="/etc/passwd")

    return with_decoder(entries, edit)


@CASES.case("DECODER_PROFILE")
def decoder_with_a_constant_that_no_layer_reads(entries: Entries) -> bytes:
    cube = numpy_helper.from_array(np.zeros((2, 2, 2), np.float32), "cube")
    return with_decoder(entries, lambda m: m.graph.initializer.append(cube))


@CASES.case("DECODER_PROFILE")
def decoder_with_a_fixed_batch(entries: Entries) -> bytes:
    def edit(model: onnx.ModelProto) -> None:
        model.graph.input[0].type.tensor_type.shape.dim[0].dim_value = 1

    return with_decoder(entries, edit)


@CASES.case("DECODER_PROFILE")
def decoder_nodes_out_of_order(entries: Entries) -> bytes:
    def edit(model: onnx.ModelProto) -> None:
        nodes = list(model.graph.node)
        del model.graph.node[:]
        model.graph.node.extend(reversed(nodes))

    return with_decoder(entries, edit)


@CASES.case("DECODER_PROFILE")
def decoder_with_another_activation(entries: Entries) -> bytes:
    def edit(model: onnx.ModelProto) -> None:
        node = next(node for node in model.graph.node if node.op_type == "Relu")
        node.op_type = "Tanh"

    return with_decoder(entries, edit)


@CASES.case("DECODER_PROFILE")
def decoder_that_subtracts_another_number(entries: Entries) -> bytes:
    def edit(model: onnx.ModelProto) -> None:
        name = next(node for node in model.graph.node if node.op_type == "Sub").input[1]
        (one,) = (t for t in model.graph.initializer if t.name == name)
        one.CopyFrom(numpy_helper.from_array(np.float32(0.5), name))

    return with_decoder(entries, edit)


@CASES.case("DECODER_PROFILE")
def decoder_with_weights_that_do_not_fit(entries: Entries) -> bytes:
    decoder = random_decoder()
    first = replace(decoder.layers[0], weight=np.zeros((5, 8), np.float32))
    made = replace(decoder, layers=(first, *decoder.layers[1:]))
    model = onnx.load_from_string(decoder_to_bytes(made))
    model.graph.input[0].type.tensor_type.shape.dim[1].dim_value = 18
    return with_entry(entries, DECODER, model.SerializeToString())


@CASES.case("DECODER_PROFILE")
def decoder_without_clamps(entries: Entries) -> bytes:
    """The last operator is a plain layer, which may give negative light."""

    def edit(model: onnx.ModelProto) -> None:
        del model.graph.node[-4:]
        model.graph.node[-1].output[0] = "transport"

    return with_decoder(entries, edit)


@CASES.case("DECODER_PROFILE")
def int8_decoder_whose_bias_has_a_scale_of_its_own(entries: Entries) -> bytes:
    model = onnx.load_from_string(decoder_to_bytes(random_int8_decoder(largest=64)))
    last = [node for node in model.graph.node if node.op_type == "Gemm"][-1]
    (maker,) = (node for node in model.graph.node if node.output[0] == last.input[2])
    (scale,) = (t for t in model.graph.initializer if t.name == maker.input[1])
    scale.CopyFrom(numpy_helper.from_array(np.full(6, 0.01, np.float32), scale.name))
    return with_entry(
        entries,
        DECODER,
        model.SerializeToString(),
        lambda m: tier_part(m).update(decoderPrecision="int8"),
    )


def layers_that_share_weights(*weights: np.ndarray, count: int) -> bytes:
    """The file of a decoder whose hidden layers have these weights by turns, each stored once."""
    graph = GraphWriter()
    first, last = np.zeros((18, len(weights[0])), np.float32), np.zeros((len(weights[0]), 6), "f4")
    names = [graph.constant(weight) for weight in weights]
    biases = [graph.constant(np.zeros(weight.shape[1], np.float32)) for weight in weights]
    value = graph.node("Clip", "queries", -LIMIT, LIMIT)
    value = graph.node("Relu", graph.node("Gemm", value, first, np.zeros(len(first.T), np.float32)))
    for k in range(count):
        stored = k % len(weights)
        value = graph.node("Relu", graph.node("Gemm", value, names[stored], biases[stored]))
    value = graph.node("Gemm", value, last, np.zeros(6, np.float32))
    value = graph.node("Exp", graph.node("Clip", value, 0.0, 1.0))
    graph.node("Mul", graph.node("Sub", value, 1.0), 1.0, output="transport")
    return graph.model(value_info("queries", ["N", 18]), value_info("transport", ["N", 6]))


@CASES.case("DECODER_COST")
def decoder_of_countless_layers_with_one_weight(entries: Entries) -> bytes:
    """A reader that keeps the weights of each layer needs 16.7 million for 256 KB in the file."""
    weight = np.zeros((256, 256), np.float32)
    return with_entry(entries, DECODER, layers_that_share_weights(weight, count=256))


@CASES.case("DECODER_COST")
def decoder_of_many_wide_layers(entries: Entries) -> bytes:
    """From one number to 2,048 and back, 40 times."""
    wide, narrow = np.zeros((1, 2048), np.float32), np.zeros((2048, 1), np.float32)
    return with_entry(entries, DECODER, layers_that_share_weights(wide, narrow, count=80))


CASES.add(
    "DECODER_RESULT",
    decoder_of_negative_light=lambda e: with_profile(e, replace(random_decoder(), unit=-1.0)),
)


@CASES.case("DECODER_RESULT")
def decoder_with_a_weight_that_is_no_number(entries: Entries) -> bytes:
    decoder = random_decoder()
    decoder.layers[0].weight[0, 0] = np.nan
    return with_profile(entries, decoder)


@CASES.case("DECODER_SATURATION")
def decoder_whose_pairs_of_weights_exceed_16_bits(entries: Entries) -> bytes:
    """127 next to 127: 255 * 254 is more than a signed 16-bit number holds."""
    return with_profile(entries, random_int8_decoder(largest=127), "int8")
