"""What is packed as rna-three: its files, its size, what it imports."""

from __future__ import annotations

import json
import re
import tarfile
from pathlib import Path

import pytest

from tests.web.three.pages import TOY, installed

MOST_BYTES = 5_000_000
"""Of page, module and toy; three.js is the page's own."""


@pytest.fixture(scope="module")
def package(tmp_path_factory) -> tuple[Path, Path]:
    """The tarball, and the package installed from it."""
    folder = tmp_path_factory.mktemp("package")
    tarball = installed(folder)
    return tarball, folder / "node_modules" / "rna-three"


def test_files(package):
    with tarfile.open(package[0]) as archive:
        names = {Path(name).name for name in archive.getnames()}
    assert names == {"package.json", "README.md", "LICENSE", "rna-three.js", "rna-three.d.ts"}


def test_manifest(package):
    manifest = json.loads((package[1] / "package.json").read_text())
    assert manifest["license"] == "Apache-2.0"
    assert re.fullmatch(r"\d+\.\d+\.\d+", manifest["version"])
    assert manifest["sideEffects"] is False
    assert list(manifest["peerDependencies"]) == ["three"]
    for name in manifest["exports"]["."].values():
        assert (package[1] / name).is_file()


def test_three_is_not_packed(package):
    text = (package[1] / "rna-three.js").read_text()
    imported = set(re.findall(r'\bfrom"([^"]+)"', text))
    assert imported == {"three/webgpu", "three/tsl"}


def test_page_module_and_toy_are_small(package):
    module = (package[1] / "rna-three.js").stat().st_size
    assert module + TOY.stat().st_size < MOST_BYTES


def test_types_name_what_is_exported(package):
    declared = re.findall(r"export class (\w+)", (package[1] / "rna-three.d.ts").read_text())
    text = (package[1] / "rna-three.js").read_text()
    exported = re.findall(r"\w+ as (\w+)", re.findall(r"export\{([^}]*)\}", text)[-1])
    assert set(declared) == set(exported)
