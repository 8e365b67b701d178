"""Filters of hits that a ray passes through, compiled, which Embree calls for every hit.

A filter gets the address of RTCFilterFunctionNArguments and sets `valid` to 0 to refuse the hit.
What to refuse stands in the ray's id; what a ray carries through refused hits stands in the
query's context, see `kernels`.
"""

from functools import cache
from typing import Any

import numpy as np
from numba import types

from rna_sdk.machine.compiled import callback, compiled
from rna_trace.embree.kernels import (
    CONTEXT_COLOURED,
    CONTEXT_LAST,
    CONTEXT_SHARE,
    CONTEXT_WEIGHT,
    RAY_DIRECTION,
    RAY_ID,
    RAY_ORIGIN,
)
from rna_trace.hashing import hash_bits
from rna_trace.memory import load_f32, load_f64, load_u32, load_u64, store_f64, store_u32
from rna_trace.transmittance import STRANDS, transmittance
from rna_trace.vectors import Vector

# RTCFilterFunctionNArguments as 64-bit words, and RTCHit in a packet of one as 32-bit words.
FILTER_VALID, FILTER_USER_DATA, FILTER_CONTEXT, FILTER_RAY, FILTER_HIT = range(5)
FILTER_HIT_NORMAL, FILTER_HIT_U, FILTER_HIT_V = 0, 3, 4
FILTER_HIT_PRIMITIVE, FILTER_HIT_GEOMETRY, FILTER_HIT_INSTANCE = 5, 6, 7

# RTCIntersectArguments and RTCOccludedArguments as 64-bit words, as far as they are alike: flags
# with feature mask, context, filter; then zeros.
ARGUMENT_WORDS = 8
ARGUMENT_FILTER = 2
INVOKE_ARGUMENT_FILTER = 1 << 1
ALL_FEATURES = 0xFFFFFFFF


@compiled(fastmath=())
def _word(arguments: Any, number: int) -> np.uint64:
    return load_u64(arguments + np.uint64(8 * number))


@compiled(fastmath=())
def _bits(address: Any, number: int) -> np.uint32:
    return load_u32(address + np.uint64(4 * number))


@compiled(fastmath=())
def _refuse(arguments: Any) -> None:
    store_u32(_word(arguments, FILTER_VALID), np.uint32(0))


@compiled(fastmath=())
def _on_start_instance(arguments: Any) -> bool:
    hit = _word(arguments, FILTER_HIT)
    return bool(_bits(_word(arguments, FILTER_RAY), RAY_ID) == _bits(hit, FILTER_HIT_INSTANCE))


@compiled(fastmath=())
def _along_normal(arguments: Any) -> float:
    """The dot product of the ray's direction and the hit's normal, both of any length."""
    ray, hit = _word(arguments, FILTER_RAY), _word(arguments, FILTER_HIT)
    result = 0.0
    for axis in range(3):
        direction = np.float64(load_f32(ray + np.uint64(4 * (RAY_DIRECTION + axis))))
        result += direction * load_f32(hit + np.uint64(4 * (FILTER_HIT_NORMAL + axis)))
    return result


@compiled(fastmath=())
def _on_start_strand(arguments: Any) -> bool:
    """Whether the hit is on a strand from inside, or on the strand that the ray's id names."""
    table = _word(arguments, FILTER_USER_DATA)
    if table == np.uint64(0):
        return False
    strands = _word(table, STRANDS)
    if strands == np.uint64(0):
        return False
    segment = np.uint64(_bits(_word(arguments, FILTER_HIT), FILTER_HIT_PRIMITIVE))
    same = _bits(_word(arguments, FILTER_RAY), RAY_ID) == load_u32(strands + segment * np.uint64(4))
    return same or _along_normal(arguments) > 0.0


@compiled(fastmath=())
def _transmittance(arguments: Any) -> Vector:
    """(red, green, blue) of the hit."""
    ray, hit = _word(arguments, FILTER_RAY), _word(arguments, FILTER_HIT)
    u = np.float64(load_f32(hit + np.uint64(4 * FILTER_HIT_U)))
    v = np.float64(load_f32(hit + np.uint64(4 * FILTER_HIT_V)))
    x = np.float64(load_f32(ray + np.uint64(4 * RAY_DIRECTION)))
    y = np.float64(load_f32(ray + np.uint64(4 * (RAY_DIRECTION + 1))))
    z = np.float64(load_f32(ray + np.uint64(4 * (RAY_DIRECTION + 2))))
    triangle = _bits(hit, FILTER_HIT_PRIMITIVE)
    table = _word(arguments, FILTER_USER_DATA)
    facing = _along_normal(arguments) < 0.0
    return transmittance(table, triangle, u, v, (x, y, z), facing)


@compiled(fastmath=())
def _chance(arguments: Any) -> float:
    """Deterministic random number in [0, 1) of a ray and a primitive."""
    ray, hit = _word(arguments, FILTER_RAY), _word(arguments, FILTER_HIT)
    state = np.uint32(0)
    for word in (FILTER_HIT_PRIMITIVE, FILTER_HIT_GEOMETRY, FILTER_HIT_INSTANCE):
        state = hash_bits(state ^ _bits(hit, word))
    for axis in range(3):
        state = hash_bits(state ^ _bits(ray, RAY_ORIGIN + axis))
        state = hash_bits(state ^ _bits(ray, RAY_DIRECTION + axis))
    return state * 2.0**-32


@compiled(fastmath=())
def _multiply(address: Any, red: float, green: float, blue: float) -> None:
    """Multiply three float64 in memory."""
    for channel in range(3):
        factor = red if channel == 0 else (green if channel == 1 else blue)
        place = address + np.uint64(8 * channel)
        store_f64(place, load_f64(place) * factor)


@compiled(fastmath=())
def _pass_at_random(arguments: Any) -> None:
    """Refuse the hit as often as it lets light through, the mean of its colours."""
    red, green, blue = _transmittance(arguments)
    mean = (red + green + blue) / 3.0
    context = _word(arguments, FILTER_CONTEXT)
    coloured = not (red == green == blue)
    share = context + np.uint64(8 * CONTEXT_SHARE)
    if mean > 0.0 and _chance(arguments) < mean:
        if coloured:
            store_f64(context + np.uint64(8 * CONTEXT_COLOURED), 1.0)
        _refuse(arguments)
        return
    for channel in range(3):
        store_f64(share + np.uint64(8 * channel), 1.0)
    if coloured:
        rest = 1.0 - mean
        _multiply(share, (1.0 - red) / rest, (1.0 - green) / rest, (1.0 - blue) / rest)


@compiled(fastmath=())
def _pass_all(arguments: Any) -> None:
    """Multiply the ray's transmittance by the hit's; refuse the hit unless the product is 0."""
    red, green, blue = _transmittance(arguments)
    weight = _word(arguments, FILTER_CONTEXT) + np.uint64(8 * CONTEXT_WEIGHT)
    _multiply(weight, red, green, blue)
    for channel in range(3):
        if load_f64(weight + np.uint64(8 * channel)) > 0.0:
            _refuse(arguments)
            return


@compiled(fastmath=())
def _is_last(arguments: Any) -> bool:
    """Whether the hit is named by the context."""
    hit, result = _word(arguments, FILTER_HIT), True
    last = _word(arguments, FILTER_CONTEXT) + np.uint64(8 * CONTEXT_LAST)
    for k, word in enumerate((FILTER_HIT_PRIMITIVE, FILTER_HIT_GEOMETRY, FILTER_HIT_INSTANCE)):
        result &= _bits(hit, word) == _bits(last, k)
    return result


@callback(types.uintp)
def _refuse_start_instance(arguments: Any) -> None:
    """RTCFilterFunctionN: refuse a hit on the instance that the ray's id names."""
    if _on_start_instance(arguments):
        _refuse(arguments)


@callback(types.uintp)
def _refuse_start_strand(arguments: Any) -> None:
    """RTCFilterFunctionN: refuse a hit from inside, and one on the strand the ray's id names."""
    if _on_start_strand(arguments):
        _refuse(arguments)


@callback(types.uintp)
def _pass_at_random_but_start_instance(arguments: Any) -> None:
    if _on_start_instance(arguments):
        _refuse(arguments)
    else:
        _pass_at_random(arguments)


@callback(types.uintp)
def _pass_all_but_start_instance(arguments: Any) -> None:
    if _on_start_instance(arguments):
        _refuse(arguments)
    else:
        _pass_all(arguments)


@callback(types.uintp)
def _pass_all_but_start_strand(arguments: Any) -> None:
    if _on_start_strand(arguments):
        _refuse(arguments)
    else:
        _pass_all(arguments)


@callback(types.uintp)
def _weigh_passed(arguments: Any) -> None:
    """Refuse every hit; multiply by colour over mean where `_pass_at_random` has passed."""
    if not (_on_start_instance(arguments) or _is_last(arguments)):
        red, green, blue = _transmittance(arguments)
        mean = (red + green + blue) / 3.0
        if mean > 0.0 and _chance(arguments) < mean:
            weight = _word(arguments, FILTER_CONTEXT) + np.uint64(8 * CONTEXT_WEIGHT)
            _multiply(weight, red / mean, green / mean, blue / mean)
    _refuse(arguments)


@cache
def start_instance_filter() -> np.ndarray:
    """Arguments that make a ray of either sort pass through the instance its id names.

    Returns (8,) uint64, the same array each time: its address may go to Embree.
    """
    return _arguments(_refuse_start_instance.address)


@cache
def start_strand_filter() -> np.ndarray:
    """RTCOccludedArguments that make a ray pass through the strand its id names.

    It also leaves every other strand that it starts in. For curves with a `geometry_table` of
    their strands as user data, among meshes. Returns as `start_instance_filter` does.
    """
    return _arguments(_refuse_start_strand.address)


@cache
def random_transmittance_filters() -> tuple[np.ndarray, np.ndarray]:
    """Arguments of `kernels.intersect_through`: of its search, and of its weights.

    The instance that the ray's id names is passed through as well.
    """
    return _arguments(_pass_at_random_but_start_instance.address), _arguments(_weigh_passed.address)


@cache
def transmittance_filter() -> np.ndarray:
    """Arguments of `kernels.transmitted`; the ray's id is as for `start_instance_filter`."""
    return _arguments(_pass_all_but_start_instance.address)


@cache
def strand_transmittance_filter() -> np.ndarray:
    """Arguments of `kernels.transmitted`; the ray's id is as for `start_strand_filter`."""
    return _arguments(_pass_all_but_start_strand.address)


def _arguments(filter_address: int) -> np.ndarray:
    arguments = np.zeros(ARGUMENT_WORDS, np.uint64)
    arguments[0] = INVOKE_ARGUMENT_FILTER | ALL_FEATURES << 32
    arguments[ARGUMENT_FILTER] = filter_address
    return arguments
