"""Processor time of a query, known before any model is trained: weights do not change it."""

from __future__ import annotations

import time
from itertools import pairwise

import numpy as np

from rna_export.training.presets import PRESETS
from rna_sdk.package.blocks import query_width
from rna_sdk.package.decoder.profile_decoder import ProfileDecoder, ProfileLayer
from rna_sdk.runtime.engine.compiled_decoder import CompiledDecoder
from rna_sdk.runtime.engine.costs import median_seconds

PRESET = "small"

_ROWS = 4096
_OUTPUTS = 6  # visible and shadowed colours


def query_seconds(kind: str) -> float:
    """Seconds of one thread for a query's float32 decoder of PRESET, with random weights.

    kind: "surface" or "fiber".
    """
    model, rng = PRESETS[kind][PRESET].model, np.random.default_rng(0)
    columns = query_width(model.inputs, model.channels)
    widths = [columns, *[model.width] * model.hidden_layers, _OUTPUTS]
    layers = [
        ProfileLayer(
            rng.normal(size=sizes).astype(np.float32) / np.float32(np.sqrt(sizes[0])),
            np.zeros(sizes[1], np.float32),
            step=0.0,
            scale=None,
            relu=number < model.hidden_layers,
        )
        for number, sizes in enumerate(pairwise(widths))
    ]
    decoder = CompiledDecoder(ProfileDecoder(-1.0, 1.0, None, None, tuple(layers), 8.0, 1.0, None))
    queries = rng.uniform(-1.0, 1.0, (_ROWS, columns)).astype(np.float32)
    return median_seconds(lambda: decoder.run(queries), time.thread_time) / _ROWS
