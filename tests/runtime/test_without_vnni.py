"""int8 decoders on a CPU without VNNI, which onnxruntime is made to see."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

from tests.avx2.__main__ import avx2_environment
from tests.avx2.masked import missing

HERE = Path(__file__).parent

SATURATES = """
import numpy as np, onnxruntime as ort
from rna_sdk.runtime import onnx_bytes as pb
operands = ["q", "one", "zero", "weight", "one", "zero8", "one", "zero"]
node = pb.node("QLinearMatMul", operands, "y")
tensors = {"one": np.float32(1), "zero": np.uint8(0), "zero8": np.int8(0)}
tensors["weight"] = np.array([[127], [127], [-127], [-127]], np.int8)
fields = [pb.chunk(1, node), pb.chunk(2, b"g")]
fields += [pb.chunk(5, pb.tensor(name, np.asarray(value))) for name, value in tensors.items()]
fields += [pb.chunk(11, pb.value("q", ["N", 4], "uint8"))]
fields += [pb.chunk(12, pb.value("y", ["N", 1], "uint8"))]
model = pb.integer(1, 8) + pb.chunk(8, pb.opset("", 17)) + pb.chunk(7, b"".join(fields))
session = ort.InferenceSession(model, providers=["CPUExecutionProvider"])
q = np.array([[255, 255, 254, 255]] * 8, np.uint8)
print(session.run(None, {"q": q})[0].ravel())
"""
"""Prints the sum 127 in exact arithmetic: 64,770 - 64,643; saturated it is 0."""


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, str]:
    if reason := missing():
        pytest.skip(reason)
    return avx2_environment(tmp_path_factory.mktemp("avx2"))


def test_the_emulated_cpu_saturates(environment: Mapping[str, str]) -> None:
    command = [sys.executable, "-c", SATURATES]
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert "127" not in done.stdout and "0" in done.stdout, done.stdout + done.stderr


@pytest.mark.parametrize("file", ["test_saturation.py", "test_int8_decoder.py"])
def test_int8_is_exact(environment: Mapping[str, str], file: str) -> None:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(HERE / file)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
