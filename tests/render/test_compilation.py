"""The message while kernels are compiled, and its absence at a second start."""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from rna_render.command import compilation
from rna_render.command.compilation import compilations_reported
from rna_render.command.compile_ahead import compiling_ahead
from rna_sdk.machine import compiled as compiled_module
from rna_sdk.machine.compiled import watched_compilations

SCENE = Path(__file__).parents[2] / "examples" / "quickstart" / "scene.yaml"

CODE = """
import numpy as np
from rna_sdk.machine.compiled import compiled, watched_compilations
count = []
with watched_compilations(count.append):
    from rna_sdk.runtime.kernels.vectors import dot
    dot(*2 * [(np.float32(1), np.float32(2), np.float32(3))])
print(count)
"""


def test_what_is_in_the_cache_is_not_counted(tmp_path):
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}
    command = [sys.executable, "-c", CODE]
    told = [
        subprocess.run(command, env=environment, check=True, capture_output=True).stdout
        for _ in range(2)
    ]
    assert told == [b"[False, True]\n", b"[]\n"]


def compile_so_many(count: int) -> None:
    for _ in range(count):
        compiled_module._tell_watchers(False)
        compiled_module._tell_watchers(True)


def test_a_count_and_a_time_are_told(capsys, monkeypatch):
    monkeypatch.setattr(compilation, "_APART", -1.0)
    monkeypatch.setattr(compilation, "core_count", lambda: 1)
    with compilations_reported(SCENE):
        compile_so_many(25)
    output = capsys.readouterr().err
    assert (
        output
        == "compiling kernels, once: 3\ncompiled 25 kernels in 0 s; the next start finds them\n"
    )


def test_few_are_not_worth_a_line(capsys):
    with compilations_reported(SCENE):
        compile_so_many(2)
    assert capsys.readouterr().err == ""


def test_a_watcher_is_gone_after_its_context():
    seen: list[bool] = []
    with watched_compilations(seen.append):
        compile_so_many(1)
    compile_so_many(1)
    assert seen == [False, True]


def test_the_renderers_kernels_are_compiled_ahead(tmp_path, monkeypatch):
    """The process renders, and does not outlive what it is for."""
    command = [sys.executable, "-m", "rna_render.command.compile_ahead", SCENE, tmp_path]
    subprocess.run(command, check=True, capture_output=True)
    with compiling_ahead(SCENE):
        pass
    started: list[int] = []

    @contextmanager
    def ahead(scene: Path) -> Iterator[None]:
        assert scene == SCENE
        started.append(1)
        yield

    monkeypatch.setattr(compilation, "compiling_ahead", ahead)
    monkeypatch.setattr(compilation, "core_count", lambda: 2)
    with compilations_reported(SCENE):
        compile_so_many(30)
    assert started == [1]
