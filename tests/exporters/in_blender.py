"""Runs Python inside Blender, beside the modules of the capture worker, and reads its answer."""

import json
import subprocess
from pathlib import Path
from typing import Any

import rna_export.capture.blender_process.blender_worker

_MODULES = Path(rna_export.capture.blender_process.blender_worker.__file__).parents[2] / "blender"
_START = f"""
import json, os, sys
sys.path.insert(0, {str(_MODULES)!r})
import bpy
bpy.ops.wm.read_factory_settings(use_empty=True)
def answer(value):
    print("\\nRNA " + json.dumps(value), flush=True)
    os._exit(0)  # bpy may crash while it unloads
"""


def answer_of(python: Path, code: str, *arguments: str) -> Any:
    """What the code gives to `answer`; `arguments` are its sys.argv[1:]."""
    ran = subprocess.run(
        [python, "-c", _START + code, *arguments], capture_output=True, text=True, timeout=300
    )
    for line in ran.stdout.splitlines():
        if line.startswith("RNA "):
            return json.loads(line[4:])
    raise AssertionError(ran.stdout[-2000:] + ran.stderr[-2000:])
