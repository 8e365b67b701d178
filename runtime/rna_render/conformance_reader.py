"""The SDK and this renderer as a reader program, with all levels: evaluation, rays, checks.

rna-conform -- python -m rna_render.conformance_reader
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import numpy as np

from rna_sdk.conformance.reader import base_color, check, deformed, environment, evaluate, geometry
from rna_sdk.conformance.reader_program import run_reader
from rna_sdk.package import Curves, Mesh, Package

if TYPE_CHECKING:
    from rna_trace.fiber import FiberPoints
    from rna_trace.surface import SurfacePoints


def visibility(package: str, records: bytes) -> np.ndarray:
    """(n, 3) float32: the visibility, RGB, of the rays of n hits."""
    # Here, since two hundred runs only check a package.
    from rna_trace.asset_parts import mesh_transmittance
    from rna_trace.parts_scene import PartsScene

    words = np.frombuffer(records, "<u4").reshape(-1, 8)
    with Package.open(package) as opened:
        count = len(opened.manifest.parts)
        geometries = [opened.geometry(part) for part in range(count)]
        transmittance = [
            mesh_transmittance(shape, opened.transmittance(part))
            for part, shape in enumerate(geometries)
        ]
    scene = PartsScene(geometries, transmittance)
    seen = np.empty((len(words), 3), np.float32)
    for part, shape in enumerate(geometries):
        rows = np.flatnonzero(words[:, 7] == part)
        points, wi = _points(shape, words[rows])
        result = scene.visible(part, points, wi)
        seen[rows] = result if result.ndim == 2 else result[:, None]
    return seen


def normals(package: str, records: bytes) -> np.ndarray:
    """Shading normals of queries at n hits on meshes, (n, 3) float32."""
    from rna_trace.normal_maps import NormalMaps
    from rna_trace.surface import SurfacePoints

    words = np.frombuffer(records, "<u4").reshape(-1, 8)
    b = np.ascontiguousarray(words.view("<f4")[:, 1:3].T.astype(np.float32))
    result = np.empty((len(words), 3), np.float32)
    with Package.open(package) as opened:
        for part in np.unique(words[:, 7]).tolist():
            mesh, textures = opened.mesh(part), opened.normal_maps(part)
            rows = np.flatnonzero(words[:, 7] == part)
            maps = NormalMaps(mesh, textures) if textures else None
            b1, b2 = np.ascontiguousarray(b[:, rows])
            triangle = words[rows, 0].astype(np.int32)
            result[rows] = SurfacePoints.of(mesh, triangle, b1, b2, maps).mapped
    return result


def _points(
    shape: Mesh | Curves, words: np.ndarray
) -> tuple[SurfacePoints | FiberPoints, np.ndarray]:
    """The points of hit records on one part, and their directions."""
    from rna_trace.fiber import FiberPoints
    from rna_trace.surface import SurfacePoints

    numbers, primitive = words.view("<f4").astype(np.float32), words[:, 0].astype(np.int32)
    if isinstance(shape, Mesh):
        b1, b2 = np.ascontiguousarray(numbers[:, 1:3].T)
        points = SurfacePoints.of(shape, primitive, b1, b2)
        return points, np.ascontiguousarray(numbers[:, 3:6])
    x, wi = (np.ascontiguousarray(numbers[:, k : k + 3]) for k in (1, 4))
    no_use = np.zeros_like(x)
    return FiberPoints(x, no_use, no_use, primitive), wi


if __name__ == "__main__":
    sys.exit(
        run_reader(
            evaluate=evaluate,
            environment=environment,
            nearby=evaluate,
            visibility=visibility,
            normals=normals,
            base_color=base_color,
            geometry=geometry,
            deformed=deformed,
            validate=check,
        )
    )
