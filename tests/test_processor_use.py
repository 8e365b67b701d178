"""One thread takes one core: no pool of a library is as large as the machine."""

import os
from runpy import run_path

import pytest

from tests.conftest import REPOSITORY

pytestmark = pytest.mark.skipif(
    len(os.sched_getaffinity(0)) < 2, reason="on one core nothing can take a second one"
)


def test_workers_that_start_together_import_blender_on_different_cores():
    """On one core sixteen of them took 40 s."""
    few_cores = REPOSITORY / "exporters" / "rna_export" / "blender" / "few_cores.py"
    chosen = run_path(str(few_cores))["chosen"]
    taken = [chosen({0, 2, 4, 6}, 1, number) for number in range(1001, 1005)]
    assert set().union(*taken) == {0, 2, 4, 6}
    assert chosen({0, 2, 4, 6}, 3, 3) == {6, 0, 2}
    assert chosen({5}, 2, 7) == {5}


@pytest.mark.blender
def test_a_worker_has_all_cores_once_its_pools_are_small(tmp_path):
    """Bound to one for good, the first workers of two commands would share it."""
    from rna_export.capture.blender_process.blender_env import find_python
    from rna_export.capture.blender_process.blender_process import Source
    from rna_export.capture.blender_process.blender_worker import BlenderWorker

    source = Source(REPOSITORY / "examples" / "quickstart" / "toy.py")
    with BlenderWorker(find_python(), source, tmp_path, threads=1) as worker:
        assert worker.render_card() > 0.0
        assert worker._process is not None
        for thread in os.listdir(f"/proc/{worker._process.pid}/task"):
            assert os.sched_getaffinity(int(thread)) == os.sched_getaffinity(0)
