"""rna-run against Mitsuba with rna_mitsuba: images and speed.

    rna-bench mitsuba --picture bench/mitsuba.jpg --out bench/mitsuba.json

The picture has rna-run, Mitsuba and their difference x 4, one row a scene. Kernel compilation is
not timed; the renderers alternate.
"""

from __future__ import annotations

import argparse
import json
import statistics
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from rna_bench.bench_options import add_out
from rna_bench.bench_pages import save_picture
from rna_bench.results import publish
from rna_export.metrics import IRRADIANCE, psnr

Renderer = Callable[[int], np.ndarray]
"""A scene's image for a seed, (height, width, 3)."""

_VARIANT = "llvm_ad_rgb"


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--picture", type=Path, required=True, help="JPEG or PNG to write")
    parser.add_argument(
        "--size", type=int, nargs=2, default=(300, 200), help="width, height, pixels"
    )
    parser.add_argument("--samples", type=int, default=32, help="samples per pixel and run")
    parser.add_argument("--runs", type=int, default=3, help="timed runs of each")
    add_out(parser)


def run(args: argparse.Namespace) -> None:
    import mitsuba

    mitsuba.set_variant(_VARIANT)  # before anything of Mitsuba is imported from its modules
    from rna_bench.hosts.mitsuba_scenes import Ours, Theirs, pairs

    rows, records = [], {}
    with tempfile.TemporaryDirectory() as folder:
        for name, pair in pairs(Path(folder)).items():
            both = (
                Ours(Path(folder), pair, tuple(args.size), args.samples),
                Theirs(pair, tuple(args.size), args.samples),
            )
            images, seconds, first = render_in_turn(both, args.runs)
            rows.append(np.concatenate([*images, np.abs(images[0] - images[1]) * 4], axis=1))
            records[name] = record(images, seconds, first)
            print(name, json.dumps(records[name]), flush=True)
    args.picture.parent.mkdir(parents=True, exist_ok=True)
    sheet = np.clip(np.concatenate(rows), 0, 1) ** (1 / 2.2)
    image = Image.fromarray(np.round(sheet * 255).astype(np.uint8))
    small = (image.width * 3 // 5, image.height * 3 // 5)
    save_picture(image.resize(small, Image.Resampling.LANCZOS), args.picture)
    settings = {"size": list(args.size), "samples": args.samples, "runs": args.runs}
    publish({"variant": _VARIANT, **settings, "scenes": records}, args)


def render_in_turn(
    both: tuple[Renderer, Renderer], runs: int
) -> tuple[list[np.ndarray], tuple[list[float], list[float]], list[float]]:
    """Mean images, seconds of each run, and those of the first, which compiles."""
    first: list[float] = []
    seconds: tuple[list[float], list[float]] = [], []
    images: tuple[list[np.ndarray], list[np.ndarray]] = [], []
    for renderer in both:
        start = time.perf_counter()
        renderer(0)
        first.append(time.perf_counter() - start)
    for run in range(runs):
        for k, renderer in enumerate(both):
            start = time.perf_counter()
            images[k].append(renderer(1 + run))
            seconds[k].append(time.perf_counter() - start)
    return [np.mean(of, axis=0) for of in images], seconds, first


def record(
    images: list[np.ndarray], seconds: tuple[list[float], list[float]], first: list[float]
) -> dict[str, Any]:
    """The JSON record of a scene."""
    ours, theirs = images
    medians = [statistics.median(of) for of in seconds]
    return {
        "rnaRunSeconds": round(medians[0], 3),
        "mitsubaSeconds": round(medians[1], 3),
        "mitsubaOverRnaRun": round(medians[1] / medians[0], 2),
        "firstRunSeconds": {"rnaRun": round(first[0], 1), "mitsuba": round(first[1], 1)},
        "meanRnaRun": [round(float(x), 5) for x in ours.mean(axis=(0, 1))],
        "meanMitsuba": [round(float(x), 5) for x in theirs.mean(axis=(0, 1))],
        "psnr": round(psnr(ours / IRRADIANCE, theirs / IRRADIANCE), 2),
    }
