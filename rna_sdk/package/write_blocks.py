"""Input blocks in the languages of readers, from the table and formulas of spec/RNA.md, 6.3.

`python -m rna_sdk.package.write_blocks`, in a checkout. The web pages read spec/blocks.json.
"""

from __future__ import annotations

import ast
import json
import sys
from collections.abc import Iterable

from rna_sdk.package.formulas.block_formulas import BlockFormulas
from rna_sdk.package.formulas.languages import C, Lanes, Language, Wgsl, indented
from rna_sdk.package.generated import generate, note

_MODULE = "rna_sdk.package.write_blocks"
_NOTE = f"{note(_MODULE)} Formulas: RNA.md, 6.3."
_KINDS = "surface", "fiber"
_RAW = "# fmt: off\n# isort: skip_file\n# ruff: noqa: E501"
"""A generated statement is one line."""


def files(formulas: BlockFormulas) -> dict[str, str]:
    """Path below the repository -> text."""
    return {
        "spec/blocks.json": _json(formulas),
        "rna_sdk/package/block_table.py": _table(formulas),
        "rna_sdk/runtime/kernels/input_blocks.py": _lanes(formulas),
        "exporters/rna_export/training/model/input_formulas.py": _arrays(
            formulas,
            "from torch import Tensor",
            "from rna_export.training.model.tensor_vectors import {}",
            "Tensor",
        ),
        "runtime/rna_mitsuba/input_formulas.py": _arrays(
            formulas, "from typing import Any", "from rna_mitsuba.vectors import {}", "Any"
        ),
        "runtime/rna_gpu/wgsl/surface_blocks.wgsl": _wgsl(formulas, "surface", "m"),
        "runtime/rna_gpu/wgsl/fiber_blocks.wgsl": _wgsl(formulas, "fiber"),
        "examples/hosts/c/rna/block_table.h": _c_table(formulas),
        "examples/hosts/c/rna/block_formulas.h": _c_formulas(formulas),
    }


def _kinds(formulas: BlockFormulas, block: str) -> list[str]:
    return [kind for kind in _KINDS if formulas.kind(block) in (None, kind)]


def _reads_light(formulas: BlockFormulas, block: str) -> bool:
    return "wi" in formulas.needs(block)


def _json(formulas: BlockFormulas) -> str:
    rows = [
        {
            "name": block,
            "width": formulas.width(block),
            "kinds": _kinds(formulas, block),
            "light": _reads_light(formulas, block),
        }
        for block in formulas.values
    ]
    return '{\n  "blocks": [\n    ' + ",\n    ".join(map(json.dumps, rows)) + "\n  ]\n}\n"


def _table(formulas: BlockFormulas) -> str:
    rows = [
        f'    "{block}": ({formulas.width(block)}, frozenset({_quoted(_kinds(formulas, block))}), '
        f"{_reads_light(formulas, block)}),\n"
        for block in formulas.values
    ]
    numbers = [f"{block.upper()} = {k}\n" for k, block in enumerate(formulas.values)]
    return (
        f'"""Input blocks.\n\n{_NOTE}\n"""\n\n'
        "BLOCK_TABLE: dict[str, tuple[int | None, frozenset[str], bool]] = {\n"
        f"{''.join(rows)}}}\n"
        '"""Name -> columns, None for the feature channels; kinds of assets; whether it reads the '
        'light."""\n\n# Places in the table.\n' + "".join(numbers)
    )


def _quoted(names: list[str]) -> str:
    return "{" + ", ".join(f'"{name}"' for name in names) + "}"


def _lines(*lines: str) -> str:
    return "\n".join(lines) + "\n"


def _lanes(formulas: BlockFormulas) -> str:
    language = Lanes(formulas)
    names = ", ".join(sorted(block.upper() for block in formulas.values if block != "features"))
    text = _lines(
        f'"""Compiled: input blocks, LANES rows at a time. {_NOTE}"""',
        "",
        _RAW,
        "from __future__ import annotations",
        "",
        "from typing import Any",
        "",
        "from rna_sdk.compiled import compiled",
        f"from rna_sdk.package.block_table import {names}",
        "from rna_sdk.runtime.kernels.block_columns import put",
        "from rna_sdk.runtime.kernels.lane_vectors import "
        "at_least, clamped, largest, length, log2, narrowed",
        "from rna_sdk.runtime.kernels.lanes import sqrt, where",
        "from rna_sdk.runtime.kernels.vectors import dot",
        "",
        *(f"{name} = {value}" for name, value in formulas.constants.items()),
    )
    for name, term, what in (
        ("halfway", "m", "m: the half vector of unit wo and wi; 0 where they are opposite."),
        ("bent_normal", "q", "q: the unit normal n, bent by the first three features f."),
    ):
        arguments = formulas.arguments(term)
        body = [f'"""{what}"""', *language.terms(term), f"return {term}"]
        text += _function(name, arguments, "Any", body)
    for kind, given in (("surface", ["m"]), ("fiber", [])):
        arguments = [*formulas.arguments(*formulas.blocks_of(kind)), *given]
        body = ['"""All blocks but `features`, in LANES rows from `row` on; p in float64."""']
        body += language.blocks(kind, set(given))
        text += _function(f"put_{kind}", ["queries", "row", "columns", *arguments], "None", body)
    return text


def _function(name: str, arguments: Iterable[str], result: str, body: list[str]) -> str:
    typed = ", ".join(f"{argument}: Any" for argument in arguments)
    return _lines("", "", "@compiled()", f"def {name}({typed}) -> {result}:", *indented(body))


def _arrays(formulas: BlockFormulas, types: str, functions: str, number: str) -> str:
    """Python for an array library. functions: where those of formulas come from."""
    names = "at_least, clamped, cross, dot, largest, length, log2, sqrt, where"
    text = _lines(
        f'"""Input blocks of vectors and numbers. {_NOTE}"""',
        "",
        _RAW,
        "from __future__ import annotations",
        "",
        types,
        "",
        functions.format(names),
    )
    for kind in _KINDS:
        arguments = formulas.arguments(*formulas.blocks_of(kind))
        typed = ", ".join(f"{argument}: {number}" for argument in arguments)
        body = [
            '"""Name -> values, for the blocks in `inputs` and those that are arguments."""',
            f"blocks: dict[str, tuple[{number}, ...]] = {{}}",
            *Language(formulas).blocks(kind),
            "return blocks",
        ]
        result = f"dict[str, tuple[{number}, ...]]"
        text += _lines("", "", f"def {kind}_blocks(inputs: tuple[str, ...], {typed}) -> {result}:")
        text += _lines(*indented(body))
    return text


def _wgsl(formulas: BlockFormulas, kind: str, *given: str) -> str:
    language = Wgsl(formulas)
    text = f"// Input blocks of a {kind}, but `features`. {_NOTE}\n"
    types = {"vector": "vec3f", "scalar": "f32"}

    def function(name: str, arguments: list[str], result: str, body: list[str]) -> str:
        typed = [f"{a}: {types[formulas.type_of(ast.Name(a))]}" for a in arguments]
        return _lines("", f"fn {name}({', '.join(typed)}){result} {{", *indented(body), "}")

    if "m" in given:
        body = [*language.terms("m"), "return m;"]
        text += "\n// 0 where they are opposite." + function(
            "rna_halfway", formulas.arguments("m"), " -> vec3f", body
        )
    arguments = [*formulas.arguments(*formulas.blocks_of(kind)), *given]
    body = language.places(kind) + language.blocks(kind, set(given))
    return text + function(f"rna_{kind}_blocks", arguments, "", body)


def _c_table(formulas: BlockFormulas) -> str:
    numbers = [f"    {block.upper()},\n" for block in formulas.values]
    rows = []
    for block in formulas.values:
        uses = [f"FOR_{kind.upper()}" for kind in _kinds(formulas, block)]
        uses += [] if _reads_light(formulas, block) else ["FOR_EMISSION"]
        width = formulas.width(block) or 0
        rows.append(f'    [{block.upper()}] = {{"{block}", {width}, {" | ".join(uses)}}},\n')
    return (
        f"/* Input blocks (section 6.3). {_NOTE} */\n"
        '#ifndef RNA_BLOCK_TABLE_H\n#define RNA_BLOCK_TABLE_H\n\n#include "base.h"\n\n'
        f"enum Block {{\n{''.join(numbers)}    BLOCKS\n}};\n\n"
        "enum { FOR_SURFACE = 1 << RNA_SURFACE, FOR_FIBER = 1 << RNA_FIBER, FOR_EMISSION = 4 };\n\n"
        "static const struct {\n"
        "    const char *name;\n"
        "    int width; /* 0: as many as the planes have channels */\n"
        "    unsigned uses;\n"
        f"}} BLOCK_TABLE[BLOCKS] = {{\n{''.join(rows)}}};\n\n#endif\n"
    )


def _c_formulas(formulas: BlockFormulas) -> str:
    text = (
        f"/* Values of input blocks. {_NOTE} */\n"
        "#ifndef RNA_BLOCK_FORMULAS_H\n#define RNA_BLOCK_FORMULAS_H\n\n"
        '#include "block_functions.h"\n#include "block_table.h"\n#include "points.h"\n'
    )
    for kind in _KINDS:
        text += _lines(
            "",
            f"static void put_{kind}(const Points *points, const int column[BLOCKS], "
            "float *restrict queries) {",
            *indented(C(formulas).blocks(kind)),
            "}",
        )
    return text + "\n#endif\n"


if __name__ == "__main__":
    sys.exit(generate(files(BlockFormulas.read()), _MODULE))
