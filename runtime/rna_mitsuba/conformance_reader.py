"""Evaluation, rays, normals and base colours of this renderer as a reader program.

rna-conform -- python -m rna_mitsuba.conformance_reader
"""

import sys

import drjit as dr
import mitsuba as mi
import numpy as np

if mi.variant() is None:
    mi.set_variant("llvm_ad_rgb")

from rna_mitsuba.evaluator import PartEvaluator
from rna_mitsuba.points import FiberGeometry
from rna_mitsuba.tracing import NO_STRAND, PackageScene
from rna_sdk.conformance.reader_program import BASE_COLOR_HIT, run_reader
from rna_sdk.package import Package


def evaluate(
    form: str, package: str, tier: str, part: int, arrays: dict[str, np.ndarray]
) -> np.ndarray:
    """(n, width) float32."""
    at = {
        name: mi.Float(rows.copy()) if rows.ndim == 1 else _vector(rows)
        for name, rows in arrays.items()
    }
    with Package.open(package) as opened:
        evaluator = PartEvaluator(opened, tier, part)
    result = evaluator.decode(form, at, mi.Bool(True))
    return np.hstack([_rows(colour, len(arrays["wo"])) for colour in result])


def visibility(package: str, records: bytes) -> np.ndarray:
    """(n, 3) float32: the visibility, RGB, of the rays of n hits."""
    words = np.frombuffer(records, "<u4").reshape(-1, 8)
    numbers = words.view("<f4").astype(np.float32)
    with Package.open(package) as opened:
        scene = PackageScene(opened)
    seen = np.empty((len(words), 3), np.float32)
    for part, geometry in enumerate(scene.geometries):
        rows = np.flatnonzero(words[:, 7] == part)
        primitive, active = mi.UInt32(words[rows, 0].copy()), mi.Bool(True)
        strand = mi.UInt32(NO_STRAND)
        if isinstance(geometry, FiberGeometry):
            origin, wi = _vector(numbers[rows, 1:4]), _vector(numbers[rows, 4:7])
            strand = geometry.strand(primitive, active)
        else:
            b1, b2 = (mi.Float(numbers[rows, k].copy()) for k in (1, 2))
            wi = _vector(numbers[rows, 3:6])
            at = geometry.points(primitive, b1, b2, mi.Point3f(0), wi, active)
            origin = at.origin(wi, scene.step)
        result = scene.visibility(
            mi.Point3f(origin),
            wi,
            mi.Float(dr.inf),
            mi.UInt32(part),
            strand,
            dr.full(mi.Bool, True, len(rows)),
        )
        seen[rows] = _rows(result, len(rows))
    return seen


def normals(package: str, records: bytes) -> np.ndarray:
    """Shading normals of queries at n hits on meshes, (n, 3) float32."""
    words = np.frombuffer(records, "<u4").reshape(-1, 8)
    numbers, result = words.view("<f4").astype(np.float32), np.empty((len(words), 3), np.float32)
    with Package.open(package) as opened:
        scene = PackageScene(opened)
    for part in np.unique(words[:, 7]).tolist():
        rows = np.flatnonzero(words[:, 7] == part)
        b1, b2 = (mi.Float(numbers[rows, k].copy()) for k in (1, 2))
        origin, direction = mi.Point3f(0), mi.Vector3f(0)
        primitive = mi.UInt32(words[rows, 0].copy())
        at = scene.geometries[part].points(primitive, b1, b2, origin, direction, mi.Bool(True))
        result[rows] = _rows(at.axis, len(rows))
    return result


def base_color(package: str, records: bytes) -> np.ndarray:
    """Base colours of n hits on meshes, (n, 3) float32."""
    hits = np.frombuffer(records, BASE_COLOR_HIT)
    result = np.empty((len(hits), 3), np.float32)
    with Package.open(package) as opened:
        scene = PackageScene(opened)
    for part in np.unique(hits["part"]).tolist():
        rows = np.flatnonzero(hits["part"] == part)
        primitive = mi.UInt32(hits["primitive"][rows].copy())
        numbers = (mi.Float(hits[name][rows].copy()) for name in ("u", "v", "level"))
        result[rows] = _rows(scene.geometries[part].base_color(primitive, *numbers), len(rows))
    return result


def _vector(rows: np.ndarray) -> mi.Vector3f:
    return mi.Vector3f(np.ascontiguousarray(rows.T))


def _rows(colour: mi.Color3f, count: int) -> np.ndarray:
    return np.broadcast_to(np.array(colour).T, (count, 3)).astype(np.float32)


if __name__ == "__main__":
    sys.exit(
        run_reader(
            evaluate=evaluate,
            nearby=evaluate,
            visibility=visibility,
            normals=normals,
            base_color=base_color,
        )
    )
