"""Cycles on the chart: which sample counts it is rendered with."""

from rna_bench.frontier.cycles_curve import _doubling


def counts(seconds_a_path: float, allowed: float, reference: int) -> list[int]:
    taken: dict[int, float] = {}
    for samples in _doubling(taken, allowed, reference):
        taken[samples] = samples * seconds_a_path
    return list(taken)


def test_counts_double_while_there_is_time():
    assert counts(1.0, 31.0, 10_000) == [1, 2, 4, 8, 16]
    assert counts(1.0, 30.0, 10_000) == [1, 2, 4, 8]


def test_a_line_needs_three():
    assert counts(100.0, 1.0, 8) == [1, 2, 4]


def test_counts_stay_well_below_the_references():
    assert counts(1e-6, 60.0, 256) == [1, 2, 4, 8, 16, 32, 64]
