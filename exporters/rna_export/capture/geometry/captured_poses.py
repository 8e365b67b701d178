"""The poses that a capture takes its rays in: the parts at other frames of the source."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.geometry.followed_source import FollowedSource
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves, Mesh, SourceVertices

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
    Raises CaptureError where nothing moves, MotionError where triangles or strands change.
    """
    if not frames:
        return
    name, rest_frame = worker.source.path.name, worker.opened["frame"]
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
