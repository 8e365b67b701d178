"""The packed rna-three: its files, its size, its imports."""

import json
import re
import subprocess
import tarfile
from pathlib import Path

import pytest

from tests.web.three.pages import REPOSITORY, TOY, installed

MOST_BYTES = 5_000_000
"""Bytes of page, module and toy; three.js belongs to the page."""
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
def package(tmp_path_factory):
    """The tarball, and the package installed from it."""
    folder = tmp_path_factory.mktemp("package")
    tarball = installed(folder)
    return tarball, folder / "node_modules" / "rna-three"


def test_files(package):
    with tarfile.open(package[0]) as archive:
        names = {Path(name).name for name in archive.getnames()}
    module = {"rna-three.js", "rna-three.js.map", "rna-three.d.ts"}
    assert names == {"package.json", "README.md", "LICENSE"} | module


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


HITS = """
    import { PartRays } from "ADDRESS";
    import { Matrix4, Raycaster, Vector3 } from "THREE";
    const words = (...values) => new Uint32Array(new Float32Array(values).buffer);
    const box = [...words(0, 0, 0), 0, ...words(1, 1, 0), 1];
    const geometry = {
      nodes: new Uint32Array([...box, ...box]), primitives: new Uint32Array([0, 1, 2, 0]),
      normalsAt: 3,
      points: new Float32Array([
        0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0.5, 0, 0, 1, 0.25, 0, 0, 1, 0.25, 0, 0, 1, 0.75,
      ]),
    };
    const ray = new Raycaster(new Vector3(0.25, 0.5, 1), new Vector3(0, 0, -1));
    for (const hasUVs of [true, false]) {
      const hits = [], part = { kind: "surface", primitive: new Uint32Array([0, 0, 0]), hasUVs };
      new PartRays(geometry, part).raycast({}, new Matrix4(), ray, hits);
      console.log(JSON.stringify(hits.map(({ distance, uv }) => [distance, uv?.x, uv?.y])));
    }
"""


def test_hits_have_the_place_in_the_texture():
    sources = REPOSITORY / "runtime" / "web"
    raycast = (sources / "src" / "three" / "raycast.js").as_uri()
    three = (sources / "node_modules" / "three" / "build" / "three.webgpu.js").as_uri()
    program = HITS.replace("ADDRESS", raycast).replace("THREE", three)
    command = ["node", "--input-type=module", "-e", program]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300)
    assert [json.loads(line) for line in done.stdout.splitlines()] == [
        [[1, 0.5, 0.5]],
        [[1, None, None]],
    ]


EXPORT = """
    import fs from "node:fs";
    import { GLTFExporter } from "THREE";
    import { RnaLoader } from "rna-three";
    globalThis.FileReader = class {
      readAsDataURL(blob) {
        blob.arrayBuffer().then((bytes) => {
          this.result = `data:;base64,${Buffer.from(bytes).toString("base64")}`;
          this.onloadend();
        });
      }
    };
    const bytes = new Uint8Array(fs.readFileSync(process.argv[1])).buffer;
    const asset = await new RnaLoader().parseAsync(bytes);
    const { meshes, materials } = await new GLTFExporter().parseAsync(asset);
    console.log(JSON.stringify([meshes.length, materials.length]));
"""


def test_exporters_write_the_shape(package):
    three = package[1].parent / "three" / "examples" / "jsm" / "exporters" / "GLTFExporter.js"
    program = EXPORT.replace("THREE", three.as_uri())
    command = ["node", "--input-type=module", "-e", program, str(KIT / "surface-tiny.rna")]
    folder = package[1].parents[1]
    done = subprocess.run(command, capture_output=True, text=True, cwd=folder, timeout=300)
    assert done.stdout.splitlines()[-1] == "[1,1]", done.stderr
    assert "GLTFExporter: Use MeshStandardMaterial" in done.stderr
