"""Render an asset in motion beside Cycles with the original, frame by frame, as one film.

    rna-bench film walk.yaml --source lamb.py --out bench/lamb

A scene file with one asset in motion and `animation.frames`. Writes film.webp (ours on the left),
film.json with the time and the difference of each frame, and frames as PNG. A frame's time holds
all that moves: bending, trees, rendering and denoising, without reading files; its CPU seconds are
those of all threads, which say more on a busy machine. Finished frames are kept. Arguments after --
are passed to a source that is a Python script.
"""

from __future__ import annotations

import argparse
from pathlib import Path


def add_options(p: argparse.ArgumentParser) -> None:
    """The options of the command."""
    p.add_argument("scene", type=Path, help="scene file with an asset in motion (path)")
    p.add_argument("--source", type=Path, required=True, help="the moving model (path, required)")
    p.add_argument("--out", type=Path, required=True, help="folder (path, required)")
    p.add_argument(
        "--first",
        type=int,
        help="frame of the source in frame 0 of the scene (int, default: its first)",
    )
    p.add_argument(
        "--cycles-samples", type=int, default=32, help="Cycles samples per pixel (int, default: 32)"
    )
    p.add_argument(
        "--noisy", action="store_true", help="without denoising, of either (default: off)"
    )


def run(args: argparse.Namespace) -> None:
    """Render the missing frames, and write the film."""
    from rna_bench.scenes.film import film

    for path in film(args):
        print(f"wrote {path}")
