"""Train other methods for relightable assets for equal times, and render their results.

    rna-bench peers bench/toy.views --package examples/quickstart/toy.rna --out bench/peers-toy

Views are those of `rna-bench peers-data`, or a folder in NRHints' layout, or `sphere`: a
Lambertian sphere under a point light, which every method must fit. Writes `peers.json`,
`curves.svg` and sheets like the paper's; the same command resumes. See docs/peers.md.
"""

import argparse
from pathlib import Path
from typing import Any

from rna_bench.peers.methods import METHODS, Setting
from rna_sdk.errors import SceneError

SPHERE = "sphere"
_SPHERE_VIEWS, _SPHERE_SIZE = 500, 64


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of this command."""
    parser.add_argument("views", type=Path, help="folder of views, or `sphere` (path)")
    parser.add_argument(
        "--out", type=Path, required=True, help="folder for checkpoints and report (path, required)"
    )
    parser.add_argument(
        "--package",
        type=Path,
        nargs="+",
        default=[],
        help="our packages of the same asset, to render beside them; the first is the known "
        "geometry (paths, default: none)",
    )
    parser.add_argument(
        "--methods",
        nargs="+",
        choices=METHODS,
        help="methods to train (text, default: all that the data and --package allow)",
    )
    parser.add_argument(
        "--minutes", type=float, default=10.0, help="processor time per training, minutes"
    )
    parser.add_argument(
        "--steps",
        type=int,
        help="steps per training, instead of --minutes (int, default: none)",
    )
    parser.add_argument(
        "--full",
        action="store_true",
        help="use the published batch sizes and samples per ray, meant for a GPU (default: off)",
    )
    parser.add_argument("--seeds", type=int, nargs="+", default=[0], help="seeds of trainings")
    parser.add_argument("--device", default="cpu", help="PyTorch device: cpu or cuda")
    parser.add_argument(
        "--threads",
        type=int,
        default=1,
        help="threads per training; more than there are free cores are slow",
    )
    parser.add_argument("--held-out", type=int, default=4, help="views of each kind to measure")
    parser.add_argument(
        "--size",
        type=int,
        help="width and height to measure at, a divisor of the views' (int, default: the views')",
    )
    parser.add_argument("--samples", type=int, default=32, help="samples per pixel of our package")
    parser.add_argument(
        "--again",
        action="store_true",
        help="discard results that were made with other settings (default: off)",
    )


def run(args: argparse.Namespace) -> None:
    """Train, render and write the report."""
    from rna_bench.peers import our_package
    from rna_bench.peers.known_geometry import KnownGeometry
    from rna_bench.peers.peers_report import write_report
    from rna_bench.peers.study import run_method
    from rna_export.training.optimization.product_kernels import use_threads

    use_threads(args.threads)
    plan = _plan(args)
    settings = _settings(args)
    geometry = KnownGeometry(args.package[0], plan.train) if args.package else None
    rows = []
    for seed in args.seeds:
        for name in args.methods or _possible(args):
            setting = Setting(seed, args.device, args.full, geometry)
            result = run_method(METHODS[name], setting, plan, args.out, settings, args.again)
            last = result["points"][-1]
            print(
                f"{name}, seed {seed}: {last['cpu_minutes']:.1f} min, {last['scores']}", flush=True
            )
            rows.append(result)
    ours = our_package.measured(args.package, plan, args.samples)
    write_report(args.out, args.stamp, settings, plan, rows, ours)


def _settings(args: argparse.Namespace) -> dict[str, Any]:
    """Settings that the records depend on."""
    return {
        "views": args.views.name,
        "minutes": None if args.steps else args.minutes,
        "steps": args.steps,
        "held_out": args.held_out,
        "size": args.size,
    }


def _possible(args: argparse.Namespace) -> list[str]:
    """Methods that the data and the package allow."""
    return [
        row.name
        for row in METHODS.values()
        if (args.package or not row.needs_geometry)
        and (not row.collocated or "train_collocated" in _splits(args.views))
    ]


def _splits(views: Path) -> list[str]:
    from rna_bench.peers.views_reader import splits_of

    if str(views) == SPHERE:
        return ["train", "val", "train_collocated", "val_collocated"]
    return splits_of(views)


def _plan(args: argparse.Namespace) -> Any:
    """The data of a study. Raises SceneError for views that cannot be used."""
    from rna_bench.peers.scoring import HeldOut, reduced
    from rna_bench.peers.study import Plan

    train = _read(args.views, "train", None)
    there, collocated = _splits(args.views), None
    if any(METHODS[name].collocated for name in args.methods or _possible(args)):
        collocated = _read(args.views, "train_collocated", None)
    held_out: dict[str, HeldOut] = {}
    for split in [name for name in ("val", "val_collocated") if name in there]:
        views = _read(args.views, split, args.held_out)
        held_out[split] = HeldOut.of(views if args.size is None else reduced(views, args.size))
    if not held_out:
        raise SceneError("found no transforms_val.json", file=args.views)
    return Plan(train, collocated, held_out, args.minutes, args.steps)


def _read(folder: Path, split: str, limit: int | None) -> Any:
    from rna_bench.peers.sphere.lambert_sphere import sphere_views
    from rna_bench.peers.views_reader import read_views

    if str(folder) != SPHERE:
        return read_views(folder, split, limit)
    return sphere_views(limit or _SPHERE_VIEWS, _SPHERE_SIZE, split)
