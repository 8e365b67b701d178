"""Where an evaluation's time goes: the steps of the tile loop, on one thread."""

from __future__ import annotations

import time
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package import Package
from rna_sdk.runtime.decoder import Decoder
from rna_sdk.runtime.output_kernel import split_transport
from rna_sdk.runtime.tiles import Batch, QueryFiller

STEPS = ("inputs", "decoder", "output")
"""Gather of features and assembly of the decoder's inputs; the decoder; copies to the results."""


def step_times(
    package: Package, name: str, batch: tuple[NDArray[np.float32], ...]
) -> dict[str, float]:
    """ns a query of a tier on one thread, by step.

    batch: the arguments of the asset's `evaluate`.
    """
    tier = package.tier(name)
    kind = package.manifest.kind
    filler = QueryFiller(package.planes(tier.name), package.manifest.bounds, tier, kind)
    decoder = Decoder(package.decoder(tier.name), filler.largest_query)
    rows = decoder.tile_rows
    n = max(len(batch[0]) // 4 // rows, 1) * rows
    outputs = np.zeros((2, len(batch[0]), 3), np.float32)
    positions, axes, *offsets, wo, wi = batch
    h = offsets[0] if offsets else np.empty(0, np.float32)
    everything = Batch(positions, axes, h, wo, wi, *outputs)
    queries = np.zeros((rows, decoder.columns), np.float32)
    valid = np.empty(rows, np.bool_)
    for _ in range(2):  # the first one warms caches
        total = dict.fromkeys(STEPS, 0.0)
        for start in range(0, n, rows):
            tile = slice(start, min(start + rows, n))
            marks = [time.perf_counter()]
            filler.fill(everything, tile, queries, valid)
            marks.append(time.perf_counter())
            transport = decoder.run(queries)
            marks.append(time.perf_counter())
            split_transport(transport, valid, outputs[0, tile], outputs[1, tile])
            marks.append(time.perf_counter())
            for step, (before, after) in zip(total, pairwise(marks), strict=True):
                total[step] += after - before
    return {step: round(taken / n * 1e9, 1) for step, taken in total.items()}
