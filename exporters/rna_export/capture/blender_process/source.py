"""What a Blender process opens."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from rna_export.capture.capture_settings import CLAMP_DIRECT, CLAMP_INDIRECT, CaptureSettings


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

    @classmethod
    def captured(cls, path: Path, arguments: tuple[str, ...], settings: CaptureSettings) -> Source:
        """The source as a capture of these settings opens it."""
        clamps = settings.clamp_direct, settings.clamp_indirect
        axes = settings.front, settings.up
        return cls(path, arguments, *clamps, *axes, settings.parts, settings.rest_frame)
