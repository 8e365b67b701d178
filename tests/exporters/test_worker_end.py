"""A Blender worker ends with the process that started it, also while Blender is still loading."""

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from rna_export.capture.blender_process.blender_process import _WORKER

LOADING = "import os, time\nprint(os.getpid(), flush=True)\ntime.sleep(60)\n"
PARENT = """
import os, subprocess, sys
command = [sys.executable, *sys.argv[1:], str(os.getpid())]
worker = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
print(worker.stdout.readline().decode(), flush=True)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="Linux alone tells a process of its parent")
def test_a_worker_ends_while_blender_loads(tmp_path):
    (tmp_path / "bpy.py").write_text(LOADING)
    command = [sys.executable, "-c", PARENT, _WORKER, "1"]
    done = subprocess.run(
        command, env={**os.environ, "PYTHONPATH": str(tmp_path)}, capture_output=True, timeout=60
    )
    end = time.monotonic() + 10
    while _runs(int(done.stdout)):
        assert time.monotonic() < end
        time.sleep(0.05)


def _runs(process: int) -> bool:
    """Whether there is such a process that is no zombie: proc(5)."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False
