"""Dr.Jit's evaluation as a reader program, with the level `evaluate`.

rna-conform -- python -m rna_mitsuba.conformance_reader
"""

from __future__ import annotations

import sys

import mitsuba as mi
import numpy as np

if mi.variant() is None:
    mi.set_variant("llvm_ad_rgb")

from rna_mitsuba.evaluator import PartEvaluator
from rna_sdk.conformance.reader_program import run_reader
from rna_sdk.package import Package


def evaluate(package: str, tier: str, part: int, queries: np.ndarray) -> np.ndarray:
    """(n, 6) float32 for (n, 13) queries."""
    position, axis, h, wo, wi = _arguments(queries)
    with Package.open(package) as opened:
        evaluator = PartEvaluator(opened, tier, part)
    found = evaluator.transport(position, axis, h, wo, wi, mi.Bool(True))
    return np.hstack([_rows(colour, len(queries)) for colour in found])


def emission(package: str, tier: str, part: int, queries: np.ndarray) -> np.ndarray:
    """(n, 3) float32 for (n, 10) queries."""
    position, axis, h, wo, _ = _arguments(np.hstack([queries, queries[:, 7:10]]))
    with Package.open(package) as opened:
        evaluator = PartEvaluator(opened, tier, part)
    return _rows(evaluator.emission(position, axis, h, wo, mi.Bool(True)), len(queries))


def _arguments(queries: np.ndarray):  # type: ignore[no-untyped-def]
    x, axis, h, wo, wi = np.split(np.ascontiguousarray(queries), (3, 6, 7, 10), axis=1)
    vectors = (mi.Vector3f(np.ascontiguousarray(v.T)) for v in (axis, wo, wi))
    axis, wo, wi = vectors
    return mi.Point3f(np.ascontiguousarray(x.T)), axis, mi.Float(h[:, 0].copy()), wo, wi


def _rows(colour: mi.Color3f, count: int) -> np.ndarray:
    return np.broadcast_to(np.array(colour).T, (count, 3)).astype(np.float32)


if __name__ == "__main__":
    sys.exit(run_reader(evaluate=evaluate, emission=emission))
