"""Blender with the extension, installed from its zip as a user would."""

import os
import subprocess
import sys
from collections.abc import Callable

import pytest

from tests.conftest import REPOSITORY

RunInBlender = Callable[..., str]
SOURCES = (".", "runtime", "exporters")

INSTALL = """
import os, sys, traceback
import bpy
bpy.ops.wm.read_factory_settings(use_empty=True)
assert bpy.ops.extensions.package_install_files(
    filepath={zip!r}, repo="user_default", enable_on_install=True) == {{"FINISHED"}}
scene = bpy.context.scene
def refused(operator, **arguments):
    try:
        operator(**arguments)
    except RuntimeError as error:
        print("refused:", " ".join(str(error).split()))
status = 1
try:
    exec(compile(open(sys.argv[1]).read(), sys.argv[1], "exec"))
    status = 0
except BaseException:
    traceback.print_exc()
sys.stdout.flush(); sys.stderr.flush()
os._exit(status)  # bpy may crash while it unloads
"""


@pytest.fixture(scope="session")
def extension_zip(tmp_path_factory):
    """The extension, as the script makes it."""
    out = tmp_path_factory.mktemp("extension") / "rna_sdk.zip"
    subprocess.run([REPOSITORY / "scripts" / "blender-extension", out], check=True)
    return out


@pytest.fixture
def run_in_blender(blender_python, extension_zip, tmp_path):
    """Runs the text of a script where the extension is installed; returns what it printed.

    The script has `bpy`, `scene` (empty) and `refused`, which prints why an operator fails.
    """
    environment = {
        **os.environ,
        "BLENDER_USER_RESOURCES": str(tmp_path / "user"),
        "XDG_DATA_HOME": str(tmp_path / "data"),
        "RNA_SDK_PYTHON": sys.executable,
        "PYTHONPATH": os.pathsep.join(str(REPOSITORY / folder) for folder in SOURCES),
    }

    def run(script: str, python: str | None = None) -> str:
        (tmp_path / "script.py").write_text(script)
        (tmp_path / "install.py").write_text(INSTALL.format(zip=str(extension_zip)))
        done = subprocess.run(
            [blender_python, tmp_path / "install.py", tmp_path / "script.py"],
            env=environment | ({} if python is None else {"RNA_SDK_PYTHON": python}),
            cwd=tmp_path,
            capture_output=True,
            text=True,
            timeout=300,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout + done.stderr

    return run
