"""Memory by its address, for compiled code that Embree calls: it gets nothing but addresses."""

from collections.abc import Callable
from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from rna_sdk.machine.compiled import compiled


def _load(word: Any, result: Any) -> Any:
    @intrinsic
    def load(typing_context: Any, address: Any) -> Any:
        def codegen(_context: Any, builder: Any, _signature: Any, values: Any) -> Any:
            return builder.load(builder.inttoptr(values[0], word.as_pointer()))

        return result(types.uintp), codegen

    return load


def _store(word: Any, value_type: Any) -> Any:
    @intrinsic
    def store(typing_context: Any, address: Any, value: Any) -> Any:
        def codegen(context: Any, builder: Any, _signature: Any, values: Any) -> Any:
            builder.store(values[1], builder.inttoptr(values[0], word.as_pointer()))
            return context.get_dummy_value()

        return types.void(types.uintp, value_type), codegen

    return store


load_u8: Callable[[Any], int] = _load(ir.IntType(8), types.uint8)
load_i32: Callable[[Any], int] = _load(ir.IntType(32), types.int32)
load_u32: Callable[[Any], np.uint32] = _load(ir.IntType(32), types.uint32)
load_u64: Callable[[Any], np.uint64] = _load(ir.IntType(64), types.uint64)
load_f32: Callable[[Any], float] = _load(ir.FloatType(), types.float32)
load_f64: Callable[[Any], float] = _load(ir.DoubleType(), types.float64)
store_u32: Callable[[Any, np.uint32], None] = _store(ir.IntType(32), types.uint32)
store_f64: Callable[[Any, float], None] = _store(ir.DoubleType(), types.float64)


def _pointer(element: Any) -> Any:
    @intrinsic
    def pointer(typing_context: Any, address: Any) -> Any:
        def codegen(context: Any, builder: Any, _signature: Any, values: Any) -> Any:
            kind = context.get_value_type(types.CPointer(element))
            return builder.inttoptr(values[0], kind)

        return types.CPointer(element)(types.uintp), codegen

    return pointer


# For `numba.carray`, which makes an array of them.
pointer_i32 = _pointer(types.int32)
pointer_f32 = _pointer(types.float32)
pointer_f64 = _pointer(types.float64)


@compiled(fastmath=())
def signed(word: Any) -> int:
    """An unsigned integer as one that may be negative; int() would leave it unsigned."""
    return np.int64(word)  # type: ignore[return-value]
