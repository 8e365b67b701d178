"""`rna-bench`: the chart of speed against accuracy, and the suite of known failures."""

from __future__ import annotations

import argparse
import sys

from rna_bench.frontier import cli as frontier
from rna_bench.stability import cli as stability
from rna_sdk.console import command_parser, run_command

_COMMANDS = (frontier, stability)
"""Modules with NAME, SENTENCE, EXAMPLE, WHEN_STOPPED, add_options(parser) and run(args)."""


def parser() -> argparse.ArgumentParser:
    """The options of `rna-bench` and of its commands."""
    p = command_parser(
        "rna-bench",
        "Measure models of one asset: speed against accuracy, and where the method breaks.",
        frontier.EXAMPLE,
        epilog="rna-bench COMMAND --help shows the options of a command.",
    )
    commands = p.add_subparsers(required=True, metavar="COMMAND")
    for module in _COMMANDS:
        command = commands.add_parser(
            module.NAME,
            help=module.SENTENCE,
            description=f"{module.SENTENCE}\n\n  {module.EXAMPLE}",
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        module.add_options(command)
        command.add_argument(
            "--debug", action="store_true", help="show the traceback of an error (default: off)"
        )
        command.set_defaults(module=module)
    return p


def main(argv: list[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    args = parser().parse_args(argv)
    module = args.module
    return run_command(lambda: module.run(args), args.debug, module.WHEN_STOPPED, "bench")


if __name__ == "__main__":
    sys.exit(main())
