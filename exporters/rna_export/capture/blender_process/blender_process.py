"""A source, and a Blender process that has it open: start, JSON lines, stop, restart."""

import contextlib
import json
import os
import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from rna_export.capture.blender_process.exchanged_files import no_space_left
from rna_export.capture.capture_settings import CLAMP_DIRECT, CLAMP_INDIRECT, CaptureSettings
from rna_sdk.commands.gltf_remedies import with_remedy
from rna_sdk.errors import CaptureError
from rna_work.processor_time import process_seconds


@dataclass(frozen=True)
class Source:
    """The source model and its Cycles settings; enough to open a worker again."""

    path: Path
    arguments: tuple[str, ...] = ()
    clamp_direct: float = CLAMP_DIRECT
    clamp_indirect: float = CLAMP_INDIRECT
    front: str | None = None  # axes of the file; None: the usual ones of its kind
    up: str | None = None
    parts: str = "kinds"  # see CaptureSettings
    rest_frame: int | None = None  # that is shown; None for the one that the file opens with
    glass: str = "leave"  # smooth glass: see CaptureSettings
    least_roughness: float = 0.0  # of reflecting lobes: see CaptureSettings

    @classmethod
    def captured(
        cls, path: Path, arguments: tuple[str, ...], settings: CaptureSettings
    ) -> "Source":
        """The source as a capture of these settings opens it."""
        return cls(
            path,
            arguments,
            clamp_direct=settings.clamp_direct,
            clamp_indirect=settings.clamp_indirect,
            front=settings.front,
            up=settings.up,
            parts=settings.parts,
            rest_frame=settings.rest_frame,
            glass=settings.glass,
            least_roughness=settings.least_roughness,
        )


_LINES = 5  # of Blender's output, in an error
_LINE = 160  # characters of each
_WORKER = Path(__file__).parents[2] / "blender" / "worker.py"


@dataclass(frozen=True)
class ScenePart:
    """The objects of an opened source that become a part of the asset."""

    name: str
    kind: str  # "surface" or "fiber"
    owner: str | None  # the top object that it is; None: whatever is of the kind


class BlenderProcess:
    """Stock Blender in a process of its own, holding one opened source; for a `with` statement.

    Attributes:
        source: what is opened.
        opened: Blender's answer to that.
        parts: what the source consists of.

    Raises `CaptureError` when Blender cannot start, cannot load the source or fails at a request.
    """

    def __init__(self, python: Path, source: Source, folder: Path, threads: int, name: str):
        self._python, self.source, self._threads = python, source, threads
        self._folder, self._name = folder, name
        self._frame = source.rest_frame  # that the source shows; None for the one it opens with
        self._variant: str | None = None  # that it shows; None for its own materials
        self._process: subprocess.Popen[str] | None = None
        self._spent = 0.0  # processor time of processes that have ended, s

    def __enter__(self) -> Self:
        self._folder.mkdir(parents=True, exist_ok=True)
        self._start()
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _start(self) -> None:
        self._log = (self._folder / f"worker-{self._name}.log").open("w", encoding="utf-8")
        self._process = self._launch()
        try:
            self.opened = self._ask(
                op="open",
                source=str(self.source.path.resolve()),
                arguments=list(self.source.arguments),
                clampDirect=self.source.clamp_direct,
                clampIndirect=self.source.clamp_indirect,
                front=self.source.front,
                up=self.source.up,
                parts=self.source.parts,
                frame=self._frame,
                glass=self.source.glass,
                leastRoughness=self.source.least_roughness,
            )
            self._frame = self.opened["frame"]
            self.parts = tuple(ScenePart(**part) for part in self.opened["parts"])
            if self._variant is not None:
                self._ask(op="showVariant", name=self._variant)
        except BaseException:
            self.close()
            raise

    def _launch(self) -> subprocess.Popen[str]:
        """A process that has opened nothing yet; Blender's own files are in `folder`."""
        folder = str(self._folder.resolve())
        return subprocess.Popen(
            [str(self._python), str(_WORKER), str(self._threads), str(os.getpid())],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._log,
            env={**os.environ, "TMPDIR": folder, "BLENDER_USER_RESOURCES": folder},
            encoding="utf-8",
            errors="replace",  # Blender prints names of files as their bytes are
            process_group=0,  # Ctrl-C is for us; half a render would look like a whole one
        )

    def kill(self) -> None:
        """Kill the process, if it runs: calls from other threads then raise CaptureError."""
        if self._process is not None:
            self._process.kill()

    def processor_seconds(self) -> float | None:
        """Processor time of all its processes so far, s; None where the system does not tell."""
        process = self._process
        if process is None or process.poll() is not None:
            return self._spent
        now = process_seconds(process.pid)
        return None if now is None else self._spent + now

    def close(self) -> None:
        """End the process; safe to call twice."""
        process = self._running()
        if process.poll() is None:
            self._spent += process_seconds(process.pid) or 0.0
        self.kill()
        process.wait()
        for stream in (process.stdin, process.stdout, self._log):
            if stream is not None:
                with contextlib.suppress(OSError):  # a request that never reached it; a full disk
                    stream.close()

    def _running(self) -> subprocess.Popen[str]:
        assert self._process is not None  # since __enter__
        return self._process

    def restart(self) -> None:
        """A fresh process with the same source: Blender's memory grows over many renders."""
        self.close()
        self._start()

    def _ask(self, **request: Any) -> dict[str, Any]:
        process = self._running()
        assert process.stdin is not None and process.stdout is not None  # pipes
        try:
            process.stdin.write(json.dumps(request) + "\n")
            process.stdin.flush()
            for line in process.stdout:
                if line.startswith("RNA "):
                    answer: dict[str, Any] = json.loads(line[4:])
                    if not answer["ok"]:
                        said = with_remedy(answer["error"])
                        raise CaptureError(f"{self.source.path}: {said}")
                    return answer
                self._log.write(line)
        except OSError:  # of a pipe whose other end is gone, or of the log on a full disk
            pass
        if (why := no_space_left(self._folder)) is not None:
            raise CaptureError(f"{self._folder}: {why}")
        raise CaptureError(
            f"{self.source.path}: the Blender worker ended without an answer to "
            f"{request['op']!r}{_signal_of(process)}; its last output: {self._last_words()}"
        )

    def _last_words(self) -> str:
        self._log.flush()
        text = Path(self._log.name).read_text("utf-8", errors="replace")
        shown = "".join(c if c.isprintable() or c == "\n" else " " for c in text)
        lines = [" ".join(line.split())[:_LINE] for line in shown.split("\n") if line.strip()]
        return " / ".join(lines[-_LINES:]) or "none"

    @property
    def kind(self) -> str:
        """Kind of the opened source's parts: "surface", "fiber" or "both"."""
        kinds = {part.kind for part in self.parts}
        return kinds.pop() if len(kinds) == 1 else "both"

    def frame_span(self) -> tuple[int, int, float]:
        """First and last frame of the source's scene, and frames a second."""
        answer = self._ask(op="frameSpan")
        return answer["first"], answer["last"], answer["rate"]

    def show_variant(self, name: str | None) -> None:
        """Show another of the source's variants; None: its own materials."""
        if name != self._variant:
            self._variant = name
            self._ask(op="showVariant", name=name)

    def show_frame(self, frame: int) -> None:
        """Go to another frame of the source, for later exports and renders."""
        if frame != self._frame:
            self._frame = frame
            self._ask(op="showFrame", frame=frame)


def _signal_of(process: subprocess.Popen[str]) -> str:
    """The signal that ended it, in words: " by SIGSEGV"; "" if it ended itself, or goes on."""
    with contextlib.suppress(subprocess.TimeoutExpired, ValueError):
        status = process.wait(10.0)
        return f" by {signal.Signals(-status).name}" if status < 0 else ""
    return ""
