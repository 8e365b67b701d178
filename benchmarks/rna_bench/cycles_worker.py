"""Cycles with an original open, as all comparisons start it."""

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from rna_export.capture.blender_process import blender_env
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_sdk.errors import CaptureError
from rna_sdk.machine.cores import core_count


@contextmanager
def cycles(source: Path, arguments: tuple[str, ...] = ()) -> Iterator[BlenderWorker]:
    """A worker with the source open, on all cores; arguments: of a source that is a script.

    Raises CaptureError where there is no such file, no Blender, or it cannot open the source.
    """
    if not source.is_file():
        raise CaptureError(f"{source}: no such file")
    python, opened = blender_env.find_python(), Source(source, arguments)
    with (
        tempfile.TemporaryDirectory(prefix="rna-bench-") as scratch,
        BlenderWorker(python, opened, Path(scratch), core_count()) as worker,
    ):
        yield worker
