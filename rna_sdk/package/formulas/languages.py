"""Statements of formulas in the languages of readers, of which `write_blocks` makes files."""

import ast
from collections.abc import Iterable, Sequence

from rna_sdk.package.formulas.block_formulas import FLAG, VECTOR, BlockFormulas

_OF_VECTORS = {"dot", "cross", "length", "largest"}


class Language:
    """Statements of formulas, by default in Python for the arrays of any library.

    Attributes:
        by_components: whether vectors are written as their three components.
        divides: whether a division by a number stays one, and is no product with 1 / number.
        calls: function of formulas -> how a call of it is written, with places for arguments.
        assignment, if_, end_, or_: how statements are written.
    """

    by_components = False
    divides = True
    calls: dict[str, str] = {}  # noqa: RUF012
    assignment = "{0} = {1}"
    if_, end_, or_ = "if {}:", "", " or "

    def __init__(self, formulas: BlockFormulas, prefix: str = "") -> None:
        """prefix: of names of functions."""
        self.formulas, self.prefix = formulas, prefix

    def text(self, node: ast.expr) -> str:
        """An expression."""
        if self.by_components and self.formulas.type_of(node) == VECTOR:
            return f"({', '.join(self.numbers(node))})"
        return ast.unparse(_Rewriting(self).visit(node))

    def numbers(self, node: ast.expr) -> list[str]:
        """The components of a vector, or a number."""
        components = range(3) if self.formulas.type_of(node) == VECTOR else [None]
        return [ast.unparse(_Rewriting(self, k).visit(node)) for k in components]

    def columns(self, block: str) -> list[str]:
        """The numbers that a block has."""
        return [column for value in self.formulas.values[block] for column in self.numbers(value)]

    def assigned(self, name: str) -> str:
        """The statement that gives a term its value."""
        return self.assignment.format(name, self.text(self.formulas.terms[name]))

    def present(self, block: str) -> str:
        """Whether the decoder takes a block."""
        return f'"{block}" in inputs'

    def put(self, block: str) -> list[str]:
        """Statements that write a block's values."""
        values = ", ".join(self.text(value) for value in self.formulas.values[block])
        return [f'blocks["{block}"] = ({values},)']

    def terms(self, name: str) -> list[str]:
        """Statements of the inputs of a block, or of a term and its inputs."""
        needed = self.formulas.needs(name, self.formulas.terms)
        own = [name] if name in self.formulas.terms else []
        return [self.assigned(n) for n in needed + own]

    def blocks(self, *kinds: str, given: Sequence[str] = ()) -> list[str]:
        """Statements that write the blocks of kinds of parts. given: terms that are known.

        What several blocks need is computed once, and nothing that no block needs.
        """
        formulas, blocks = self.formulas, self.formulas.blocks_of(*kinds)
        needs = {block: formulas.needs(block, formulas.terms, *given) for block in blocks}
        every = [name for names in needs.values() for name in names]
        shared = [n for n in formulas.terms if every.count(n) > 1]
        groups: list[list[str]] = []  # of blocks that share terms
        for block in blocks:
            mine = [g for g in groups if any({*needs[block]} & {*needs[b]} for b in g)]
            merged = [*(b for g in mine for b in g), block]
            groups = [g for g in groups if g not in mine] + [merged]
        lines = []
        for group in groups:
            inner = [self.assigned(n) for n in shared if any(n in needs[b] for b in group)]
            for block in group:
                own = [self.assigned(n) for n in needs[block] if n not in shared] + self.put(block)
                lone = formulas.is_plain(block) or len(group) == 1
                inner += own if lone else self._if([block], own)
            lines += inner if formulas.is_plain(group[0]) else self._if(group, inner)
        return lines

    def _if(self, blocks: list[str], lines: list[str]) -> list[str]:
        """Statements that run where one of these blocks is present."""
        condition = self.or_.join(map(self.present, blocks))
        return [self.if_.format(condition), *indented(lines), *filter(None, [self.end_])]


class Lanes(Language):
    """Python for numba, with a row in each lane; a vector is a tuple, and needs no derivative."""

    by_components = True
    divides = False
    calls = {"at_least": "{0}"}  # noqa: RUF012

    def present(self, block: str) -> str:
        return f"columns[{block.upper()}] >= 0"

    def put(self, block: str) -> list[str]:
        values = f"({', '.join(self.columns(block))},)"
        if "p" in self.formulas.needs(block):  # in float64
            values = f"narrowed({values})"
        return [f"put(queries, row, columns[{block.upper()}], {values})"]


class Wgsl(Language):
    """WGSL, with the columns of a block in groups of four."""

    calls = {  # noqa: RUF012
        "where": "select({2}, {1}, {0})",
        "at_least": "max({0}, {1})",
        "clamped": "clamp({0}, -1.0, 1.0)",
        "largest": "rna_largest({0})",
    }
    assignment = "let {0} = {1};"
    if_, end_, or_ = "if {} {{", "}", " || "

    def present(self, block: str) -> str:
        return f"rna_slot(RNA_BLOCK_{block.upper()}) != RNA_NONE"

    def put(self, block: str) -> list[str]:
        values = self.formulas.values[block]
        columns = [self.text(value) for value in values]
        is_vector = self.formulas.type_of(values[0]) == VECTOR
        columns += ["0.0"] * (1 if is_vector else -len(columns) % 4)
        groups = [", ".join(columns[k : k + 4]) for k in range(0, len(columns), 4)]
        slot = f"rna_slot(RNA_BLOCK_{block.upper()})"
        return [
            f"rna_put({slot}{f' + {k}u' if k else ''}, vec4f({group}));"
            for k, group in enumerate(groups)
        ]


class C(Language):
    """C, in float64, with a loop over the rows for each block, of which compilers make vectors."""

    by_components = True
    divides = False
    calls = {"log2": "log2_of((float)({0}))"}  # noqa: RUF012

    def assigned(self, name: str) -> str:
        kind, value = self.formulas.type_of(ast.Name(name)), self.text(self.formulas.terms[name])
        if kind == VECTOR:
            return f"const double {name}[3] = {{{value[1:-1]}}};"
        return f"const {'bool' if kind == FLAG else 'double'} {name} = {value};"

    def blocks(self, *kinds: str, given: Sequence[str] = ()) -> list[str]:
        lines = []
        for block in self.formulas.blocks_of(*kinds):
            place, arguments = f"column[{block.upper()}]", self.formulas.arguments(block)
            if self.formulas.is_plain(block):
                (rows,), width = map(self._rows, arguments), self.formulas.width(block)
                first = f"{rows}[0]" if width == 3 else rows
                lines.append(f"put_rows({first}, {width}, {place}, queries);")
                continue
            loads = ", ".join(map(self._load, arguments))
            values = enumerate(self.columns(block))
            row = [f"const double {loads};", *self.terms(block)]
            row += [f"PUT({block.upper()}, {k}, {value});" for k, value in values]
            lines += [f"if ({place} >= 0)", "    for (int r = 0; r < ROWS; r++) {"]
            lines += [*indented(indented(row)), "    }"]
        return lines

    def _rows(self, argument: str) -> str:
        """Where the points have an argument."""
        return f"points->{'axis' if argument in ('n', 't') else argument}"

    def _load(self, argument: str) -> str:
        rows = self._rows(argument)
        if self.formulas.type_of(ast.Name(argument)) == VECTOR:
            return f"{argument}[3] = VECTOR({rows})"
        return f"{argument} = {rows}[r]"


def indented(lines: Iterable[str]) -> list[str]:
    return [f"    {line}" for line in lines]


class _Rewriting(ast.NodeTransformer):
    """An expression as a language writes it; with k, that component of a vector's."""

    def __init__(self, language: Language, k: int | None = None) -> None:
        self._language, self._k = language, k

    def visit_Constant(self, node: ast.Constant) -> ast.expr:
        return ast.Constant(float(node.value))  # type: ignore[arg-type]

    def visit_Name(self, node: ast.Name) -> ast.expr:
        formulas = self._language.formulas
        if node.id in formulas.constants:
            return ast.Constant(formulas.constants[node.id])
        if self._k is None or formulas.type_of(node) != VECTOR:
            return node
        return ast.Subscript(node, ast.Constant(self._k))

    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        return ast.Compare(self.visit(node.left), node.ops, [self.visit(node.comparators[0])])

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        left, operator, right = self.visit(node.left), node.op, self.visit(node.right)
        by_number = isinstance(operator, ast.Div) and isinstance(right, ast.Constant)
        if by_number and not self._language.divides:
            operator, right = ast.Mult(), ast.BinOp(ast.Constant(1.0), ast.Div(), right)
        return ast.BinOp(left, operator, right)

    def visit_Call(self, node: ast.Call) -> ast.expr:
        assert isinstance(node.func, ast.Name)
        name, visitor = node.func.id, self
        if name == "cross" and self._k is not None:
            return self._crossed(*node.args)
        if name in _OF_VECTORS:
            visitor = _Rewriting(self._language)
            if self._language.by_components and not all(isinstance(a, ast.Name) for a in node.args):
                raise ValueError(f"{ast.unparse(node)}: expected named vectors")
        arguments: list[ast.expr] = [visitor.visit(argument) for argument in node.args]
        if name not in self._language.calls:
            return ast.Call(ast.Name(self._language.prefix + name), arguments, [])
        if self._language.calls[name] == "{0}":
            return arguments[0]
        return ast.Name(self._language.calls[name].format(*map(ast.unparse, arguments)))

    def _crossed(self, a: ast.expr, b: ast.expr) -> ast.expr:
        """Component k of a x b."""
        assert self._k is not None
        i, j = (_Rewriting(self._language, (self._k + step) % 3) for step in (1, 2))
        first = ast.BinOp(i.visit(a), ast.Mult(), j.visit(b))
        return ast.BinOp(first, ast.Sub(), ast.BinOp(j.visit(a), ast.Mult(), i.visit(b)))
