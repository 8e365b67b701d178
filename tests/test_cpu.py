"""How many cores there are: of the affinity, and of the quotas of control groups."""

import math
import os
from pathlib import Path

import pytest

from rna_sdk.machine import cores as cores_module
from rna_sdk.machine.cores import core_count
from rna_sdk.machine.cpu import thread_count


def written(root: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return root


V1 = "12:cpuset:/docker/abc\n4:cpu,cpuacct:/docker/abc\n1:name=systemd:/docker/abc\n"
GROUPS: dict[str, tuple[dict[str, str], float]] = {
    "none": ({}, math.inf),
    "version 2 without limit": (
        {"proc/self/cgroup": "0::/a\n", "sys/fs/cgroup/a/cpu.max": "max 100000\n"},
        math.inf,
    ),
    "version 2": (
        {"proc/self/cgroup": "0::/a/b\n", "sys/fs/cgroup/a/b/cpu.max": "150000 100000\n"},
        1.5,
    ),
    "version 2, of the group outside": (
        {
            "proc/self/cgroup": "0::/a/b\n",
            "sys/fs/cgroup/a/cpu.max": "200000 100000\n",
            "sys/fs/cgroup/a/b/cpu.max": "max 100000\n",
        },
        2.0,
    ),
    "version 2, as a container sees it": (
        {"proc/self/cgroup": "0::/\n", "sys/fs/cgroup/cpu.max": "400000 100000\n"},
        4.0,
    ),
    "version 1": (
        {
            "proc/self/cgroup": V1,
            "sys/fs/cgroup/cpu,cpuacct/docker/abc/cpu.cfs_quota_us": "50000\n",
            "sys/fs/cgroup/cpu,cpuacct/docker/abc/cpu.cfs_period_us": "100000\n",
        },
        0.5,
    ),
    "version 1, told the path outside": (
        {
            "proc/self/cgroup": V1,
            "sys/fs/cgroup/cpu/cpu.cfs_quota_us": "300000\n",
            "sys/fs/cgroup/cpu/cpu.cfs_period_us": "100000\n",
        },
        3.0,
    ),
    "version 1 without limit": (
        {
            "proc/self/cgroup": V1,
            "sys/fs/cgroup/cpu/cpu.cfs_quota_us": "-1\n",
            "sys/fs/cgroup/cpu/cpu.cfs_period_us": "100000\n",
        },
        math.inf,
    ),
    "of another form": (
        {"proc/self/cgroup": "0::/\n", "sys/fs/cgroup/cpu.max": "a lot\n"},
        math.inf,
    ),
}


@pytest.mark.parametrize("case", GROUPS)
def test_the_quota_is_found(case, tmp_path):
    files, expected = GROUPS[case]
    assert cores_module._quota(written(tmp_path, files)) == expected


@pytest.mark.parametrize(("quota", "cores"), [(math.inf, 8), (3.0, 3), (1.5, 2), (0.2, 1), (99, 8)])
def test_the_lesser_of_affinity_and_quota_counts(monkeypatch, quota, cores):
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: set(range(8)))
    monkeypatch.setattr(cores_module, "_quota", lambda _: quota)
    assert core_count() == thread_count(None) == cores
    assert thread_count(5) == 5
