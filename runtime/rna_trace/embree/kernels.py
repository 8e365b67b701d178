"""Compiled loops that hand rays to Embree, one rtcIntersect1 or rtcOccluded1 a ray.

A call through a ctypes function object cannot be cached by numba, because it bakes an address
into the code. So addresses (of the function, of the scene) come in as integers, and the
intrinsics below turn them into calls and memory accesses. All kernels are cached on disk.
"""

from typing import Any, NamedTuple

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from rna_sdk.machine.compiled import compiled

# RTCRayHit as 32-bit words (rtcore_ray.h): RTCRay, then RTCHit; 16-byte aligned, 96 bytes.
RAY_ORIGIN, RAY_TNEAR, RAY_DIRECTION, RAY_TIME = 0, 3, 4, 7
RAY_TFAR, RAY_MASK, RAY_ID, RAY_FLAGS = 8, 9, 10, 11
HIT_NORMAL, HIT_U, HIT_V, HIT_PRIMITIVE, HIT_GEOMETRY, HIT_INSTANCE = 12, 15, 16, 17, 18, 19
RAY_HIT_WORDS = 24
RAY_WORDS = 12
ALIGNMENT = 16
INVALID_ID = 0xFFFFFFFF

# RTCRayQueryContext (rtcore_common.h) with what is ours behind it, as 64-bit words: of a closest
# hit what it does not let through over the chance to be one; the product over hits that were
# passed; whether they were coloured; the hit to leave out: primitive, geometry, instance, uint32.
CONTEXT_SHARE, CONTEXT_WEIGHT, CONTEXT_COLOURED, CONTEXT_LAST = 8, 11, 14, 15
CONTEXT_WORDS = 17
ARGUMENT_CONTEXT = 1

# Rays written before the first of them is traced. Embree reads a ray in 16-byte loads, which
# stall on 4-byte stores that have only just been made.
BLOCK = 32


class Rays(NamedTuple):
    """ray_id: (n,) uint32, the geometry that a ray passes, as in one of the `filters`. mask: (n,)
    uint32; rays meet instances that share a bit. origins, directions: (n, 3) float32. tnear, tfar:
    (n,) float32. All but the vectors may be (1,), for all rays.
    """

    ray_id: np.ndarray
    mask: np.ndarray
    origins: np.ndarray
    directions: np.ndarray
    tnear: np.ndarray
    tfar: np.ndarray


class Hits(NamedTuple):
    """t: (n,) float32, infinity for a miss. instance, geometry, primitive: (n,) int32, -1 for a
    miss; instance also where there are none. u, v: (n,) float32, 0 for a miss. ng: (n, 3) float32,
    unit, 0 for a miss.
    """

    t: np.ndarray
    instance: np.ndarray
    geometry: np.ndarray
    primitive: np.ndarray
    u: np.ndarray
    v: np.ndarray
    ng: np.ndarray


@intrinsic
def _call_embree(typing_context: Any, function: Any, scene: Any, ray: Any, arguments: Any) -> Any:
    """Call `function(scene, ray, arguments)`; all four are addresses."""
    signature = types.void(types.uintp, types.uintp, types.uintp, types.uintp)

    def codegen(context: Any, builder: Any, _signature: Any, values: Any) -> Any:
        pointer = ir.IntType(8).as_pointer()
        function_type = ir.FunctionType(ir.VoidType(), [pointer] * 3)
        callee = builder.inttoptr(values[0], function_type.as_pointer())
        builder.call(callee, [builder.inttoptr(value, pointer) for value in values[1:]])
        return context.get_dummy_value()

    return signature, codegen


call_embree: Any = _call_embree  # numba's type has the typing context among the arguments


@compiled(fastmath=())
def _ray_block(words: int) -> np.ndarray:
    """BLOCK structs of `words` float32 each, on an address that Embree's loads may use."""
    block = np.empty(BLOCK * words + ALIGNMENT // 4, np.float32)
    skip = (-block.ctypes.data) % ALIGNMENT // 4
    return block[skip : skip + BLOCK * words].reshape(BLOCK, words)


@compiled(fastmath=())
def _set_ray(
    ray: np.ndarray,
    bits: np.ndarray,
    origin: np.ndarray,
    direction: np.ndarray,
    tnear: float,
    tfar: float,
    mask: int,
    ray_id: int,
) -> None:
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
    bits[RAY_MASK] = mask
    bits[RAY_ID] = ray_id
    bits[RAY_FLAGS] = 0


@compiled(fastmath=())
def _store_normal(ray: np.ndarray, ng: np.ndarray) -> None:
    """Normalise Embree's Ng, of any length, in float64: squares of tiny ones leave float32."""
    x, y, z = ray[HIT_NORMAL], ray[HIT_NORMAL + 1], ray[HIT_NORMAL + 2]
    x, y, z = np.float64(x), np.float64(y), np.float64(z)
    length = np.sqrt(x * x + y * y + z * z)
    scale = 1.0 / length if length > 0.0 else 0.0
    ng[0], ng[1], ng[2] = x * scale, y * scale, z * scale


@compiled(fastmath=())
def _aim(ray: np.ndarray, bits: np.ndarray, i: int, rays: Rays) -> bool:
    """Fill the RTCRay with row i of Rays; False for a ray that meets nothing."""
    ray_id, mask, origins, directions, tnear, tfar = rays
    near, far = tnear[min(i, len(tnear) - 1)], tfar[min(i, len(tfar) - 1)]
    number, met = ray_id[min(i, len(ray_id) - 1)], mask[min(i, len(mask) - 1)]
    _set_ray(ray, bits, origins[i], directions[i], near, far, met, number)
    return bool(ray[RAY_TNEAR] <= ray[RAY_TFAR])


@compiled(fastmath=())
def _store_hits(block: np.ndarray, bits: np.ndarray, start: int, count: int, hits: Hits) -> None:
    """Copy `count` RTCHits to Hits, from row `start` on."""
    t, instance, geometry, primitive, u, v, ng = hits
    for k in range(count):
        i = start + k
        hit = bits[k, HIT_GEOMETRY] != INVALID_ID
        t[i] = block[k, RAY_TFAR] if hit else np.inf
        instance[i] = np.int32(bits[k, HIT_INSTANCE]) if hit else -1
        geometry[i] = np.int32(bits[k, HIT_GEOMETRY]) if hit else -1
        primitive[i] = np.int32(bits[k, HIT_PRIMITIVE]) if hit else -1
        u[i] = block[k, HIT_U] if hit else 0.0
        v[i] = block[k, HIT_V] if hit else 0.0
        if hit:
            _store_normal(block[k], ng[i])
        else:
            ng[i] = 0.0


@compiled(rows="hits rays", fastmath=())
def intersect(function: int, scene: int, arguments: int, rays: Rays, hits: Hits) -> None:
    """Closest hits.

    function, scene: addresses of rtcIntersect1 and of the scene. arguments: address of
    RTCIntersectArguments, or 0. rays: Rays. hits: Hits, written.
    """
    n = len(hits[0])
    block = _ray_block(RAY_HIT_WORDS)
    bits = block.view(np.uint32)
    address = block.ctypes.data
    for start in range(0, n, BLOCK):
        count = min(BLOCK, n - start)
        for k in range(count):
            _aim(block[k], bits[k], start + k, rays)
            bits[k, HIT_GEOMETRY] = INVALID_ID
            bits[k, HIT_INSTANCE] = INVALID_ID
        for k in range(count):
            if block[k, RAY_TNEAR] <= block[k, RAY_TFAR]:
                call_embree(function, scene, address + k * RAY_HIT_WORDS * 4, arguments)
        _store_hits(block, bits, start, count, hits)


@compiled(rows="result rays", fastmath=())
def occluded(function: int, scene: int, arguments: int, rays: Rays, result: np.ndarray) -> None:
    """Whether anything is hit between tnear and tfar.

    function, scene: addresses of rtcOccluded1 and of the scene. arguments: address of
    RTCOccludedArguments, or 0. rays: Rays. result: (n,) bool, written; False for a ray that is
    not finite or has no direction.
    """
    n = len(result)
    block = _ray_block(RAY_WORDS)
    bits = block.view(np.uint32)
    address = block.ctypes.data
    for start in range(0, n, BLOCK):
        count = min(BLOCK, n - start)
        for k in range(count):
            _aim(block[k], bits[k], start + k, rays)
        for k in range(count):
            if block[k, RAY_TNEAR] <= block[k, RAY_TFAR]:
                call_embree(function, scene, address + k * RAY_WORDS * 4, arguments)
        for k in range(count):
            # rtcOccluded1 reports a hit by setting tfar to minus infinity.
            result[start + k] = block[k, RAY_TFAR] == -np.inf


@compiled(fastmath=())
def _query(arguments: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A copy of the arguments with a context of its own, and the context."""
    context = np.full(CONTEXT_WORDS, 0xFFFFFFFFFFFFFFFF, np.uint64)
    copy = arguments.copy()
    copy[ARGUMENT_CONTEXT] = context.ctypes.data
    return copy, context


@compiled(fastmath=())
def _start(context: np.ndarray) -> None:
    """Initialise the context of a ray, except for its instance."""
    values = context.view(np.float64)
    values[CONTEXT_SHARE:CONTEXT_COLOURED] = 1.0
    values[CONTEXT_COLOURED] = 0.0


@compiled(rows="result rays", fastmath=())
def transmitted(
    function: int, scene: int, arguments: np.ndarray, rays: Rays, result: np.ndarray
) -> None:
    """Product of the transmittance of all hits between tnear and tfar.

    arguments: (8,) uint64 of a transmittance filter. result: (n, 3) float32, written; 1 for a ray
    that is not finite or has no direction. The others are those of `occluded`.
    """
    n = len(result)
    block = _ray_block(RAY_WORDS)
    ray, bits = block[0], block.view(np.uint32)[0]
    query, context = _query(arguments)
    for i in range(n):
        result[i] = 1.0
        if _aim(ray, bits, i, rays):
            _start(context)
            call_embree(function, scene, block.ctypes.data, query.ctypes.data)
            blocked = ray[RAY_TFAR] == -np.inf
            for channel in range(3):
                weight = context.view(np.float64)[CONTEXT_WEIGHT + channel]
                result[i, channel] = 0.0 if blocked else weight


@compiled(rows="hits rays weight", fastmath=())
def intersect_through(
    functions: tuple[int, int],
    scene: int,
    arguments: tuple[np.ndarray, np.ndarray],
    rays: Rays,
    hits: Hits,
    weight: np.ndarray,
) -> None:
    """Closest hits of rays that pass through hits at random, as often as these let light through.

    functions: addresses of rtcIntersect1 and of rtcOccluded1. arguments: of either, (8,) uint64,
    of `filters.random_transmittance_filters`. weight: (n, 3) float32, written: what is found has to
    be multiplied by it, 1 unless a hit is coloured; or (0, 3), where none is. The others are those
    of `intersect`.
    """
    n = len(hits[0])
    block = _ray_block(RAY_HIT_WORDS)
    blocks = block.view(np.uint32)
    ray, bits, address = block[0], blocks[0], block.ctypes.data
    query, context = _query(arguments[0])
    weighing, _ = _query(arguments[1])
    weighing[ARGUMENT_CONTEXT] = context.ctypes.data
    for i in range(n):
        bits[HIT_GEOMETRY] = INVALID_ID
        bits[HIT_INSTANCE] = INVALID_ID
        _start(context)
        traced = _aim(ray, bits, i, rays)
        if traced:
            call_embree(functions[0], scene, address, query.ctypes.data)
        _store_hits(block, blocks, i, 1, hits)
        if len(weight):
            values = context.view(np.float64)
            if traced and values[CONTEXT_COLOURED] > 0.0:
                _name_last(context, bits)
                _aim(ray, bits, i, rays)
                ray[RAY_TFAR] = min(ray[RAY_TFAR], hits[0][i])
                call_embree(functions[1], scene, address, weighing.ctypes.data)
            for channel in range(3):
                share = values[CONTEXT_SHARE + channel] if hits[0][i] < np.inf else 1.0
                weight[i, channel] = share * values[CONTEXT_WEIGHT + channel]


@compiled(fastmath=())
def _name_last(context: np.ndarray, words: np.ndarray) -> None:
    last = context[CONTEXT_LAST:].view(np.uint32)
    last[0], last[1] = words[HIT_PRIMITIVE], words[HIT_GEOMETRY]
    last[2] = words[HIT_INSTANCE]
