"""The table of input blocks in Python and C, from spec/blocks.json, in a checkout:
`python -m rna_sdk.package.write_blocks`. The web pages read the JSON itself."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

from rna_sdk.package.generated import generate, note

_MODULE = "rna_sdk.package.write_blocks"
_SOURCE = Path(__file__).parents[2] / "spec" / "blocks.json"


def files() -> dict[str, str]:
    """Path below the repository -> text."""
    blocks = json.loads(_SOURCE.read_text(encoding="utf-8"))["blocks"]
    return {
        "rna_sdk/package/block_table.py": _python(blocks),
        "examples/hosts/c/rna/block_table.h": _c(blocks),
    }


def _python(blocks: list[dict[str, Any]]) -> str:
    rows = [
        f'    "{b["name"]}": ({b["width"]}, frozenset({_quoted(b["kinds"])}), {b["light"]}),\n'
        for b in blocks
    ]
    numbers = [f"{block['name'].upper()} = {k}\n" for k, block in enumerate(blocks)]
    return (
        f'"""Input blocks. {note(_MODULE)}"""\n\n'
        "BLOCK_TABLE: dict[str, tuple[int | None, frozenset[str], bool]] = {\n"
        f"{''.join(rows)}}}\n"
        '"""Name -> columns, None for the feature channels; kinds of assets; whether it reads the '
        'light."""\n\n# Places in the table.\n' + "".join(numbers)
    )


def _quoted(names: list[str]) -> str:
    return "{" + ", ".join(f'"{name}"' for name in names) + "}"


def _c(blocks: list[dict[str, Any]]) -> str:
    numbers = [f"    {block['name'].upper()},\n" for block in blocks]
    rows = []
    for block in blocks:
        uses = [f"FOR_{kind.upper()}" for kind in block["kinds"]]
        uses += [] if block["light"] else ["FOR_EMISSION"]
        name, width = block["name"], block["width"] or 0
        rows.append(f'    [{name.upper()}] = {{"{name}", {width}, {" | ".join(uses)}}},\n')
    return (
        f"/* Input blocks (section 6.3). {note(_MODULE)} */\n"
        '#ifndef RNA_BLOCK_TABLE_H\n#define RNA_BLOCK_TABLE_H\n\n#include "base.h"\n\n'
        f"enum Block {{\n{''.join(numbers)}    BLOCKS\n}};\n\n"
        "enum { FOR_SURFACE = 1 << RNA_SURFACE, FOR_FIBER = 1 << RNA_FIBER, FOR_EMISSION = 4 };\n\n"
        "static const struct {\n"
        "    const char *name;\n"
        "    int width; /* 0: as many as the planes have channels */\n"
        "    unsigned uses;\n"
        f"}} BLOCK_TABLE[BLOCKS] = {{\n{''.join(rows)}}};\n\n#endif\n"
    )


if __name__ == "__main__":
    sys.exit(generate(files(), _MODULE))
