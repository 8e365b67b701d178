"""`<rna-viewer src="x.glb">`: the package inside a binary glTF."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from tests.conftest import REPOSITORY
from tests.web.gltf_files import EXTENSION, GltfFile, asset_node, write_gltf

SOURCES = REPOSITORY / "runtime" / "web" / "src" / "package"
KIT = REPOSITORY / "spec" / "conformance" / "packages"
TINY, STRANDS = KIT / "surface-tiny.rna", KIT / "fiber-float16.rna"
OPENED = """
import {{ readFileSync }} from "node:fs";
import {{ Package }} from "{package}";
import {{ BlobSource }} from "{source}";
const said = [];
for (const [name, path] of Object.entries({files})) {{
  try {{
    const {{ source, manifest }} = await Package.open(
      new BlobSource(new Blob([readFileSync(path)]), name));
    said.push(`${{source.name}}: ${{source.size}} bytes, ${{manifest.name}}`);
  }} catch (error) {{
    said.push(error.message);
  }}
}}
console.log(JSON.stringify(said));
"""


def opened(*paths: Path) -> list[str]:
    """What comes of each file in node: its package, or the line."""
    program = OPENED.format(
        package=(SOURCES / "package.js").as_uri(),
        source=(SOURCES / "source.js").as_uri(),
        files=json.dumps({path.name: str(path) for path in paths}),
    )
    command = ["node", "--input-type=module", "-e", program]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=120)
    return json.loads(done.stdout)


@pytest.mark.skipif(shutil.which("node") is None, reason="needs Node")
def test_the_package_of_a_file(tmp_path):
    """Also where several nodes show it, and bytes follow it."""
    file = GltfFile()
    view = file.view(TINY.read_bytes())
    file.view(b"something else")
    file.document["nodes"] = [asset_node(view), {"mesh": 0}, asset_node(view, scale=[-1, 1, 1])]
    one = write_gltf(tmp_path / "one.glb", [TINY])
    (tmp_path / "twice.glb").write_bytes(file.to_bytes())
    expected, *actual = opened(TINY, one, tmp_path / "twice.glb")
    facts = expected.removeprefix(f"{TINY.name}: ")
    assert actual == [f"one.glb: {facts}", f"twice.glb: {facts}"]


def hostile(folder: Path) -> dict[str, bytes]:
    """Files of which none has one package, by what is told of them."""
    good = write_gltf(folder / "good.glb", [TINY]).read_bytes()

    def changed(**values: Any) -> bytes:
        file = GltfFile()
        file.view(TINY.read_bytes())
        file.document["nodes"] = [asset_node(2)]
        file.document["nodes"][0]["extensions"][EXTENSION] |= values
        return file.to_bytes()

    def placed(**values: Any) -> bytes:
        file = GltfFile()
        file.document["nodes"] = [asset_node(file.view(TINY.read_bytes()))]
        file.document["bufferViews"][2] |= values
        return file.to_bytes()

    bomb = good.replace(b'"nodes": [{', b'"nodes": ' + b"[" * 99 + b" {", 1)
    plain = GltfFile()
    plain.document["nodes"] = [{"mesh": 0}]
    two = write_gltf(folder / "two.glb", [TINY, STRANDS]).read_bytes()
    return {
        "expected one package, found 2": two,
        "expected the index of a buffer view, found 99": changed(package=99),
        "expected the index of a buffer view, found null": changed(package=None),
        'mimeType: expected "model/vnd.rna", found "model/gltf"': changed(mimeType="model/gltf"),
        "the file ends within its package": placed(byteLength=2**30),
        "the package is not in the file's BIN chunk": placed(buffer=1),
        "found -64": b"",
        "the file ends within its JSON": good[:100],
        "ends within its package, at byte": good[:-100],
        "nested too deep": bomb,
        "does not end with the end record of a ZIP archive": placed(byteLength=4000),
        "a glTF file: rna-make makes a package of it": plain.to_bytes(),
    }


@pytest.mark.skipif(shutil.which("node") is None, reason="needs Node")
def test_files_without_a_package_have_a_line(tmp_path):
    expected = hostile(tmp_path)
    paths = [tmp_path / f"{k}.glb" for k in range(len(expected))]
    for path, data in zip(paths, expected.values(), strict=True):
        path.write_bytes(data)
    for said, line in zip(opened(*paths), expected, strict=True):
        assert line in said and "\n" not in said
