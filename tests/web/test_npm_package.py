"""The packed rna-viewer: types, the manifest of its element, places of import."""

import json
import subprocess
import tarfile
from pathlib import Path

import pytest

from tests.web.in_node import ELEMENT_SOURCES, in_node
from tests.web.three.pages import packed

REACT = """import { RnaViewer as Viewer } from "rna-viewer/react";
import type { RnaViewer, RnaViewerEvents } from "rna-viewer";
export const page = (
  <rna-viewer src="toy.rna" alt="A toy" camera-controls={true} min-camera-orbit="auto 0deg auto"
    style={{ width: 300 }} ref={(own: RnaViewer | null) => { own?.resetView(); }} />
);
export function listen(viewer: RnaViewer): () => void {
  const turned = ({ detail }: RnaViewerEvents["camera-change"]) => console.log(detail.cameraOrbit);
  viewer.addEventListener("camera-change", turned);
  const place: number | undefined = viewer.positionAndNormalFromPoint(1, 2)?.position.x;
  viewer.cameraOrbit = place === undefined ? null : "0deg 90deg 2m";
  document.querySelector("rna-viewer")?.dismissPoster();
  return () => viewer.removeEventListener("camera-change", turned);
}
export const tag = (
  <rna-viewer onload={({ detail }) => console.log(detail.url)}
    onerror={({ detail }) => console.log(detail.message)}
    oncamera-change={({ detail }) => console.log(detail.cameraOrbit)} />
);
export const component = (
  <Viewer src="toy.rna" camera-controls={true} onLoad={({ detail }) => console.log(detail.url)}
    onCameraChange={({ detail }) => console.log(detail.cameraOrbit)} onClick={() => {}} />
);
// @ts-expect-error: no such value
export const wrong = <rna-viewer loading="soon" />;
// @ts-expect-error: React never calls it
export const unheard = <rna-viewer onLoad={() => {}} />;
"""
OPTIONS = {
    "strict": True, "noEmit": True, "jsx": "react-jsx", "module": "nodenext", "target": "es2022",
    "lib": ["es2022", "dom"], "skipLibCheck": False,
}  # fmt: skip


@pytest.fixture(scope="module")
def tarball():
    return packed("rna-viewer")


@pytest.fixture(scope="module")
def package(tarball, tmp_path_factory):
    """The package installed from it."""
    modules = tmp_path_factory.mktemp("npm") / "node_modules"
    modules.mkdir()
    with tarfile.open(tarball) as archive:
        archive.extractall(modules, filter="data")
    return (modules / "package").rename(modules / "rna-viewer")


def test_files(package):
    wanted = {"rna-viewer.js", "rna-viewer.js.map", "rna-viewer.d.ts", "custom-elements.json"}
    wanted |= {"react.js", "react.d.ts"}
    names = {path.name for path in package.iterdir()}
    assert names == wanted | {"package.json", "README.md", "LICENSE"}
    manifest = json.loads((package / "package.json").read_text())
    for export in manifest["exports"].values():
        for name in export.values() if isinstance(export, dict) else [export]:
            assert (package / name).is_file()


def test_manifest_of_the_element_names_all_attributes(package):
    program = f"""
        import {{ READERS }} from "{(ELEMENT_SOURCES / "attributes.js").as_uri()}";
        console.log(JSON.stringify(Object.keys(READERS)));
    """
    names = in_node(program)
    (module,) = json.loads((package / "custom-elements.json").read_text())["modules"]
    (element,) = module["declarations"]
    assert [record["name"] for record in element["attributes"]] == names
    assert all(record["description"] for record in element["attributes"])
    assert "camera-change" in [record["name"] for record in element["events"]]
    assert "poster" in [record["name"] for record in element["slots"]]
    types = (package / "rna-viewer.d.ts").read_text().split("export interface RnaViewerAttributes")
    lines = types[1].split("}")[0].splitlines()[1:]
    written = [line.split("?:")[0].strip().strip('"') for line in lines]
    assert sorted(filter(None, written)) == sorted(names)


@pytest.mark.parametrize("where", ["node", "worker"])
def test_it_is_imported_without_a_window(package, where):
    folder = package.parent.parent
    tell = 'import { RnaViewer } from "rna-viewer"; console.log(typeof RnaViewer);'
    (folder / "node.mjs").write_text(tell)
    start = 'import { Worker } from "node:worker_threads"; new Worker("./node.mjs");'
    (folder / "worker.mjs").write_text(start)
    command = ["node", f"{where}.mjs"]
    done = subprocess.run(command, capture_output=True, text=True, cwd=folder, timeout=300)
    assert (done.stdout.strip(), done.stderr) == ("function", "")


def _install(folder: Path, *names: object) -> None:
    if subprocess.run(["npm", "ping"], capture_output=True).returncode:
        pytest.skip("the npm registry does not answer")
    (folder / "package.json").write_text('{"private": true, "type": "module"}')
    install = ["npm", "install", "--no-audit", "--no-fund", "--loglevel=error", *map(str, names)]
    subprocess.run(install, cwd=folder, check=True, timeout=600)


def test_strict_react(tarball, tmp_path):
    _install(tmp_path, tarball, "react@19", "@types/react@19", "typescript@5")
    (tmp_path / "page.tsx").write_text(REACT)
    (tmp_path / "tsconfig.json").write_text(json.dumps({"compilerOptions": OPTIONS}))
    done = subprocess.run(["npx", "tsc"], cwd=tmp_path, capture_output=True, text=True, timeout=600)
    assert done.stdout == ""


def test_react_has_a_client_boundary(package):
    """Next.js runs what has none on the server alone, where no element is defined."""
    assert (package / "react.js").read_text().startswith('"use client";')
