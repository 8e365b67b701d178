"""`rna-bench NAME`: all benchmarks of the project as one command."""

import argparse
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

from rna_bench.bench_options import OptionHelp
from rna_bench.commands import COMMANDS, Command
from rna_bench.stamp import stamp
from rna_sdk.commands.command_parser import CommandParser
from rna_sdk.commands.console import command_parser, run_command, split_script_arguments
from rna_sdk.files.outputs import check_no_input

_EXAMPLE = "rna-bench scenes toy.rna --source toy.py --out bench/toy"


def parser() -> argparse.ArgumentParser:
    """The parser of the name alone; its help lists all commands."""
    width = max(map(len, COMMANDS))
    listed = "".join(f"  {c.name:{width}}  {c.sentence}\n" for c in COMMANDS.values())
    p = command_parser(
        "rna-bench",
        "Benchmark assets and the SDK; each NAME is one benchmark.",
        _EXAMPLE,
        epilog=f"benchmarks:\n{listed}\nrna-bench NAME --help shows the options of a command.",
    )
    p.add_argument("name", metavar="NAME", choices=COMMANDS, help="benchmark, see below")
    return p


def parser_of(command: Command) -> argparse.ArgumentParser:
    """The parser of one command's own arguments; imports its module."""
    module = import_module(f"rna_bench.{command.module}")
    p = CommandParser(
        prog=f"rna-bench {command.name}",
        description=(module.__doc__ or "").replace("%", "%%"),
        formatter_class=OptionHelp,
    )
    module.add_options(p)
    p.set_defaults(run=module.run)
    return p


def main(argv: Sequence[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    given = list(sys.argv[1:] if argv is None else argv)
    command = COMMANDS[parser().parse_args(given[:1]).name]
    command_line, script_arguments = split_script_arguments(given[1:])

    def measure() -> int | None:
        args = parser_of(command).parse_args(command_line)
        _check_out(args)
        args.script_arguments, args.stamp = script_arguments, stamp(given)
        return args.run(args)

    note = "finished steps are not repeated: run the same command again to resume"
    stopped = note if command.resumes else "nothing was written"
    return run_command(measure, "--debug" in command_line, stopped, "bench")


def _check_out(args: argparse.Namespace) -> None:
    """Raises RnaError where --out would replace a file that the command reads."""
    given = vars(args).copy()
    out = given.pop("out", None)
    values = (
        v for value in given.values() for v in (value if isinstance(value, list) else [value])
    )
    if isinstance(out, Path):
        check_no_input(out, [value for value in values if isinstance(value, Path)])


if __name__ == "__main__":
    sys.exit(main())
