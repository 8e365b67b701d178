"""`rna-conform`: run a reader on the conformance kit and print the verdict of each level."""

import argparse
import json
import math
import sys
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict
from pathlib import Path

from rna_sdk.commands.console import command_parser, run_command, split_script_arguments
from rna_sdk.conformance.kit import LEVELS, Kit, find_kit, load_kit
from rna_sdk.conformance.program import Command, Program, claimed_levels
from rna_sdk.conformance.scoring import Score, cases, score
from rna_sdk.errors import ConformanceError
from rna_sdk.machine.cores import core_count

MEASURED = ("evaluate", "environment", "normals", "base-color", "geometry", "deformed")
"""Levels whose rows have tolerances of their own."""
_TABLE = "{:<10} {:<24} {:<18} {:>5} {:>6}  {:>10} {:>9}  {}"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command. Returns 0 when every level that was run passes, 1 when one does not."""
    command_line, words = split_script_arguments(arguments)
    parser = _parser()
    options = parser.parse_args(command_line)
    if not words:
        parser.error("no COMMAND; give it after --, as in: rna-conform -- ./my-reader")
    return run_command(lambda: _run(options, words), options.debug, "no verdict")


def _run(options: argparse.Namespace, words: tuple[str, ...]) -> int:
    program = Command(words, options.timeout)
    kit = load_kit(Path(options.kit) if options.kit else find_kit())
    levels = claimed_levels(program)
    missing = [level for level in options.level or () if level not in levels]
    if missing:
        raise ConformanceError(f"--level {missing[0]}: the reader only claims {', '.join(levels)}")
    running = run_levels(program, kit, options.level or levels, core_count())
    if options.json:
        scores = list(running)
        print(json.dumps([_as_json(one) for one in scores], indent=2))
    else:
        scores = print_table(running)
    return 0 if all(one.passed for one in scores) else 1


def _parser() -> argparse.ArgumentParser:
    parser = command_parser(
        "rna-conform",
        "Run an .rna reader on the conformance kit and print a table of results.",
        "rna-conform -- ./my-reader",
        usage="rna-conform [options] -- COMMAND...",
        epilog="Protocol of COMMAND: spec/conformance/README.md. Exit status: 0 all claimed levels "
        "pass,\n1 any fails, 2 bad usage.",
    )
    parser.add_argument(
        "--kit",
        metavar="PATH",
        help="conformance kit (path, default: spec/conformance of the checkout)",
    )
    parser.add_argument(
        "--level",
        action="append",
        choices=LEVELS,
        help="run only this level; may be repeated (default: every level the reader claims)",
    )
    parser.add_argument(
        "--timeout",
        type=float,
        default=300.0,
        metavar="S",
        help="time limit per run of COMMAND, seconds (float, default: 300)",
    )
    parser.add_argument("--json", action="store_true", help="print JSON (default: a table)")
    return parser


def run_levels(program: Program, kit: Kit, levels: Sequence[str], jobs: int = 1) -> Iterator[Score]:
    """The scores of all cases of these levels, in the order of the kit, as they come."""
    every = [case for level in LEVELS if level in levels for case in cases(kit, level)]
    pool = ThreadPoolExecutor(jobs)
    try:
        yield from pool.map(lambda case: score(program, kit, case), every)
    finally:
        pool.shutdown(cancel_futures=True)


def print_table(scores: Iterable[Score]) -> list[Score]:
    """A line a case (of the level `validate`, for failures alone), and the verdict a level.

    Returns the scores.
    """
    print(_TABLE.format("level", "package", "tier", "rows", "right", "tolerances", "absolute", ""))
    printed = []
    for one in scores:
        printed.append(one)
        if one.level != "validate" or not one.passed:
            print(_line(one), flush=True)
    print()
    for level in LEVELS:
        rows = [one for one in printed if one.level == level]
        if rows:
            passed = sum(one.passed for one in rows)
            verdict = "pass" if passed == len(rows) else "FAIL"
            largest = max(one.in_tolerances for one in rows)
            tail = f", largest difference {largest:.3g} tolerances" if level in MEASURED else ""
            print(f"{level}: {verdict}, {passed} of {len(rows)} cases{tail}")
    return printed


def _line(one: Score) -> str:
    measured = one.level in MEASURED and one.in_tolerances > 0
    numbers = [f"{one.in_tolerances:.3g}", f"{one.absolute:.2g}"] if measured else ["", ""]
    verdict = ": ".join(filter(None, ("pass" if one.passed else "FAIL", one.note)))
    return _TABLE.format(one.level, one.package, one.tier, one.rows, one.right, *numbers, verdict)


def _as_json(one: Score) -> dict[str, object]:
    """JSON has no infinity: null stands for it."""
    fields = asdict(one)
    return {
        key: None if isinstance(value, float) and not math.isfinite(value) else value
        for key, value in fields.items()
    }


if __name__ == "__main__":
    sys.exit(main())
