"""Decoder inputs from the compiled kernel, for tests of it."""

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package import Bounds, Int8Planes, Planes, query_width
from rna_sdk.runtime.engine.tiles import Batch, QueryFiller
from tests.package.builders import make_tier_part
from tests.runtime.points import FiberPoints, Points

BOUNDS = Bounds(min=(-1.0, -2.0, 0.1), max=(0.5, 1.0, 0.9))
CORNERS = BOUNDS.corners()


def filled(
    planes: Planes, points: Points | FiberPoints, inputs: tuple[str, ...]
) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
    """`queries` and `valid` from the kernel, of an asset in BOUNDS."""
    texels = planes.texels if isinstance(planes, Int8Planes) else planes
    _, resolution, _, channels = texels.shape
    precision = str(texels.dtype)
    part = make_tier_part(
        resolution=resolution, channels=channels, plane_precision=precision, inputs=inputs
    )
    n = len(points.positions)
    if isinstance(points, FiberPoints):
        kind, part_arrays = "fiber", {"axis": points.tangents, "h": points.h}
    else:
        kind, part_arrays = "surface", {"axis": points.normals}
    arrays = {"position": points.positions, "wo": points.wo, "wi": points.wi, **part_arrays}
    batch = Batch.of(arrays, tuple(np.empty((2, n, 3), np.float32)))
    queries = np.full((n, query_width(inputs, channels)), np.nan, np.float32)
    valid = np.zeros(n, np.bool_)
    filler = QueryFiller(planes, BOUNDS, part, kind)
    filler.fill(batch, slice(0, n), queries, valid)
    return queries, valid
