"""Compiled: fully connected layers on a panel of rows, one row a lane.

A panel is a flat float32 array [numbers of a row][PANEL rows]. A layer takes BLOCK of its outputs
at a time and keeps their sums for three registers of rows in registers: 12 sums of the 16 that
AVX2 has. Its weights come packed: for each such block BLOCK biases, then BLOCK weights an input.
"""

from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.core.registry import cpu_target
from numba.extending import intrinsic
from numpy.typing import NDArray

from rna_sdk.runtime.kernels.lanes import LANES, operation, splat

PANEL = 48
"""Rows of a panel: whole registers, three at a time, of AVX2 and of AVX-512."""

BLOCK = 4
REGISTERS = 3
_WORD = ir.IntType(64)
_INDEX = ir.IntType(32)
_FUSED = ("contract",)  # multiply-add, as everywhere in the kernels


def packed_layer(weight: NDArray[np.float32], bias: NDArray[np.float32]) -> NDArray[np.float32]:
    """(inputs, outputs) and (outputs,) as `block_sums` takes them; outputs filled up with 0."""
    outputs = -(-weight.shape[1] // BLOCK) * BLOCK
    rows = np.zeros((1 + len(weight), outputs), np.float32)
    rows[0, : len(bias)], rows[1:, : len(bias)] = bias, weight
    blocks = rows.reshape(len(rows), -1, BLOCK).transpose(1, 0, 2)
    return np.ascontiguousarray(blocks).reshape(-1)


def register_lanes() -> int:
    """float32 of a vector register of the CPU that numba compiles for."""
    features = cpu_target.target_context.codegen()._customize_tm_features()
    return 16 if "+avx512f" in features else 8


@intrinsic(prefer_literal=True)
def block_sums(
    typing_context: Any,
    lanes: Any,
    x: Any,
    x_at: Any,
    weights: Any,
    at: Any,
    inputs: Any,
    y: Any,
    y_at: Any,
    relu: Any,
) -> Any:
    """Write BLOCK outputs of a layer for REGISTERS registers of rows.

    lanes: float32 of a register, a compile-time constant. x, y: panels of the layer's inputs and
    outputs; x_at, y_at: the first of the rows in x, and of the block in y. weights, flat: those of
    the block from `at` on. relu: whether a Relu comes behind. A number's terms are added in the
    order of the inputs, whatever the CPU.
    """
    if not isinstance(lanes, types.IntegerLiteral):
        return None
    vector = ir.VectorType(ir.FloatType(), lanes.literal_value)

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any) -> Any:
        def start(k: int) -> ir.Value:
            data = context.make_array(signed.args[k])(context, builder, arguments[k]).data
            return builder.gep(data, [arguments[k + 1]])

        sums = _summed(builder, vector, start(1), start(3), arguments[5])
        _store(builder, vector, sums, start(6), arguments[8])
        return context.get_dummy_value()

    word = types.int64
    return types.void(lanes, x, word, weights, word, word, y, word, types.boolean), generate


def _summed(
    builder: ir.IRBuilder, vector: ir.VectorType, x: ir.Value, weights: ir.Value, inputs: ir.Value
) -> list[list[ir.Value]]:
    """BLOCK biases and the products of all inputs, each for REGISTERS registers of rows at x."""
    biases = [_number(builder, vector, weights, j) for j in range(BLOCK)]
    before = builder.block
    loop, behind = (builder.append_basic_block(name) for name in ("inputs", "sums"))
    builder.branch(loop)
    builder.position_at_end(loop)
    k = builder.phi(_WORD)
    totals = [[builder.phi(vector) for _ in range(REGISTERS)] for _ in biases]
    following = builder.add(k, _WORD(1))
    row = builder.gep(x, [builder.mul(k, _WORD(PANEL))])
    column = builder.gep(weights, [builder.mul(following, _WORD(BLOCK))])
    values = [builder.load(_register(builder, vector, row, r), align=4) for r in range(REGISTERS)]
    sums = []
    for j, registers in enumerate(totals):
        weight = _number(builder, vector, column, j)
        products = [builder.fmul(value, weight, flags=_FUSED) for value in values]
        pairs = zip(registers, products, strict=True)
        sums.append([builder.fadd(total, p, flags=_FUSED) for total, p in pairs])
    k.add_incoming(_WORD(0), before)
    k.add_incoming(following, loop)
    for bias, registers, grown in zip(biases, totals, sums, strict=True):
        for total, value in zip(registers, grown, strict=True):
            total.add_incoming(bias, before)
            total.add_incoming(value, loop)
    builder.cbranch(builder.icmp_signed("<", following, inputs), loop, behind)
    builder.position_at_end(behind)
    return sums


def _store(
    builder: ir.IRBuilder,
    vector: ir.VectorType,
    sums: list[list[ir.Value]],
    y: ir.Value,
    relu: ir.Value,
) -> None:
    """The sums into a panel at y, negative ones as 0 where `relu`."""
    zero = ir.Constant(vector, [0.0] * vector.count)
    for j, registers in enumerate(sums):
        row = builder.gep(y, [_WORD(j * PANEL)])
        for r, value in enumerate(registers):
            positive = builder.select(builder.fcmp_ordered(">", value, zero), value, zero)
            value = builder.select(relu, positive, value)
            builder.store(value, _register(builder, vector, row, r), align=4)


def _register(builder: ir.IRBuilder, vector: ir.VectorType, row: ir.Value, number: int) -> ir.Value:
    """Address of a register of a panel's row."""
    address = builder.gep(row, [_WORD(number * vector.count)])
    return builder.bitcast(address, vector.as_pointer())


def _number(builder: ir.IRBuilder, vector: ir.VectorType, numbers: ir.Value, j: int) -> ir.Value:
    """numbers[j] in every lane."""
    return splat(builder, builder.load(builder.gep(numbers, [_WORD(j)])), vector)


@operation
def load_square(
    typing_context: Any, rows: Any, first: Any, stride: Any, panel: Any, at: Any
) -> Any:
    """LANES columns of LANES rows, turned, into a panel.

    panel[at + c * PANEL + r] = rows.flat[first + r * stride + c], r and c below LANES.
    """
    vector = ir.VectorType(ir.FloatType(), LANES)

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any) -> Any:
        source, target = (
            context.make_array(signed.args[k])(context, builder, arguments[k]).data for k in (0, 3)
        )
        lines = []
        place = arguments[1]
        for _ in range(LANES):
            address = builder.bitcast(builder.gep(source, [place]), vector.as_pointer())
            lines.append(builder.load(address, align=4))
            place = builder.add(place, arguments[2])
        for c, line in enumerate(_turned(builder, lines)):
            start = builder.add(arguments[4], _WORD(c * PANEL))
            address = builder.bitcast(builder.gep(target, [start]), vector.as_pointer())
            builder.store(line, address, align=4)
        return context.get_dummy_value()

    word = types.int64
    return types.void(rows, word, word, panel, word), generate


def _turned(builder: ir.IRBuilder, lines: list[ir.Value]) -> list[ir.Value]:
    """The transpose of a square of vectors: blocks off the diagonal change places, ever smaller."""
    count = len(lines)
    mask = ir.VectorType(_INDEX, count)
    size = count // 2
    while size:
        above = [k if not k & size else count + k - size for k in range(count)]
        below = [k + size if not k & size else count + k for k in range(count)]
        for i in (i for i in range(count) if not i & size):
            a, b = lines[i], lines[i + size]
            lines[i] = builder.shuffle_vector(a, b, ir.Constant(mask, above))
            lines[i + size] = builder.shuffle_vector(a, b, ir.Constant(mask, below))
        size //= 2
    return lines
