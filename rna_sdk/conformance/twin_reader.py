"""The runtime's numpy twin as a reader program, with the decoder's graph as the package has it.

rna-conform -- python -m rna_sdk.conformance.twin_reader
"""

from __future__ import annotations

import sys

import numpy as np
from numpy.typing import NDArray

from rna_sdk.conformance.reader_program import run_reader
from rna_sdk.package import Int8Planes, Package
from rna_sdk.runtime.decoder import Graph
from rna_sdk.runtime.queries_reference import fiber_queries_reference, queries_reference


def evaluate(package: str, tier: str, queries: NDArray[np.float32]) -> NDArray[np.float32]:
    """(n, 6) for (n, 13) queries."""
    position, axis, h, wo, wi = np.split(queries, (3, 6, 7, 10), axis=1)
    valid = np.isfinite(queries).all(axis=1)
    for directions in (axis, wo, wi):
        valid &= directions.any(axis=1)
    with Package.open(package) as opened:
        part, stored = opened.manifest.parts[0], opened.planes(tier)
        planes = stored.decoded() if isinstance(stored, Int8Planes) else stored
        place = planes, part.bounds.corners(), opened.tier(tier).parts[0].inputs
        at, t, o, i = position[valid], axis[valid], wo[valid], wi[valid]
        if part.kind == "surface":
            inputs = queries_reference(*place, at, t, o, i)
        else:
            inputs = fiber_queries_reference(*place, at, t, h[valid, 0], o, i)
        graph = Graph(bytes(opened.decoder(tier)), optimized=False)
    result = np.zeros((len(queries), 6), np.float32)
    result[valid] = graph.run(inputs)
    return result


if __name__ == "__main__":
    sys.exit(run_reader(evaluate=evaluate))
