"""Options of commands that write a package: name, credit, and the form `environment`."""

import unicodedata
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from pathlib import Path

MINUTES = 5.0
_SHARE = 0.25  # of the minutes that a command has in all
_NO_TEXT = ("Cc", "Cs", "Zl", "Zp")  # Unicode's categories: controls, half pairs, ends of lines


def asset_name(text: str) -> str:
    """A name for people, as an argument. Raises ArgumentTypeError unless it is one line of text."""
    if not text or any(unicodedata.category(c) in _NO_TEXT for c in text):
        raise ArgumentTypeError(f"expected a line of text, found {text!r}")
    return text


def add_credit(p: ArgumentParser) -> None:
    """Add --name, --source and --license."""
    p.add_argument(
        "--name",
        type=asset_name,
        help="name of the asset (text, default: file name of the source without its suffix)",
    )
    p.add_argument(
        "--source",
        help="credit of the original model: name, author, URL (text, default: file name and "
        "SHA-256)",
    )
    p.add_argument(
        "--license",
        default="NOASSERTION",
        help="SPDX license expression of the asset (text, default: %(default)s)",
    )


def add_environment(p: ArgumentParser) -> None:
    """Add --environment, --environment-minutes and --environment-files."""
    p.add_argument(
        "--environment",
        action="store_true",
        help="add lobes: one query estimates the light of a whole environment map, for the first "
        "image in viewers; trained from the package itself (default: off)",
    )
    p.add_argument(
        "--environment-minutes",
        type=float,
        default=MINUTES,
        metavar="MINUTES",
        help="time limit for training and measuring the lobes (float, default: %(default)g)",
    )
    p.add_argument(
        "--environment-files",
        nargs="+",
        type=Path,
        default=[],
        metavar="HDR",
        help="environment maps under which the error of the lobes is measured, besides two "
        "generated ones (paths to .hdr or .exr, default: none)",
    )


def check_environment(args: Namespace, options: ArgumentParser) -> None:
    """Exits with an error of usage where the options do not belong together."""
    if not 0.0 < args.environment_minutes < float("inf"):
        found = f"expected a number above 0, found {args.environment_minutes:g}"
        options.error(f"argument --environment-minutes: {found}")
    if args.environment_files and not args.environment:
        options.error("--environment-files: expected --environment as well")


def lobe_minutes(args: Namespace) -> float:
    """Limit of the lobes' training and measurement, of `rna-make`; 0 for none."""
    if not args.environment:
        return 0.0
    whole = args.minutes or args.more or float("inf")
    return float(min(args.environment_minutes, _SHARE * whole))
