"""What a ray passes through: compiled filters that Embree asks about every hit.

A filter gets the address of RTCFilterFunctionNArguments and sets `valid` to 0 to refuse the hit.
What to refuse stands in the ray's id.
"""

from __future__ import annotations

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from rna_render.embree_kernels import RAY_DIRECTION, RAY_ID
from rna_sdk.compiled import callback

# RTCFilterFunctionNArguments as 64-bit words, and RTCHit in a packet of one as 32-bit words.
FILTER_VALID, FILTER_USER_DATA, FILTER_RAY, FILTER_HIT = 0, 1, 3, 4
FILTER_HIT_NORMAL, FILTER_HIT_PRIMITIVE, FILTER_HIT_INSTANCE = 0, 5, 7

# RTCIntersectArguments and RTCOccludedArguments as 64-bit words, as far as they are alike: flags
# with feature mask, context, filter; then zeros.
ARGUMENT_WORDS = 8
ARGUMENT_FILTER = 2
INVOKE_ARGUMENT_FILTER = 1 << 1
ALL_FEATURES = 0xFFFFFFFF

_word = ir.IntType(32)


def _load(word_type, result):
    @intrinsic
    def load(typing_context, address):
        def codegen(_context, builder, _signature, values):
            return builder.load(builder.inttoptr(values[0], word_type.as_pointer()))

        return result(types.uintp), codegen

    return load


_load_u32 = _load(_word, types.uint32)
_load_u64 = _load(ir.IntType(64), types.uint64)
_load_f32 = _load(ir.FloatType(), types.float32)


@intrinsic
def _store_zero_u32(typing_context, address):
    """Write a 32-bit zero to `address`."""

    def codegen(context, builder, _signature, values):
        builder.store(ir.Constant(_word, 0), builder.inttoptr(values[0], _word.as_pointer()))
        return context.get_dummy_value()

    return types.void(types.uintp), codegen


@callback(types.uintp)
def _refuse_own_instance(arguments):
    """RTCFilterFunctionN: refuse a hit on the instance that the ray's id names."""
    ray = _load_u64(arguments + FILTER_RAY * 8)
    hit = _load_u64(arguments + FILTER_HIT * 8)
    if _load_u32(ray + RAY_ID * 4) == _load_u32(hit + FILTER_HIT_INSTANCE * 4):
        _store_zero_u32(_load_u64(arguments + FILTER_VALID * 8))


@callback(types.uintp)
def _refuse_own_strand(arguments):
    """RTCFilterFunctionN: refuse a hit from inside, and one on the strand the ray's id names.

    The user data of curves is the address of the strand of each segment, uint32; meshes have
    none, and their hits stand.
    """
    ray = _load_u64(arguments + FILTER_RAY * 8)
    hit = _load_u64(arguments + FILTER_HIT * 8)
    strands = _load_u64(arguments + FILTER_USER_DATA * 8)
    if strands == 0:
        return
    segment = types.uint64(_load_u32(hit + FILTER_HIT_PRIMITIVE * 4))
    outward = types.float32(0.0)
    for axis in range(3):
        direction = _load_f32(ray + types.uint64(RAY_DIRECTION + axis) * 4)
        outward += direction * _load_f32(hit + types.uint64(FILTER_HIT_NORMAL + axis) * 4)
    if outward > 0.0 or _load_u32(ray + RAY_ID * 4) == _load_u32(strands + segment * 4):
        _store_zero_u32(_load_u64(arguments + FILTER_VALID * 8))


def own_instance_filter() -> np.ndarray:
    """Arguments that make a ray of either sort pass through the instance its id names.

    Returns (8,) uint64; the caller keeps it alive while its address is in use.
    """
    return _arguments(_refuse_own_instance.address)


def own_strand_filter() -> np.ndarray:
    """RTCOccludedArguments that make a ray pass through the strand its id names.

    It also leaves every other strand that it starts in. For curves with `strands` as their
    user data, among meshes without. Returns (8,) uint64; the
    caller keeps it alive while its address is in use.
    """
    return _arguments(_refuse_own_strand.address)


def _arguments(filter_address: int) -> np.ndarray:
    arguments = np.zeros(ARGUMENT_WORDS, np.uint64)
    arguments[0] = INVOKE_ARGUMENT_FILTER | ALL_FEATURES << 32
    arguments[ARGUMENT_FILTER] = filter_address
    return arguments
