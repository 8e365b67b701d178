"""`rna-info`: facts of a package."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_sdk.commands.console import command_parser, run_command
from rna_sdk.errors import RnaError
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.files.file_kinds import not_a
from rna_sdk.files.outputs import check_outputs
from rna_sdk.package.command.package_info import info_lines, package_info
from rna_sdk.package.geometry.standin_glb import standin_glb
from rna_sdk.package.manifest.extensions import Standin, of_part
from rna_sdk.package.package import Package


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status."""
    options = parser().parse_args(arguments)
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
        help="write the geometry with its stand-in materials as glTF (.glb) for other viewers;\n"
        "strands become at most 300,000 triangles (path, default: none)",
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
        check_outputs([options.glb], [path])
        with Package.open(path) as package:
            write_atomically(options.glb, standin_glb(package, _colors(path, package)))
        print(f"wrote {options.glb}", file=sys.stderr)


def _colors(path: Path, package: Package) -> dict[int, np.ndarray]:
    """Reflectance of the first tier at vertices of surfaces that are not metal, by part."""
    from rna_sdk.runtime import load  # slow to import
    from rna_sdk.runtime.standin_colors import surface_colors

    colors = {}
    for i, part in enumerate(load(path).parts):
        standin = of_part(package.manifest, Standin, i)
        if part.kind == "surface" and not (standin and standin.metallic):
            colors[i] = np.minimum(surface_colors(part), 1)
    return colors


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
