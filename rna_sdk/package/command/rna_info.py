"""`rna-info`: facts of a package."""

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path

from rna_sdk.commands.console import command_parser, run_command
from rna_sdk.errors import RnaError
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.files.file_kinds import not_a
from rna_sdk.files.outputs import check_glb_name, check_outputs
from rna_sdk.package.command.package_info import info_lines, package_info
from rna_sdk.package.gltf.glb_file import write_glb
from rna_sdk.package.package import Package


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status."""
    command = parser()
    options = command.parse_args(arguments)
    if (options.fallback and not options.glb) or (options.node and not options.fallback):
        command.error("--fallback needs --glb, and --node needs --fallback")
    return run_command(lambda: _run(options), options.debug, "nothing was written")


def parser() -> argparse.ArgumentParser:
    """The options of `rna-info`."""
    p = command_parser(
        "rna-info",
        "Show a package's size, parts, tiers, error, cost, origin and training.",
        "rna-info asset.rna",
        epilog="Errors and costs are those recorded in the package; costs were measured on the\n"
        "machine that exported it. rna-compare measures errors against the original model.",
    )
    p.add_argument("package", type=Path, help="the package (path)")
    p.add_argument("--json", action="store_true", help="print JSON (default: text)")
    p.add_argument(
        "--poster",
        type=Path,
        metavar="PNG",
        help="write the package's poster image to this file (path, default: none)",
    )
    p.add_argument(
        "--glb",
        type=Path,
        metavar="GLB",
        help="write a .glb that carries the package, with the geometry and its stand-in materials\n"
        "for viewers that do not know RNA; strands become a mesh of fewer, thicker ones (path,\n"
        "default: none)",
    )
    p.add_argument(
        "--fallback",
        type=Path,
        metavar="GLB",
        help="with --glb: what other viewers show, a .glb of yours, or one that a program wrote\n"
        "again and left the package out of; it stays as it is (path, default: the stand-in)",
    )
    p.add_argument(
        "--node",
        nargs="+",
        default=[],
        metavar="NAME",
        help="with --fallback: the nodes that the package takes the place of, each in its own\n"
        "space (names, default: all that the scene shows)",
    )
    return p


def _run(options: argparse.Namespace) -> None:
    path = options.package
    if path.is_file() and (wrong := not_a("package", path)) is not None:
        raise RnaError(f"{path}: {wrong}")
    info = package_info(path)
    print(json.dumps(info, indent=2) if options.json else "\n".join(info_lines(info)))
    if options.poster is not None:
        _write_poster(path, options.poster)
    if options.glb is not None:
        check_glb_name(options.glb)
        check_outputs([options.glb], [path, *filter(None, [options.fallback])])
        write_glb(path, options.glb, options.fallback, options.node)
        print(f"wrote {options.glb}", file=sys.stderr)


def _write_poster(path: Path, png: Path) -> None:
    with Package.open(path) as package:
        poster = package.poster()
    if poster is None:
        raise RnaError(f"{path}: has no poster: rna-pack --poster adds one")
    check_outputs([png], [path])
    write_atomically(png, poster)
    print(f"wrote {png}", file=sys.stderr)


if __name__ == "__main__":
    sys.exit(main())
