"""The motion of a package whose source Blender evaluates: actions, modifiers, Alembic, USD."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from types import TracebackType

import numpy as np

from rna_export.capture.blender_process.blender_worker import BlenderWorker, Source
from rna_sdk.errors import CaptureError, MotionError
from rna_sdk.motion import Binding, bind
from rna_sdk.package import Curves, Mesh

_SAME = 1e-3
"""How far points of strands may be from the package's at rest, as a share of its diagonal."""


class BlenderMotion:
    """Positions of a package's parts at frames of its source; for a `with` statement.

    As Blender shows the source when it has been opened, it has to have the package's shape. Meshes
    and strands that the source moves itself follow it; other strands follow the mesh at their root.

    Attributes:
        first, last: frames of the source's scene. rate: frames a second.

    Raises CaptureError where Blender cannot open the source, MotionError for another shape.
    """

    def __init__(
        self,
        python: Path,
        source: Source,
        folder: Path,
        geometries: Sequence[Mesh | Curves],
        package: str,
    ) -> None:
        self._worker = BlenderWorker(python, source, folder, threads=1)
        self._geometries, self._names = geometries, (source.path.name, package)

    def __enter__(self) -> BlenderMotion:
        self._worker.__enter__()
        try:
            span = self._worker.frame_span()
            self.first, self.last, self.rate = span
            self._bind()
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
        for number in numbers:
            self._worker.show_frame(number)
            mesh = self._mesh()
            strands = self._strands() if self._points else None
            where = f"{self._names[0]}: frame {number}"
            if mesh is not None and len(mesh) != self._corners:
                found = f"has {len(mesh) // 3} triangles, expected {self._corners // 3} as at rest"
                raise MotionError(f"{where}: {found}")
            if self._points and (strands is None or len(strands.points) != self._points):
                found = f"has {0 if strands is None else len(strands.points)} points of strands"
                raise MotionError(f"{where}: {found}, expected {self._points} as at rest")
            yield [self._part(binding, mesh, strands) for binding in self._bindings]

    def _bind(self) -> None:
        mesh, strands = self._mesh(), self._strands()
        self._corners = 0 if mesh is None else len(mesh)
        self._bindings: list[Binding | None] = []
        for geometry in self._geometries:
            if isinstance(geometry, Curves) and _same_strands(geometry, strands):
                self._bindings.append(None)
                continue
            if mesh is None:
                what = "strands" if isinstance(geometry, Curves) else "mesh"
                raise MotionError(f"{self._names[0]} has not the {what} of {self._names[1]}")
            triangles = np.arange(len(mesh)).reshape(-1, 3)
            self._bindings += bind([geometry], mesh, triangles, self._names)
        follows = strands is not None and None in self._bindings
        self._points = len(strands.points) if strands is not None and follows else 0

    def _part(
        self, binding: Binding | None, mesh: np.ndarray | None, strands: Curves | None
    ) -> np.ndarray:
        if binding is None:
            assert strands is not None
            return strands.points
        assert mesh is not None
        return binding.positions(mesh)

    def _mesh(self) -> np.ndarray | None:
        """Corners of all triangles, (3t, 3) float32; None where there are none."""
        if not any(part.kind == "surface" for part in self._worker.parts):
            return None
        return self._worker.export_corners()["positions"]

    def _strands(self) -> Curves | None:
        if not any(part.kind == "fiber" for part in self._worker.parts):
            return None
        return self._worker.export_curves()


def _same_strands(geometry: Curves, strands: Curves | None) -> bool:
    """Whether a source's strands are a part's, point by point."""
    if strands is None or not np.array_equal(strands.offsets, geometry.offsets):
        return False
    away = np.linalg.norm(strands.points - geometry.points, axis=1).max()
    size = np.linalg.norm(np.ptp(geometry.points, axis=0))
    return bool(away <= _SAME * size)


def frame_numbers(asked: tuple[int, int] | None, motion: BlenderMotion) -> range:
    """The frames to write: those asked for, or all of the source's scene."""
    first, last = asked or (motion.first, motion.last)
    if last < first:
        raise CaptureError(f"the source has frames {first} to {last}: give --frames")
    return range(first, last + 1)
