"""A Ray cluster of three nodes on this machine; its tests are skipped where Ray is missing."""

import importlib.util
import os
import warnings
from typing import Any

import pytest

MISSING = "ray is not installed: pip install -e '.[cluster]'"


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    if importlib.util.find_spec("ray") is None:
        for item in items:
            if {"cluster", "ray_address"} & set(getattr(item, "fixturenames", ())):
                item.add_marker(pytest.mark.skip(reason=MISSING))


def start_cluster() -> Any:
    """A cluster of three nodes of one core each on this machine, of which the first is the head."""
    os.environ["RAY_USAGE_STATS_ENABLED"] = "0"
    os.environ["RAY_worker_niceness"] = "0"  # else 15: a busy machine would leave them nothing
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # Ray's own, of its future versions
        from ray.cluster_utils import Cluster

        cluster = Cluster(
            initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False}
        )
        for _ in range(2):
            cluster.add_node(num_cpus=1)
    return cluster


@pytest.fixture(scope="module")
def cluster():
    """Three nodes of one core each."""
    made = start_cluster()
    yield made
    made.shutdown()


@pytest.fixture(scope="module")
def ray_address(cluster):
    return cluster.address
