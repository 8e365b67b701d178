"""Queries of lobes in the kit: rows of a file (spec/conformance/README.md)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Rows = NDArray[np.float32]

COLUMNS = 14
COMMAND = "environment"
"""The word of the protocol that requests lobes; also the level's name."""


@dataclass(frozen=True)
class LobeQueries:
    """n queries.

    Attributes:
        position, axis, wo: (n, 3) float32; axis: normals or tangents.
        h: (n,) float32.
        free: (n,) float32, visibility along the mirror direction.
        primitive: (n,) int64, triangles or segments.
        u, v: (n,) float32, barycentric coordinates there.
    """

    position: Rows
    axis: Rows
    h: Rows
    wo: Rows
    free: Rows
    primitive: NDArray[np.int64]
    u: Rows
    v: Rows

    @classmethod
    def of(cls, rows: Rows) -> "LobeQueries":
        """rows: (n, COLUMNS) float32."""
        column = np.ascontiguousarray(rows.T)
        position, axis, wo = (np.ascontiguousarray(rows[:, k : k + 3]) for k in (0, 3, 7))
        primitive = column[11].astype(np.int64)
        return cls(position, axis, column[6], wo, column[10], primitive, column[12], column[13])

    def arguments(self, kind: str) -> tuple[Rows, ...]:
        """Arguments of `lobes` for a part of this kind, except the visibility of vertices."""
        across = (self.h,) if kind == "fiber" else ()
        return self.position, self.axis, *across, self.wo, self.free


def answer_of(amplitudes: NDArray[np.floating], axes: NDArray[np.floating]) -> Rows:
    """(n, 6 L) float32 of amplitudes and axes, (n, L, 3) each."""
    both = np.concatenate([amplitudes, axes], axis=2)
    return both.reshape(len(both), -1).astype(np.float32)
