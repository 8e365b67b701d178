"""int8 decoders on a CPU without VNNI, which onnxruntime is made to see."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.avx2.__main__ import avx2_environment
from tests.avx2.masked import missing

HERE = Path(__file__).parent


@pytest.fixture(scope="module")
def environment(tmp_path_factory):
    if reason := missing():
        pytest.skip(reason)
    return avx2_environment(tmp_path_factory.mktemp("avx2"))


def test_the_emulated_cpu_saturates(environment):
    code = "from tests.avx2.saturating import sums_in_16_bits; print(sums_in_16_bits())"
    command = [sys.executable, "-c", code]
    root = HERE.parents[1]
    done = subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True)
    assert done.stdout == "True\n", done.stdout + done.stderr


def test_int8_is_exact(environment):
    files = [str(HERE / name) for name in ("test_saturation.py", "test_int8_decoder.py")]
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *files]
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
