"""Packages in glTF files that GLTFLoader loads: their pictures, and omitted loads."""

import shutil
from base64 import b64decode
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.render.chromium import Page
from tests.web.gltf_files import EXTENSION, GltfFile, asset_node
from tests.web.pages import TIMEOUT
from tests.web.three.pages import PAGE, REPOSITORY, installed, opened

pytestmark = pytest.mark.chromium

KIT = REPOSITORY / "spec" / "conformance" / "packages"
SURFACE, STRANDS = KIT / "surface-float32.rna", KIT / "fiber-float16.rna"
MIRRORED = {"translation": [2.0, 0.5, 0.0], "rotation": [0.0, 0.6, 0.0, 0.8], "scale": [-0.5] * 3}
PLACES = np.array([[-1, 0, 0], [1, 0, 1]], "<f4")
TURNS = np.array([[0, 0, 0, 1], [0, 0.6, 0, 0.8]], "<f4")
SIZES = np.array([[1, 1, 1], [-0.5, 0.5, 0.5]], "<f4")
LOAD = """
const load = async (name, options = { renderer }) => {
  const loader = new GLTFLoader().register((parser) => new rna.RNAExtension(parser, options));
  return loader.loadAsync(name);
};
const view = { position: [5, 4, 6], lookAt: [0, 0, 0] };
const at = (asset, { translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }) => {
  asset.position.set(...translation);
  asset.quaternion.set(...rotation);
  asset.scale.set(...scale);
  return asset;
};
const group = (...objects) => new THREE.Group().add(...objects);
"""


def scene_file() -> GltfFile:
    """An asset, mirrored too, beside a cube; the fallback has a child; strands elsewhere."""
    file = GltfFile()
    surface, strands = (file.view(path.read_bytes()) for path in (SURFACE, STRANDS))
    far = {"translation": [0.0, 0.0, -3.0]}
    fox = asset_node(surface, children=[2], name="fox")
    fox["extensions"][EXTENSION]["fallbackFlip"] = 0.25
    file.document["nodes"] = [
        {"children": [1, 3, 4, 5]},
        fox,
        {"mesh": 0, "translation": [0.0, 1.0, 0.0]},
        asset_node(surface, **MIRRORED),
        {"mesh": 0, "scale": [0.3] * 3, "translation": [-2.0, 0.0, 0.0], "name": "cube"},
        asset_node(strands, **far),
    ]
    return file


def instances_file(package: Path) -> GltfFile:
    """Two instances of a package, the second one mirrored, in a node that is moved."""
    file = GltfFile()
    arrays = {"TRANSLATION": PLACES, "ROTATION": TURNS, "SCALE": SIZES}
    attributes = {name: file.accessor(values) for name, values in arrays.items()}
    node = asset_node(file.view(package.read_bytes()), translation=[0.0, 0.5, 0.0])
    node["extensions"]["EXT_mesh_gpu_instancing"] = {"attributes": attributes}
    file.document["nodes"] = [node]
    file.document["extensionsUsed"].append("EXT_mesh_gpu_instancing")
    return file


def bones_file() -> GltfFile:
    """A cube that is bound to a joint below a package, and to the package's own node."""
    file = GltfFile()
    own = file.document["meshes"][0]["primitives"][0]
    joints, shares = np.array([[1, 0, 0, 0]] * 8, "<u2"), np.array([[1, 0, 0, 0]] * 8, "<f4")
    places = {"JOINTS_0": file.accessor(joints), "WEIGHTS_0": file.accessor(shares)}
    bound = {**own, "attributes": {**own["attributes"], **places}}
    file.document["meshes"].append({"primitives": [bound]})
    file.document["skins"] = [{"joints": [1, 2]}]
    file.document["nodes"] = [
        {"children": [1, 3]},
        asset_node(file.view(SURFACE.read_bytes()), children=[2], translation=[0.0, 0.0, 4.0]),
        {"mesh": 0, "translation": [1.0, 0.5, -4.0], "name": "hand"},
        {"mesh": 1, "skin": 0, "name": "bound"},
    ]
    return file


def broken_file() -> GltfFile:
    """A package that is cut, and one that is whole."""
    file = GltfFile()
    views = [file.view(data) for data in (SURFACE.read_bytes()[:-9], SURFACE.read_bytes())]
    file.document["nodes"] = [{"children": [1, 2]}, *map(asset_node, views)]
    return file


def odd_bytes() -> bytes:
    """Nodes of no instances and of endless ones in one place, and a chunk behind the usual two."""
    file = GltfFile()
    package = file.view(SURFACE.read_bytes())
    for name, count in (("TRANSLATION", 0), ("_ID", 2**31)):
        accessor = {"componentType": 5126, "count": count, "type": "VEC3"}
        file.document["accessors"].append(accessor)
        node = asset_node(package)
        attributes = {"attributes": {name: len(file.document["accessors"]) - 1}}
        node["extensions"]["EXT_mesh_gpu_instancing"] = attributes
        file.document.setdefault("nodes", []).append(node)
    file.document["scenes"] = [{"nodes": [0, 1]}]
    data = bytearray(file.to_bytes() + bytes([4, 0, 0, 0]) + b"ACME" + bytes(4))
    data[8:12] = len(data).to_bytes(4, "little")
    return bytes(data)


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("gltf")
    installed(folder)
    for path in (SURFACE, STRANDS, PAGE):
        shutil.copy(path, folder)
    files = {
        "scene": scene_file(),
        "surfaces": instances_file(SURFACE),
        "strands": instances_file(STRANDS),
        "broken": broken_file(),
        "bones": bones_file(),
    }
    for name, file in files.items():
        (folder / f"{name}.glb").write_bytes(file.to_bytes())
    (folder / "odd.glb").write_bytes(odd_bytes())
    with opened(folder, PAGE.name, 96, 60) as page:
        page.wait_for("!!globalThis.test", TIMEOUT)
        yield page


def run(page: Page, body: str) -> Any:
    """What an async function of this body returns."""
    names = "{ THREE, GLTFLoader, rna, renderer, picture }"
    return page.evaluate(f"(async () => {{ const {names} = test; {LOAD} {body} }})()")


def test_a_scene_has_the_same_bits_as_its_packages(page):
    """In their places, beside the cube; the fallback is not even loaded."""
    actual = run(
        page,
        f"""
        const loader = new rna.RnaLoader();
        const fox = await loader.loadAsync("{SURFACE.name}");
        const hair = await loader.loadAsync("{STRANDS.name}");
        const gltf = await load("scene.glb"), [root] = gltf.scene.children;
        const cube = root.getObjectByName("cube"), [own] = root.children;
        const facts = [
          root.children.map(({{ type }}) => type), own.children.length, own.name,
          gltf.userData.rnaAssets.length, root.children[1].content === own.content,
          gltf.userData.rnaAssets.map(({{ userData }}) => userData.fallbackFlip ?? null),
        ];
        const pictures = [await picture(gltf.scene, 96, 60, view)];
        const mirrored = at(fox.clone(), {{
          translation: [2, 0.5, 0], rotation: [0, 0.6, 0, 0.8], scale: [-0.5, -0.5, -0.5] }});
        const far = at(hair, {{ translation: [0, 0, -3] }});
        const box = new THREE.Mesh(cube.geometry, cube.material);
        const moved = at(box, {{ translation: [-2, 0, 0], scale: [0.3, 0.3, 0.3] }});
        pictures.push(await picture(group(fox, mirrored, moved, far), 96, 60, view));
        gltf.scene.traverse((object) => object.isRnaAsset && object.dispose());
        const left = gltf.userData.rnaAssets.map((asset) => asset.content.users.size);
        return [facts, ...pictures, left];
        """,
    )
    types = ["RnaAsset", "RnaAsset", "Mesh", "RnaAsset"]
    assert actual[0] == [types, 2, "fox", 2, True, [0.25, None]]
    assert actual[1] == actual[2]
    assert actual[3] == [0, 0]  # all disposed of


@pytest.mark.parametrize(("name", "package"), [("surfaces", SURFACE), ("strands", STRANDS)])
def test_instances(page, name, package):
    """Against copies of the asset, which differ by how matrices are multiplied."""
    expected, actual, kinds = run(
        page,
        f"""
        const gltf = await load("{name}.glb"), asset = gltf.userData.rnaAssets[0];
        const whole = await new rna.RnaLoader().loadAsync("{package.name}");
        const mirrored = at(whole.clone(), {{
          translation: [1, 0, 1], rotation: [0, 0.6, 0, 0.8], scale: [-0.5, 0.5, 0.5] }});
        const copies = group(at(whole, {{ translation: [-1, 0, 0] }}), mirrored);
        copies.position.y = 0.5;
        const kinds = gltf.scene.children[0].children.map((mesh) => mesh.isInstancedMesh);
        return [
          await picture(copies, 96, 60, view), await picture(gltf.scene, 96, 60, view), kinds];
        """,
    )
    assert kinds == [True, True]  # one of them of mirrored instances
    first, second = (np.frombuffer(b64decode(text), "<f4") for text in (expected, actual))
    assert np.count_nonzero(first) > 250
    error = np.mean((first - second) ** 2)
    assert 10 * np.log10(np.max(first) ** 2 / error) > 60


def test_odd_instances_and_chunks(page):
    actual = run(
        page,
        """
        const { children } = (await load("odd.glb")).scene;
        return children.map(({ children }) => children.map(({ count }) => count));
        """,
    )
    assert actual == [[], [1]]


def test_joints_below_a_package_move_other_meshes(page):
    """A node with a package may be a bone, and bones may be below it, without their meshes."""
    actual = run(
        page,
        """
        const gltf = await load("bones.glb"), bound = gltf.scene.getObjectByName("bound");
        gltf.scene.updateMatrixWorld(true);
        bound.skeleton.update();
        const place = bound.applyBoneTransform(0, new THREE.Vector3(0, 0, 0)).toArray();
        const { isBone, children } = gltf.scene.getObjectByName("hand");
        return [place, isBone, children.length];
        """,
    )
    assert actual == [[1.0, 0.5, 0.0], True, 0]


def test_what_cannot_be_shown_has_its_fallback(page):
    """And one line: where a package is broken, or nothing can draw it."""
    actual = run(
        page,
        """
        const said = [], { warn } = console;
        console.warn = (...words) => said.push(words.join(" "));
        const kinds = ({ scene }) => {
          const found = [];
          scene.traverse(({ type }) => found.push(type));
          return found.filter((type) => ["Mesh", "RnaAsset"].includes(type));
        };
        const broken = kinds(await load("broken.glb"));
        const classic = await import("./node_modules/three/build/three.module.js");
        const others = [
          new THREE.WebGPURenderer({ forceWebGL: true }), new classic.WebGLRenderer()];
        const without = [];
        for (const renderer of others) without.push(kinds(await load("scene.glb", { renderer })));
        console.warn = warn;
        const missing = await load("scene.glb", {}).catch(({ message }) => message);
        const nonsense = await load("scene.glb", { renderer, nonsense: 1 })
          .catch(({ message }) => message);
        return { broken, without, said, missing, nonsense };
        """,
    )
    assert actual["broken"] == ["Mesh", "RnaAsset", "Mesh"]
    assert actual["without"] == [["Mesh"] * 5] * 2
    assert len(actual["said"]) == 3
    assert "glTF: the file does not end with the end record of a ZIP archive" in actual["said"][0]
    assert all(line.endswith("glTF files show their fallback") for line in actual["said"])
    assert "expected the option renderer" in actual["missing"]
    assert "has no option nonsense" in actual["nonsense"]
