"""Where an evaluation's time goes: the steps of the tile loop, on one thread."""

from __future__ import annotations

import time

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package import Package, decoder_from_bytes
from rna_sdk.package.decoder.query_arrays import QUERY_ARRAYS
from rna_sdk.runtime.engine.batch import Batch
from rna_sdk.runtime.engine.decoder_sessions import Decoder
from rna_sdk.runtime.engine.tiles import QueryFiller
from rna_sdk.runtime.kernels.output_kernel import write_results

STEPS = ("gather", "inputs", "decoder", "output")
"""Features from the planes; the decoder's other inputs; the decoder; copies to the results."""


def step_times(
    package: Package, name: str, batch: tuple[NDArray[np.float32], ...]
) -> dict[str, float]:
    """ns/query of a tier on one thread, by step.

    Features and other inputs are written in one pass: what that takes beyond a pass that writes
    features alone counts as inputs. Both passes decode, so that caches are alike.

    batch: the arguments of the asset's `evaluate`.
    """
    part, own = package.manifest.parts[0], package.tier(name).parts[0]
    whole = QueryFiller(package.planes(name), part.bounds, own, part.kind)
    fillers = [whole.laying_out(("features",)), whole]
    decoder = Decoder(
        decoder_from_bytes(package.decoder(name), own.decoder), fillers[-1].largest_query
    )
    (gather, _, _), (filled, decoded, copied) = (_passed(f, decoder, batch) for f in fillers)
    steps = gather, filled - gather, decoded, copied
    return {step: round(float(ns), 1) for step, ns in zip(STEPS, steps, strict=True)}


def _passed(
    filler: QueryFiller, decoder: Decoder, batch: tuple[NDArray[np.float32], ...]
) -> NDArray[np.float64]:
    """ns/query of filling, decoding and copying, over a quarter of the batch."""
    rows = decoder.tile_rows
    n = max(len(batch[0]) // 4 // rows, 1) * rows
    outputs = np.zeros((2, len(batch[0]), 3), np.float32)
    names = [array.name for array in QUERY_ARRAYS if len(batch) == 5 or not array.kind]
    everything = Batch.of(dict(zip(names, batch, strict=True)), tuple(outputs))
    queries = np.zeros((rows, decoder.columns), np.float32)
    valid = np.empty(rows, np.bool_)
    for _ in range(2):  # the first one warms caches
        total = np.zeros(3)
        for start in range(0, n, rows):
            tile = slice(start, min(start + rows, n))
            marks = [time.thread_time()]
            filler.fill(everything, tile, queries, valid)
            marks.append(time.thread_time())
            transport = decoder.run(queries)
            marks.append(time.thread_time())
            for k in range(2):
                write_results(transport, 3 * k, valid, outputs[k, tile])
            marks.append(time.thread_time())
            total += np.diff(marks)
    return total / n * 1e9
