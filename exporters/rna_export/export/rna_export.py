"""`rna-export`: makes an `.rna` package from trained checkpoints."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from rna_export.export.package_options import add_credit, add_environment, check_environment
from rna_export.export.precision import MAX_LOSS, add_precision, precisions_of
from rna_export.training.training_options import add_incomplete
from rna_sdk.commands.console import command_line, command_parser, run_command
from rna_sdk.files.file_kinds import kind_of
from rna_sdk.files.outputs import check_outputs, check_package_name
from rna_sdk.package.gltf.glb_file import package_to_write

if TYPE_CHECKING:
    from rna_export.training.checkpoint import Trained

_NONE = Path("none")  # of --standin


def parser() -> argparse.ArgumentParser:
    """The options of `rna-export`."""
    p = command_parser(
        "rna-export",
        "Export trained checkpoints to one .rna package, one tier per checkpoint.",
        "rna-export runs/helmet --out helmet.rna",
    )
    p.add_argument(
        "checkpoints",
        nargs="+",
        type=Path,
        help="checkpoints or output folders of rna-train, one per tier, the default tier first; an "
        "asset of several parts needs its folder. With --environment and no checkpoint, a "
        "package to add lobes to (paths)",
    )
    p.add_argument(
        "--out",
        type=Path,
        required=True,
        help="output package, .rna, or .glb with a fallback for viewers that do not know RNA "
        "(path, required)",
    )
    p.add_argument(
        "--dataset",
        type=Path,
        help="dataset of rna-capture (path, default: the dataset of the first checkpoint)",
    )
    add_precision(p)
    p.add_argument(
        "--max-loss",
        type=float,
        default=MAX_LOSS,
        metavar="DB",
        help="largest PSNR loss of a tier against the trained model, dB; the export fails beyond "
        "it (float, default: %(default)s)",
    )
    p.add_argument(
        "--poster",
        type=Path,
        metavar="PNG",
        help="thumbnail stored in the package (path, default: rendered from the front)",
    )
    p.add_argument(
        "--proxies",
        nargs="+",
        type=int,
        default=[],
        metavar="PIXELS",
        help="add simplified proxy meshes for these heights of the asset in the image, pixels; "
        "rna-run uses them in scenes with `quality` (ints, default: none)",
    )
    p.add_argument(
        "--standin",
        type=Path,
        metavar="FOLDER",
        help="folder of rna-train --preset analytic on the same dataset; its materials become the "
        "textures that web pages show first and rna-info --glb writes, for parts with texture "
        "coordinates; none: no textures (path, default: a short fit, for parts without base "
        "colour, in up to 15%% of the package's size)",
    )
    p.add_argument(
        "--source-vertices",
        action="store_true",
        help="store the number of each vertex in the source, 4 bytes each, by which rna-motion "
        "matches the two (default: off)",
    )
    p.add_argument(
        "--coding",
        choices=["raw", "deflate"],
        default="raw",
        help="deflate: lossless compression by RNA_deflate; readers without this extension reject "
        "the package (default: %(default)s)",
    )
    add_incomplete(p)
    add_credit(p)
    add_environment(p)
    return p


def main(argv: list[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    options = parser()
    args = options.parse_args(argv)
    if any(pixels < 1 for pixels in args.proxies):
        options.error(f"argument --proxies: expected 1 or more, found {min(args.proxies)}")
    check_environment(args, options)
    run = _run
    if any(kind_of(path) == "package" for path in args.checkpoints):
        _check_package(args, options)
        run = _add_lobes

    def checked() -> None:
        check_package_name(args.out)
        run(args)

    return run_command(checked, args.debug, "no partial package was written", "train")


def _check_package(args: argparse.Namespace, options: argparse.ArgumentParser) -> None:
    """Exits with an error of usage unless one package is given, and the form `environment`."""
    if len(args.checkpoints) > 1 or not args.environment:
        found = " ".join(map(str, args.checkpoints))
        options.error(f"found {found}, expected checkpoints, or one package with --environment")
    for name in ("dataset", "precision", "poster", "proxies", "name", "source", "standin"):
        if getattr(args, name):
            options.error(f"argument --{name}: expected checkpoints, found {args.checkpoints[0]}")


def _add_lobes(args: argparse.Namespace) -> None:
    """A copy of a package with the form `environment`."""
    from rna_export.lobes.environment_training import add_lobes

    (package,) = args.checkpoints
    check_outputs([args.out], [package, *args.environment_files])
    with package_to_write(args.out) as out:
        lines = add_lobes(package, out, args.environment_minutes, args.environment_files)
    before, after = (path.stat().st_size / 1e6 for path in (package, args.out))
    print("\n".join(lines))
    print(f"wrote {args.out}, {after:.2f} MB ({package}: {before:.2f} MB)")
    print(f"next: {command_line('rna-view', args.out)}")


def _analytic(folder: Path | None) -> list[Trained] | None:
    from rna_export.export.trained_tiers import checkpoint_paths
    from rna_export.training.checkpoint import load_checkpoint

    if folder is None:
        return None
    return [] if folder == _NONE else [load_checkpoint(path) for path in checkpoint_paths([folder])]


def _run(args: argparse.Namespace) -> None:
    from rna_export.capture.dataset.completeness import check_complete
    from rna_export.capture.dataset.dataset_folder import Dataset
    from rna_export.capture.geometry.cut import as_cut
    from rna_export.export.export_summary import closing_lines
    from rna_export.export.extras import add_extras
    from rna_export.export.package_build import build_package
    from rna_export.export.standin_textures import check_analytic
    from rna_export.export.trained_tiers import checkpoint_paths
    from rna_export.fallback_error import complete_fallback
    from rna_export.lobes.environment_training import add_lobes
    from rna_export.pictures import sheet_of
    from rna_export.training.checkpoint import load_checkpoint

    checkpoints = checkpoint_paths(args.checkpoints)
    given = [*checkpoints, *args.environment_files]
    check_outputs([args.out], given if args.poster is None else [*given, args.poster])
    trained = [load_checkpoint(path) for path in checkpoints]
    analytic = _analytic(args.standin)
    whole = Dataset(args.dataset or trained[0].dataset)
    check_complete(whole, args.incomplete)
    dataset = as_cut(whole, trained[0].cut)
    check_analytic(analytic or (), dataset)
    presets = dict.fromkeys(one.preset_name for one in trained)
    precisions = precisions_of(args.precision, presets)
    proxies = sorted(set(args.proxies), reverse=True)
    coded, lobes = args.coding == "deflate", []
    with package_to_write(args.out) as out:
        manifest = build_package(
            trained,
            dataset,
            out,
            args.source,
            args.license,
            print,
            precisions,
            max_loss=args.max_loss,
            name=args.name,
        )
        add_extras(out, dataset, args.poster, proxies, coded, print, args.source_vertices, analytic)
        if args.environment:
            lobes = add_lobes(out, out, args.environment_minutes, args.environment_files)
    lines = [*closing_lines(args.out, manifest, trained, dataset), *lobes]
    print("\n".join([*lines, *complete_fallback(args.out, dataset)]))
    size = args.out.stat().st_size / 1e6
    print(f"wrote {args.out}, {size:.2f} MB, {sheet_of(args.out)}")
    print(f"next: {command_line('rna-validate', args.out)}")


if __name__ == "__main__":
    sys.exit(main())
