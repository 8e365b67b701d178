"""Render an asset in scenes against Cycles with the original: error and time by component.

    rna-bench scenes toy.rna --source toy.py --out bench/toy

Environments, a lamp, a red wall beside the asset, and instances near and far. Both renderers
alternate, raw and denoised: Cycles with its own denoiser, ours with Open Image Denoise, where there
is a wheel of it. The error is split into the package's own (the floor, independent of
sampling) and noise. Writes the figures as JSON and one sheet as PNG.

Cycles references are slow, and cached in OUT/references; --references-only makes them beforehand,
on a machine that may be busy. The rest needs an idle one. Arguments after -- are passed to a source
that is a Python script.
"""

import argparse
from pathlib import Path


def add_options(p: argparse.ArgumentParser) -> None:
    """The options of the command."""
    p.add_argument("asset", type=Path, help="the .rna file")
    p.add_argument("--source", type=Path, required=True, help="model it was captured from (path)")
    p.add_argument(
        "--out", type=Path, required=True, help="folder for the results (path, required)"
    )
    p.add_argument("--tier", help="tier of the asset (text, default: its first)")
    p.add_argument(
        "--environment",
        nargs="*",
        default=["forest", "studio"],
        metavar="FILE",
        help="environment maps, EXR or HDR, or names of those shipped with Blender (path, "
        "default: forest studio)",
    )
    p.add_argument(
        "--scenes",
        nargs="+",
        metavar="NAME",
        help="scenes to run: an environment's name, lamp, wall, near-and-far (default: all)",
    )
    p.add_argument(
        "--samples", type=int, nargs="+", default=[1, 4, 16, 64], help="rna-run samples per pixel"
    )
    p.add_argument(
        "--cycles-samples",
        type=int,
        nargs="+",
        default=[1, 2, 4, 8, 16, 32, 64],
        help="Cycles samples per pixel",
    )
    p.add_argument(
        "--reference-samples",
        type=int,
        default=512,
        help="Cycles samples per pixel of the reference, split over two renders",
    )
    p.add_argument(
        "--floor-samples", type=int, default=256, help="rna-run samples per pixel of the floor"
    )
    p.add_argument(
        "--resolution", type=int, nargs=2, default=[640, 360], help="width, height in pixels"
    )
    p.add_argument(
        "--share",
        type=float,
        default=1 / 3,
        help="share of the picture that the asset covers, by the camera's distance (float, "
        "default: a third)",
    )
    p.add_argument("--turn", type=float, default=0.0, help="camera rotation, degrees")
    p.add_argument(
        "--references-only",
        action="store_true",
        help="render the missing Cycles references and stop (default: off)",
    )
    p.add_argument(
        "--again",
        action="store_true",
        help="measure again, reusing the Cycles references (default: off)",
    )


def run(args: argparse.Namespace) -> None:
    """Make the missing measurements, and write the results."""
    from rna_bench.scenes.scenes_study import study

    print(f"wrote {study(args)}")
