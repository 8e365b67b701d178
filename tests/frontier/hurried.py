"""Quick trials, where no test looks at how long they take."""

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from tests.exporters.synthetic import hurried_packages


@contextmanager
def hurried_trials() -> Iterator[None]:
    """Little tuning of int8 decoders and short timings."""
    with hurried_packages(), pytest.MonkeyPatch.context() as patch:
        patch.setattr("rna_bench.frontier.trials.cost._SECONDS", 0.005)
        patch.setattr("rna_bench.frontier.trials.cost._FEWEST", 1024)
        yield
