"""The SDK and this renderer as a reader program, with all levels: evaluation, rays, checks.

rna-conform -- python -m rna_render.conformance_reader
"""

from __future__ import annotations

import sys

import numpy as np

from rna_sdk.conformance.reader import check, evaluate
from rna_sdk.conformance.reader_program import run_reader
from rna_sdk.package import Mesh, Package


def visibility(package: str, records: bytes) -> np.ndarray:
    """(n,) bool: whether the asset leaves the rays of n hits free."""
    # Here, since two hundred runs only check a package.
    from rna_render import fiber, surface
    from rna_render.embree import CurveScene, TriangleScene

    words = np.frombuffer(records, "<u4").reshape(-1, 8)
    numbers, primitive = words.view("<f4").astype(np.float32), words[:, 0].astype(np.int32)
    with Package.open(package) as opened:
        geometry = opened.geometry()
    if isinstance(geometry, Mesh):
        scene = TriangleScene([(geometry.positions, geometry.triangles)])
        b1, b2 = np.ascontiguousarray(numbers[:, 1:3].T)
        points = surface.SurfacePoints.of(geometry, primitive, b1, b2)
        return surface.visible(scene, points, np.ascontiguousarray(numbers[:, 3:6]))
    curves = CurveScene(geometry.points, geometry.radii, geometry.offsets)
    x, wi = (np.ascontiguousarray(numbers[:, k : k + 3]) for k in (1, 4))
    return fiber.visible(curves, x, primitive, wi)


if __name__ == "__main__":
    sys.exit(run_reader(evaluate=evaluate, visibility=visibility, validate=check))
