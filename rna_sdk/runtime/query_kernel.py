"""The compiled kernel that makes decoder inputs: rows of `queries` from surface points.

`queries_reference.py` says the same in numpy and is what tests compare with. Directions and
texel coordinates are computed in float64, which costs next to nothing here and keeps
1 - n.h accurate inside a highlight; texels are weighted and summed in float32.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic
from numpy.typing import NDArray

from rna_sdk.package.blocks import INPUT_BLOCKS
from rna_sdk.runtime.compiled import compiled

Rows = NDArray[np.float32]
Vector = tuple[float, float, float]
QueryKernel = Callable[..., None]

FEATURES, POSITION, NORMAL, WO, WI, HALF_VECTOR = range(6)
"""Places of the blocks in the kernel's `columns`."""

_PLACES = {
    "features": FEATURES,
    "position": POSITION,
    "normal": NORMAL,
    "wo": WO,
    "wi": WI,
    "half_vector": HALF_VECTOR,
}

_ROWS_AHEAD = 16
"""How far ahead of the row being made its texels are fetched: far enough for memory to answer,
near enough that they are still in the first-level cache."""

_SQRT_HALF_BITS = 0x3FE6A09E667F3BCD
"""float64 sqrt(1/2) as an integer."""

_VECTORS = types.Array(types.float32, 2, "C", readonly=True)
_BOX = types.Array(types.float64, 2, "C", readonly=True)
_COLUMNS = types.Array(types.int64, 1, "C", readonly=True)


def block_columns(inputs: tuple[str, ...], channels: int) -> NDArray[np.int64]:
    """(6,) int64: the first column of each block in `queries`, -1 for a block not in `inputs`.

    inputs: names of INPUT_BLOCKS in the order of the columns; channels: features a texel.
    """
    columns = np.full(len(_PLACES), -1, np.int64)
    column = 0
    for name in inputs:
        columns[_PLACES[name]] = column
        column += INPUT_BLOCKS[name] or channels
    return columns


@cache
def query_kernel(channels: int, precision: str) -> QueryKernel:
    """The kernel for planes of this many channels, `precision` float16 or float32.

    Its arguments, all C-contiguous and in object space:

        planes      (3 * R * R * channels,) float32, or float16 seen as uint16; R = resolution
        resolution  int
        box         (2, 3) float64, lower corner and 1 / extent of the bounds
        columns     (6,) int64 of `block_columns`
        positions, normals, wo, wi  (n, 3) float32
        queries     (n, K) float32, written
        valid       (n,) bool, written: False where an argument is NaN or infinite or a
                    direction has no length; such a row of `queries` is zero
    """
    texel = types.uint16 if precision == "float16" else types.float32

    @compiled(
        types.Array(texel, 1, "C", readonly=True),
        types.intp,
        _BOX,
        _COLUMNS,
        *(_VECTORS,) * 4,
        types.float32[:, ::1],
        types.boolean[::1],
    )
    def fill_queries(
        planes: NDArray[Any],
        resolution: int,
        box: NDArray[np.float64],
        columns: NDArray[np.int64],
        positions: Rows,
        normals: Rows,
        wo: Rows,
        wi: Rows,
        queries: Rows,
        valid: NDArray[np.bool_],
    ) -> None:
        at_features, at_position = columns[FEATURES], columns[POSITION]
        at_normal, at_wo, at_wi = columns[NORMAL], columns[WO], columns[WI]
        at_half_vector = columns[HALF_VECTOR]
        last = len(positions) - 1
        for i in range(len(positions)):
            if at_features >= 0:
                soon = _relative(_vector(positions, min(i + _ROWS_AHEAD, last)), box)
                offsets, _ = _triplane_footprint(soon, resolution, channels)
                _prefetch_texels(planes, offsets)  # type: ignore[call-arg]
            x = _vector(positions, i)
            n, o, l = _unit(normals, i), _unit(wo, i), _unit(wi, i)  # noqa: E741
            total = _sum(x) + _sum(n) + _sum(o) + _sum(l)
            finite = total - total == 0.0  # NaN for any NaN or infinity
            valid[i] = finite
            if not finite:
                queries[i] = np.float32(0.0)
                continue
            p = _relative(x, box)
            if at_features >= 0:
                offsets, weights = _triplane_footprint(p, resolution, channels)
                at = np.uintp(i * queries.shape[1] + at_features)
                _weighted_texel_sum(planes, channels, offsets, weights, queries, at)  # type: ignore[call-arg]
            if at_position >= 0:
                _write(queries, i, at_position, _signed(p))
            if at_normal >= 0:
                _write(queries, i, at_normal, n)
            if at_wo >= 0:
                _write(queries, i, at_wo, o)
            if at_wi >= 0:
                _write(queries, i, at_wi, l)
            if at_half_vector >= 0:
                n_h, log_gap, wi_h = _half_vector(n, o, l)
                _write(queries, i, at_half_vector, (n_h, log_gap, _dot(n, l)))
                queries[i, at_half_vector + 3] = np.float32(_dot(n, o))
                queries[i, at_half_vector + 4] = np.float32(wi_h)

    return fill_queries


@compiled()
def _vector(vectors: Rows, i: int) -> Vector:
    return np.float64(vectors[i, 0]), np.float64(vectors[i, 1]), np.float64(vectors[i, 2])


@compiled()
def _unit(vectors: Rows, i: int) -> Vector:
    """Vector i at unit length; NaN in a component where the vector has no direction."""
    x, y, z = _vector(vectors, i)
    square = x * x + y * y + z * z
    scale = 1.5 - 0.5 * square  # 1 / sqrt(square) to 4e-11 where square is within 1e-5 of 1
    if not abs(square - 1.0) < 1e-5:
        scale = 1.0 / math.sqrt(square)
    return x * scale, y * scale, z * scale


@compiled()
def _relative(x: Vector, box: NDArray[np.float64]) -> Vector:
    """Position x as a fraction of the bounds, clamped to them."""
    return (
        min(max((x[0] - box[0, 0]) * box[1, 0], 0.0), 1.0),
        min(max((x[1] - box[0, 1]) * box[1, 1], 0.0), 1.0),
        min(max((x[2] - box[0, 2]) * box[1, 2], 0.0), 1.0),
    )


@compiled()
def _signed(p: Vector) -> Vector:
    return 2.0 * p[0] - 1.0, 2.0 * p[1] - 1.0, 2.0 * p[2] - 1.0


@compiled()
def _sum(v: Vector) -> float:
    return v[0] + v[1] + v[2]


@compiled()
def _dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@compiled()
def _write(queries: Rows, i: int, column: int, values: Vector) -> None:
    queries[i, column] = np.float32(values[0])
    queries[i, column + 1] = np.float32(values[1])
    queries[i, column + 2] = np.float32(values[2])


@compiled()
def _half_vector(n: Vector, wo: Vector, wi: Vector) -> Vector:
    """n.h, log2(1 - min(n.h, 1) + 1e-4) / 6 and wi.h."""
    h = (wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2])
    square = _dot(h, h)
    scale = 1.0 / math.sqrt(square)
    if square < 1e-12:  # opposite directions have no half vector
        h, scale = n, 1.0
    n_h = _dot(n, h) * scale
    return n_h, _log2(1.0 - min(n_h, 1.0) + 1e-4) / 6.0, _dot(wi, h) * scale


@compiled()
def _log2(x: float) -> float:
    """log2 of a positive normal number to 1e-7, several times as fast as the library's.

    x = 2^e m with m within sqrt(2) of 1, by the bits of float64. With s = (m - 1) / (m + 1),
    log2 m = 2 / ln 2 (s + s^3 / 3 + s^5 / 5 + ...).
    """
    bits = np.float64(x).view(np.int64)
    e = (bits - _SQRT_HALF_BITS) >> 52
    m = np.int64(bits - (e << 52)).view(np.float64)
    s = (m - 1.0) / (m + 1.0)
    q = s * s
    series = 1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0)))
    return float(e + 2.0 / math.log(2.0) * s * series)


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
def _triplane_footprint(p: Vector, resolution: int, channels: int) -> tuple[Any, Any]:
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


@intrinsic(prefer_literal=True)
def _weighted_texel_sum(
    typing_context: Any, planes: Any, channels: Any, offsets: Any, weights: Any, out: Any, at: Any
) -> Any:
    """out.flat[at : at + channels] = sum over k of weights[k] * planes[offsets[k] : + channels].

    In LLVM's vector types, since a loop over channels is not vectorised: the compiler cannot
    know that `out` and `planes` are apart. `channels` is a compile-time constant. planes:
    float32, or uint16 holding float16 bits, which the vector load converts.
    """
    if not isinstance(channels, types.IntegerLiteral):
        return None
    lanes = channels.literal_value
    is_half = planes.dtype == types.uint16

    def generate(context: Any, builder: ir.IRBuilder, signature: Any, arguments: Any) -> Any:
        def data(k: int) -> Any:
            array_type = signature.args[k]
            return context.make_array(array_type)(context, builder, arguments[k]).data

        stored = ir.HalfType() if is_half else ir.FloatType()
        floats = ir.VectorType(ir.FloatType(), lanes)
        texels = builder.bitcast(data(0), stored.as_pointer())
        total = ir.Constant(floats, [0.0] * lanes)
        for k in range(len(signature.args[2])):
            start = builder.gep(texels, [builder.extract_value(arguments[2], k)])
            texel_pointer = builder.bitcast(start, ir.VectorType(stored, lanes).as_pointer())
            texel = builder.load(texel_pointer, align=2 if is_half else 4)
            texel = builder.fpext(texel, floats) if is_half else texel
            weight = _splat(builder, builder.extract_value(arguments[3], k), floats)
            product = builder.fmul(texel, weight, flags=("contract",))
            total = builder.fadd(total, product, flags=("contract",))
        target = builder.gep(data(4), [arguments[5]])
        builder.store(total, builder.bitcast(target, floats.as_pointer()), align=4)
        return context.get_dummy_value()

    return types.void(planes, channels, offsets, weights, out, at), generate


@intrinsic
def _prefetch_texels(typing_context: Any, planes: Any, offsets: Any) -> Any:
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
