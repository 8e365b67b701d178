"""Commands of the SDK as separate processes, whose output goes to a log."""

import os
import re
import signal
import subprocess
from pathlib import Path

from .sdk import SdkError, find_python

SIDE = Path(__file__).parent / "sdk_side"


class Command:
    """A running command.

    arguments: of the SDK's Python, or of `python`. log: the file for what it says; added to.
    survives: whether it goes on when Blender ends.
    """

    def __init__(self, arguments, log, survives=False, python=None):
        self._log, self._from = Path(log), Path(log).stat().st_size if Path(log).exists() else 0
        environment = {k: v for k, v in os.environ.items() if k != "PYTHONHOME"}
        with open(log, "ab") as file:
            self.process = subprocess.Popen(
                [str(python or find_python()), *map(str, arguments)],
                stdin=subprocess.DEVNULL,
                stdout=file,
                stderr=subprocess.STDOUT,
                env={**environment, "PYTHONUNBUFFERED": "1"},
                start_new_session=survives,
            )

    def is_running(self):
        return self.process.poll() is None

    def wait(self, timeout=None):
        self.process.wait(timeout)

    def interrupt(self):
        """Ask it to stop, as Ctrl-C does."""
        if self.is_running():
            self.process.send_signal(signal.SIGINT)

    def end(self, timeout):
        """Interrupt it; kill it if it is still there after `timeout` seconds."""
        self.interrupt()
        try:
            self.process.wait(timeout)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()

    def lines(self):
        """All it has said, without progress bars that were drawn over."""
        return log_lines(self._log, self._from)

    def check(self):
        """Raises SdkError with the command's output if it has failed."""
        if self.process.returncode:
            raise SdkError(failure(self.lines(), self.process.returncode))


def run(arguments, log):
    """Run a command to its end. Raises SdkError if it fails."""
    command = Command(arguments, log)
    command.wait()
    command.check()


def log_lines(path, start=0):
    """Lines of a log from a byte offset; of overdrawn lines the last state."""
    with open(path, "rb") as file:
        file.seek(start)
        text = file.read().decode("utf-8", "replace")
    return [line.rpartition("\r")[2].rstrip() for line in re.split(r"\r?\n", text) if line.strip()]


def failure(lines, status):
    """The line of a log with the reason why a command failed."""
    errors = [line for line in lines if line.startswith("error: ")]
    last = errors[-1].removeprefix("error: ") if errors else (lines or ["it said nothing"])[-1]
    return last if errors else f"the command ended with status {status}: {last}"
