"""Where points of an asset in motion are in the next frame."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rna_sdk.runtime import DeformedCurves
from rna_trace.asset_parts import Shape
from rna_trace.embree.tracing import ClosestHits
from rna_trace.surface import interpolate


@dataclass(frozen=True, eq=False)
class NextFrame:
    """shapes: of an asset's parts in this frame. positions: of each part in the next, (v, 3)."""

    shapes: Sequence[Shape]
    positions: Sequence[np.ndarray]

    def points(self, part: int, hits: ClosestHits, ray: np.ndarray, x: np.ndarray) -> np.ndarray:
        """Hits x of this frame on a part, in the next one: (m, 3) float32, object space.

        ray: (m,) which of the hits. Points on strands move with the middle line.
        """
        shape, moved = self.shapes[part], self.positions[part]
        primitive, u, v = hits.primitive[ray], hits.u[ray], hits.v[ray]
        if not isinstance(shape, DeformedCurves):
            return interpolate(moved, shape.mesh.triangles, primitive, u, v)
        first = shape.curves.segments()[primitive]
        way = _along(moved, first, u) - _along(shape.curves.points, first, u)
        return np.asarray(x + way, np.float32)


def _along(points: np.ndarray, first: np.ndarray, u: np.ndarray) -> np.ndarray:
    """Points at u of the segments that begin at `first`."""
    after = first + np.uint32(1)
    return np.asarray((1 - u)[:, None] * points[first] + u[:, None] * points[after])
