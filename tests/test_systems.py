"""What can be checked of Windows and macOS on Linux: modules, functions and names of files.

Ours are imported and run in a Python without what the other system lacks.
"""

import subprocess
import sys

import pytest
import yaml

from tests.conftest import REPOSITORY

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"

_SCRIPT = """\
import importlib, os, pkgutil, signal, sys
import embreex, numba, onnxruntime, OpenEXR, PIL.Image, pydantic, tqdm, trimesh, yaml

system, toy, out = sys.argv[1:]
missing = ["sched_getaffinity", "sched_setaffinity"]
if system == "win32":
    missing += ["fork", "killpg", "getuid", "mkfifo", "statvfs", "getpgid", "setsid"]
    for name in ("fcntl", "resource", "pwd", "grp", "termios", "tty", "pty", "syslog"):
        sys.modules[name] = None
    for name in ("SIGKILL", "SIGHUP", "SIGALRM", "SIGUSR1", "setitimer", "alarm"):
        delattr(signal, name)
for name in missing:
    delattr(os, name)
for room in ("rna_sdk", "rna_work", "rna_trace", "rna_render"):
    for module in pkgutil.walk_packages(importlib.import_module(room).__path__, room + "."):
        if "cluster" not in module.name:  # which needs Ray
            importlib.import_module(module.name)

import numpy as np
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.package import validate
from rna_sdk.runtime import load
from rna_work.cached import locked

asset = load(toy)
up, corner = np.float32([[0, 1, 0]]), np.zeros(1, np.float32)
color = asset.base_color_at(np.uint32([0]), corner, corner)
visible, _ = asset.evaluate(asset.mesh.positions[:1], up, up, up, color)
assert np.isfinite(visible).all() and validate(toy) == []
from pathlib import Path
write_atomically(Path(out) / "a.bin", b"whole")
with locked(Path(out) / "lock"):
    assert (Path(out) / "a.bin").read_bytes() == b"whole"
"""


@pytest.mark.parametrize("system", ["win32", "darwin"])
def test_readers_and_renderers_import_and_read_there(system, tmp_path):
    command = [sys.executable, "-c", _SCRIPT, system, str(TOY), str(tmp_path)]
    subprocess.run(command, check=True, cwd=REPOSITORY)


def test_names_of_files_are_good_on_windows():
    """No names that differ by case alone, reserved ones, or characters that it refuses."""
    listed = subprocess.run(["git", "ls-files"], cwd=REPOSITORY, capture_output=True, text=True)
    paths = listed.stdout.splitlines() or pytest.skip("not a clone")
    assert len({path.lower() for path in paths}) == len(paths)
    reserved = {"con", "prn", "aux", "nul", *(f"{d}{k}" for d in ("com", "lpt") for k in range(10))}
    for path in paths:
        parts = path.split("/")
        assert not set('<>:"\\|?*') & set(path), path
        assert not reserved & {part.split(".")[0].lower() for part in parts}, path
        assert not any(part.endswith((" ", ".")) for part in parts), path


def test_the_workflow_runs_what_is_here():
    text = (REPOSITORY / ".github" / "workflows" / "tests.yml").read_text()
    jobs = yaml.safe_load(text)["jobs"]
    assert {job["runs-on"] for job in jobs.values()} >= {"ubuntu-24.04", "${{ matrix.system }}"}
    steps = [step["run"] for job in jobs.values() for step in job["steps"] if "run" in step]
    named = [word for step in steps for word in step.split() if word.startswith(("tests/", ".ci/"))]
    assert named and all((REPOSITORY / name).exists() for name in named)
