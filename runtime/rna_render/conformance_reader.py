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
    from rna_render.fiber import FiberPoints
    from rna_render.parts_scene import PartsScene
    from rna_render.surface import SurfacePoints

    words = np.frombuffer(records, "<u4").reshape(-1, 8)
    numbers, primitive = words.view("<f4").astype(np.float32), words[:, 0].astype(np.int32)
    with Package.open(package) as opened:
        geometry = opened.geometry()
    scene = PartsScene([geometry])
    if isinstance(geometry, Mesh):
        b1, b2 = np.ascontiguousarray(numbers[:, 1:3].T)
        points = SurfacePoints.of(geometry, primitive, b1, b2)
        return scene.visible(0, points, np.ascontiguousarray(numbers[:, 3:6]))
    x, wi = (np.ascontiguousarray(numbers[:, k : k + 3]) for k in (1, 4))
    no_use = np.zeros_like(x)
    return scene.visible(0, FiberPoints(x, no_use, no_use, primitive), wi)


if __name__ == "__main__":
    sys.exit(run_reader(evaluate=evaluate, visibility=visibility, validate=check))
