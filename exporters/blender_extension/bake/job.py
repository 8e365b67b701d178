"""A bake: a process that outlives Blender, and the folder with its progress."""

import json
import os
import re
import shlex
import shutil
import signal
from dataclasses import dataclass
from pathlib import Path

from ..sdk import SdkError
from ..sdk_command import SIDE, Command, failure, log_lines
from .options import lasting
from .seal import is_sealed, seal_of

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

    folder: for its rays, trainings, log and pictures. A job that this user began there goes on; in
    any other folder with files none begins.
    """

    def __init__(self, folder):
        self.folder = Path(folder)
        self.sheet = self.folder / "compare" / "sheet.png"
        names = "log", "pid", "job.json", "made"
        self._log, self._pid, self._settings, self._made = (self.folder / n for n in names)

    def is_begun(self):
        return self._stored() is not None

    def check_free(self):
        """Raises SdkError if the folder has files that no bake of this user's wrote."""
        if self.folder.is_symlink() or (self.folder.exists() and not self.folder.is_dir()):
            raise SdkError(f"{self.folder}: expected a folder, or none")
        if self.folder.is_dir() and not self.is_begun():
            result = sorted(path.name for path in self.folder.iterdir())[:3]
            if result:
                raise SdkError(
                    f"{self.folder}: found {', '.join(result)}, not written by a bake of yours "
                    "here; move the folder away, or name another package"
                )

    def begin(self, out, options, source, name):
        """Store the job's package and options, as its own; its file `source` exists already.

        name: of the asset.
        """
        named = {"source": source.name, "name": name}
        self._store({"out": str(out), "options": options, **named, "more": 0.0})

    def begin_more(self, minutes, out, options):
        """Store that a finished job goes on for `minutes`.

        Raises SdkError if it was begun for something else, is not finished or has no rays any more.
        """
        self._check_same(out, options, is_more=True)
        if not self._made.is_file():
            raise SdkError("the bake is not finished: Continue, then go on for more minutes")
        if not all((self.folder / name).is_file() for name in _RAYS):
            raise SdkError(
                f"{self.folder / 'make'}: found no rays to continue with, expected rays of the "
                "bake; Bake Anew captures them again"
            )
        self._store({**self._stored(), "more": minutes})
        self._made.unlink()
        with self._log.open("a") as log:  # its last line no longer says that all is finished
            log.write(f"going on for {minutes:g} minutes\n")

    def _store(self, settings):
        temporary = self._settings.with_suffix(".part")
        seal = seal_of(self._sealed(settings))
        temporary.write_text(json.dumps({**settings, "seal": seal}, indent=1))
        temporary.replace(self._settings)

    def check_same(self, out, options):
        """Raises SdkError if the job was begun for something else."""
        self._check_same(out, options, is_more=self._stored()["more"] > 0.0)

    def _check_same(self, out, options, is_more):
        """is_more: whether lengths may differ, since more minutes have their own."""
        stored = self._stored()
        both = stored["options"], options
        begun_options, now_options = map(lasting, both) if is_more else both
        for what, begun, now in (
            ("the package", stored["out"], str(out)),
            ("options", shlex.join(begun_options), shlex.join(now_options)),
        ):
            if begun != now:
                raise SdkError(
                    f"the bake was begun with {what} {begun}, found {now}: set that back, or Bake "
                    "Anew"
                )

    @property
    def out(self):
        """The package."""
        return Path(self._stored()["out"])

    @property
    def source(self):
        """The .blend file with the objects, whose name the package records."""
        return self.folder / self._stored()["source"]

    def source_of(self, filepath):
        """Place for the objects of a .blend file, by its name; the text is empty if unsaved."""
        return self.folder / (f"{Path(filepath).stem}.blend" if filepath else "untitled.blend")

    def start(self):
        """Start, or continue. Raises SdkError without an environment of the SDK."""
        stored = self._stored()
        options = stored["options"]
        if stored["more"]:
            options = [*lasting(options), f"--more={stored['more']:g}"]
        named = f"--name={stored['name']}"
        script = [SIDE / "bake.py", self.source, self.out, self.folder, named, *options]
        command = Command(script, self._log, survives=True)
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
        if not self.is_begun() or not self._pid.is_file():
            return False
        return _is_bake(int(self._pid.read_text()), self.folder)

    def remove(self):
        """Delete the job's files, if it is this user's; the package and all other files stay."""
        if not self.is_begun():
            return
        source = self.source
        for name in _FOLDERS:
            shutil.rmtree(self.folder / name, ignore_errors=True)
        for path in (source, self._log, self._pid, self._made, self._settings):
            path.unlink(missing_ok=True)
        if not any(self.folder.iterdir()):
            self.folder.rmdir()

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

    def _stored(self):
        """The record that `begin` stored; None if there is no job, or one of others."""
        try:
            record = json.loads(self._settings.read_text())
            settings = {
                "out": str(record["out"]),
                "options": [str(one) for one in record["options"]],
                "source": Path(record["source"]).name,
                "name": str(record["name"]),
                "more": float(record["more"]),
            }
            return settings if is_sealed(self._sealed(settings), record["seal"]) else None
        except (OSError, ValueError, KeyError, TypeError, RecursionError):
            return None

    def _sealed(self, settings):
        """Sealed text: with the folder, so that a copy elsewhere is no job."""
        return json.dumps([self._key(), settings])

    def _key(self):
        return str(self.folder.resolve())


_FOLDERS = ("make", "compare")
"""Written by rna-make and rna-compare."""
_RAYS = ("make/make.json", "make/rays/manifest.json")
"""The state from which more minutes continue."""
_started = {}
"""Processes of this Blender by their job's folder."""


def _running(lines):
    bar = _BAR.match(lines[-1]) if lines else None
    if bar:
        return Status("running", int(bar[2]) / 100.0, bar[1])
    return Status("running", 0.0, lines[-1] if lines else "starting")


def _is_bake(pid, folder):
    """Whether the process is there and is this bake, not another one with its old number."""
    try:
        arguments = Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")
        return str(SIDE / "bake.py").encode() in arguments and str(folder).encode() in arguments
    except OSError:
        return False
