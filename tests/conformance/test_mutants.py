"""Mutants of the hosts in Python: a few of what `python -m tests.conformance.mutants` tries."""

import json

import pytest

from tests.conformance.mutants import (
    CAUGHT,
    LEVELS,
    RECORD,
    Mutant,
    mutants,
    reason,
    source_of,
    verdict,
)


@pytest.fixture(scope="module")
def every():
    return [mutant for host in LEVELS for mutant in mutants(host)]


def test_all_are_on_record_and_caught_or_allowed(every):
    """Stale after a change of the host: run python -m tests.conformance.mutants."""
    record = json.loads(RECORD.read_text())
    assert list(record) == [mutant.name for mutant in every]
    assert all(record[m.name] in (CAUGHT, reason(m) or None) for m in every)


def test_there_are_many_and_they_differ(every):
    assert len(every) >= 100
    sources = {mutant.source for mutant in every}
    assert len(sources - set(map(source_of, LEVELS))) > 0.9 * len(every)


@pytest.mark.parametrize(
    "change",
    [
        "s_i + s_o -> s_i - s_o",
        "2 * p - 1 -> 2 * p + 1",
        "np.log2 -> np.log",
        "np.rint -> np.trunc",
        "n / 32767 -> n * 32767",
        "angle * turned -> angle / turned",
    ],
)
def test_a_change_is_caught(change, kit, every):
    mutant = next(mutant for mutant in every if mutant.name.endswith(change))
    assert verdict(mutant, kit) == CAUGHT


@pytest.mark.parametrize("host", LEVELS)
def test_a_host_itself_passes(host, kit):
    assert verdict(Mutant(host, "unchanged", source_of(host)), kit) == "passes"
