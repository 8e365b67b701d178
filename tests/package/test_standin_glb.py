"""rna-info --glb: packages as ordinary glTF files."""

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rna_render.materials.files.mesh_file import MeshFileWarning, read_mesh_object
from rna_render.materials.mesh_object import MeshObject
from rna_render.scene.material_models import DiffuseModel
from rna_sdk.package import Curves, Package
from rna_sdk.package.command.rna_info import main
from rna_sdk.package.gltf.strand_ribbons import ribbons
from rna_sdk.runtime import load
from rna_sdk.runtime.standin_colors import surface_colors, vertex_base_colors
from tests.conftest import REPOSITORY
from tests.exporters.in_blender import answer_of
from tests.package.carriers import opened

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
CURLS = REPOSITORY / "examples" / "fibers" / "curly_ball.rna"
PLAIN = DiffuseModel(type="diffuse")
KIT = REPOSITORY / "spec" / "conformance" / "packages"


def _glb(package: Path, folder: Path) -> Path:
    path = folder / f"{package.stem}.glb"
    assert main([str(package), "--glb", str(path)]) == 0
    return path


def _mesh(path: Path) -> MeshObject:
    with pytest.warns(MeshFileWarning, match="not shown: RNA_relightable_asset"):
        return read_mesh_object(path, PLAIN)


def test_a_mesh_has_its_triangles_and_its_material(tmp_path):
    path = _glb(TOY, tmp_path)
    document, blob = opened(path)
    with Package.open(TOY) as package:
        mesh, manifest = package.mesh(), package.manifest
    stated = manifest.extensions["RNA_standin"]["parts"][0]
    material = document["materials"][0]["pbrMetallicRoughness"]
    assert material["baseColorFactor"] == [1.0, 1.0, 1.0, 1.0]
    assert material["roughnessFactor"] == stated["roughness"]
    assert manifest.license in document["asset"]["copyright"]
    number = document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"]
    view = document["bufferViews"][document["accessors"][number]["bufferView"]]
    rows = np.frombuffer(blob[view["byteOffset"] :][: view["byteLength"]], "<u2").reshape(-1, 4)
    colors = rows[:, :3] / 65535
    corners = mesh.positions[mesh.triangles]
    edges = corners[:, 1:] - corners[:, :1]
    area = np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1)
    mean = np.average(colors[mesh.triangles].mean(axis=1), axis=0, weights=area)
    np.testing.assert_allclose(mean, stated["baseColor"], atol=0.15)
    assert (colors.std(axis=0) > 0.1).all()  # red, yellow, blue and grey bricks
    loaded = _mesh(path)
    np.testing.assert_array_equal(loaded.positions, mesh.positions)
    np.testing.assert_array_equal(loaded.triangles, mesh.triangles)


def test_parts_are_nodes_and_holes_are_alpha(tmp_path):
    path = _glb(KIT / "parts-lantern.rna", tmp_path)
    document, blob = opened(path)
    with Package.open(KIT / "parts-lantern.rna") as package:
        names = [part.name for part in package.manifest.parts]
        holes = [package.transmittance(i) for i in range(len(names))]
    *parts, root = document["nodes"]
    assert [node["name"] for node in parts] == names
    assert root["children"] == list(range(len(names)))
    assert document["scenes"] == [{"nodes": [len(names)]}]
    records = [record for part in holes for record in part]
    modes = {m["alphaMode"] for m in document["materials"] if "alphaMode" in m}
    assert modes == {"BLEND" if record.cutoff is None else "MASK" for record in records}
    surfaces = [m["pbrMetallicRoughness"] for m in document["materials"] if "alphaMode" in m]
    number = next(s["baseColorTexture"]["index"] for s in surfaces if "baseColorTexture" in s)
    image = document["images"][document["textures"][number]["source"]]
    view = document["bufferViews"][image["bufferView"]]
    png = blob[view["byteOffset"] :][: view["byteLength"]]
    alpha = np.array(Image.open(io.BytesIO(png)))[..., 3]
    texture = next(r.texture for r in records if r.texture.shape[:2] == alpha.shape)
    np.testing.assert_allclose(alpha, 255.0 - texture.mean(axis=2), atol=0.5)


def test_images_of_base_colour_are_textures_and_vertices_have_the_rest(tmp_path):
    """In the package's own bytes; but for linear or moved images, which viewers would get wrong."""
    path = _glb(KIT / "surface-print.rna", tmp_path)
    document, blob = opened(path)
    primitives = document["meshes"][0]["primitives"]
    corners = [document["accessors"][p["indices"]]["count"] // 3 for p in primitives]
    materials = [document["materials"][p["material"]] for p in primitives]
    surfaces = [material["pbrMetallicRoughness"] for material in materials]
    printed = {
        first: surface
        for first, surface in zip(np.cumsum([0, *corners[:-1]]).tolist(), surfaces, strict=True)
        if "baseColorTexture" in surface
    }
    assert sorted(printed) == [0, 75] and printed[75]["baseColorFactor"][:3] == [0.5, 1.0, 1.0]
    texture = document["textures"][printed[75]["baseColorTexture"]["index"]]
    assert document["samplers"][texture["sampler"]] == {"wrapS": 33071, "wrapT": 33648}
    view = document["bufferViews"][document["images"][texture["source"]]["bufferView"]]
    part = load(KIT / "surface-print.rna").parts[0]
    with Package.open(KIT / "surface-print.rna") as package:
        png, start = package.entry("textures/dot.png")
    assert view["byteOffset"] == start and blob[start:][: view["byteLength"]] == bytes(png)
    number = primitives[0]["attributes"]["COLOR_0"]
    place = document["bufferViews"][document["accessors"][number]["bufferView"]]
    rows = np.frombuffer(blob[place["byteOffset"] :][: place["byteLength"]], "<u2")
    colors, whole = rows.reshape(-1, 4)[:, :3] / 65535, np.minimum(surface_colors(part), 1.0)
    base = np.maximum(vertex_base_colors(part), 1.0 / 255.0)
    for first, count, is_printed in ((0, 30, True), (30, 25, False)):
        vertices = np.unique(part.mesh.triangles[first : first + count])
        expected = whole[vertices] / (base[vertices] if is_printed else 1.0)
        np.testing.assert_allclose(colors[vertices], np.minimum(expected, 1.0), atol=1e-4)


def test_strands_become_ribbons_of_their_width_and_stay_below_the_limit():
    along = np.linspace(0.0, 1.0, 20, dtype=np.float32)
    strand = np.stack([along, along**2, np.zeros(20, np.float32)], axis=1)
    points = (strand + np.arange(50, dtype=np.float32)[:, None, None]).reshape(-1, 3)
    radii = np.full(1000, 0.01, np.float32)
    curves = Curves(points, radii, np.arange(0, 1001, 20, dtype=np.uint32))
    full = ribbons(curves)
    assert len(full.triangles) == 50 * 19 * 2
    away = np.linalg.norm(full.positions.reshape(-1, 2, 3) - points[:, None], axis=2)
    np.testing.assert_allclose(away, 0.01 * np.pi / 2, rtol=1e-3)
    corners = full.positions[full.triangles]
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.einsum("ij,ij->i", faces, full.normals[full.triangles].sum(axis=1)) > 0).all()
    few = ribbons(curves, max_triangles=600)
    assert len(few.triangles) == 400
    near = np.linalg.norm(few.positions[:2].astype(float) - points[0], axis=1)
    np.testing.assert_allclose(near, 2 * away.max(), rtol=1e-3)


def test_a_strand_that_turns_back_stays_finite():
    points = np.float32([[0, 0, 0], [1, 0, 0], [0, 0, 0], [0, 1, 0]])
    mesh = ribbons(Curves(points, np.full(4, 0.1, np.float32), np.uint32([0, 4])))
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1.0, atol=1e-5)
    assert np.isfinite(mesh.positions).all()


@pytest.mark.parametrize("name", sorted(path.name for path in KIT.glob("*.rna")))
def test_every_package_of_the_kit_loads(name, tmp_path):
    assert len(_mesh(_glb(KIT / name, tmp_path)).triangles)


def test_bad_files_are_one_line_and_write_nothing(tmp_path, capsys):
    bad = tmp_path / "bad.rna"
    bad.write_bytes(TOY.read_bytes()[:5000])
    assert main([str(bad), "--glb", str(tmp_path / "bad.glb")]) == 1
    assert main([str(TOY), "--glb", str(tmp_path / "none" / "toy.glb")]) == 1
    assert len(capsys.readouterr().err.splitlines()) <= 4
    assert [path.name for path in tmp_path.iterdir()] == ["bad.rna"]


IMPORT = """
bpy.ops.import_scene.gltf(filepath=sys.argv[1])
objects = [o for o in bpy.data.objects if o.type == "MESH"]
answer([
    [o.name, len(o.data.polygons), [m.name for m in o.data.materials],
     [node.type for m in o.data.materials for node in m.node_tree.nodes],
     [round(max((o.matrix_world @ v.co)[k] for v in o.data.vertices), 4) for k in range(3)]]
    for o in objects
])
"""


@pytest.mark.blender
@pytest.mark.parametrize("package", [TOY, CURLS], ids=["toy", "curls"])
def test_blender_opens_it(package, tmp_path, blender_python):
    path = _glb(package, tmp_path)
    mesh = _mesh(path)
    ((_, polygons, materials, nodes, high),) = answer_of(blender_python, IMPORT, str(path))
    assert polygons == pytest.approx(len(mesh.triangles), rel=0.01) and len(materials) == 1
    assert ("VERTEX_COLOR" in nodes) == (package is TOY)
    x = mesh.positions[:, 0].max()
    assert high[0] == pytest.approx(x, abs=1e-3)
    assert high[1] == pytest.approx(-mesh.positions[:, 2].min(), abs=1e-3)
