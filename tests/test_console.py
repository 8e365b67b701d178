"""What all commands have in common: errors of the system, and readers that end early."""

import errno
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from rna_sdk.commands.console import run_command

LONG = """
import sys
from pathlib import Path
from rna_sdk.commands.console import command_parser, run_command
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
        (MemoryError("Unable to allocate 8 TiB"), "not enough memory: Unable to allocate 8 TiB"),
        (MemoryError(), "not enough memory"),
        (
            RuntimeError(
                "[enforce fail at alloc_cpu.cpp:127] err == 0. DefaultCPUAllocator: can't allocate "
                "memory: you tried to allocate 112000000000 bytes. Error code 12 (Cannot allocate "
                "memory)"
            ),
            "not enough memory: you tried to allocate 112000000000 bytes",
        ),
    ],
)
def test_an_error_of_the_system_is_one_line(error, line, capsys):
    assert fails(error) == 1
    assert capsys.readouterr().err == f"error: {line}\n"
    assert fails(error, debug=True) == 1
    assert "Traceback" in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [[], ["--help"]])
def test_work_goes_on_after_its_reader_ended(tmp_path, arguments):
    reading, writing = os.pipe()
    command = [sys.executable, "-c", LONG, tmp_path / "done", *arguments]
    with subprocess.Popen(command, stdout=writing, stderr=writing) as process:
        os.close(writing)
        assert os.read(reading, 5) in (b"frame", b"usage", b"rende")
        os.close(reading)
    assert process.returncode == 0
    assert (tmp_path / "done").exists() is not bool(arguments)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no /dev/full")
def test_output_into_a_full_disk_is_one_line(tmp_path):
    with open("/dev/full", "w") as full:
        command = [sys.executable, "-c", LONG, tmp_path / "done"]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 1
    assert done.stderr == "error: standard output: No space left on device\n"


WAITING = """
import sys, time
from rna_sdk.commands.console import run_command
def command():
    try:
        print("runs", flush=True)
        time.sleep(60)
    finally:
        print("tidied", flush=True)
sys.exit(run_command(command, False, "the same command resumes"))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGTERM to handle")
@pytest.mark.parametrize(
    ("number", "background"),
    [(signal.SIGINT, False), (signal.SIGTERM, False), (signal.SIGTERM, True)],
)
def test_a_command_that_is_stopped_tidies(number, background):
    """In the background of a shell script, Ctrl-C is ignored."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN if background else signal.SIG_DFL)
    try:
        command = [sys.executable, "-c", WAITING]
        pipe = subprocess.PIPE
        process = subprocess.Popen(command, stdout=pipe, stderr=pipe, text=True)
    finally:
        signal.signal(signal.SIGINT, before)
    assert process.stdout is not None and process.stdout.readline() == "runs\n"
    process.send_signal(number)
    out, err = process.communicate(timeout=30)
    assert (out, err) == ("tidied\n", "stopped; the same command resumes\n")
    assert process.returncode == 130


DELETING = """
import sys, time
from rna_sdk.commands.console import run_command
class Bar:
    def __del__(self):
        print("runs", flush=True)
        time.sleep(60)
def command():
    Bar()
    time.sleep(60)
sys.exit(run_command(command, False, "the same command resumes"))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGTERM to handle")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_ctrl_c_in_a_destructor_stops_too(number):
    """Python ignores exceptions there."""
    process = subprocess.Popen(
        [sys.executable, "-c", DELETING], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdout is not None and process.stdout.readline() == "runs\n"
    process.send_signal(number)
    _, err = process.communicate(timeout=30)
    assert err == "stopped; the same command resumes\n" and process.returncode == 130
