"""Check an ONNX decoder: its structure first, then that it loads and keeps its word."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from rna_sdk.errors import PackageError
from rna_sdk.package.decoder.decoder_bounds import check_bounds
from rna_sdk.package.decoder.decoder_form import INPUT_NAME, PartDecoder, allowed
from rna_sdk.package.decoder.onnx_fields import DataType
from rna_sdk.package.decoder.onnx_model import FLOAT, Model, Value, read_model
from rna_sdk.package.decoder.profile_decoder import read_profile, saturating_weights
from rna_sdk.package.decoder.protobuf import WireError
from rna_sdk.package.decoder.saturation import PAIR_LIMIT
from rna_sdk.package.issues import Code, Issue, refuse
from rna_sdk.package.limits import (
    IR_VERSIONS,
    MAX_DECODER_BYTES,
    MAX_DECODER_NODES,
    MAX_DECODER_WIDTH,
    OPSET_VERSIONS,
)

Rows = NDArray[np.float32]

QUANTIZERS = frozenset({"QuantizeLinear", "DequantizeLinear"})

# Operators whose row i of the result can depend on row i of the queries alone, and whose
# dimensions do not grow beyond the bounds of decoder_bounds.py.
OPERATORS = QUANTIZERS | frozenset(
    "Abs Add And Atan Cast Ceil Clip Concat Constant Cos Div Elu Equal Erf Exp Floor Gelu Gemm "
    "Greater GreaterOrEqual HardSigmoid HardSwish Identity IsInf IsNaN LayerNormalization "
    "LeakyRelu Less LessOrEqual Log MatMul Max Min Mish Mul Neg Not Or PRelu Pow Reciprocal Relu "
    "Selu Sigmoid Sign Sin Slice Softplus Softsign Split Sqrt Sub Sum Tanh ThresholdedRelu "
    "Where Xor".split()
)

TENSOR_TYPES = frozenset(value for name, value in vars(DataType).items() if name.isupper())
DEFAULT_DOMAINS = frozenset({"", "ai.onnx"})

_PROBES = (0.0, 1.0, -1.0, 1e4, -1e4, float(np.finfo(np.float32).max), -3.4e38)
_RANDOM_ROWS = 17
_INT8_SHARE = 0.75
"""Fraction of an int8 decoder's rows that must be identical in another order, and alone."""


def check_decoder(data: memoryview, own: PartDecoder) -> list[Issue]:
    """Check the entry `data` against the spec; returns warnings.

    The inference engine sees the bytes only after the structure has passed.

    Raises:
        PackageError: with the first DECODER_* issue found.
    """
    if len(data) > MAX_DECODER_BYTES:
        expected = f"at most {MAX_DECODER_BYTES}"
        refuse(Code.DECODER_TOO_LARGE, own.entry, f"{len(data)} bytes", expected)
    try:
        model = read_model(data)
    except WireError as error:
        refuse(Code.DECODER_NOT_ONNX, own.entry, error, "an ONNX ModelProto")
    _check_versions(model, own.entry)
    _check_interface(model, own)
    _check_nodes(model, own)
    _check_tensors(model, own.entry)
    check_bounds(model, own)
    _check_results(bytes(data), own)
    return _warnings(model, own.entry)


def _warnings(model: Model, name: str) -> list[Issue]:
    issues = []
    if isinstance(outside := read_profile(model), str):
        issues.append(Issue.of(Code.DECODER_PROFILE, name, outside, "the decoder profile"))
    if weights := saturating_weights(model):
        expected = f"neighbours of one sign that add up to at most {PAIR_LIMIT}"
        issues.append(Issue.of(Code.DECODER_SATURATION, f"{name}#{weights[0]}", "larger", expected))
    return issues


def _check_versions(model: Model, name: str) -> None:
    if not model.opsets or not model.nodes:
        refuse(Code.DECODER_NOT_ONNX, name, "no operator set or no nodes", "an ONNX ModelProto")
    for i, (domain, version) in enumerate(model.opsets):
        where = f"{name}#/opset_import/{i}"
        if domain not in DEFAULT_DOMAINS or i > 0:
            refuse(Code.DECODER_DOMAIN, where, repr(domain), "the default domain, once")
        if version not in OPSET_VERSIONS:
            refuse(Code.DECODER_VERSION, where, version, _span(OPSET_VERSIONS))
    if model.ir_version not in IR_VERSIONS:
        where = f"{name}#/ir_version"
        refuse(Code.DECODER_VERSION, where, model.ir_version, _span(IR_VERSIONS))


def _span(versions: range) -> str:
    return f"{versions.start} to {versions.stop - 1}"


def _check_interface(model: Model, own: PartDecoder) -> None:
    sides = (
        (Code.DECODER_INPUT, "input", model.inputs, INPUT_NAME, own.columns),
        (Code.DECODER_OUTPUT, "output", model.outputs, own.form.name, own.width),
    )
    for code, side, values, name, width in sides:
        if list(values) != [Value(name, FLOAT, (None, width))]:
            where = f"{own.entry}#/graph/{side}"
            found = [f"{v.name} type {v.dtype} {list(v.dims)}" for v in values]
            refuse(code, where, found, f"{name} float32 [N, {width}], N symbolic")


def _check_nodes(model: Model, own: PartDecoder) -> None:
    if model.nested:
        found = "functions, training info or sparse tensors"
        refuse(Code.DECODER_NESTED, f"{own.entry}#", found, "none")
    if len(model.nodes) > MAX_DECODER_NODES:
        where = f"{own.entry}#/graph/node"
        refuse(Code.DECODER_GRAPH, where, len(model.nodes), f"at most {MAX_DECODER_NODES} nodes")
    for i, node in enumerate(model.nodes):
        where = f"{own.entry}#/graph/node/{i}"
        if node.domain not in DEFAULT_DOMAINS:
            refuse(Code.DECODER_DOMAIN, where, node.domain, "the default domain")
        if node.nested:
            refuse(Code.DECODER_NESTED, where, f"a graph in {node.operator}", "none")
        if node.operator not in OPERATORS:
            refuse(Code.DECODER_OPERATOR, where, node.operator, "one of the list in the spec")
    quantized = any(node.operator in QUANTIZERS for node in model.nodes)
    actual = "int8" if quantized else "float32"
    if actual != own.precision:
        refuse(Code.DECODER_PRECISION, own.entry, actual, own.precision)


def _check_tensors(model: Model, name: str) -> None:
    tensors = [*model.initializers, *(t for node in model.nodes for t in node.tensors)]
    for tensor in tensors:
        where = f"{name}#{tensor.name}"
        if tensor.external:
            refuse(Code.DECODER_EXTERNAL, where, "external data", "data in the file")
        small = len(tensor.dims) <= 2 and max(tensor.dims, default=1) <= MAX_DECODER_WIDTH
        if tensor.dtype not in TENSOR_TYPES or not small:
            found = f"type {tensor.dtype} {list(tensor.dims)}"
            expected = f"at most 2 dimensions of at most {MAX_DECODER_WIDTH}"
            refuse(Code.DECODER_TENSOR, where, found, expected)


def _check_results(data: bytes, own: PartDecoder) -> None:
    """Load the decoder and ask it a few queries: together, in another order, and alone."""
    # Imported here: everything but this last check works, and starts fast, without it.
    import onnxruntime as ort

    options = ort.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    options.graph_optimization_level = ort.GraphOptimizationLevel.ORT_DISABLE_ALL
    options.log_severity_level = 4
    queries = _probes(own.columns)
    order = np.random.default_rng(1).permutation(len(queries))
    ordinary = np.arange(len(_PROBES), len(queries))  # what rounding does to the others is larger
    try:
        session = ort.InferenceSession(data, options, providers=["CPUExecutionProvider"])

        def run(rows: Rows) -> Rows:
            result: Rows = session.run([own.form.name], {INPUT_NAME: rows})[0]
            if result.dtype != np.float32 or result.shape != (len(rows), own.width):
                found = f"{result.dtype} {list(result.shape)}"
                expected = f"float32 {[len(rows), own.width]}"
                refuse(Code.DECODER_RESULT, own.entry, found, expected)
            return result

        run(queries[:0])
        output, permuted = run(queries), run(queries[order])
        alone = np.concatenate([run(queries[k : k + 1]) for k in ordinary])
    except PackageError:
        raise
    except Exception as error:  # the engine's exceptions share no narrower base
        refuse(Code.DECODER_LOAD, own.entry, error, "a model that loads and runs")
    good = allowed(output).all(axis=1)
    if not good.all():
        row = int(np.argmin(good))
        found = f"{output[row].tolist()} for inputs that begin with {queries[row, 0]:g}"
        refuse(Code.DECODER_RESULT, own.entry, found, "finite and >= 0 for any finite input")
    in_order = permuted[np.argsort(order)]
    _check_rows_apart(output[ordinary], (in_order[ordinary], alone), own)


def _check_rows_apart(expected: Rows, others: Iterable[Rows], own: PartDecoder) -> None:
    """Whether equal rows came out of calls with other rows, in other places."""
    # Sums of int8 halfway between two steps may round another way in a batch of another size.
    enough = 1.0 if own.precision == "float32" else _INT8_SHARE
    for result in others:
        if np.isclose(result, expected, rtol=1e-3, atol=1e-5).all(axis=1).mean() < enough:
            found = "rows that depend on others, or on their place"
            refuse(Code.DECODER_RESULT, own.entry, found, "rows that depend on themselves alone")


def _probes(columns: int) -> Rows:
    """Queries (n, columns): rows of one number each, up to the largest, and random ones."""
    constant = np.repeat(np.array(_PROBES, np.float32)[:, None], columns, axis=1)
    random = np.random.default_rng(0).uniform(-1, 1, (_RANDOM_ROWS, columns)).astype(np.float32)
    return np.concatenate([constant, random])
