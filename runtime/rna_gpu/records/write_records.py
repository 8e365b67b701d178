"""The records in WGSL, and for JavaScript: `python -m rna_gpu.records.write_records`."""

from __future__ import annotations

import json
import re
import sys
from typing import Any

from rna_gpu.records import part, scene
from rna_gpu.records.record import Record, constants
from rna_sdk.package.generated import generate, note

_MODULE = "rna_gpu.records.write_records"
_SHADERS = "runtime/rna_gpu/wgsl"
_LIMITS = {
    "MAX_LAYERS": part.MAX_LAYERS,
    "MAX_EXACT_INPUTS": part.MAX_EXACT_INPUTS,
    "UNIFORM_WEIGHTS": part.UNIFORM_WEIGHTS,
}


def files() -> dict[str, str]:
    """Path below the repository -> text."""
    of_parts = part.LAYER, part.PART
    of_scenes = scene.FRAME, scene.PATH, scene.PENDING
    layouts = {record.name: record.layout() for record in (*of_parts, *of_scenes)}
    numbers = _LIMITS | part.PART_CONSTANTS | scene.SCENE_CONSTANTS
    tables = {"note": note(_MODULE), "constants": numbers, "records": layouts}
    return {
        f"{_SHADERS}/part_records.wgsl": _wgsl(part.PART_CONSTANTS, *of_parts),
        f"{_SHADERS}/render/scene_records.wgsl": _wgsl(scene.SCENE_CONSTANTS, *of_scenes),
        f"{_SHADERS}/records.json": _json(tables),
    }


def _json(tables: dict[str, Any]) -> str:
    """Indented, a member of a record on one line."""
    text = json.dumps(tables, indent=1)
    return (
        re.sub(r"\{\s*(\"at\"[^{}]*?)\s*\}", lambda m: f"{{{' '.join(m[1].split())}}}", text) + "\n"
    )


def _wgsl(values: dict[str, int], *records: Record) -> str:
    structs = "\n".join(record.wgsl() for record in records)
    return f"// {note(_MODULE)} Numbers before comments: bytes.\n\n{constants(values)}\n{structs}"


if __name__ == "__main__":
    sys.exit(generate(files(), _MODULE))
