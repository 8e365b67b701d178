"""Input blocks in the languages of readers, from the table and formulas of spec/RNA.md, 6.3.

`python -m rna_sdk.package.write_blocks`, in a checkout. The web pages read spec/blocks.json.
"""

import ast
import json
import sys
from typing import NamedTuple

from rna_sdk.package.formulas.block_formulas import SCALAR, BlockFormulas
from rna_sdk.package.formulas.languages import C, Lanes, Language, Wgsl, indented
from rna_sdk.package.generated import generate, note

_MODULE = "rna_sdk.package.write_blocks"
_NOTE = f"{note(_MODULE)} Formulas: RNA.md, 6.3."
_RAW = "# fmt: off\n# isort: skip_file\n# ruff: noqa: E501"
"""A generated statement is one line."""

_EXAMPLE = (
    "Examples:",
    "    >>> p = np.float32([[0.5, 0.75, 1.0]])",
    '    >>> (vectors,) = input_blocks(np, ("position",), p=p)["position"]',
    "    >>> vectors.tolist()",
    "    [[0.0, 0.5, 1.0]]",
)


def files(formulas: BlockFormulas) -> dict[str, str]:
    """Path below the repository -> text."""
    blocks = [_Block.of(name, formulas) for name in formulas.values]
    rows = ",\n    ".join(json.dumps(block._asdict()) for block in blocks)
    return {
        "spec/blocks.json": f'{{\n  "blocks": [\n    {rows}\n  ]\n}}\n',
        "rna_sdk/package/block_table.py": _table(blocks),
        "rna_sdk/package/array_blocks.py": _arrays(formulas),
        "rna_sdk/runtime/kernels/input_blocks.py": _lanes(formulas),
        "runtime/rna_gpu/wgsl/surface_blocks.wgsl": _wgsl(formulas, "surface", "m"),
        "runtime/rna_gpu/wgsl/fiber_blocks.wgsl": _wgsl(formulas, "fiber"),
        "examples/hosts/c/rna/block_table.h": _c_table(blocks),
        "examples/hosts/c/rna/block_formulas.h": _c_formulas(formulas),
    }


class _Block(NamedTuple):
    """A row of the table."""

    name: str
    width: int | None
    kinds: list[str]
    light: bool

    @classmethod
    def of(cls, name: str, formulas: BlockFormulas) -> "_Block":
        light = "wi" in formulas.needs(name)
        return cls(name, formulas.width(name), formulas.kinds(name), light)


def _table(blocks: list[_Block]) -> str:
    rows = [
        f'    "{b.name}": ({b.width}, frozenset({{{json.dumps(b.kinds)[1:-1]}}}), {b.light}),'
        for b in blocks
    ]
    return _lines(
        f'"""Input blocks.\n\n{_NOTE}\n"""\n',
        "BLOCK_TABLE: dict[str, tuple[int | None, frozenset[str], bool]] = {",
        *rows,
        '}\n"""Name -> columns, None for the feature channels; kinds of assets; whether it reads '
        'the light."""\n\n# Places in the table.',
        *(f"{block.name.upper()} = {k}" for k, block in enumerate(blocks)),
    )


def _lines(*lines: str) -> str:
    return "\n".join(lines) + "\n"


def _arrays(formulas: BlockFormulas) -> str:
    text = _lines(
        f'"""Input blocks, of arrays of any library. {_NOTE}',
        "",
        "of: the functions of the formulas for this library, in a module, for one: dot, cross,",
        "length, largest, sqrt, log2, clamped, at_least, where. The others are those of 6.3.",
        f'"""\n\n{_RAW}',
    )
    typed = ", ".join(
        f"{argument}: Any = None" for argument in formulas.arguments(*formulas.values)
    )
    return text + _lines(
        "from typing import Any\n\n",
        f"def input_blocks(of: Any, inputs: tuple[str, ...], *, {typed}) -> dict[str, Any]:",
        '    """Block -> its vectors and numbers, for `inputs`, but not `features`.',
        "",
        *indented(_EXAMPLE),
        '    """',
        "    blocks: dict[str, Any] = {}",
        *indented(Language(formulas, "of.").blocks()),
        "    return blocks",
    )


def _lanes(formulas: BlockFormulas) -> str:
    language = Lanes(formulas)
    text = _lines(
        f'"""Compiled: input blocks, LANES rows at a time. {_NOTE}"""\n\n{_RAW}',
        "from typing import Any\n",
        "from rna_sdk.machine.compiled import compiled",
        "from rna_sdk.package.block_table import "
        + ", ".join(sorted(block.upper() for block, values in formulas.values.items() if values)),
        "from rna_sdk.runtime.kernels.block_columns import put",
        "from rna_sdk.runtime.kernels.lane_vectors import clamped, largest, length, log2, narrowed",
        "from rna_sdk.runtime.kernels.lanes import sqrt, where",
        "from rna_sdk.runtime.kernels.vectors import dot\n",
        *(f"{name} = {value}" for name, value in formulas.constants.items()),
    )

    def function(name: str, arguments: list[str], result: str, what: str, body: list[str]) -> str:
        typed = ", ".join(f"{argument}: Any" for argument in arguments)
        start = f"\n\n@compiled()\ndef {name}({typed}) -> {result}:\n"
        return start + _lines(*indented([f'"""{what}"""', *body]))

    for name, term, what in (
        ("halfway", "m", "m: the half vector of unit wo and wi; 0 where they are opposite."),
        ("bent_normal", "q", "q: the unit normal n, bent by the first three features f."),
    ):
        body = [*language.terms(term), f"return {term}"]
        text += function(name, formulas.arguments(term), "Any", what, body)
    for kind, given in (("surface", ["m"]), ("fiber", [])):
        arguments = [*formulas.arguments(*formulas.blocks_of(kind)), *given]
        what = "All blocks but `features`, in LANES rows from `row` on; p in float64."
        body = language.blocks(kind, given=given)
        arguments = ["queries", "row", "columns", *arguments]
        text += function(f"put_{kind}", arguments, "None", what, body)
    return text


def _wgsl(formulas: BlockFormulas, kind: str, *given: str) -> str:
    language = Wgsl(formulas)

    def function(name: str, arguments: list[str], result: str, body: list[str]) -> str:
        numbers = {a for a in arguments if formulas.type_of(ast.Name(a)) == SCALAR}
        typed = ", ".join(f"{a}: {'f32' if a in numbers else 'vec3f'}" for a in arguments)
        return _lines("", f"fn {name}({typed}){result} {{", *indented(body), "}")

    text = f"// Input blocks of a {kind}, but `features`. {_NOTE}\n"
    if "m" in given:  # 0 where they are opposite
        body = [*language.terms("m"), "return m;"]
        text += function("rna_halfway", formulas.arguments("m"), " -> vec3f", body)
    arguments = [*formulas.arguments(*formulas.blocks_of(kind)), *given]
    return text + function(f"rna_{kind}_blocks", arguments, "", language.blocks(kind, given=given))


def _c_table(blocks: list[_Block]) -> str:
    rows = []
    for b in blocks:
        uses = [f"FOR_{kind.upper()}" for kind in b.kinds] + ["FOR_EMISSION"] * (not b.light)
        rows.append(f'    [{b.name.upper()}] = {{"{b.name}", {b.width or 0}, {" | ".join(uses)}}},')
    return _lines(
        f"/* Input blocks (section 6.3). {_NOTE} */",
        '#ifndef RNA_BLOCK_TABLE_H\n#define RNA_BLOCK_TABLE_H\n\n#include "base.h"\n',
        "enum Block {",
        *(f"    {block.name.upper()}," for block in blocks),
        "    BLOCKS\n};\n",
        "enum { FOR_SURFACE = 1 << RNA_SURFACE, FOR_FIBER = 1 << RNA_FIBER, FOR_EMISSION = 4 };\n",
        "static const struct {",
        "    const char *name;",
        "    int width; /* 0: as many as the planes have channels */",
        "    unsigned uses;",
        "} BLOCK_TABLE[BLOCKS] = {",
        *rows,
        "};\n\n#endif",
    )


def _c_formulas(formulas: BlockFormulas) -> str:
    text = _lines(
        f"/* Values of input blocks. {_NOTE} */",
        "#ifndef RNA_BLOCK_FORMULAS_H\n#define RNA_BLOCK_FORMULAS_H\n",
        '#include "block_functions.h"\n#include "block_table.h"\n#include "points.h"',
    )
    arguments = "const Points *points, const int column[BLOCKS], float *restrict queries"
    body = indented(C(formulas).blocks())
    return text + _lines("", f"static void put_blocks({arguments}) {{", *body, "}", "", "#endif")


if __name__ == "__main__":
    sys.exit(generate(files(BlockFormulas.read()), _MODULE))
