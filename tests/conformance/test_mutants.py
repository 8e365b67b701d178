"""Mutants of the minimal host: a few of those that `python -m tests.conformance.mutants` tries."""

from __future__ import annotations

import json

import pytest

from rna_sdk.conformance.kit import Kit
from tests.conformance.mutants import CAUGHT, HOST, RECORD, Mutant, mutants, reason, verdict

ALL = mutants(HOST.read_text())


def test_all_are_on_record_and_caught_or_allowed() -> None:
    """Stale after a change of the host: run python -m tests.conformance.mutants."""
    record = json.loads(RECORD.read_text())
    assert list(record) == [mutant.name for mutant in ALL]
    assert all(record[m.name] in (CAUGHT, reason(m) or None) for m in ALL)


def test_there_are_many_and_they_differ() -> None:
    assert len(ALL) >= 100
    assert len({mutant.source for mutant in ALL} | {HOST.read_text()}) > 0.9 * len(ALL)


@pytest.mark.parametrize(
    "change",
    [
        "s_i + s_o -> s_i - s_o",
        "2 * p - 1 -> 2 * p + 1",
        "np.log2 -> np.log",
        "np.rint -> np.trunc",
    ],
)
def test_a_change_is_caught(change: str, kit: Kit) -> None:
    mutant = next(mutant for mutant in ALL if mutant.name.endswith(change))
    assert verdict(mutant, kit) == CAUGHT


def test_the_host_itself_passes(kit: Kit) -> None:
    assert verdict(Mutant("unchanged", HOST.read_text()), kit) == "passes"
