"""Blender workers for the tests of the exporters."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from itertools import count
from pathlib import Path

import pytest

from rna_export.capture.blender_process.blender_worker import BlenderWorker, Source
from tests.exporters.scenes import write_scene

OpenWorker = Callable[..., BlenderWorker]


@pytest.fixture
def open_worker(blender_python: Path, tmp_path: Path) -> Iterator[OpenWorker]:
    """Opens a worker on a file, or on the text of a script; ends it after the test."""
    opened = count()

    def open_(
        scene: Path | str,
        *arguments: str,
        front: str | None = None,
        up: str | None = None,
        parts: str = "kinds",
        rest_frame: int | None = None,
    ) -> BlenderWorker:
        name = f"scene{next(opened)}"
        path = write_scene(tmp_path, name, scene) if isinstance(scene, str) else scene
        how = {"front": front, "up": up, "parts": parts, "rest_frame": rest_frame}
        source = Source(path, arguments, **how)
        worker = BlenderWorker(blender_python, source, tmp_path / "scratch", 1, name)
        return workers.enter_context(worker)

    with ExitStack() as workers:
        yield open_
