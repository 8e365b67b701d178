"""The formulas of input blocks, read from spec/RNA.md, 6.3: a table of blocks, and their terms.

Both are expressions in the syntax of Python: `+ - * / < ==`, numbers, names and calls of FUNCTIONS.
"""

import ast
import re
from collections.abc import Iterable
from pathlib import Path

SPECIFICATION = Path(__file__).parents[3] / "spec" / "RNA.md"

VECTOR, SCALAR, FLAG = "vector", "scalar", "flag"
ARGUMENTS = {"p": VECTOR, "n": VECTOR, "t": VECTOR, "h": SCALAR}
ARGUMENTS |= {"f": VECTOR, "wo": VECTOR, "wi": VECTOR}
"""Name -> type of the arguments of formulas."""
_KINDS = {"n": "surface", "t": "fiber", "h": "fiber"}
"""Arguments that one kind of part alone has."""
FUNCTIONS = {
    "dot": SCALAR,
    "cross": VECTOR,
    "length": SCALAR,
    "largest": SCALAR,
    "sqrt": SCALAR,
    "log2": SCALAR,
    "clamped": SCALAR,
    "at_least": SCALAR,
    "where": None,  # the type of its second argument
}

_ROW = re.compile(r"\| `(\w+)` \| (\w+) \| (\w+) \| (.*) \|")


class BlockFormulas:
    """Attributes:
    values: block -> the expressions of its values, none of `features`, which are gathered.
    terms: name -> expression, in an order in which each has what it needs.
    constants: name in capitals -> number.
    """

    def __init__(self, text: str) -> None:
        """text: the specification's. Raises ValueError: the table's width or kind is wrong."""
        section = text.split("### 6.3 Input blocks")[1].split("\n## ")[0]
        section, code = section.split("```python\n")[0], section.split("```")[1]
        self.terms: dict[str, ast.expr] = {}
        self.constants: dict[str, float] = {}
        self._types = dict(ARGUMENTS)
        for line in ast.parse(code.removeprefix("python\n")).body:
            assert isinstance(line, ast.Assign) and isinstance(line.targets[0], ast.Name)
            name = line.targets[0].id
            if name.isupper():
                self.constants[name] = ast.literal_eval(line.value)
                continue
            self._types[name] = self.type_of(line.value)
            self.terms[name] = line.value
        self.values: dict[str, tuple[ast.expr, ...]] = {}
        for name, width, kinds, values in _ROW.findall(section):
            expressions = re.findall("`([^`]*)`", values) if width != "C" else []
            self.values[name] = tuple(
                ast.parse(expression, mode="eval").body for expression in expressions
            )
            of = self.kinds(name)
            expected = str(self.width(name) or "C"), "both" if len(of) == 2 else of[0]
            if (width, kinds) != expected:
                raise ValueError(f"{name}: found {width}, {kinds} in 6.3, expected {expected}")

    @classmethod
    def read(cls) -> "BlockFormulas":
        """Formulas of the specification in this checkout."""
        return cls(SPECIFICATION.read_text(encoding="utf-8"))

    def type_of(self, node: ast.expr) -> str:
        """VECTOR, SCALAR or FLAG. Raises KeyError: a name or function that is not known."""
        match node:
            case ast.Name(id=name):
                return SCALAR if name in self.constants else self._types[name]
            case ast.Compare():
                return FLAG
            case ast.Call(func=ast.Name(id=name), args=arguments):
                types = [self.type_of(argument) for argument in arguments]
                return FUNCTIONS[name] or types[1]
            case ast.BinOp():
                return VECTOR if VECTOR in map(self.type_of, (node.left, node.right)) else SCALAR
        return SCALAR

    def width(self, block: str) -> int | None:
        """Columns; None of `features`."""
        widths = [3 if self.type_of(value) == VECTOR else 1 for value in self.values[block]]
        return sum(widths) or None

    def kinds(self, block: str) -> list[str]:
        """The kinds of parts that have its inputs."""
        needed = {_KINDS[name] for name in self.needs(block) if name in _KINDS}
        return [kind for kind in ("surface", "fiber") if needed <= {kind}]

    def blocks_of(self, *kinds: str) -> list[str]:
        """The blocks that have formulas, for these kinds of parts, or for any."""
        of = set(kinds or ("surface", "fiber"))
        return [b for b, values in self.values.items() if values and of & {*self.kinds(b)}]

    def is_plain(self, block: str) -> bool:
        """Whether its value is an argument as it is."""
        return [ast.unparse(value) for value in self.values[block]] in [[a] for a in ARGUMENTS]

    def arguments(self, *names: str) -> list[str]:
        """The arguments that these blocks or terms need."""
        return [a for a in ARGUMENTS if any(a in self.needs(name) for name in names)]

    def needs(self, name: str, of: Iterable[str] = (), *given: str) -> list[str]:
        """The names of `of`, or of all arguments and terms, that a block or a term needs, in order.

        What is given, and what that alone needs, is left out.
        """
        needed: set[str] = set()
        waiting = list(self.values[name] if name in self.values else [self.terms[name]])
        while waiting:
            for node in ast.walk(waiting.pop()):
                if isinstance(node, ast.Name) and node.id not in {*needed, *given, *FUNCTIONS}:
                    needed.add(node.id)
                    waiting += filter(None, [self.terms.get(node.id)])
        return [name for name in of or (*ARGUMENTS, *self.terms) if name in needed]
