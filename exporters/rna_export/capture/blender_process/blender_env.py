"""Finds or creates the Python environment of Blender's module.

`bpy` needs numpy below 2 and is GPL; so it stays out of the SDK's own environment and process.
"""

import os
import subprocess
import sys
import venv
from pathlib import Path

from rna_sdk.errors import CaptureError
from rna_sdk.files.owned_folder import cache_folder
from rna_work.cached import locked

BPY_VERSION = "5.0.1"  # the first whose fibers have the shape THICK_LINEAR
VARIABLE = "RNA_BLENDER_PYTHON"


def default_folder() -> Path:
    """Default folder of the environment of `--setup-blender`."""
    return cache_folder() / f"blender-{BPY_VERSION}"


def find_python() -> Path:
    """The interpreter that can `import bpy`; `CaptureError` says how to get one."""
    named = os.environ.get(VARIABLE)
    python = Path(named) if named else default_folder() / "bin" / "python"
    if not (python.is_file() if named else _is_whole(default_folder())):
        raise CaptureError(
            f"no Blender environment: {python} is missing or unfinished; run "
            f"'rna-capture --setup-blender', or set {VARIABLE} to a Python 3.11 that can import bpy"
        )
    return python


def find_or_set_up() -> Path:
    """The interpreter; its environment is made where it is missing, by one process at a time.

    Raises CaptureError if it cannot be made, or if the variable names none.
    """
    if os.environ.get(VARIABLE) or _is_whole(default_folder()):
        return find_python()
    folder = default_folder()
    with locked(folder.with_name(folder.name + ".lock")):
        return find_python() if _is_whole(folder) else set_up()


def _is_whole(folder: Path) -> bool:
    """Whether pip came to its end: it writes this record last."""
    return any(folder.glob(f"lib/python*/site-packages/bpy-{BPY_VERSION}.dist-info/RECORD"))


def set_up() -> Path:
    """Create the environment and install `bpy` into it; returns its interpreter."""
    if sys.version_info[:2] != (3, 11):
        found = f"{sys.version_info.major}.{sys.version_info.minor}"
        raise CaptureError(f"bpy {BPY_VERSION} needs Python 3.11, this is Python {found}")
    folder = default_folder()
    python = folder / "bin" / "python"
    if not python.is_file():
        venv.create(folder, with_pip=True)
    command = [str(python), "-m", "pip", "install", "--quiet", f"bpy=={BPY_VERSION}"]
    if subprocess.run(command).returncode != 0:
        raise CaptureError(f"could not install bpy {BPY_VERSION} into {folder}")
    return python
