"""Public names of packages: each is in the stub, and is loaded on first use."""

import ast
import importlib
import pickle
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

FACES = [
    "rna_sdk.motion",
    "rna_sdk.package",
    "rna_sdk.runtime",
    "rna_render",
    "rna_render.lights",
    "rna_render.materials",
    "rna_render.scene",
    "rna_trace",
]


def homes(face: str) -> dict[str, str]:
    """Public name of a package -> the module that defines it, as its stub says."""
    spec = find_spec(face)
    assert spec is not None and spec.origin is not None
    stub = ast.parse(Path(spec.origin).with_suffix(".pyi").read_text())
    imports = [node for node in stub.body if isinstance(node, ast.ImportFrom)]
    return {alias.name: f"{face}.{node.module}" for node in imports for alias in node.names}


@pytest.mark.parametrize("face", FACES)
def test_every_name_has_a_home(face):
    package = importlib.import_module(face)
    assert sorted(homes(face)) == sorted(package.__all__)
    for name, module in homes(face).items():
        assert getattr(package, name) is getattr(importlib.import_module(module), name)
    assert set(package.__all__) <= set(dir(package))


@pytest.mark.parametrize("face", FACES)
def test_no_name_is_that_of_a_module(face):
    """It would become the module as soon as something imports that."""
    spec = find_spec(face)
    assert spec is not None and spec.origin is not None
    modules = {path.stem for path in Path(spec.origin).parent.iterdir()}
    assert modules & set(homes(face)) == set()


@pytest.mark.parametrize("face", FACES)
def test_an_unknown_name_is_an_error(face):
    package = importlib.import_module(face)
    with pytest.raises(AttributeError, match=f"No {face} attribute lode"):
        _ = package.lode
    with pytest.raises(ImportError, match="lode"):
        exec(f"from {face} import lode")


def test_classes_are_pickled_by_their_own_module():
    from rna_sdk.package import Mesh

    assert pickle.loads(pickle.dumps(Mesh)) is Mesh


@pytest.mark.parametrize("face", FACES)
def test_a_face_loads_nothing_by_itself(face):
    code = f"import sys, {face}\nassert not {{'numpy', 'numba', 'pydantic'}} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)
