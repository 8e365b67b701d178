"""What all commands have in common: errors of the system, and readers that end early."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest

from rna_sdk.console import run_command

LONG = """
import sys
from pathlib import Path
from rna_sdk.console import command_parser, run_command
options = command_parser("rna-test", "Test.", "rna-test", epilog=100_000 * "long ")
options.parse_args(sys.argv[2:])
def command():
    for number in range(20_000):
        print("frame", number, flush=number % 100 == 0)
        print("rendering", number, file=sys.stderr)
    Path(sys.argv[1]).touch()
sys.exit(run_command(command, False, "stopped"))
"""


def fails(error: BaseException, debug: bool = False) -> int:
    def command() -> None:
        raise error

    return run_command(command, debug, "stopped")


@pytest.mark.parametrize(
    ("error", "line"),
    [
        (OSError(errno.ENOSPC, "No space left on device"), "No space left on device"),
        (OSError(errno.EROFS, "Read-only file system", "/a/b"), "/a/b: Read-only file system"),
        (PermissionError(errno.EACCES, "Permission denied", "a"), "a: Permission denied"),
        (TimeoutError("no answer"), "no answer"),
    ],
)
def test_an_error_of_the_system_is_one_line(
    error: OSError, line: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert fails(error) == 1
    assert capsys.readouterr().err == f"error: {line}\n"
    assert fails(error, debug=True) == 1
    assert "Traceback" in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [[], ["--help"]])
def test_work_goes_on_after_its_reader_ended(tmp_path: Path, arguments: list[str]) -> None:
    reading, writing = os.pipe()
    command = [sys.executable, "-c", LONG, tmp_path / "done", *arguments]
    with subprocess.Popen(command, stdout=writing, stderr=writing) as process:
        os.close(writing)
        assert os.read(reading, 5) in (b"frame", b"usage", b"rende")
        os.close(reading)
    assert process.returncode == 0
    assert (tmp_path / "done").exists() is not bool(arguments)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no /dev/full")
def test_output_into_a_full_disk_is_one_line(tmp_path: Path) -> None:
    with open("/dev/full", "w") as full:
        command = [sys.executable, "-c", LONG, tmp_path / "done"]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 1
    assert done.stderr == "error: standard output: No space left on device\n"
