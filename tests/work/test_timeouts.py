"""When an item counts as hanging, and whose processor time is counted."""

import subprocess
import sys
import threading
import time

import pytest

from rna_work.processor_time import process_seconds, thread_seconds
from rna_work.timeouts import Timeouts, Watch

linux = pytest.mark.skipif(sys.platform != "linux", reason="no /proc")


def timeouts() -> Timeouts:
    """Time-outs of a capture whose items took 40 s, also of the processor."""
    actual = Timeouts()
    for _ in range(5):
        actual.learn("shard", 40.0, 40.0)
    return actual


def faults(rate: float, seconds: int, stuck_at: float = 1e9) -> list[tuple[int, str]]:
    """When an item that gets this share of a core is at fault, looked at each second."""
    watch, learned = Watch(0.0, 100.0), timeouts()
    for now in range(seconds):
        reason = watch.fault(learned, "shard", float(now), 100.0 + rate * min(now, stuck_at))
        if reason:
            return [(now, reason)]
    return []


def test_a_worker_that_uses_the_processor_is_not_hung():
    assert faults(rate=0.02, seconds=10_000) == []  # fifty programs on its core


def test_a_worker_that_does_nothing_is_hung_after_ten_times_as_long():
    [(when, reason)] = faults(rate=0.0, seconds=1000)
    assert when == 401 and "the last 401 s without use of the processor" in reason


def test_a_worker_that_stops_in_the_middle_is_found():
    [(when, _)] = faults(rate=0.5, seconds=3000, stuck_at=300)
    assert 700 < when <= 900


def test_a_worker_in_circles_is_ended_by_its_processor_time():
    [(when, reason)] = faults(rate=1.0, seconds=1000)
    assert when == 401 and "401 s of processor time, expected within 400 s" in reason


def test_without_processor_time_the_clock_decides():
    watch, learned = Watch(0.0, None), timeouts()
    assert not watch.fault(learned, "shard", 399.0, None)
    assert "expected within 400 s" in watch.fault(learned, "shard", 401.0, None)


@linux
def test_processor_time_of_a_process_counts_its_children():
    spin = "import time\nwhile time.process_time() < 0.3: pass\n"
    nested = f"import subprocess, sys, time; subprocess.run([sys.executable, '-c', {spin!r}])"
    waits = spin + "import sys; sys.stdin.read()"
    living = f"{nested}; subprocess.run([sys.executable, '-c', {waits!r}])"
    command = [sys.executable, "-c", living]
    with subprocess.Popen(command, stdin=subprocess.PIPE) as process:
        try:
            until = time.monotonic() + 60.0
            while (process_seconds(process.pid) or 0.0) < 0.5:  # one that ended, one that lives
                assert time.monotonic() < until
                time.sleep(0.02)
        finally:
            process.kill()
    assert process_seconds(process.pid) is None


@linux
def test_processor_time_of_a_thread_is_its_own():
    before = thread_seconds(threading.get_native_id())
    until = time.thread_time() + 0.1
    while time.thread_time() < until:
        pass
    after = thread_seconds(threading.get_native_id())
    assert before is not None and after is not None and after - before >= 0.08
    assert thread_seconds(2**22 + 1) is None
