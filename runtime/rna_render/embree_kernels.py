"""Compiled loops that hand rays to Embree, one rtcIntersect1 or rtcOccluded1 a ray.

A call through a ctypes function object cannot be cached by numba, because it bakes an address
into the code. So addresses (of the function, of the scene) come in as integers, and the
intrinsics below turn them into calls and memory accesses. All kernels are cached on disk.
"""

from __future__ import annotations

import numpy as np
from llvmlite import ir
from numba import cfunc, njit, prange, types
from numba.extending import intrinsic

# RTCRayHit as 32-bit words (rtcore_ray.h): RTCRay, then RTCHit; 16-byte aligned, 96 bytes.
RAY_ORIGIN, RAY_TNEAR, RAY_DIRECTION, RAY_TIME = 0, 3, 4, 7
RAY_TFAR, RAY_MASK, RAY_ID, RAY_FLAGS = 8, 9, 10, 11
HIT_U, HIT_V, HIT_PRIMITIVE, HIT_GEOMETRY, HIT_INSTANCE = 15, 16, 17, 18, 19
RAY_HIT_WORDS = 24
RAY_WORDS = 12
ALIGNMENT = 16
INVALID_ID = 0xFFFFFFFF

# RTCFilterFunctionNArguments as 64-bit words, and the place of instID[0] in a hit packet of one.
FILTER_VALID, FILTER_RAY, FILTER_HIT = 0, 3, 4
FILTER_HIT_INSTANCE = 7

# RTCOccludedArguments as 64-bit words: flags with feature mask, context, filter, and padding.
ARGUMENT_WORDS = 8
ARGUMENT_FILTER = 2
INVOKE_ARGUMENT_FILTER = 1 << 1
ALL_FEATURES = 0xFFFFFFFF

# Rays in one unit of parallel work: enough to hide its start, few enough to balance.
CHUNK = 1024
# Rays written before the first of them is traced. Embree reads a ray in 16-byte loads, which
# stall on 4-byte stores that have only just been made.
BLOCK = 32

_word, _byte = ir.IntType(32), ir.IntType(8)


@intrinsic
def _call_embree(typing_context, function, scene, ray, arguments):
    """Call `function(scene, ray, arguments)`; all four are addresses."""
    signature = types.void(types.uintp, types.uintp, types.uintp, types.uintp)

    def codegen(context, builder, _signature, values):
        pointer = _byte.as_pointer()
        function_type = ir.FunctionType(ir.VoidType(), [pointer] * 3)
        callee = builder.inttoptr(values[0], function_type.as_pointer())
        builder.call(callee, [builder.inttoptr(value, pointer) for value in values[1:]])
        return context.get_dummy_value()

    return signature, codegen


def _load(word_type, result):
    @intrinsic
    def load(typing_context, address):
        def codegen(_context, builder, _signature, values):
            return builder.load(builder.inttoptr(values[0], word_type.as_pointer()))

        return result(types.uintp), codegen

    return load


_load_u32 = _load(_word, types.uint32)
_load_u64 = _load(ir.IntType(64), types.uint64)


@intrinsic
def _store_zero_u32(typing_context, address):
    """Write a 32-bit zero to `address`."""

    def codegen(context, builder, _signature, values):
        builder.store(ir.Constant(_word, 0), builder.inttoptr(values[0], _word.as_pointer()))
        return context.get_dummy_value()

    return types.void(types.uintp), codegen


@cfunc(types.void(types.uintp), cache=True)
def _refuse_own_instance(arguments):
    """RTCFilterFunctionN: refuse a hit on the instance that the ray's id names."""
    ray = _load_u64(arguments + FILTER_RAY * 8)
    hit = _load_u64(arguments + FILTER_HIT * 8)
    if _load_u32(ray + RAY_ID * 4) == _load_u32(hit + FILTER_HIT_INSTANCE * 4):
        _store_zero_u32(_load_u64(arguments + FILTER_VALID * 8))


def own_instance_filter() -> np.ndarray:
    """RTCOccludedArguments that make a ray pass through the instance its id names.

    Returns (8,) uint64; the caller keeps it alive while its address is in use.
    """
    arguments = np.zeros(ARGUMENT_WORDS, np.uint64)
    arguments[0] = INVOKE_ARGUMENT_FILTER | ALL_FEATURES << 32
    arguments[ARGUMENT_FILTER] = _refuse_own_instance.address
    return arguments


@njit(cache=True)
def _ray_block(words):
    """BLOCK structs of `words` float32 each, on an address that Embree's loads may use."""
    block = np.empty(BLOCK * words + ALIGNMENT // 4, np.float32)
    skip = (-block.ctypes.data) % ALIGNMENT // 4
    return block[skip : skip + BLOCK * words].reshape(BLOCK, words)


@njit(cache=True)
def _set_ray(ray, bits, origin, direction, tnear, tfar, ray_id):
    """Fill the RTCRay; a ray that is not finite or has no direction gets an empty interval."""
    size = np.float32(0.0)
    for axis in range(3):
        ray[RAY_ORIGIN + axis] = origin[axis]
        ray[RAY_DIRECTION + axis] = direction[axis]
        size += abs(direction[axis])
    place = abs(origin[0]) + abs(origin[1]) + abs(origin[2])
    traced = place < np.inf and 0.0 < size < np.inf  # False for NaN too
    ray[RAY_TNEAR] = tnear
    ray[RAY_TIME] = 0.0
    ray[RAY_TFAR] = tfar if traced else -1.0
    bits[RAY_MASK] = INVALID_ID
    bits[RAY_ID] = ray_id
    bits[RAY_FLAGS] = 0


@njit(cache=True, parallel=True)
def intersect(
    function, scene, owner_word, origins, directions, tnear, tfar, t, owner, triangle, u, v
):
    """Closest hits.

    function, scene: addresses of rtcIntersect1 and of the scene.
    owner_word: HIT_GEOMETRY or HIT_INSTANCE, the number that `owner` gets.
    origins, directions: (n, 3) float32. tnear, tfar: (n,) float32, or (1,) for all rays.
    t: (n,) float32 out, infinity for a miss.
    owner, triangle: (n,) int32 out, -1 for a miss.
    u, v: (n,) float32 out, 0 for a miss.
    """
    n = len(t)
    for chunk in prange((n + CHUNK - 1) // CHUNK):
        rays = _ray_block(RAY_HIT_WORDS)
        bits = rays.view(np.uint32)
        address = rays.ctypes.data
        for start in range(chunk * CHUNK, min(n, (chunk + 1) * CHUNK), BLOCK):
            count = min(BLOCK, n - start)
            for k in range(count):
                i = start + k
                near, far = tnear[min(i, len(tnear) - 1)], tfar[min(i, len(tfar) - 1)]
                _set_ray(rays[k], bits[k], origins[i], directions[i], near, far, 0)
                bits[k, HIT_GEOMETRY] = INVALID_ID
                bits[k, HIT_INSTANCE] = INVALID_ID
            for k in range(count):
                if rays[k, RAY_TNEAR] <= rays[k, RAY_TFAR]:
                    _call_embree(function, scene, address + k * RAY_HIT_WORDS * 4, 0)
            for k in range(count):
                i = start + k
                hit = bits[k, HIT_GEOMETRY] != INVALID_ID
                t[i] = rays[k, RAY_TFAR] if hit else np.inf
                owner[i] = np.int32(bits[k, owner_word]) if hit else -1
                triangle[i] = np.int32(bits[k, HIT_PRIMITIVE]) if hit else -1
                u[i] = rays[k, HIT_U] if hit else 0.0
                v[i] = rays[k, HIT_V] if hit else 0.0


@njit(cache=True, parallel=True)
def occluded(function, scene, arguments, ray_id, origins, directions, tnear, tfar, result):
    """Whether anything is hit between tnear and tfar.

    function, scene: addresses of rtcOccluded1 and of the scene.
    arguments: address of RTCOccludedArguments, or 0.
    ray_id: (n,) uint32, or (1,) for all rays: the instance that a ray passes through, if
        `arguments` are those of own_instance_filter.
    origins, directions: (n, 3) float32. tnear, tfar: (n,) float32, or (1,) for all rays.
    result: (n,) bool out; False for a ray that is not finite or has no direction.
    """
    n = len(result)
    for chunk in prange((n + CHUNK - 1) // CHUNK):
        rays = _ray_block(RAY_WORDS)
        bits = rays.view(np.uint32)
        address = rays.ctypes.data
        for start in range(chunk * CHUNK, min(n, (chunk + 1) * CHUNK), BLOCK):
            count = min(BLOCK, n - start)
            for k in range(count):
                i = start + k
                near, far = tnear[min(i, len(tnear) - 1)], tfar[min(i, len(tfar) - 1)]
                number = ray_id[min(i, len(ray_id) - 1)]
                _set_ray(rays[k], bits[k], origins[i], directions[i], near, far, number)
            for k in range(count):
                if rays[k, RAY_TNEAR] <= rays[k, RAY_TFAR]:
                    _call_embree(function, scene, address + k * RAY_WORDS * 4, arguments)
            for k in range(count):
                # rtcOccluded1 reports a hit by setting tfar to minus infinity.
                result[start + k] = rays[k, RAY_TFAR] == -np.inf
