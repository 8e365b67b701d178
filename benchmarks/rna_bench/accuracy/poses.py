"""Error of packages in frames of their source, over that at rest, against Cycles.

    rna-bench poses static.rna trained.rna --source slab.py --frames 21 31 61

Packages of one part, of the same source and rest frame, captured with and without `--poses`. The
error is RMSE over the mean of what has turned by 2 degrees or more in a frame.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.cycles_worker import cycles
from rna_bench.one_part import OnePart, load_one_part
from rna_bench.results import publish
from rna_bench.stability.cases.motion import MOVED_DEG, Frame, shade
from rna_bench.stability.moved_references import Views, frame_images
from rna_bench.stability.view_errors import relative_error
from rna_export.capture.geometry.followed_source import FollowedSource
from rna_sdk.package import Package
from rna_trace import part_geometry


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("packages", type=Path, nargs="+", help="packages of the source (paths)")
    parser.add_argument("--source", type=Path, required=True, help="that they were made of (path)")
    parser.add_argument("--frames", type=int, nargs="+", required=True, help="to measure")
    parser.add_argument("--half", type=int, default=16, help="paths a pixel of each half")
    parser.add_argument("--out", type=Path, help="JSON to write (path, default: print only)")


def run(args: argparse.Namespace) -> None:
    assets = {path.stem: load_one_part(path, threads=1) for path in args.packages}
    made = {path.stem: _made(path) for path in args.packages}
    rest_frame = next(iter(made.values()))["restFrame"]
    frames = [rest_frame, *args.frames]
    geometry = part_geometry(next(iter(assets.values())))
    found: dict[str, np.ndarray] = {}
    with cycles(args.source) as worker:
        worker.show_frame(rest_frame)
        source = FollowedSource(worker, [geometry], args.packages[0].name)
        for frame in frames:
            (found[f"{frame}-positions"],) = source.positions(frame)
        views = Views.around([found[f"{frame}-positions"] for frame in frames])
        for frame in frames:
            images = frame_images(worker, views, frame, args.half)
            found |= {f"{frame}-{name}": value for name, value in images.items()}
    results = {
        name: {"made": made[name], "frames": _rows(asset, views, found, frames)}
        for name, asset in assets.items()
    }
    publish({"source": args.source.name, "restFrame": rest_frame, "packages": results}, args)


def _made(path: Path) -> dict[str, Any]:
    """What a package says of its capture."""
    with Package.open(path) as package:
        capture = package.manifest.provenance.capture
    return {name: capture[name] for name in ("restFrame", "poses", "lights", "rays", "samples")}


def _rows(
    asset: OnePart, views: Views, found: dict[str, np.ndarray], frames: list[int]
) -> list[dict[str, Any]]:
    rest, *moved = (shade(asset, views, found, frame) for frame in frames)
    rows = []
    for number, frame in zip(frames[1:], moved, strict=True):
        turned = frame.asset.turned_deg()
        elements = turned > MOVED_DEG
        error, at_rest = _error(frame, elements), _error(rest, elements)
        errors = {"error": error, "at_rest": at_rest, "ratio": error / at_rest}
        rows.append({"frame": number, "turned_deg": float(turned.max()), **errors})
    return rows


def _error(frame: Frame, elements: np.ndarray) -> float:
    """Of the pixels that show these triangles or segments, (t,) bool."""
    rows = elements[frame.seen.element]
    return relative_error(frame.seen.radiance[rows], frame.halves[:, rows])
