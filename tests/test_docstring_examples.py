"""Every public name of the SDK that does something has an example, and the examples run."""

import doctest
import inspect
from collections.abc import Iterator
from types import ModuleType

import numpy as np
import pytest
from pydantic import BaseModel

import rna_sdk.motion
import rna_sdk.package
import rna_sdk.runtime
from tests.conftest import REPOSITORY

MODULES = (rna_sdk.motion, rna_sdk.package, rna_sdk.runtime)
NAMES = {name: getattr(module, name) for module in MODULES for name in module.__all__} | {"np": np}
PACKAGES = {"toy.rna": "quickstart/toy.rna", "curls.rna": "fibers/curly_ball.rna"}
RECORDS = {"Asset", "Int8Planes", "Issue", "NormalMap", "ProfileDecoder", "ProfileLayer"}
RECORDS |= {"TierData", "Transmittance"}
"""Classes whose objects are handed out by others, or to others."""


def examples_of(module: ModuleType, name: str) -> list[doctest.DocTest]:
    finder = doctest.DocTestFinder(exclude_empty=True)
    actual = finder.find(getattr(module, name), name, module=False, globs=dict(NAMES))
    return [test for test in actual if test.examples]


def public() -> Iterator[tuple[ModuleType, str]]:
    for module in MODULES:
        for name in module.__all__:
            kind = getattr(module, name)
            if inspect.isfunction(kind) or (inspect.isclass(kind) and _does_something(kind)):
                yield module, name


def _does_something(kind: type) -> bool:
    data = issubclass(kind, BaseModel | Exception) or hasattr(kind, "__members__")
    return not data and kind.__name__ not in RECORDS


@pytest.mark.parametrize(("module", "name"), [pytest.param(*p, id=p[1]) for p in public()])
def test_example(module, name, tmp_path, monkeypatch):
    for link, package in PACKAGES.items():
        (tmp_path / link).symlink_to(REPOSITORY / "examples" / package)
    monkeypatch.chdir(tmp_path)
    tests = examples_of(module, name)
    assert tests, f"{module.__name__}.{name} has no example"
    failures: list[str] = []
    for test in tests:
        doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test, out=failures.append)
    assert not failures, "".join(failures)
