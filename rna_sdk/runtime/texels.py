"""Compiled: bilinear samples of a triplane, summed.

Texel coordinates are computed in float64; texels are weighted and summed in float32.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic
from numpy.typing import NDArray

from rna_sdk.compiled import compiled
from rna_sdk.runtime.vectors import Vector


@compiled()
def relative(x: Vector, box: NDArray[np.float64]) -> Vector:
    """Position x as a fraction of the bounds, clamped to them.

    box: (2, 3), lower corner and 1 / extent of the bounds.
    """
    return (
        min(max((x[0] - box[0, 0]) * box[1, 0], 0.0), 1.0),
        min(max((x[1] - box[0, 1]) * box[1, 1], 0.0), 1.0),
        min(max((x[2] - box[0, 2]) * box[1, 2], 0.0), 1.0),
    )


@compiled()
def _texel(p: float, resolution: int) -> tuple[Any, Any, Any]:
    """Texel that p in [0, 1] falls behind, step to the next one (0 at the edge), fraction.

    Texel k has its centre at (k + 0.5) / resolution.
    """
    t = min(max(p * resolution - 0.5, 0.0), resolution - 1.0)
    k = np.int64(t)
    step = np.int64(k < resolution - 1)
    return np.uintp(k), np.uintp(step), np.float32(t - k)


@compiled()
def triplane_footprint(p: Vector, resolution: int, channels: int) -> tuple[Any, Any]:
    """Where the 12 texels around p start in the flat planes, and their bilinear weights.

    The planes are XY, YZ and ZX: the first axis runs along a row of texels.
    """
    x, dx, fx = _texel(p[0], resolution)
    y, dy, fy = _texel(p[1], resolution)
    z, dz, fz = _texel(p[2], resolution)
    one = np.float32(1.0)
    gx, gy, gz = one - fx, one - fy, one - fz
    side, size = np.uintp(resolution), np.uintp(channels)
    xy = (y * side + x) * size
    yz = ((side + z) * side + y) * size
    zx = ((side + side + x) * side + z) * size
    dx, dy, dz = dx * size, dy * size, dz * size
    up_y, up_z, up_x = dy * side, dz * side, dx * side
    offsets = (
        *(xy, xy + dx, xy + up_y, xy + up_y + dx),
        *(yz, yz + dy, yz + up_z, yz + up_z + dy),
        *(zx, zx + dz, zx + up_x, zx + up_x + dz),
    )
    weights = (
        *(gy * gx, gy * fx, fy * gx, fy * fx),
        *(gz * gy, gz * fy, fz * gy, fz * fy),
        *(gx * gz, gx * fz, fx * gz, fx * fz),
    )
    return offsets, weights


_PLANES = 3


@intrinsic(prefer_literal=True)
def weighted_texel_sum(
    typing_context: Any,
    planes: Any,
    scales: Any,
    channels: Any,
    offsets: Any,
    weights: Any,
    out: Any,
    at: Any,
) -> Any:
    """out.flat[at : at + channels] = sum over k of weights[k] * planes[offsets[k] : + channels].

    In LLVM's vector types, since a loop over channels is not vectorised: the compiler cannot
    know that `out` and `planes` are apart. `channels` is a compile-time constant. planes:
    float32; uint16 holding float16 bits, which the vector load converts; or int8, of which each
    plane's sum is multiplied by its (channels,) of scales. scales: (3 * channels,) float32, read
    for int8 alone.
    """
    if not isinstance(channels, types.IntegerLiteral):
        return None
    lanes = channels.literal_value
    stored, size = _STORED[planes.dtype]

    def generate(context: Any, builder: ir.IRBuilder, signature: Any, arguments: Any) -> Any:
        def data(k: int) -> Any:
            array_type = signature.args[k]
            return context.make_array(array_type)(context, builder, arguments[k]).data

        floats = ir.VectorType(ir.FloatType(), lanes)
        zero = ir.Constant(floats, [0.0] * lanes)
        texels = builder.bitcast(data(0), stored.as_pointer())

        def vector_at(start: Any, element: ir.Type, align: int) -> Any:
            vectors = ir.VectorType(element, lanes).as_pointer()
            return builder.load(builder.bitcast(start, vectors), align=align)

        def sum_of(corners: range, total: Any) -> Any:
            for k in corners:
                start = builder.gep(texels, [builder.extract_value(arguments[3], k)])
                texel = vector_at(start, stored, size)
                if planes.dtype == types.uint16:
                    texel = builder.fpext(texel, floats)
                elif planes.dtype == types.int8:
                    texel = builder.sitofp(texel, floats)
                weight = _splat(builder, builder.extract_value(arguments[4], k), floats)
                product = builder.fmul(texel, weight, flags=("contract",))
                total = builder.fadd(total, product, flags=("contract",))
            return total

        corners = len(signature.args[3])
        if planes.dtype == types.int8:
            each, total = corners // _PLANES, zero
            for plane in range(_PLANES):
                start = builder.gep(data(1), [ir.Constant(ir.IntType(64), plane * lanes)])
                scale = vector_at(start, ir.FloatType(), 4)
                part = sum_of(range(plane * each, (plane + 1) * each), zero)
                part = builder.fmul(part, scale, flags=("contract",))
                total = builder.fadd(total, part, flags=("contract",))
        else:
            total = sum_of(range(corners), zero)
        target = builder.gep(data(5), [arguments[6]])
        builder.store(total, builder.bitcast(target, floats.as_pointer()), align=4)
        return context.get_dummy_value()

    return types.void(planes, scales, channels, offsets, weights, out, at), generate


_STORED = {
    types.int8: (ir.IntType(8), 1),
    types.uint16: (ir.HalfType(), 2),
    types.float32: (ir.FloatType(), 4),
}
"""Element type of the flat planes -> what it is to LLVM, and its bytes."""


@intrinsic
def prefetch_texels(typing_context: Any, planes: Any, offsets: Any) -> Any:
    """Ask for the cache lines at planes[k] for each k in offsets; any k is harmless."""

    def generate(context: Any, builder: ir.IRBuilder, signature: Any, arguments: Any) -> Any:
        array_type = signature.args[0]
        texels = context.make_array(array_type)(context, builder, arguments[0]).data
        address, number = ir.IntType(8).as_pointer(), ir.IntType(32)
        prefetch = builder.module.declare_intrinsic(
            "llvm.prefetch", [address], ir.FunctionType(ir.VoidType(), [address, *[number] * 3])
        )
        read, keep, data = number(0), number(3), number(1)
        for k in range(len(signature.args[1])):
            texel = builder.gep(texels, [builder.extract_value(arguments[1], k)])
            builder.call(prefetch, [builder.bitcast(texel, address), read, keep, data])
        return context.get_dummy_value()

    return types.void(planes, offsets), generate


def _splat(builder: ir.IRBuilder, scalar: ir.Value, vector: ir.VectorType) -> ir.Value:
    """`scalar` in every lane of a value of type `vector`."""
    undefined = ir.Constant(vector, ir.Undefined)
    index = ir.IntType(32)
    first = builder.insert_element(undefined, scalar, index(0))
    mask = ir.Constant(ir.VectorType(index, vector.count), [0] * vector.count)
    return builder.shuffle_vector(first, undefined, mask)
