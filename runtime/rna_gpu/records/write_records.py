"""The records in WGSL, and for JavaScript: `python -m rna_gpu.records.write_records`."""

import json
import re
import sys
from collections.abc import Iterable, Mapping
from typing import Any

from rna_gpu.records import geometry, part, scene, tables
from rna_gpu.records.record import Record, constants
from rna_render.lights import kinds_of_lights, number_places
from rna_sdk.package.generated import generate, note

_MODULE = "rna_gpu.records.write_records"
_SHADERS = "runtime/rna_gpu/wgsl"
_LIMITS = {
    "MAX_LAYERS": part.MAX_LAYERS,
    "MAX_EXACT_INPUTS": part.MAX_EXACT_INPUTS,
    "UNIFORM_WEIGHTS": part.UNIFORM_WEIGHTS,
}
_SECTIONS = {
    "objects": tables.OBJECT,
    "surfaces": tables.SURFACE,
    "textures": tables.TEXTURE,
    "lights": tables.LIGHT,
}


def files() -> dict[str, str]:
    """Path below the repository -> text."""
    of_geometry = [geometry.NODE, geometry.PRIMITIVE, geometry.INSTANCE]
    of_scenes = [scene.FRAME, scene.PATH, scene.QUERY, scene.QUERIES]
    records = [part.LAYER, part.PART, part.ROW, *of_geometry, *of_scenes, *_SECTIONS.values()]
    result = {
        "note": note(_MODULE),
        "constants": _LIMITS
        | part.PART_CONSTANTS
        | geometry.GEOMETRY_CONSTANTS
        | scene.SCENE_CONSTANTS
        | tables.TABLE_CONSTANTS,
        "records": {record.name: record.layout() for record in records},
        "lights": {kind: number_places(numbers) for kind, numbers in kinds_of_lights().items()},
        "usualLobes": tables.USUAL_LOBES,
        "viewerLights": {kind: k for k, kind in enumerate(tables.VIEWER_LIGHTS)},
    }
    return {
        f"{_SHADERS}/part_records.wgsl": _wgsl(part.PART_CONSTANTS, [part.LAYER, part.PART]),
        f"{_SHADERS}/row_records.wgsl": _wgsl({}, [part.ROW]),
        f"{_SHADERS}/geometry_records.wgsl": _wgsl(geometry.GEOMETRY_CONSTANTS, of_geometry),
        f"{_SHADERS}/render/scene_records.wgsl": _wgsl(scene.SCENE_CONSTANTS, of_scenes),
        f"{_SHADERS}/render/table_records.wgsl": _tables(),
        f"{_SHADERS}/records.json": _json(result),
    }


def _tables() -> str:
    """Functions that read the sections of the table; none of its records stands there alone."""
    read = "\n".join(record.accessors(name) for name, record in _SECTIONS.items())
    return f"{_wgsl(tables.TABLE_CONSTANTS)}\n{read}\n{tables.light_accessors()}"


def _json(tables: dict[str, Any]) -> str:
    """Indented, a member of a record on one line."""
    text = json.dumps(tables, indent=1)
    return (
        re.sub(r"\{\s*(\"at\"[^{}]*?)\s*\}", lambda m: f"{{{' '.join(m[1].split())}}}", text) + "\n"
    )


def _wgsl(values: Mapping[str, Any], records: Iterable[Record] = ()) -> str:
    parts = [f"// {note(_MODULE)}\n", constants(values), *(record.wgsl() for record in records)]
    return "\n".join(filter(None, parts))


if __name__ == "__main__":
    sys.exit(generate(files(), _MODULE))
