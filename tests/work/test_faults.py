"""One run with each fault on a cluster; `python -m tests.work.faults` makes more of them."""

import random

import pytest

from tests.work.faults import FAULTS, one_run

pytestmark = pytest.mark.filterwarnings("ignore")  # Ray's own, of its future versions


@pytest.mark.parametrize("fault", FAULTS)
def test_nothing_is_lost_or_made_twice(cluster, fault, tmp_path):
    one_run(cluster, fault, random.Random(fault), tmp_path)
