"""Blender workers for the tests of the exporters, and quick exports."""

import subprocess
from collections.abc import Callable
from contextlib import ExitStack, suppress
from itertools import count
from pathlib import Path
from typing import Any, ClassVar

import pytest

from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_sdk.errors import CaptureError
from tests.exporters.scenes import write_scene
from tests.exporters.synthetic import make_dataset

OpenWorker = Callable[..., BlenderWorker]
SaveBlend = Callable[..., Path]


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    """The ball of `synthetic`."""
    return make_dataset(tmp_path_factory.mktemp("data") / "ball.rays")


@pytest.fixture(scope="module", autouse=True)
def quick_exports():
    """Posters of one sample, costs of few queries: most of an export's time, unseen by tests."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("rna_export.export.poster_rendering._SAMPLES", 1)
        patch.setattr("rna_export.export.measure._COST_ROWS", 2_000)
        yield


class LentWorker(BlenderWorker):
    """A worker that leaves its process to the next one, whose source replaces its own.

    Blender's start takes longer than most sources. A process that has rendered is not left: Cycles
    keeps its tables of sample points.
    """

    _idle: ClassVar[list[subprocess.Popen[str]]] = []
    has_rendered = _has_left = False

    def _launch(self) -> subprocess.Popen[str]:
        return self._idle.pop() if self._idle else super()._launch()

    def _ask(self, **request: Any) -> dict[str, Any]:
        self.has_rendered = self.has_rendered or request["op"].startswith("render")
        try:
            return super()._ask(**request)
        except CaptureError as error:
            if "ended without an answer" in str(error):
                self._running().wait(60)  # so that `close` sees it
            raise

    def close(self) -> None:
        process = self._running()
        if self._has_left:
            return
        if self._idle or self.has_rendered or process.poll() is not None:
            super().close()
        else:
            self._log.close()
            self._idle.append(process)
            self._has_left = True

    @classmethod
    def end_idle(cls) -> None:
        while cls._idle:
            process = cls._idle.pop()
            process.kill()
            process.communicate()


@pytest.fixture(scope="session")
def lent_workers():
    """Ends the process that is left in the end."""
    yield
    LentWorker.end_idle()


@pytest.fixture
def open_worker(blender_python, tmp_path, lent_workers):
    """Opens a worker on a file, or on the text of a script; closes it after the test."""
    opened = count()

    def open_(scene: Path | str, *arguments: str, **how: Any) -> BlenderWorker:
        """how: of `Source`."""
        name = f"scene{next(opened)}"
        path = write_scene(tmp_path, name, scene) if isinstance(scene, str) else scene
        source = Source(path, arguments, **how)
        worker = LentWorker(blender_python, source, tmp_path / "scratch", 1, name)
        return workers.enter_context(worker)

    with ExitStack() as workers:
        yield open_


@pytest.fixture
def save_blend(open_worker):
    """Makes a .blend file of the text of a script, which begins with an empty file of that name.

    renders: whether the script does so itself.
    """

    def save(path: Path, body: str, renders: bool = False) -> Path:
        start = "bpy.ops.wm.read_factory_settings(use_empty=True)\n"
        save_it = f"\nbpy.ops.wm.save_as_mainfile(filepath={str(path)!r})\n"
        path.parent.mkdir(exist_ok=True)
        with suppress(CaptureError):  # it need not be a source
            worker = open_worker(start + save_it + body + save_it)
            worker.has_rendered = renders
            worker.close()
        assert path.is_file()
        return path

    return save
