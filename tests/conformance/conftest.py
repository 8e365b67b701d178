"""The kit, and readers to run on it within this process."""

import contextlib
import importlib.util
import io
from collections.abc import Callable
from dataclasses import dataclass, fields
from types import ModuleType

import numpy as np
import pytest

from rna_sdk.conformance.kit import load_kit
from rna_sdk.conformance.program import Answer
from rna_sdk.conformance.reader_program import Deformed, Environment, Evaluate, Geometry, run_reader
from tests.conftest import REPOSITORY

KIT = REPOSITORY / "spec" / "conformance"
HOSTS = REPOSITORY / "examples" / "hosts"
MINIMAL = HOSTS / "minimal.py"


@pytest.fixture(scope="session")
def kit():
    return load_kit(KIT)


@pytest.fixture(scope="session")
def minimal():
    """The minimal host as a module."""
    return host_module("minimal")


@pytest.fixture
def deformed_host():
    """The host of deformed shapes as a module of its own, to be changed."""
    return host_module("deformed")


def host_module(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"{name}_host", HOSTS / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def with_geometry(host: ModuleType) -> "InProcess":
    """The host of deformed shapes, or a changed one, as a reader."""

    def geometry(package: str, part: int) -> np.ndarray:
        return np.float32(host.geometry(package, part))

    def deformed(package: str, part: int, shape: np.ndarray, records: bytes) -> np.ndarray:
        return np.float32(host.deformed(package, part, shape.astype(float), records))

    return InProcess(geometry=geometry, deformed=deformed)


@dataclass(frozen=True)
class InProcess:
    """Functions as a reader program: the same protocol, without a process a call."""

    evaluate: Evaluate | None = None
    visibility: Callable[[str, bytes], np.ndarray] | None = None
    normals: Callable[[str, bytes], np.ndarray] | None = None
    validate: Callable[[str], tuple[bool, list[str]]] | None = None
    environment: Environment | None = None
    nearby: Evaluate | None = None
    base_color: Callable[[str, bytes], np.ndarray] | None = None
    geometry: Geometry | None = None
    deformed: Deformed | None = None

    def run(self, *arguments: str) -> Answer:
        out, errors = io.StringIO(), io.StringIO()
        had = {field.name: getattr(self, field.name) for field in fields(self)}
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
            status = run_reader(arguments, **had)
        return Answer(status, out.getvalue(), errors.getvalue())


@pytest.fixture
def folder_of_kit(tmp_path):
    """A copy of the kit's index alone, to be damaged."""
    (tmp_path / "kit.json").write_bytes((KIT / "kit.json").read_bytes())
    return tmp_path
