"""`rna-compare`: a package against the original in Cycles."""

import argparse
import sys
import tempfile
from pathlib import Path

from rna_export.capture.orientation import AXES, joined_axes
from rna_sdk.commands.console import command_parser, run_command, split_script_arguments
from rna_sdk.files.owned_folder import owned


def parser() -> argparse.ArgumentParser:
    """The options of `rna-compare`."""
    p = command_parser(
        "rna-compare",
        "Render a package with rna-run and its original with Cycles; write an HTML comparison.",
        "rna-compare helmet.rna helmet.gltf --out compare/helmet",
        epilog="Renders three cameras, one of them a close-up (only hair: a fourth, of single "
        "strands),\nunder three suns and in a white world each. Arguments after -- are passed to a "
        "Python\nsource.",
    )
    p.add_argument("package", type=Path, help="the package (path)")
    p.add_argument("source", type=Path, help="the model it was captured from (path)")
    p.add_argument("--out", type=Path, required=True, help="folder for the report (path, required)")
    p.add_argument("--tier", help="tier to render (text, default: the package's first)")
    p.add_argument(
        "--samples",
        type=int,
        default=16,
        help="rna-run samples per pixel (int, default: %(default)s)",
    )
    p.add_argument(
        "--cycles-samples",
        type=int,
        default=256,
        help="Cycles samples per pixel, at least 2, split over two renders (int, default: "
        "%(default)s)",
    )
    p.add_argument(
        "--resolution",
        type=int,
        default=384,
        help="width and height, pixels (int, default: %(default)s)",
    )
    p.add_argument(
        "--front",
        choices=AXES,
        metavar="AXIS",
        help="front axis of the package (X, Y, Z, -X, -Y or -Z, default: Z, the front in glTF and "
        "Blender's -Y)",
    )
    p.add_argument(
        "--up",
        choices=AXES,
        default="Y",
        metavar="AXIS",
        help="up axis of the package (as --front, default: Y, Blender's Z)",
    )
    return p


def main(argv: list[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    command_line, arguments = split_script_arguments(argv)
    options = parser()
    args = options.parse_args(joined_axes(command_line))
    if args.cycles_samples < 2:
        options.error(
            f"argument --cycles-samples: expected at least 2, found {args.cycles_samples}"
        )
    stopped = f"finished images are in {args.out}"
    return run_command(lambda: _run(args, arguments), args.debug, stopped, "train")


def _run(args: argparse.Namespace, arguments: tuple[str, ...]) -> None:
    from rna_export.capture.blender_process import blender_env
    from rna_export.capture.blender_process.blender_process import Source
    from rna_export.capture.blender_process.blender_worker import BlenderWorker
    from rna_export.capture.blender_process.source_file import check_source
    from rna_export.compare.comparison_page import error_of, outcome_of, write_page
    from rna_export.compare.comparison_run import Pair, compare, returned_light
    from rna_export.compare.origin import Origin
    from rna_sdk.commands.error_words import albedo_text
    from rna_sdk.machine.cores import core_count
    from rna_sdk.runtime import FiberAsset, load

    check_source(args.source)
    asset = load(args.package, tier=args.tier, threads=1)
    origin = Origin.of(args.package, args.tier)
    doubt = origin.doubt(args.source)
    if doubt is not None:
        print(doubt, flush=True)
    python = blender_env.find_python()
    source = Source(
        args.source,
        arguments,
        front=origin.front,
        up=origin.up,
        rest_frame=origin.rest_frame,
        glass=origin.glass,
    )
    settings = {
        "tier": origin.tier,
        "samples": args.samples,
        "cyclesSamples": args.cycles_samples,
        "resolution": args.resolution,
        "threads": core_count(),
    }

    def done(pairs: list[Pair]) -> None:
        """Report the last image, and write the results so far: the next ones may take minutes."""
        p = pairs[-1]
        print(
            f"{p.error}, coverage differs by {p.coverage:.2%}, "
            f"ours {p.seconds_ours:.2f} s, Cycles {p.seconds_cycles:.2f} s",
            flush=True,
        )
        title = f"{args.package.stem}: the package and Cycles"
        write_page(args.out, title, pairs, settings, (args.package, args.source, origin, doubt))

    print(f"opening {args.source} in Blender", flush=True)
    with (
        owned(args.out, "rna-compare"),
        tempfile.TemporaryDirectory(prefix="rna-compare-") as scratch,
        BlenderWorker(python, source, Path(scratch), core_count()) as worker,
    ):
        pairs = compare(
            asset,
            args.package,
            worker,
            args.samples,
            args.cycles_samples,
            args.resolution,
            (args.front or ("-Y" if args.up[-1] == "Z" else "Z"), args.up),
            lambda k, n, shot: print(f"image {k} of {n}: {shot.name}: ", end="", flush=True),
            done,
        )
    if doubt is not None:
        print(doubt)
    print(f"{origin.tier}: {error_of(pairs)}")
    if (returned := returned_light(pairs)) is not None:
        print(f"{origin.tier}: {albedo_text(returned, None)}, in a white world")
    is_of_strands = all(isinstance(part, FiberAsset) for part in asset.parts)
    told = outcome_of(pairs, is_of_strands).told(args.out / "worst.png", "pictures under suns")
    print("\n".join(told))
    print(f"wrote {args.out / 'index.html'}, {args.out / 'results.json'}, {args.out / 'sheet.png'}")


if __name__ == "__main__":
    sys.exit(main())
