"""Render an asset in scenes, beside Cycles with the original: error over time, and where it goes.

    rna-bench scenes toy.rna --source toy.py --out bench/toy

Environments, a lamp, a red wall beside the asset, and instances near and far. Both programs render
by turns, raw and denoised: Cycles by its own denoiser, ours by Open Image Denoise where the extra
`denoise` is installed. The error is told apart into the package's own, which more samples do not
lessen (the floor), and noise. A page, the figures as JSON and one sheet as PNG are written.

Cycles' references are slow, and kept in OUT/references. Run it on a machine that does nothing else.
Arguments after -- go to a source that is a Python script.
"""

from __future__ import annotations

import argparse
from pathlib import Path


def add_options(p: argparse.ArgumentParser) -> None:
    """The options of the command."""
    p.add_argument("asset", type=Path, help="the .rna file")
    p.add_argument("--source", type=Path, required=True, help="what it was captured from (path)")
    p.add_argument("--out", type=Path, required=True, help="folder for page and results (path)")
    p.add_argument("--tier", help="of the asset (text, default: its first)")
    p.add_argument(
        "--max-error",
        type=float,
        help="let quality choose tiers by this error (float, default: the tier for all)",
    )
    p.add_argument(
        "--environment",
        nargs="*",
        default=["forest", "studio"],
        metavar="FILE",
        help="images of surroundings, EXR or HDR, or names of those that come with Blender (path, "
        "default: forest studio)",
    )
    p.add_argument(
        "--scenes",
        nargs="+",
        metavar="NAME",
        help="of the scenes: an environment's name, lamp, wall, near-and-far (default: all)",
    )
    p.add_argument("--samples", type=int, nargs="+", default=[4, 16, 64], help="ours a pixel")
    p.add_argument(
        "--cycles-samples", type=int, nargs="+", default=[4, 8, 16, 32, 64], help="Cycles' a pixel"
    )
    p.add_argument(
        "--reference-samples",
        type=int,
        default=1024,
        help="Cycles' a pixel for what all is compared with: half of them in each of two renders",
    )
    p.add_argument("--floor-samples", type=int, default=1024, help="ours for the floor, a pixel")
    p.add_argument("--repeats", type=int, default=1, help="of ours; medians count")
    p.add_argument(
        "--resolution", type=int, nargs=2, default=[192, 144], help="width, height in pixels"
    )
    p.add_argument("--turn", type=float, default=0.0, help="of the camera, as for rna-compare")
    p.add_argument("--bounces", type=int, help="of light in Cycles (int, default: the source's)")
    p.add_argument(
        "--again",
        action="store_true",
        help="measure again; Cycles' references are kept (default: off)",
    )


def run(args: argparse.Namespace) -> None:
    """Measure what is not measured yet, and write."""
    from rna_bench.scenes.scenes_study import study

    study(args)
    names = ("index.html", "scenes.json", "scenes.png")
    print("wrote " + ", ".join(str(args.out / name) for name in names))
