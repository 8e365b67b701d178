"""Compiled: bilinear samples of a triplane, summed.

Texel coordinates are computed in float64, LANES rows at a time; texels are weighted and summed in
float32, all channels of a row at a time.
"""

from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled
from rna_sdk.runtime.kernels.lane_memory import store_counts, store_lanes
from rna_sdk.runtime.kernels.lane_vectors import between
from rna_sdk.runtime.kernels.lanes import LANES, narrow, splat, whole

_tools: Any = cgutils  # numba leaves it without types
PLANES = 3
CORNERS = 4


@compiled()
def relative(x: Any, box: NDArray[np.float64]) -> Any:
    """Positions x as fractions of the bounds, clamped to them.

    box: (2, 3), lower corner and 1 / extent of the bounds.
    """
    return (
        between((x[0] - box[0, 0]) * box[1, 0], 0.0, 1.0),
        between((x[1] - box[0, 1]) * box[1, 1], 0.0, 1.0),
        between((x[2] - box[0, 2]) * box[1, 2], 0.0, 1.0),
    )


@compiled()
def _texel(p: Any, resolution: float) -> Any:
    """The last but one texel at most that p in [0, 1] falls behind; the fraction towards the next.

    Texel k has its centre at (k + 0.5) / resolution; resolution is 2 or more.
    """
    t = between(p * resolution - 0.5, 0.0, resolution - 1.0)
    k = whole(between(t, 0.0, resolution - 2.0))
    return k, narrow(t - k)


@compiled()
def store_footprints(
    p: Any, resolution: float, texels: NDArray[np.uint32], weights: NDArray[np.float32], slot: int
) -> None:
    """Stores the indices of the four texels around p on each plane, and their bilinear weights.

    The planes are XY, YZ and ZX: the first axis runs along a row of texels. Plane by plane of a
    slot: texels[slot, plane, lane] counts texels of all planes; weights[slot, plane, corner, lane]
    come behind one another.
    """
    x, fx = _texel(p[0], resolution)
    y, fy = _texel(p[1], resolution)
    z, fz = _texel(p[2], resolution)
    at = np.uintp(slot * PLANES * LANES)
    store_counts(texels, at, y * resolution + x)
    store_counts(texels, at + np.uintp(LANES), (resolution + z) * resolution + y)
    store_counts(texels, at + np.uintp(2 * LANES), (2.0 * resolution + x) * resolution + z)
    _store_weights(weights, slot * PLANES, fx, fy)
    _store_weights(weights, slot * PLANES + 1, fy, fz)
    _store_weights(weights, slot * PLANES + 2, fz, fx)


@compiled()
def _store_weights(weights: NDArray[np.float32], plane: int, u: Any, v: Any) -> None:
    a, b = 1.0 - u, 1.0 - v
    at = np.uintp(plane * CORNERS * LANES)
    store_lanes(weights, at, b * a)
    store_lanes(weights, at + np.uintp(LANES), b * u)
    store_lanes(weights, at + np.uintp(2 * LANES), v * a)
    store_lanes(weights, at + np.uintp(3 * LANES), v * u)


@intrinsic(prefer_literal=True)
def weighted_texel_sum(
    typing_context: Any,
    planes: Any,
    scales: Any,
    channels: Any,
    resolution: Any,
    footprint: Any,
    out: Any,
    at: Any,
) -> Any:
    """out.flat[at : at + channels] = the features of one lane of a slot of `store_footprints`.

    In LLVM's vector types, since a loop over channels is not vectorised: the compiler cannot
    know that `out` and `planes` are apart. `channels` is a compile-time constant. planes:
    float32; uint16 holding float16 bits, which the vector load converts; or int8, of which each
    plane's sum is multiplied by its (channels,) of scales. scales: (3 * channels,) float32, read
    for int8 alone. footprint: texels, weights, slot, lane.
    """
    if not isinstance(channels, types.IntegerLiteral):
        return None
    count = channels.literal_value
    stored, size = _STORED[planes.dtype]

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any) -> Any:
        at_lane = _Footprint(context, builder, signed.args[4], arguments[4])
        floats = ir.VectorType(ir.FloatType(), count)

        def load(start: Any, element: ir.Type, align: int) -> Any:
            vectors = ir.VectorType(element, count).as_pointer()
            return builder.load(builder.bitcast(start, vectors), align=align)

        planes_at, scales_at = (_data(context, builder, signed, arguments, k) for k in (0, 1))
        total = ir.Constant(floats, [0.0] * count)
        for plane, corners in enumerate(at_lane.starts(planes_at, count, arguments[3])):
            part = None if planes.dtype == types.int8 else total
            for corner, start in enumerate(corners):
                texel = load(start, stored, size)
                if planes.dtype == types.uint16:
                    texel = builder.fpext(texel, floats)
                elif planes.dtype == types.int8:
                    texel = builder.sitofp(texel, floats)
                weight = splat(builder, at_lane.weight(plane, corner), floats)
                product = builder.fmul(texel, weight, flags=("contract",))
                part = product if part is None else _sum(builder, part, product)
            if planes.dtype == types.int8:
                scale = load(builder.gep(scales_at, [_WORD(plane * count)]), ir.FloatType(), 4)
                part = _sum(builder, total, builder.fmul(part, scale, flags=("contract",)))
            total = part
        target = builder.gep(_data(context, builder, signed, arguments, 5), [arguments[6]])
        builder.store(total, builder.bitcast(target, floats.as_pointer()), align=4)
        return context.get_dummy_value()

    return types.void(planes, scales, channels, resolution, footprint, out, at), generate


@intrinsic(prefer_literal=True)
def prefetch_texels(
    typing_context: Any, planes: Any, channels: Any, resolution: Any, footprint: Any
) -> Any:
    """Ask for the cache lines that `weighted_texel_sum` will read."""
    if not isinstance(channels, types.IntegerLiteral):
        return None
    count = channels.literal_value

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any) -> Any:
        at_lane = _Footprint(context, builder, signed.args[3], arguments[3])
        address, number = ir.IntType(8).as_pointer(), ir.IntType(32)
        kind = ir.FunctionType(ir.VoidType(), [address, *[number] * 3])
        prefetch = builder.module.declare_intrinsic("llvm.prefetch", [address], kind)
        read, keep, cached = number(0), number(3), number(1)
        planes_at = _data(context, builder, signed, arguments, 0)
        for corners in at_lane.starts(planes_at, count, arguments[2]):
            for start in corners:
                builder.call(prefetch, [builder.bitcast(start, address), read, keep, cached])
        return context.get_dummy_value()

    return types.void(planes, channels, resolution, footprint), generate


_STORED = {
    types.int8: (ir.IntType(8), 1),
    types.uint16: (ir.HalfType(), 2),
    types.float32: (ir.FloatType(), 4),
}
"""Element type of the flat planes -> its LLVM type, and its bytes."""
_WORD = ir.IntType(64)


class _Footprint:
    """One lane of a slot of `store_footprints`, in LLVM."""

    def __init__(self, context: Any, builder: ir.IRBuilder, kind: Any, value: Any) -> None:
        self._builder = builder
        parts = _tools.unpack_tuple(builder, value)
        self._texels, self._weights = (
            context.make_array(kind[k])(context, builder, parts[k]).data for k in (0, 1)
        )
        self._slot, self._lane = parts[2:]

    def weight(self, plane: int, corner: int) -> ir.Value:
        return self._load(self._weights, PLANES * CORNERS, plane * CORNERS + corner)

    def starts(self, planes: ir.Value, count: int, side: ir.Value) -> list[list[ir.Value]]:
        """Addresses of the four texels on each plane, of `count` channels each."""
        builder, result = self._builder, []
        next_row = builder.mul(side, _WORD(count))
        for plane in range(PLANES):
            number = builder.zext(self._load(self._texels, PLANES, plane), _WORD)
            corner = builder.gep(planes, [builder.mul(number, _WORD(count))])
            pair = [corner, builder.gep(corner, [next_row])]
            result.append([start for c in pair for start in (c, builder.gep(c, [_WORD(count)]))])
        return result

    def _load(self, array: ir.Value, groups: int, group: int) -> ir.Value:
        """Value of array[slot, group, lane] with the given number of groups per slot."""
        builder = self._builder
        first = builder.add(builder.mul(self._slot, _WORD(groups * LANES)), self._lane)
        return builder.load(builder.gep(array, [builder.add(first, _WORD(group * LANES))]))


def _data(context: Any, builder: ir.IRBuilder, signed: Any, arguments: Any, k: int) -> ir.Value:
    """Address of the data of argument k, an array."""
    return context.make_array(signed.args[k])(context, builder, arguments[k]).data


def _sum(builder: ir.IRBuilder, a: ir.Value, b: ir.Value) -> ir.Value:
    return builder.fadd(a, b, flags=("contract",))
