"""Methods to keep an int8 decoder exact on every CPU: accuracy and time of each.

    rna-bench int8-weights runs/toy/best.ckpt --out vnni.json
    python -m tests.avx2 rna-bench int8-weights runs/toy/best.ckpt --out avx2.json

Each variant quantises the same trained decoder: `eight` with weights up to 127, which the runtime
has to hand over as uint8; `pairs` (what rna-export writes) with pairs of inputs that fit 16 bits;
`seven` with weights up to 64. PSNR is of the dataset's validation images, of the decoder alone
(planes as trained). Times are of the decoder alone in one thread, medians of runs that alternate.
"""

from __future__ import annotations

import argparse
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import torch

from rna_bench.int8.engine import sums_in_16_bits
from rna_bench.options import add_out, add_repeats
from rna_bench.results import publish
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.export.decoder import export_decoder
from rna_export.export.int8_decoder import WeightScale, int8_decoder, pair_scale
from rna_export.export.tiers import calibration
from rna_export.machine import seconds_of
from rna_export.metrics import PSNR_DEFINITION, psnr
from rna_export.training.checkpoint import load_checkpoint
from rna_sdk.runtime.engine.decoder_sessions import Decoder


def largest(limit: float) -> WeightScale:
    """Steps with which the largest weight of an output becomes `limit`."""
    return lambda weight: weight.abs().amax(dim=1).clamp(min=1e-9) / limit


VARIANTS: dict[str, WeightScale | None] = {
    "float32": None,
    "eight": largest(127.0),
    "pairs": pair_scale,
    "seven": largest(64.0),
}


def run(args: argparse.Namespace) -> None:
    report = {
        "sums_in_16_bits": sums_in_16_bits(),
        "psnr": PSNR_DEFINITION,
        "repeats": args.repeats,
        "checkpoints": [measured(path, args.repeats) for path in args.checkpoints],
    }
    publish(report, args)


def decode(decoder: Decoder, tile: np.ndarray, calls: int) -> None:
    """The same tile, so often."""
    for _ in range(calls):
        decoder.run(tile)


def measured(path: Path, repeats: int) -> dict[str, Any]:
    """Each variant of one checkpoint."""
    trained = load_checkpoint(path)
    dataset = Dataset(trained.dataset).only
    seen = calibration(trained, dataset).queries
    views = dataset.validation_views()
    queries = [trained.model.queries(_tensors(view)).detach().numpy() for view in views]
    decoders = {}
    for name, scale in VARIANTS.items():
        layers = int8_decoder(trained.model, seen, scale) if scale else None
        decoders[name] = Decoder(export_decoder(trained.model, layers))
    rows = np.concatenate(queries)
    times: dict[str, list[float]] = {name: [] for name in decoders}
    for _ in range(repeats + 1):  # the first run warms caches
        for name, decoder in decoders.items():
            tile = padded(rows[: decoder.tile_rows], decoder.columns)
            calls = max(1, 30_000 // len(tile))
            taken = seconds_of(partial(decode, decoder, tile, calls))
            times[name].append(1e9 * taken / (calls * len(tile)))
    return {
        "asset": dataset.manifest.name,
        "preset": trained.preset_name,
        "width": trained.preset.model.width,
        "variants": {
            name: {
                "psnr": round(mean_psnr(decoder, queries, views), 3),
                "ns_per_query": round(float(np.median(times[name][1:])), 1),
            }
            for name, decoder in decoders.items()
        },
    }


def mean_psnr(decoder: Decoder, queries: list[np.ndarray], views: list[ValidationView]) -> float:
    values = []
    for asked, view in zip(queries, views, strict=True):
        transport = decoder.run(padded(asked, decoder.columns))
        picked = view.pick(transport[:, :3], transport[:, 3:])
        values.append(psnr(picked, view.samples["radiance"]))
    return float(np.mean(values))


def padded(queries: np.ndarray, columns: int) -> np.ndarray:
    return np.pad(queries, ((0, 0), (0, columns - queries.shape[1])))


def _tensors(view: ValidationView) -> dict[str, torch.Tensor]:
    return {k: torch.from_numpy(np.ascontiguousarray(v)) for k, v in view.queries.items()}


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("checkpoints", nargs="+", type=Path, help="checkpoints of rna-train")
    add_repeats(parser)
    add_out(parser)
