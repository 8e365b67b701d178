"""The motion of a package whose source Blender evaluates: actions, modifiers, Alembic, USD."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from types import TracebackType

import numpy as np

from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.geometry.followed_source import FollowedSource
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves, Mesh, SourceVertices


class BlenderMotion:
    """Positions of a package's parts at frames of its source; for a `with` statement.

    At its rest frame, at which it is opened, the source has to have the package's shape.

    Attributes:
        first, last: frames of the source's scene. rate: frames a second. by_number: whether the
            meshes are followed by the numbers of their vertices.

    Raises CaptureError where Blender cannot open the source, MotionError for another shape.
    """

    def __init__(
        self,
        python: Path,
        source: Source,
        folder: Path,
        geometries: Sequence[Mesh | Curves],
        package: str,
        numbers: Sequence[SourceVertices | None] = (),
    ) -> None:
        """package: its name, for errors. numbers: of each part, as for `bind`."""
        self._worker = BlenderWorker(python, source, folder, threads=1)
        self._geometries, self._numbers, self._package = geometries, numbers, package

    def __enter__(self) -> BlenderMotion:
        self._worker.__enter__()
        try:
            span = self._worker.frame_span()
            self.first, self.last, self.rate = span
            shown = self._worker, self._geometries, self._package, self._numbers
            self._source = FollowedSource(*shown)
            self.by_number = self._source.by_number
        except BaseException:
            self._worker.close()
            raise
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._worker.close()

    def frames(self, numbers: Sequence[int]) -> Iterator[list[np.ndarray]]:
        """The positions of each part, (v, 3) float32, at these frames in turn.

        Raises MotionError where the source changes its triangles or strands.
        """
        return map(self._source.positions, numbers)


def frame_numbers(asked: tuple[int, int] | None, motion: BlenderMotion) -> range:
    """The frames to write: those asked for, or all of the source's scene."""
    first, last = asked or (motion.first, motion.last)
    if last < first:
        raise CaptureError(f"the source has frames {first} to {last}: give --frames")
    return range(first, last + 1)
