"""`rna-pack`: writes a package again, its entries coded or plain, with a poster."""

import argparse
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from rna_sdk.commands.console import command_line, command_parser, run_command
from rna_sdk.errors import PackageError, RnaError
from rna_sdk.files.outputs import check_outputs
from rna_sdk.files.regular_file import read_regular
from rna_sdk.package.container.zip_container import MANIFEST_NAME
from rna_sdk.package.container.zip_writer import write_container
from rna_sdk.package.container.zipped_again import zipped_entries
from rna_sdk.package.gltf.glb_file import package_to_write
from rna_sdk.package.packing import Unpacked


def parser() -> argparse.ArgumentParser:
    """The options of `rna-pack`."""
    p = command_parser(
        "rna-pack",
        "Repack a package losslessly: compress it, uncompress it, or replace its poster image.",
        "rna-pack toy.rna --out toy-small.rna --deflate",
        epilog="Without --deflate all entries are stored uncompressed, which every reader "
        "supports.\nA package that a ZIP program has rewritten is repaired.",
    )
    p.add_argument("package", type=Path, help="input package (path)")
    p.add_argument(
        "--out",
        type=Path,
        required=True,
        help="output package, .rna, or .glb with a fallback for viewers that do not know RNA\n"
        "(path, required)",
    )
    p.add_argument(
        "--deflate",
        action="store_true",
        help="compress entries losslessly with the extension RNA_deflate; readers without it "
        "reject the package (default: off)",
    )
    p.add_argument(
        "--poster",
        type=Path,
        metavar="PNG",
        help="poster image of the asset (path, default: unchanged)",
    )
    return p


def main(argv: list[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    args = parser().parse_args(argv)
    return run_command(lambda: _run(args), args.debug, "nothing was written")


def _run(args: argparse.Namespace) -> None:
    given = [args.package] if args.poster is None else [args.package, args.poster]
    check_outputs([args.out], given)
    unpacked = _unpacked(args.package)
    if args.poster is not None:
        unpacked = unpacked.with_poster(_read(args.poster))
    before = args.package.stat().st_size
    with package_to_write(args.out) as package:
        (unpacked.deflated() if args.deflate else unpacked).write(package)
    size = args.out.stat().st_size
    print(
        f"wrote {args.out}, {size / 1e6:.2f} MB ({args.package}: {before / 1e6:.2f} MB)\n"
        f"next: {command_line('rna-validate', args.out)}"
    )


def _unpacked(path: Path) -> Unpacked:
    """The package; a ZIP program's copy is repaired."""
    try:
        return Unpacked.read(path)
    except PackageError:
        if (entries := zipped_entries(path, MANIFEST_NAME)) is None:
            raise
    with TemporaryDirectory() as folder:
        repaired = Path(folder) / path.name
        with repaired.open("wb") as file:
            write_container(file, entries)
        return Unpacked.read(repaired)


def _read(path: Path) -> bytes:
    try:
        return read_regular(path)
    except OSError as error:
        raise RnaError(f"{path}: found {error.strerror}, expected a PNG (--poster)") from error


if __name__ == "__main__":
    sys.exit(main())
