"""Compiled: fully connected layers on a panel of rows, one row a lane.

A panel is a flat float32 array [numbers of a row][PANEL rows]. A layer takes BLOCK of its outputs
at a time and keeps their sums for three registers of rows in registers: 12 sums of the 16 that
AVX2 has. Its weights come packed: for each such block BLOCK biases, then BLOCK weights an input.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.core.registry import cpu_target
from numba.extending import intrinsic
from numpy.typing import NDArray

from rna_sdk.runtime.lanes import LANES, operation, splat

PANEL = 48
"""Rows of a panel: whole registers, three at a time, of AVX2 and of AVX-512."""

BLOCK = 4
REGISTERS = 3
_WORD = ir.IntType(64)
_INDEX = ir.IntType(32)


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
    count = lanes.literal_value
    vector = ir.VectorType(ir.FloatType(), count)

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any) -> Any:
        def start(k: int) -> ir.Value:
            data = context.make_array(signed.args[k])(context, builder, arguments[k]).data
            return builder.gep(data, [arguments[k + 1]])

        def rows(base: ir.Value, register: int) -> ir.Value:
            address = builder.gep(base, [_WORD(register * count)])
            return builder.bitcast(address, vector.as_pointer())

        def number(base: ir.Value, j: int) -> ir.Value:
            return splat(builder, builder.load(builder.gep(base, [_WORD(j)])), vector)

        x_start, w_start, y_start = start(1), start(3), start(6)
        first = [number(w_start, j) for j in range(BLOCK)]
        before = builder.block
        loop, behind = (builder.append_basic_block(n) for n in ("inputs", "sums"))
        builder.branch(loop)
        builder.position_at_end(loop)
        k = builder.phi(_WORD)
        k.add_incoming(_WORD(0), before)
        sums = [[builder.phi(vector) for _ in range(REGISTERS)] for _ in range(BLOCK)]
        x_row = builder.gep(x_start, [builder.mul(k, _WORD(PANEL))])
        following = builder.add(k, _WORD(1))
        w_row = builder.gep(w_start, [builder.mul(following, _WORD(BLOCK))])
        loaded = [builder.load(rows(x_row, r), align=4) for r in range(REGISTERS)]
        grown = []
        for j, row in enumerate(sums):
            weight = number(w_row, j)
            for r, total in enumerate(row):
                product = builder.fmul(loaded[r], weight, flags=("contract",))
                grown.append(builder.fadd(total, product, flags=("contract",)))
                total.add_incoming(first[j], before)
                total.add_incoming(grown[-1], builder.block)
        k.add_incoming(following, builder.block)
        more = builder.icmp_signed("<", following, arguments[5])
        builder.cbranch(more, loop, behind)
        builder.position_at_end(behind)
        zero = ir.Constant(vector, [0.0] * count)
        for place, value in enumerate(grown):
            j, register = divmod(place, REGISTERS)
            positive = builder.select(builder.fcmp_ordered(">", value, zero), value, zero)
            value = builder.select(arguments[8], positive, value)
            target = rows(builder.gep(y_start, [_WORD(j * PANEL)]), register)
            builder.store(value, target, align=4)
        return context.get_dummy_value()

    word = types.int64
    return types.void(lanes, x, word, weights, word, word, y, word, types.boolean), generate


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
