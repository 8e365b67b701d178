"""What pyproject.toml requires: the base of what the SDK imports, and all with a lowest version."""

import ast
import subprocess
import sys
import tomllib

import pytest

from scripts.lowest_versions import pins
from tests.conftest import REPOSITORY

PROJECT = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]


def imported(folder: str) -> set[str]:
    """Top-level modules that the files of a folder import."""
    names = set()
    for path in (REPOSITORY / folder).rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Import):
                names |= {alias.name.partition(".")[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom) and node.module:
                names.add(node.module.partition(".")[0])
    return names


def test_the_base_requires_what_the_sdk_imports_and_no_more():
    required = {pin.partition("==")[0].replace("-", "_") for pin in pins(PROJECT["dependencies"])}
    parts = {"llvmlite", "pydantic_core"}  # of numba and of pydantic
    others = set(sys.stdlib_module_names) | {"rna_sdk"} | parts
    actual = {"pillow" if name == "PIL" else name for name in imported("rna_sdk") - others}
    assert required == actual


def test_the_lowest_versions_are_what_the_lowest_test_installs():
    command = [sys.executable, REPOSITORY / "scripts" / "lowest_versions.py"]
    said = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    extras = PROJECT["optional-dependencies"].values()
    wanted = [*PROJECT["dependencies"], *(r for extra in extras for r in extra)]
    wanted = [r.replace(">=", "==") for r in wanted if not r.startswith("rna-sdk[")]
    assert sorted(wanted) == sorted(said) and "numpy==1.26" in said


@pytest.mark.parametrize(
    ("name", "fixed", "fault"),
    [("torch", (2, 10), "CVE-2026-24747"), ("pillow", (10, 3), "CVE-2023-4863 and CVE-2024-28219")],
)
def test_no_version_with_a_known_fault_is_admitted(name, fixed, fault):
    groups = [PROJECT["dependencies"], *PROJECT["optional-dependencies"].values()]
    (lowest,) = (p for group in groups for p in pins(group) if p.startswith(f"{name}=="))
    assert tuple(map(int, lowest.partition("==")[2].split("."))) >= fixed, fault


def test_the_sdist_takes_files_of_the_top_alone():
    """A pattern without a slash in front matches in every folder."""
    targets = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["tool"]["hatch"]["build"]
    patterns = targets["targets"]["sdist"]["include"]
    assert [p for p in patterns if not (p[0] == "/" and (REPOSITORY / p[1:]).exists())] == []


def test_the_lowest_test_names_files_that_exist():
    lines = (REPOSITORY / "scripts" / "test-lowest").read_text().splitlines()
    shown = lines[lines.index("tests=(") : lines.index(")") + 1]
    listed = [*shown, 'printf "%s\\n" "${tests[@]#--ignore=}"']
    paths = subprocess.check_output(["bash", "-c", "\n".join(listed)], text=True).split()
    assert len(paths) > 10
    assert [path for path in paths if not (REPOSITORY / path).exists()] == []


def test_a_marker_is_kept():
    assert pins(["numpy>=2.0; python_version < '3.14'"]) == ["numpy==2.0; python_version < '3.14'"]


@pytest.mark.parametrize("requirement", ["numpy", "numpy~=2.0", "numpy>=1.26,<3"])
def test_another_form_is_refused(requirement):
    with pytest.raises(ValueError, match=r"expected name>=version"):
        pins([requirement])
