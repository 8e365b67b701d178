"""The vertices of a package at other frames of its source, and the poses of a capture."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_sdk.errors import CaptureError, MotionError
from rna_sdk.motion import Binding, bind
from rna_sdk.package import Curves, Mesh, SourceVertices

_SAME = 1e-3
"""How far points of strands may be from the package's at rest, as a share of its diagonal."""


class FollowedSource:
    """Positions of a package's parts, as the source shows them.

    Meshes and strands that the source moves itself follow it; other strands follow the mesh at
    their root.

    worker: an opened source, which shows its rest frame. geometries: of the parts, in order.
    package: its name, for errors. numbers: of each part, as for `bind`; none if left out.

    Attributes:
        by_number: whether the package's numbers of vertices are followed.

    Raises MotionError where the source has not this shape.
    """

    def __init__(
        self,
        worker: BlenderWorker,
        geometries: Sequence[Mesh | Curves],
        package: str,
        numbers: Sequence[SourceVertices | None] = (),
    ) -> None:
        self._worker, self._name = worker, worker.source.path.name
        self._owners: list[str | None] = [None] * len(geometries)
        kinds = ["fiber" if isinstance(g, Curves) else "surface" for g in geometries]
        if [part.kind for part in worker.parts] == kinds:
            self._owners = [part.owner for part in worker.parts]
        mesh, triangles = self._mesh()
        self._vertices = len(mesh)
        known = numbers or [None] * len(geometries)
        self._bindings: list[Binding | None] = []
        self._points: list[int] = []
        for geometry, owner, indices in zip(geometries, self._owners, known, strict=True):
            is_same = isinstance(geometry, Curves) and _same_strands(geometry, self._strands(owner))
            self._points.append(len(geometry.points) if isinstance(geometry, Curves) else 0)
            if is_same:
                self._bindings.append(None)
                continue
            if not len(mesh):
                what = "strands" if isinstance(geometry, Curves) else "mesh"
                raise MotionError(f"{self._name} has not the {what} of {package}")
            self._bindings += bind([geometry], mesh, triangles, (self._name, package), [indices])
        self.by_number = any(b is not None and b.by_number for b in self._bindings)

    def positions(self, frame: int) -> list[np.ndarray]:
        """The positions of each part, (v, 3) float32, at a frame, which the source shows then.

        Raises MotionError where the source changes its triangles or strands.
        """
        self._worker.show_frame(frame)
        where = f"{self._name}: frame {frame}"
        mesh = None
        if any(b is not None for b in self._bindings):
            mesh, _ = self._mesh()
            if len(mesh) != self._vertices:
                found = f"has {len(mesh)} vertices, expected {self._vertices} as at rest"
                raise MotionError(f"{where}: {found}")
        return [self._part(where, k, mesh) for k in range(len(self._bindings))]

    def _part(self, where: str, part: int, mesh: np.ndarray | None) -> np.ndarray:
        binding = self._bindings[part]
        if binding is not None:
            assert mesh is not None
            return binding.positions(mesh)
        strands, expected = self._strands(self._owners[part]), self._points[part]
        count = 0 if strands is None else len(strands.points)
        if strands is None or count != expected:
            found = f"has {count} points of strands"
            raise MotionError(f"{where}: {found}, expected {expected} as at rest")
        return strands.points

    def _mesh(self) -> tuple[np.ndarray, np.ndarray]:
        """Vertices of the source, (v, 3) float32, 0 for those of no triangle, and triangles."""
        if not any(part.kind == "surface" for part in self._worker.parts):
            return np.zeros((0, 3), np.float32), np.zeros((0, 3), np.int64)
        corners = self._worker.export_corners()
        positions = np.zeros((int(corners["vertices"]), 3), np.float32)
        positions[corners["vertex"]] = corners["positions"]
        return positions, corners["vertex"].reshape(-1, 3).astype(np.int64)

    def _strands(self, owner: str | None) -> Curves | None:
        if not any(part.kind == "fiber" for part in self._worker.parts):
            return None
        return self._worker.export_curves(owner)


def _same_strands(geometry: Curves, strands: Curves | None) -> bool:
    """Whether a source's strands are a part's, point by point."""
    if strands is None or not np.array_equal(strands.offsets, geometry.offsets):
        return False
    away = np.linalg.norm(strands.points - geometry.points, axis=1).max()
    size = np.linalg.norm(np.ptp(geometry.points, axis=0))
    return bool(away <= _SAME * size)


_STILL = 1e-4
"""Share of the diagonal by which something has to move, or a pose is no other one."""


def captured_poses(
    worker: BlenderWorker,
    geometries: Mapping[str, Mesh | Curves],
    sources: Mapping[str, SourceVertices],
    frames: Sequence[int],
) -> Iterator[tuple[int, dict[str, np.ndarray]]]:
    """Each frame, and the positions of each part, (v, 3) float32.

    worker: an opened source, which shows its rest frame. geometries: of its parts, there.
    sources: numbers of their vertices, where they are known. frames: without the rest frame.
    Raises CaptureError where nothing moves or a material changes, MotionError where triangles or
    strands change.
    """
    if not frames:
        return
    name, rest_frame = worker.source.path.name, worker.opened["frame"]
    for what in worker.opened["changing"][:1]:
        raise CaptureError(
            f"{name}: {what}, and a model has one look in all its poses: use a still image and a "
            "material without keyframes, or no --poses"
        )
    numbers = [sources.get(part) for part in geometries]
    source = FollowedSource(worker, list(geometries.values()), "its own rest frame", numbers)
    rest = [g.points if isinstance(g, Curves) else g.positions for g in geometries.values()]
    size = float(np.linalg.norm(np.ptp(np.concatenate(rest), axis=0)))
    for frame in frames:
        positions = source.positions(frame)
        pairs = zip(rest, positions, strict=True)
        if max(float(np.abs(after - before).max()) for before, after in pairs) < _STILL * size:
            raise CaptureError(
                f"{name}: frame {frame} is as the rest frame, {rest_frame}: nothing moves"
            )
        yield frame, dict(zip(geometries, positions, strict=True))
