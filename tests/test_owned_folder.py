"""Folders of commands: none of the user's files is touched, and one process writes at a time."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from rna_sdk.errors import RnaError
from rna_sdk.files.owned_folder import owned

HOLDER = """
import sys, time
from pathlib import Path
from rna_sdk.files.owned_folder import owned
with owned(Path(sys.argv[1]), "rna-test") as own, own.scratch() as scratch:
    (scratch / "half").touch()
    (own.path / "result").touch()
    print("held", flush=True)
    time.sleep(60)
"""


def names(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*"))


def test_a_folder_of_others_is_refused_and_stays(tmp_path):
    for k in range(5):
        (tmp_path / f"{k}.txt").touch()
    before = names(tmp_path)
    message = r"found 0\.txt, 1\.txt, 2\.txt and 2 more, which rna-test did not write; expected a "
    with pytest.raises(RnaError, match=message), owned(tmp_path, "rna-test"):
        pytest.fail("entered")
    assert names(tmp_path) == before
    with pytest.raises(RnaError, match="is a file"), owned(tmp_path / "0.txt", "rna-test"):
        pytest.fail("entered")


def test_a_folder_of_another_command_is_refused(tmp_path):
    with owned(tmp_path, "rna-one"):
        (tmp_path / "result").touch()
    with pytest.raises(RnaError, match=r"found \.rna-one, result,"), owned(tmp_path, "rna-two"):
        pytest.fail("entered")


@pytest.mark.parametrize("folder", ["new", "a/b/new", "empty", "hidden", "own"])
def test_a_folder_of_its_own_is_entered(tmp_path, folder):
    path = tmp_path / folder
    if folder in ("empty", "hidden", "own"):
        path.mkdir()
    for name in {"hidden": [".gitkeep"], "own": [".rna-test", "x"]}.get(folder, []):
        (path / name).touch()
    with owned(path, "rna-test") as entered:
        (entered.path / "result").touch()
    assert {".rna-test", "result"} <= set(names(path))
    assert (path / ".rna-test").read_bytes() == b""


def test_a_command_that_wrote_nothing_leaves_nothing(tmp_path):
    with pytest.raises(ValueError), owned(tmp_path / "new", "rna-test"):
        raise ValueError
    (tmp_path / "old").mkdir()
    with owned(tmp_path / "old", "rna-test"):
        pass
    assert names(tmp_path) == ["old"]


def test_only_what_is_named_is_deleted(tmp_path):
    work, elsewhere = tmp_path / "work", tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "mine").touch()
    with owned(work, "rna-test") as folder:
        (work / "rays").mkdir()
        (work / "rays" / "0").touch()
        (work / "state.json").touch()
        (work / "linked").symlink_to(elsewhere)
        (work / "notes.txt").touch()
        assert folder.dissolve("rays", "state.json", "linked", "missing") == ["notes.txt"]
        assert names(work) == [".rna-test", "notes.txt"]
        (work / "notes.txt").unlink()
        assert folder.dissolve() == []
    assert names(tmp_path) == ["elsewhere", "elsewhere/mine"]


def test_one_process_writes_and_kill_minus_9_frees_the_folder(tmp_path):
    path = tmp_path / "work"
    command = [sys.executable, "-c", HOLDER, path]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as holder:
        assert holder.stdout is not None and holder.stdout.readline() == "held\n"
        message = rf"work: in use by rna-test, process {holder.pid} on \S+ since 2\d{{3}}-[-\d: ]+;"
        with pytest.raises(RnaError, match=message), owned(path, "rna-test"):
            pytest.fail("entered")
        holder.send_signal(signal.SIGKILL)
    (path / f".last.ckpt.{os.urandom(6).hex()}.part").touch()
    (path / "user.part").touch()
    assert any("scratch" in name for name in names(path))
    with owned(path, "rna-test"):
        assert names(path) == [".rna-test", "result", "user.part"]
