"""The error tree."""

import pickle
from pathlib import Path

import pytest

from rna_sdk.errors import PackageError, RnaError, SceneError
from rna_sdk.package import Code, Issue

ISSUES = [Issue.of(Code.ZIP_CRC, 64, "0x1", "0x2"), Issue.of(Code.FIELD_VALUE, "/tiers/0", 3, 4)]
ERRORS = [
    PackageError(ISSUES, Path("toy.rna")),
    PackageError(iter(ISSUES)),
    SceneError("expected a number", file=Path("scene.yaml"), line=3, key="samples"),
    SceneError("nothing to render"),
    *(error("why") for error in RnaError.__subclasses__() if error is not PackageError),
]


@pytest.mark.parametrize("error", ERRORS, ids=lambda error: type(error).__name__)
def test_an_error_survives_pickling(error):
    copy = pickle.loads(pickle.dumps(error))
    assert type(copy) is type(error) and str(copy) == str(error)
    assert vars(copy) == vars(error)


@pytest.mark.parametrize("code", Code)
def test_a_code_survives_pickling(code):
    assert pickle.loads(pickle.dumps(code)) is code
