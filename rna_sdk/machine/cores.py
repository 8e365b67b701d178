"""The cores that this process may use."""

import math
import os
from collections.abc import Iterator
from pathlib import Path


def core_count() -> int:
    """Number of cores that this process may use, at least 1.

    The lesser of its affinity and the processor time that its control groups, such as those of a
    container, are given a second, rounded up. Where a system tells neither: all cores.
    """
    affinity = getattr(os, "sched_getaffinity", None)  # Linux alone has it
    cores = len(affinity(0)) if affinity else os.cpu_count() or 1
    return max(1, math.ceil(min(cores, _quota(Path("/")))))


def _quota(root: Path) -> float:
    """Cores' worth of time that the control groups of this process have; infinite without limit.

    root: of the file system. A group has at most what the groups have that it is in: Linux'
    Documentation/admin-guide/cgroup-v2.rst, cgroup-v1/; scheduler/sched-bwc.rst.
    """
    try:
        lines = (root / "proc/self/cgroup").read_text().splitlines()
    except OSError:
        return math.inf
    quota = math.inf
    for line in lines:  # number:controllers:path; version 2 has no controllers
        _, controllers, path = line.split(":", 2)
        if controllers and "cpu" not in controllers.split(","):
            continue
        mounts = [controllers, "cpu"] if controllers else ["", "unified"]
        for mount in mounts:
            top = root / "sys/fs/cgroup" / mount
            # A container may see its own group at the top, and be told the path outside.
            group = top / path.lstrip("/")
            for folder in (group, *group.parents):
                if folder.is_relative_to(top):
                    quota = min(quota, *_limits(folder))
    return quota


def _limits(group: Path) -> Iterator[float]:
    """Limits of a control group of version 2 and of version 1, in cores."""
    yield math.inf
    for names in (("cpu.max",), ("cpu.cfs_quota_us", "cpu.cfs_period_us")):
        try:
            quota, period = " ".join((group / name).read_text() for name in names).split()
            if quota not in ("max", "-1"):
                yield float(quota) / float(period)
        except (OSError, ValueError):
            pass  # no such file, or one of another form: no limit that is known
