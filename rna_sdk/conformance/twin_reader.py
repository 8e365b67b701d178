"""The runtime's numpy twin as a reader program, with the decoder's graph as the package has it.

rna-conform -- python -m rna_sdk.conformance.twin_reader
"""

from __future__ import annotations

import sys

import numpy as np
from numpy.typing import NDArray

from rna_sdk.conformance.reader_program import run_reader
from rna_sdk.package import Package, float_planes
from rna_sdk.reference.queries import fiber_queries_reference, queries_reference
from rna_sdk.runtime.engine.decoder_sessions import Graph


def evaluate(
    package: str, tier: str, part: int, queries: NDArray[np.float32]
) -> NDArray[np.float32]:
    """(n, 6) for (n, 13) queries."""
    with Package.open(package) as opened:
        record = opened.tier(tier).parts[part]
        return _answer(opened, tier, part, record.inputs, opened.decoder(tier, part), queries)


def emission(
    package: str, tier: str, part: int, queries: NDArray[np.float32]
) -> NDArray[np.float32]:
    """(n, 3) for (n, 10) queries."""
    with Package.open(package) as opened:
        own, decoder = opened.tier(tier).parts[part].emission, opened.emission_decoder(tier, part)
        if own is None or decoder is None:
            return np.zeros((len(queries), 3), np.float32)
        no_light = queries[:, 7:10]  # of length, like wo; no block of emission reads it
        rows = np.hstack([queries, no_light])
        return _answer(opened, tier, part, own.inputs, decoder, rows)


def _answer(
    opened: Package,
    tier: str,
    number: int,
    inputs: tuple[str, ...],
    decoder: memoryview,
    queries: NDArray[np.float32],
) -> NDArray[np.float32]:
    """The decoder's output, 0 for rows that are no queries."""
    position, axis, h, wo, wi = np.split(queries, (3, 6, 7, 10), axis=1)
    valid = np.isfinite(queries).all(axis=1)
    for directions in (axis, wo, wi):
        valid &= directions.any(axis=1)
    part, planes = opened.manifest.parts[number], float_planes(opened.planes(tier, number))
    place = planes, part.bounds.corners(), inputs
    at, t, o, i = position[valid], axis[valid], wo[valid], wi[valid]
    if part.kind == "surface":
        rows = queries_reference(*place, at, t, o, i)
    else:
        rows = fiber_queries_reference(*place, at, t, h[valid, 0], o, i)
    output = Graph(bytes(decoder), optimized=False).run(rows)
    result = np.zeros((len(queries), output.shape[1]), np.float32)
    result[valid] = output
    return result


if __name__ == "__main__":
    sys.exit(run_reader(evaluate=evaluate, emission=emission))
