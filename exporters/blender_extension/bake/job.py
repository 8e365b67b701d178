"""A bake: a process that outlives Blender, and the folder that tells how far it is."""

import json
import os
import re
import shutil
import signal
from dataclasses import dataclass
from pathlib import Path

from ..sdk_command import SIDE, Command, failure, log_lines

_BAR = re.compile(r"(.*?):\s+(\d+)%\|")
_END = "bake finished"


@dataclass(frozen=True)
class Status:
    """state: "none", "running", "stopped", "failed" or "finished". share: of the whole, 0 to 1.

    text: what is being done, or what went wrong.
    """

    state: str
    share: float = 0.0
    text: str = ""


class Job:
    """One bake.

    folder: for its rays, trainings, log and pictures; a job that is there already goes on.
    """

    def __init__(self, folder):
        self.folder = Path(folder)
        self.source = self.folder / "source.blend"
        self.sheet = self.folder / "compare" / "sheet.png"
        self._log, self._pid, self._order = (self.folder / n for n in ("log", "pid", "job.json"))

    def is_begun(self):
        return self._order.is_file()

    def begin(self, out, options):
        """Store the job's options for rna-make; `source` exists already."""
        order = {"source": str(self.source), "out": str(out), "folder": str(self.folder)}
        self._order.write_text(json.dumps({**order, "options": options}, indent=1))

    @property
    def out(self):
        """The package."""
        return Path(json.loads(self._order.read_text())["out"])

    def start(self):
        """Start, or continue. Raises SdkError without an environment of the SDK."""
        command = Command([SIDE / "bake.py", self._order], self._log, survives=True)
        self._pid.write_text(str(command.process.pid))
        _started[self._key()] = command

    def stop(self):
        """Interrupts the job, as Ctrl-C does; finished work is kept."""
        if self.is_running():
            os.killpg(int(self._pid.read_text()), signal.SIGINT)

    def wait(self):
        """Until it ends, if it was started from here."""
        if self._key() in _started:
            _started[self._key()].wait()

    def is_running(self):
        if self._key() in _started:
            return _started[self._key()].is_running()
        return self._pid.is_file() and _is_bake(int(self._pid.read_text()))

    def remove(self):
        """Forget it; the package stays."""
        shutil.rmtree(self.folder, ignore_errors=True)

    def status(self):
        if not self.is_begun():
            return Status("none")
        lines = log_lines(self._log) if self._log.is_file() else []
        if self.is_running():
            return _running(lines)
        if lines and lines[-1] == _END:
            return Status("finished", 1.0, f"wrote {self.out}")
        stopped = not lines or lines[-1].startswith("stopped") or _BAR.match(lines[-1])
        return Status("stopped") if stopped else Status("failed", 0.0, failure(lines, 1))

    def lines(self, count):
        """The last ones of the log."""
        return log_lines(self._log)[-count:] if self._log.is_file() else []

    def _key(self):
        return str(self.folder.resolve())


_started = {}
"""Processes of this Blender by their job's folder."""


def _running(lines):
    bar = _BAR.match(lines[-1]) if lines else None
    if bar:
        return Status("running", int(bar[2]) / 100.0, bar[1])
    return Status("running", 0.0, lines[-1] if lines else "starting")


def _is_bake(pid):
    """Whether the process is there and is a bake, not another one with its old number."""
    try:
        return b"bake.py" in Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return False
