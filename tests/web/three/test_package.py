"""What is packed as rna-three: its files, its size, what it imports."""

from __future__ import annotations

import json
import re
import subprocess
import tarfile
from pathlib import Path

import pytest

from tests.web.three.pages import REPOSITORY, TOY, installed

MOST_BYTES = 5_000_000
"""Of page, module and toy; three.js is the page's own."""
KIT = REPOSITORY / "spec" / "conformance" / "packages"
READ_IN_NODE = """
    import fs from "node:fs";
    import { RnaLoader } from "rna-three";
    for (const path of process.argv.slice(1)) {
      const bytes = new Uint8Array(fs.readFileSync(path)).buffer;
      await new RnaLoader().parseAsync(bytes).then(
        ({ tiers }) => console.log(tiers.join()), ({ message }) => console.log(message));
    }
"""


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


def test_packages_are_read_in_node_but_for_their_images(package):
    """As where pages are rendered on a server."""
    paths = [KIT / f"surface-{name}.rna" for name in ("tiny", "print")]
    command = ["node", "--input-type=module", "-e", READ_IN_NODE, *map(str, paths)]
    folder = package[1].parents[1]
    done = subprocess.run(command, capture_output=True, text=True, cwd=folder, timeout=300)
    tiers, line = done.stdout.splitlines()
    assert tiers == "two" and "expected a browser, which decodes images" in line
