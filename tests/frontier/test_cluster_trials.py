"""Trials on a cluster of three nodes: the same bits as on one machine; workers that share a GPU."""

import time
from importlib.util import find_spec
from pathlib import Path

import pytest

from rna_bench.frontier.trials.trial import Trial
from rna_bench.frontier.trials.trial_pool import TrialPool, TrialWorkers
from rna_work.executors import open_executor
from tests.exporters.synthetic import make_dataset, tiny
from tests.work.conftest import MISSING, cluster, ray_address

pytestmark = [
    pytest.mark.filterwarnings("ignore"),  # Ray's own, of its future versions
    pytest.mark.skipif(find_spec("ray") is None, reason=MISSING),
]
__all__ = ["cluster", "ray_address"]


def test_a_training_has_the_same_bits(ray_address, tmp_path):
    dataset = make_dataset(tmp_path / "ball.rays")
    trial = Trial(name="tiny", family="ours", preset=tiny(steps=12), seed=1)

    def points(workers: TrialWorkers, folder: Path) -> dict[str, object]:
        with TrialPool(dataset.folder, workers) as pool:
            (record,) = pool.run([(trial, folder)])
        return record.points

    with open_executor(None) as here:
        expected = points(TrialWorkers(1, 1, "cpu", here), tmp_path / "a")
    with open_executor(ray_address) as there:
        assert points(TrialWorkers(None, 1, "cpu", there), tmp_path / "b") == expected
    packages = [(tmp_path / name / "int8-int8.rna").read_bytes() for name in "ab"]
    assert packages[0] == packages[1]


def test_workers_share_a_gpu(cluster, ray_address):
    node = cluster.add_node(num_cpus=2, num_gpus=1)
    try:
        with open_executor(ray_address) as executor:
            while not executor.gpus():
                time.sleep(0.1)
            whole = TrialWorkers.usual("cuda", None, executor)
            assert whole.device == "cuda" and whole.backend().options()["num_gpus"] == 1.0
            assert TrialWorkers.usual("cuda", 4, executor).backend().options()["num_gpus"] == 0.25
    finally:
        cluster.remove_node(node)
