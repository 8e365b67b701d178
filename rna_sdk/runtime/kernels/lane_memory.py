"""Compiled: lanes from and to arrays, a row a lane."""

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils

from rna_sdk.runtime.kernels.lanes import LANES, LANES32, LANES64, operation

_tools: Any = cgutils  # numba leaves these without types
_tuple: Any = types.UniTuple
_FLOATS = ir.VectorType(ir.FloatType(), LANES)
_DOUBLES = ir.VectorType(ir.DoubleType(), LANES)
_INDEX = ir.IntType(32)


def _data(context: Any, builder: ir.IRBuilder, kind: Any, array: Any, at: ir.Value) -> ir.Value:
    """The address of element `at` of a flat array."""
    start = context.make_array(kind)(context, builder, array).data
    return builder.gep(start, [at])


@operation
def load_vectors(typing_context: Any, rows: Any, first: Any) -> Any:
    """x, y and z in float64 of rows first : first + LANES of a C-contiguous (n, 3) float32."""

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, values: Any) -> Any:
        start = builder.mul(values[1], ir.Constant(values[1].type, 3))
        address = _data(context, builder, signed.args[0], values[0], start)
        together = ir.VectorType(ir.FloatType(), 3 * LANES)
        block = builder.load(builder.bitcast(address, together.as_pointer()), align=4)
        undefined = ir.Constant(together, ir.Undefined)
        parts = []
        for k in range(3):
            places = [3 * row + k for row in range(LANES)]
            mask = ir.Constant(ir.VectorType(_INDEX, LANES), places)
            parts.append(builder.fpext(builder.shuffle_vector(block, undefined, mask), _DOUBLES))
        return _tools.pack_array(builder, parts, _DOUBLES)

    return _tuple(LANES64, 3)(rows, types.uintp), generate


@operation
def load_lanes(typing_context: Any, values: Any, first: Any) -> Any:
    """values[first : first + LANES] of a C-contiguous (n,) float32."""

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any) -> Any:
        address = _data(context, builder, signed.args[0], *arguments)
        return builder.load(builder.bitcast(address, _FLOATS.as_pointer()), align=4)

    return LANES32(values, types.uintp), generate


@operation
def store_lanes(typing_context: Any, values: Any, first: Any, lanes: Any) -> Any:
    """values[first : first + LANES] = lanes, of a C-contiguous float32 array seen as flat."""

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any) -> Any:
        address = _data(context, builder, signed.args[0], *arguments[:2])
        builder.store(arguments[2], builder.bitcast(address, _FLOATS.as_pointer()), align=4)
        return context.get_dummy_value()

    return types.void(values, types.uintp, LANES32), generate


@operation
def store_counts(typing_context: Any, values: Any, first: Any, lanes: Any) -> Any:
    """values[first : first + LANES] = lanes, whole numbers, of a flat uint32 array."""
    counts = ir.VectorType(ir.IntType(32), LANES)

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any) -> Any:
        address = _data(context, builder, signed.args[0], *arguments[:2])
        integers = builder.fptosi(arguments[2], counts)
        builder.store(integers, builder.bitcast(address, counts.as_pointer()), align=4)
        return context.get_dummy_value()

    return types.void(values, types.uintp, lanes), generate


@operation
def load_column(typing_context: Any, rows: Any, first: Any, stride: Any) -> Any:
    """The lanes rows.flat[first + k * stride] of a C-contiguous float32 array."""

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any) -> Any:
        lanes, at = ir.Constant(_FLOATS, ir.Undefined), arguments[1]
        for k in range(LANES):
            number = builder.load(_data(context, builder, signed.args[0], arguments[0], at))
            lanes = builder.insert_element(lanes, number, _INDEX(k))
            at = builder.add(at, arguments[2])
        return lanes

    return LANES32(rows, types.uintp, types.uintp), generate


@operation
def store_column(typing_context: Any, rows: Any, first: Any, stride: Any, lanes: Any) -> Any:
    """rows.flat[first + k * stride] = lanes[k] of a C-contiguous float32 array."""

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any) -> Any:
        at = arguments[1]
        for k in range(LANES):
            address = _data(context, builder, signed.args[0], arguments[0], at)
            builder.store(builder.extract_element(arguments[3], _INDEX(k)), address)
            at = builder.add(at, arguments[2])
        return context.get_dummy_value()

    return types.void(rows, types.uintp, types.uintp, LANES32), generate


@operation
def store_mask(typing_context: Any, flags: Any, first: Any, mask: Any) -> Any:
    """flags[first : first + LANES] = mask, of a (n,) bool."""
    flat = ir.VectorType(ir.IntType(8), LANES)

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any) -> Any:
        address = _data(context, builder, signed.args[0], *arguments[:2])
        wide = builder.zext(arguments[2], flat)
        builder.store(wide, builder.bitcast(address, flat.as_pointer()), align=1)
        return context.get_dummy_value()

    return types.void(flags, types.uintp, mask), generate
