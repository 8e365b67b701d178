"""Upper bounds of a decoder's memory and work, before an inference engine sees it (spec, 6.2).

A value with a row for each query keeps one all the way: only columns mix. So its width bounds its
size, and the sums over all nodes bound what a query takes. No shape inference is needed: each
operator's result is at most as large as its operands, or has the bound given here.
"""

from __future__ import annotations

from dataclasses import dataclass

from rna_sdk.package.decoder.decoder_form import INPUT_NAME, PartDecoder
from rna_sdk.package.decoder.onnx_model import Model, Node, Tensor
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import (
    MAX_DECODER_CONSTANTS,
    MAX_DECODER_WIDTH,
    MAX_QUERY_VALUES,
    MAX_QUERY_WORK,
)

_PRODUCTS = frozenset({"Gemm", "MatMul"})

_SHAPED_BY_FIRST = frozenset(
    {"Clip", "DequantizeLinear", "LayerNormalization", "QuantizeLinear", "Slice", "Split"}
)
"""Operators whose results have the rank of their first operand and are not larger."""

_OVER_COLUMNS = (1, -1)


@dataclass(frozen=True)
class Shape:
    """Upper bound of a value's shape, [rows, columns]; rank 1 has columns alone, rank 0 neither.

    per_query: there is a row for each query, however many; `rows` is 1 then.
    """

    columns: int
    rows: int = 1
    rank: int = 2
    per_query: bool = False

    @classmethod
    def of(cls, tensor: Tensor) -> Shape:
        """The shape of a tensor of at most two dimensions."""
        rows, columns = (1, 1, *tensor.dims)[-2:]
        return cls(columns, rows, len(tensor.dims))

    @property
    def values(self) -> int:
        """Number of values; per query, if there is a row for each."""
        return self.rows * self.columns


_NOTHING = Shape(1, rank=0)


def check_bounds(model: Model, own: PartDecoder) -> None:
    """Every value is made once and before its use, and none of the limits can be passed.

    Raises:
        PackageError: DECODER_GRAPH, DECODER_ROWS, DECODER_TENSOR, DECODER_COST.
    """
    tally = _Tally()
    shapes = {"": _NOTHING, INPUT_NAME: Shape(own.columns, per_query=True)}
    for tensor in model.initializers:
        where = f"{own.entry}#{tensor.name}"
        if tensor.name in shapes:
            refuse(Code.DECODER_GRAPH, where, "a name made twice", "each value made once")
        shapes[tensor.name] = Shape.of(tensor)
        tally.add_constant(shapes[tensor.name], where)
    for i, node in enumerate(model.nodes):
        where = f"{own.entry}#/graph/node/{i}"
        missing = [name for name in node.inputs if name not in shapes]
        twice = [name for name in node.outputs if name and name in shapes]
        if missing or twice:
            found = f"{missing} not made before, {twice} made again"
            refuse(Code.DECODER_GRAPH, where, found, "each value made once, before its use")
        operands = [shapes[name] for name in node.inputs]
        _check_rows(node, operands, where)
        result = _result(node, operands)
        if (width := max(result.rows, result.columns)) > MAX_DECODER_WIDTH:
            refuse(Code.DECODER_TENSOR, where, f"width {width}", f"at most {MAX_DECODER_WIDTH}")
        tally.add_node(node, operands, result, where)
        shapes.update((name, result) for name in node.outputs if name)
    if own.form.name not in shapes:
        refuse(Code.DECODER_GRAPH, f"{own.entry}#/graph/output", "nothing makes it", own.form.name)


def _check_rows(node: Node, operands: list[Shape], where: str) -> None:
    """Rows of queries are not multiplied by each other, transposed or put below one another."""
    if node.operator in _PRODUCTS:
        first, *others = operands or [_NOTHING]
        constant = all(not other.per_query for other in others)
        matrix = len(others) > 0 and others[0].rank == 2
        if not (first.per_query and constant and matrix) or _integer(node, "transA"):
            expected = "queries' rows, not transposed, times a constant matrix"
            refuse(Code.DECODER_ROWS, where, f"{node.operator} of other operands", expected)
    elif node.operator == "Concat" and any(operand.per_query for operand in operands):
        axis = _integer(node, "axis")
        if axis not in _OVER_COLUMNS:
            refuse(Code.DECODER_ROWS, where, f"Concat along axis {axis}", "axis 1 or -1")


def _result(node: Node, operands: list[Shape]) -> Shape:
    """Upper bound of the shape of each of the node's results."""
    per_query = any(operand.per_query for operand in operands)
    if node.operator in _PRODUCTS:
        matrix = operands[1]
        columns = matrix.rows if _integer(node, "transB") else matrix.columns
        return Shape(columns, per_query=True)
    of = operands
    if not per_query and node.operator in _SHAPED_BY_FIRST:
        of = operands[:1]
    own = Shape(node.longest_list, rank=1) if node.longest_list else _NOTHING
    of = [*of, *map(Shape.of, node.tensors), own]
    rank = max(shape.rank for shape in of)
    rows, columns = max(shape.rows for shape in of), max(shape.columns for shape in of)
    if node.operator == "Concat":
        if per_query or rank < 2 or _integer(node, "axis") in _OVER_COLUMNS:
            columns = sum(operand.columns for operand in operands)
        else:
            rows = sum(operand.rows for operand in operands)
    return Shape(columns, per_query=True) if per_query else Shape(columns, rows, rank)


def _integer(node: Node, attribute: str) -> int:
    """An integer attribute as int64; 0 where there is none."""
    value = node.integers.get(attribute, 0)
    return value - 2**64 if value >= 2**63 else value


class _Tally:
    """Sums over initializers and nodes."""

    def __init__(self) -> None:
        self._constants = self._values = self._work = 0

    def add_constant(self, shape: Shape, where: str) -> None:
        self._constants += shape.values
        if self._constants > MAX_DECODER_CONSTANTS:
            _too_much(where, self._constants, "values of constants", MAX_DECODER_CONSTANTS)

    def add_node(self, node: Node, operands: list[Shape], result: Shape, where: str) -> None:
        for tensor in node.tensors:
            self.add_constant(Shape.of(tensor), where)
        if not result.per_query:
            self.add_constant(result, where)
            return
        self._values += result.columns
        self._work += result.columns * (operands[0].columns if node.operator in _PRODUCTS else 1)
        if self._values > MAX_QUERY_VALUES:
            _too_much(where, self._values, "values a query", MAX_QUERY_VALUES)
        if self._work > MAX_QUERY_WORK:
            _too_much(where, self._work, "multiply-adds a query", MAX_QUERY_WORK)


def _too_much(where: str, found: int, what: str, limit: int) -> None:
    refuse(Code.DECODER_COST, where, f"{found} {what} up to here", f"at most {limit}")
