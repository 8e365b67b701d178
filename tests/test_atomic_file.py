"""Files that appear whole or not at all, by every part of the tree that writes one."""

import os
import subprocess
import sys

import numpy as np
import pytest

from rna_render.image.images import write_png
from rna_sdk.errors import SceneError
from rna_sdk.files.atomic_file import atomic_file, remove_leftovers, write_atomically
from rna_sdk.files.outputs import check_outputs
from rna_sdk.runtime.engine import costs


def test_the_file_is_replaced_at_the_end(tmp_path):
    path = tmp_path / "a.bin"
    path.write_bytes(b"old")
    with atomic_file(path) as temporary:
        temporary.write_bytes(b"new")
        assert path.read_bytes() == b"old"
        assert temporary.parent == tmp_path and temporary.suffix == ".part"
    assert path.read_bytes() == b"new"
    assert os.listdir(tmp_path) == ["a.bin"]


def test_a_failure_leaves_the_old_file_alone(tmp_path):
    path = tmp_path / "a.bin"
    path.write_bytes(b"old")
    with pytest.raises(ValueError), atomic_file(path) as temporary:
        temporary.write_bytes(b"half")
        raise ValueError
    with pytest.raises(FileNotFoundError), atomic_file(path):
        pass  # nothing was written
    assert path.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["a.bin"]


def test_a_folder_in_the_way_stays_and_nothing_else(tmp_path):
    path = tmp_path / "a.bin"
    path.mkdir()
    with pytest.raises(IsADirectoryError):
        write_atomically(path, b"new")
    assert os.listdir(tmp_path) == ["a.bin"]


@pytest.fixture
def no_rename(monkeypatch):
    def refuse(source: object, target: object) -> None:
        raise OSError("no space left")

    monkeypatch.setattr(os, "replace", refuse)


def test_the_cost_cache_leaves_no_temporary_file(tmp_path, monkeypatch, no_rename):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert costs.cached_cost(lambda: 5.0, "package") == 5.0
    assert os.listdir(tmp_path / "rna-sdk") == []


def test_an_image_that_cannot_be_renamed_leaves_none(tmp_path, no_rename):
    with pytest.raises(SceneError, match="cannot write the image"):
        write_png(tmp_path / "a.png", np.zeros((2, 2, 3), np.float32))
    assert os.listdir(tmp_path) == []


KILLED = """
import os, signal, sys, time
from pathlib import Path
from rna_sdk.files.atomic_file import atomic_file
with atomic_file(Path(sys.argv[1])) as temporary:
    temporary.write_bytes(b"half")
    print("writes", flush=True)
    time.sleep(60)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="folders cannot be locked")
def test_what_a_killed_process_left_goes_at_the_next_start(tmp_path):
    def names() -> list[str]:
        return sorted(path.name for path in tmp_path.iterdir())

    (tmp_path / ".a.bin.part").write_bytes(b"of somebody else")
    command = [sys.executable, "-c", KILLED, tmp_path / "a.bin"]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None and process.stdout.readline() == b"writes\n"
        remove_leftovers(tmp_path)
        assert len(names()) == 2  # somebody writes there
        process.kill()
    remove_leftovers.cache_clear()
    check_outputs([tmp_path / "b.bin"], [])
    assert names() == [".a.bin.part"]
