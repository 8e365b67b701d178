"""`rna-bench readers` asks each case's own part, and its own decoder."""

from __future__ import annotations

import pytest

from rna_bench.readers.reader_agreement import asked
from rna_sdk.conformance.kit import EvaluateCase, find_kit, load_kit
from rna_sdk.conformance.program import Answer


class Asked(Exception):
    """Carries the arguments of the call."""


class Recorder:
    """A reader that answers nothing."""

    def run(self, *arguments: str) -> Answer:
        raise Asked(arguments)


@pytest.mark.parametrize("output", ["transport", "emission"])
def test_part_and_output_are_the_cases(output: str) -> None:
    cases: list[EvaluateCase] = [c for c in load_kit(find_kit()).evaluate if c.output == output]
    last = max(cases, key=lambda case: case.part)
    with pytest.raises(Asked) as call:
        asked(Recorder(), last)
    (arguments,) = call.value.args
    word = "evaluate" if output == "transport" else "emission"
    expected = [word, str(last.package), last.tier, str(last.part), str(last.queries)]
    assert list(arguments)[: len(expected)] == expected
    if output == "transport":
        assert last.part > 0
