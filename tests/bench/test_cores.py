"""`rna-bench cores`, and with it: one thread of whatever it measures takes one core."""

import os

import pytest

from rna_bench.speed.cores import measure

MOST = 1.1  # processor seconds a second

pytestmark = pytest.mark.skipif(
    len(os.sched_getaffinity(0)) < 2, reason="on one core nothing can take a second one"
)


@pytest.mark.parametrize(
    "work",
    ["trainer", "rna-run", "evaluate", "lobes", pytest.param("capture", marks=pytest.mark.blender)],
)
def test_one_thread_takes_one_core(work):
    (row,) = measure(work, [1], [], 2.0)["threads"]
    assert row["cores_a_thread"] <= MOST
