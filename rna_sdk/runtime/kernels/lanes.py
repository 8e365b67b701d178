"""Compiled: several rows at a time, one in each lane of a vector register.

Inside a kernel a value of type `Lanes` is LANES float32 or float64 numbers. `+ - * /` and
comparisons work lane by lane, with a float on either side, too; so what is written for floats,
such as `vectors.dot`, works on lanes. There is no branch a lane: `where` chooses.
"""

import operator
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.typing.templates import AbstractTemplate, infer_global
from numba.extending import intrinsic, lower_builtin, models, register_model

LANES = 16
"""Rows at a time: one register of AVX-512 or two of AVX2 in float32."""

_tools: Any = cgutils  # numba leaves these without types
_tuple: Any = types.UniTuple
_BIT = ir.IntType(1)
_INDEX = ir.IntType(32)
_ELEMENTS: dict[types.Float, ir.Type] = {
    types.float32: ir.FloatType(),
    types.float64: ir.DoubleType(),
}


_BITS = {types.float32: (32, 23, 0x3F3504F3), types.float64: (64, 52, 0x3FE6A09E667F3BCD)}
"""For each float type: bits, bits of the fraction, and sqrt(1/2) as an integer."""


class LanesType(types.Type):
    """LANES numbers of one type."""

    def __init__(self, dtype: types.Float) -> None:
        self.dtype = dtype
        super().__init__(name=f"Lanes({dtype})")


class MaskType(types.Type):
    """LANES booleans."""


LANES32, LANES64 = LanesType(types.float32), LanesType(types.float64)
MASK = MaskType("Mask")


def _vector(element: ir.Type, count: int = LANES) -> ir.VectorType:
    return ir.VectorType(element, count)


@register_model(LanesType)
class _LanesModel(models.PrimitiveModel):
    def __init__(self, manager: Any, lanes: LanesType) -> None:
        super().__init__(manager, lanes, _vector(_ELEMENTS[lanes.dtype]))  # type: ignore[no-untyped-call]


@register_model(MaskType)
class _MaskModel(models.PrimitiveModel):
    def __init__(self, manager: Any, mask: MaskType) -> None:
        super().__init__(manager, mask, _vector(_BIT))  # type: ignore[no-untyped-call]


def operation(define: Callable[..., Any]) -> Any:
    """Decorator: numba's `intrinsic`; callers leave out its first parameter, the typing context."""
    return intrinsic(define)


def splat(builder: ir.IRBuilder, scalar: ir.Value, vector: ir.VectorType) -> ir.Value:
    """`scalar` in every lane of a value of type `vector`."""
    undefined = ir.Constant(vector, ir.Undefined)
    first = builder.insert_element(undefined, scalar, _INDEX(0))
    mask = ir.Constant(ir.VectorType(_INDEX, vector.count), [0] * vector.count)
    return builder.shuffle_vector(first, undefined, mask)


def _operand(context: Any, builder: ir.IRBuilder, value: Any, kind: Any, lanes: LanesType) -> Any:
    """A lowered operand as a vector: of lanes as it is, of a number in every lane."""
    if isinstance(kind, LanesType):
        return value
    number = context.cast(builder, value, kind, lanes.dtype)
    return splat(builder, number, _vector(_ELEMENTS[lanes.dtype]))


def _lanes_of(arguments: tuple[Any, ...]) -> LanesType | None:
    """The one type of lanes among the arguments, where the others are numbers; else None."""
    result = {a for a in arguments if isinstance(a, LanesType)}
    others = [a for a in arguments if not isinstance(a, (LanesType, types.Number))]
    return result.pop() if len(result) == 1 and not others else None


_ARITHMETIC = {
    operator.add: "fadd",
    operator.sub: "fsub",
    operator.mul: "fmul",
    operator.truediv: "fdiv",
}
_COMPARISONS = {operator.lt: "<", operator.gt: ">", operator.eq: "=="}


def _register(function: Callable[..., Any], make: Callable[..., Any], result: Any) -> None:
    """Teach numba a binary operator: its type, and `make(builder, a, b)` for its code."""

    class _Template(AbstractTemplate):
        def generic(self, arguments: Any, _: Any) -> Any:
            lanes = _lanes_of(arguments)
            kind: Any = result or lanes
            return None if lanes is None else kind(*arguments)

    infer_global(function)(_Template)

    def lower(context: Any, builder: ir.IRBuilder, signed: Any, values: Any) -> Any:
        lanes = _lanes_of(signed.args)
        assert lanes is not None
        pairs = zip(values, signed.args, strict=True)
        return make(builder, *(_operand(context, builder, v, kind, lanes) for v, kind in pairs))

    for kinds in ((LanesType, LanesType), (LanesType, types.Number), (types.Number, LanesType)):
        lower_builtin(function, *kinds)(lower)


def _arithmetic(name: str) -> Callable[..., Any]:
    flags = ("contract",)  # fused multiply-add, as everywhere in the kernels
    return lambda builder, a, b: getattr(builder, name)(a, b, flags=flags)


def _comparison(sign: str) -> Callable[..., Any]:
    return lambda builder, a, b: builder.fcmp_ordered(sign, a, b)


for _function, _name in _ARITHMETIC.items():
    _register(_function, _arithmetic(_name), None)
for _function, _sign in _COMPARISONS.items():
    _register(_function, _comparison(_sign), MASK)


@operation
def where(typing_context: Any, mask: Any, a: Any, b: Any) -> Any:
    """`a` where `mask`, else `b`; either may be a number."""
    lanes = _lanes_of((a, b))
    if not isinstance(mask, MaskType) or lanes is None:
        return None

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, values: Any) -> Any:
        pairs = zip(values[1:], signed.args[1:], strict=True)
        chosen = [_operand(context, builder, v, kind, lanes) for v, kind in pairs]
        return builder.select(values[0], *chosen)

    return lanes(mask, a, b), generate


@operation
def both(typing_context: Any, a: Any, b: Any) -> Any:
    """Logical and of two masks."""

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, values: Any) -> Any:
        return builder.and_(*values)

    return MASK(a, b), generate


@operation
def everywhere(typing_context: Any, mask: Any) -> Any:
    """Whether a mask holds in all lanes."""

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, values: Any) -> Any:
        bits = builder.bitcast(values[0], ir.IntType(LANES))
        return builder.icmp_unsigned("==", bits, ir.Constant(bits.type, -1))

    return types.boolean(mask), generate


@operation
def sqrt(typing_context: Any, x: Any) -> Any:
    """The square root of each lane, correctly rounded."""

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, values: Any) -> Any:
        name = f"llvm.sqrt.v{LANES}f{_BITS[x.dtype][0]}"
        kind = ir.FunctionType(values[0].type, [values[0].type])
        function = _tools.get_or_insert_function(builder.module, kind, name)
        return builder.call(function, values)

    return x(x), generate


@operation
def narrow(typing_context: Any, x: Any) -> Any:
    """float64 lanes as float32."""

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, values: Any) -> Any:
        return builder.fptrunc(values[0], _vector(ir.FloatType()))

    return LANES32(x), generate


@operation
def whole(typing_context: Any, x: Any) -> Any:
    """Each lane without its fraction, towards 0; within the range of int32."""

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, values: Any) -> Any:
        integers = builder.fptosi(values[0], _vector(ir.IntType(32)))
        return builder.sitofp(integers, values[0].type)

    return x(x), generate


@operation
def exponent_and_mantissa(typing_context: Any, x: Any) -> Any:
    """e and m with x = 2^e m, m within sqrt(2) of 1, for positive normal numbers."""
    width, fraction, half = _BITS[x.dtype]

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, values: Any) -> Any:
        integers = _vector(ir.IntType(width))

        def every(number: int) -> ir.Constant:
            return ir.Constant(integers, [number] * LANES)

        bits = builder.bitcast(values[0], integers)
        e = builder.ashr(builder.sub(bits, every(half)), every(fraction))
        m = builder.bitcast(builder.sub(bits, builder.shl(e, every(fraction))), values[0].type)
        narrow = builder.trunc(e, _vector(ir.IntType(32))) if width > 32 else e
        parts = builder.sitofp(narrow, values[0].type), m
        return _tools.pack_array(builder, parts, values[0].type)

    return _tuple(x, 2)(x), generate


@operation
def power_of_two(typing_context: Any, k: Any) -> Any:
    """2^k in float32, of whole k from -126 to 127."""

    def generate(context: Any, builder: ir.IRBuilder, signed: Any, values: Any) -> Any:
        integers = _vector(ir.IntType(32))
        bias, fraction = (ir.Constant(integers, [n] * LANES) for n in (127, 23))
        exponent = builder.add(builder.fptosi(values[0], integers), bias)
        return builder.bitcast(builder.shl(exponent, fraction), values[0].type)

    return LANES32(k), generate
