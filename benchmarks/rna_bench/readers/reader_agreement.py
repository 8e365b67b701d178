"""Differences between readers, and from the conformance kit's expected values.

    make -C examples/hosts/c
    rna-bench readers runtime="python -m rna_render.conformance_reader" \\
        twin="python -m rna_sdk.conformance.twin_reader" c=examples/hosts/c/build/conform \\
        minimal="python examples/hosts/minimal.py" --out benchmarks/results/readers.json

Differences are absolute, the largest of all rows of float32 tiers; rows of int8 tiers, where a sum
may round either way, stand apart. `in_tolerances` is against the expected values, in each row's own
tolerance.
"""

from __future__ import annotations

import argparse
import shlex
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_bench.bench_options import add_out
from rna_bench.results import publish
from rna_sdk.conformance.kit import EvaluateCase, Kit, find_kit, load_kit
from rna_sdk.conformance.program import Command, Program, evaluate
from rna_sdk.package.decoder.decoder_form import form_named

Answers = list[NDArray[np.float64]]


def run(args: argparse.Namespace) -> None:
    kit = load_kit(find_kit())
    answers: dict[str, Answers] = {"expected": [case.expected for case in kit.evaluate]}
    for name, command in (reader.split("=", 1) for reader in args.readers):
        program = Command(tuple(shlex.split(command)), timeout=300.0)
        answers[name] = [asked(program, case) for case in kit.evaluate]
    report = {
        "rows": sum(len(case.expected) for case in kit.evaluate),
        "in_tolerances": {
            name: in_tolerances(kit, found) for name, found in answers.items() if name != "expected"
        },
        "pairs": {
            f"{a}, {b}": between(kit, answers[a], answers[b]) for a, b in combinations(answers, 2)
        },
    }
    publish(report, args)


def asked(program: Program, case: EvaluateCase) -> NDArray[np.float64]:
    """The reader's results for the case's queries."""
    form = form_named(case.output)
    width = case.expected.shape[1]
    return evaluate(program, form, width, case.package, case.tier, case.part, case.queries)


def in_tolerances(kit: Kit, found: Answers) -> float:
    """The largest difference from the expected values, of tiers in float32."""
    worst = 0.0
    for case, rows in zip(kit.evaluate, found, strict=True):
        if case.step == 0:
            judged = case.tolerance > 0
            units = np.abs(rows - case.expected)[judged] / case.tolerance[judged]
            worst = max(worst, float(units.max()))
    return round(worst, 4)


def between(kit: Kit, a: Answers, b: Answers) -> dict[str, Any]:
    """The largest differences of two readers, with where they are."""
    result: dict[str, Any] = {}
    for precision, is_int8 in (("float32", False), ("int8", True)):
        largest = [
            (float(np.abs(x - y).max()), f"{case.package.stem}, {case.tier}")
            for case, x, y in zip(kit.evaluate, a, b, strict=True)
            if (case.step > 0) == is_int8
        ]
        difference, where = max(largest)
        result[precision] = {"largest": float(f"{difference:.3g}"), "where": where}
    return result


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("readers", nargs="+", metavar="NAME=COMMAND", help="reader programs")
    add_out(parser)
