"""Mesh files: geometry, placement, and messages about files that cannot be shown."""

import base64
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image
from pydantic import TypeAdapter

from rna_render.materials import MeshFileWarning, MeshObject, read_mesh_object
from rna_render.scene.material_models import MaterialModel
from rna_sdk.errors import SceneError
from rna_trace.bilinear import CLAMP, REPEAT
from rna_trace.surface import geometric_normals

RED, GREEN, BLUE, WHITE = (255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255)
# Upper row red, green; lower row blue, white.
IMAGE = np.array([[RED, GREEN], [BLUE, WHITE]], np.uint8)

# A square in x and y that faces +z. Seen so, its image is upright.
CORNERS = np.float32([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
FACES = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)
GLTF_UVS = np.float32([[0, 1], [1, 1], [1, 0], [0, 0]])
FROM_BELOW = GLTF_UVS * np.float32([1, -1]) + np.float32([0, 1])  # (0, 0) the lower left


def read(path, material=None) -> MeshObject:
    if material is None:
        return read_mesh_object(path)
    textures = {k: path.parent / v for k, v in material.items() if k == "texture"}
    return read_mesh_object(
        path, TypeAdapter(MaterialModel).validate_python({**material, **textures})
    )


def colours_at_corners(mesh) -> dict[tuple[float, ...], list[float]]:
    """Colour close to each corner of the square, by its position."""
    actual = {}
    for number, triangle in enumerate(mesh.triangles):
        for corner in range(3):
            weights = np.full(3, 0.05)
            weights[corner] = 0.9
            at = (np.int32([number]), np.float32(weights[1:2]), np.float32(weights[2:]))
            color = mesh.scattering(*at).base_color[0]
            actual[tuple(mesh.positions[triangle[corner]].tolist())] = np.round(color).tolist()
    return actual


UPRIGHT = {
    (0.0, 1.0, 0.0): [1, 0, 0],
    (1.0, 1.0, 0.0): [0, 1, 0],
    (0.0, 0.0, 0.0): [0, 0, 1],
    (1.0, 0.0, 0.0): [1, 1, 1],
}


def data_uri(data: bytes) -> str:
    return "data:application/octet-stream;base64," + base64.b64encode(data).decode()


class Gltf:
    """A glTF document under construction."""

    def __init__(self) -> None:
        self.json = {"asset": {"version": "2.0"}, "nodes": [], "meshes": [], "materials": []}
        self.json |= {"accessors": [], "bufferViews": [], "buffers": [], "scenes": [{"nodes": [0]}]}

    def view(self, data: bytes, **more) -> int:
        self.json["buffers"].append({"byteLength": len(data), "uri": data_uri(data)})
        number = len(self.json["buffers"]) - 1
        self.json["bufferViews"].append({"buffer": number, "byteLength": len(data)} | more)
        return number

    def accessor(self, values, **more) -> int:
        values = np.ascontiguousarray(values)
        codes = {"int8": 5120, "uint8": 5121, "uint16": 5123, "uint32": 5125, "float32": 5126}
        kind = "SCALAR" if values.ndim == 1 else f"VEC{values.shape[1]}"
        entry = {"count": len(values), "type": kind, "componentType": codes[values.dtype.name]}
        self.json["accessors"].append({"bufferView": self.view(values.tobytes())} | entry | more)
        return len(self.json["accessors"]) - 1

    def square(self, normals=True, uvs=True, **primitive) -> "Gltf":
        """A mesh of one square; `primitive` replaces what it says."""
        attributes = {"POSITION": self.accessor(CORNERS)}
        if normals:
            attributes["NORMAL"] = self.accessor(np.tile(np.float32([0, 0, 1]), (4, 1)))
        if uvs:
            attributes["TEXCOORD_0"] = self.accessor(GLTF_UVS)
        indices = self.accessor(FACES.ravel())
        entry = {"attributes": attributes, "indices": indices} | primitive
        self.json["meshes"].append({"primitives": [entry]})
        return self

    def node(self, **data) -> "Gltf":
        self.json["nodes"].append(data)
        return self

    def write(self, path: Path) -> Path:
        path.write_text(json.dumps(self.json))
        return path


def textured(folder) -> Gltf:
    Image.fromarray(IMAGE).save(folder / "an image.png")
    gltf = Gltf().square(material=0).node(mesh=0)
    texture = {"baseColorTexture": {"index": 0}}
    gltf.json |= {
        "images": [{"uri": "an%20image.png"}],
        "textures": [{"source": 0}],
        "materials": [{"pbrMetallicRoughness": texture}],
    }
    return gltf


def trimesh_square(**kwargs) -> trimesh.Trimesh:
    return trimesh.Trimesh(CORNERS, FACES, process=False, **kwargs)


def ball() -> trimesh.Trimesh:
    return trimesh.creation.icosphere(subdivisions=2)


def assert_is_the_ball(mesh, smooth=True):
    assert len(mesh.triangles) == 320
    np.testing.assert_allclose(np.linalg.norm(mesh.positions, axis=1), 1, atol=1e-5)
    ng = geometric_normals(mesh.positions, mesh.triangles, np.arange(320, dtype=np.int32))
    centres = mesh.positions[mesh.triangles].mean(axis=1)
    assert (np.sum(ng * centres, axis=1) > 0.9).all()
    expected = mesh.positions if smooth else np.repeat(ng, 3, axis=0)
    actual = mesh.normals if smooth else mesh.normals[mesh.triangles.ravel()]
    np.testing.assert_allclose(actual, expected, atol=2e-2 if smooth else 1e-5)
    for array, dtype in ((mesh.positions, "float32"), (mesh.triangles, "uint32")):
        assert array.dtype == dtype and array.flags.c_contiguous


@pytest.mark.parametrize("suffix", [".glb", ".obj", ".ply"])
@pytest.mark.parametrize("smooth", [True, False])
def test_round_trip(tmp_path, suffix, smooth):
    path = tmp_path / f"ball{suffix}"
    ball().export(path, **{"vertex_normal" if suffix == ".ply" else "include_normals": smooth})
    mesh = read(path)
    assert_is_the_ball(mesh, smooth)
    assert not mesh.is_emissive and not mesh.catches_shadows


def test_round_trip_of_gltf_with_files_beside_it(tmp_path):
    for name, data in trimesh.exchange.gltf.export_gltf(ball().scene(), True).items():
        (tmp_path / name).write_bytes(data)
    assert_is_the_ball(read(tmp_path / "model.gltf"))


@pytest.mark.parametrize("suffix", [".glb", ".obj", ".ply"])
def test_images_are_upright(tmp_path, suffix):
    """Every format's own origin of texture coordinates ends up at the upper left corner."""
    path, image = tmp_path / f"square{suffix}", Image.fromarray(IMAGE)
    material = trimesh.visual.material.SimpleMaterial(image=image, diffuse=[255] * 4)
    visual = trimesh.visual.TextureVisuals(FROM_BELOW, material=material)
    trimesh_square(visual=visual).export(path)
    if suffix == ".ply":
        image.save(tmp_path / "image.png")
        head, _, body = path.read_bytes().partition(b"\n")
        path.write_bytes(head + b"\ncomment TextureFile image.png\n" + body)
    assert colours_at_corners(read(path)) == UPRIGHT


def test_images_of_the_scene_file(tmp_path):
    """They use the file's coordinates, also where it has no material of its own."""
    Image.fromarray(IMAGE).save(tmp_path / "t.png")
    path = Gltf().square().node(mesh=0).write(tmp_path / "square.gltf")
    mesh = read(path, {"type": "diffuse", "texture": "t.png", "color": (1, 1, 1)})
    assert colours_at_corners(mesh) == UPRIGHT


def test_images_of_gltf(tmp_path):
    path = textured(tmp_path).write(tmp_path / "square.gltf")
    mesh = read(path)
    assert colours_at_corners(mesh) == UPRIGHT
    assert mesh.materials[0].metallic == mesh.materials[0].roughness == 1  # section 5.22
    embedded = textured(tmp_path)
    data = (tmp_path / "an image.png").read_bytes()
    for image in ({"bufferView": embedded.view(data)}, {"uri": data_uri(data)}):
        embedded.json["images"] = [image | {"mimeType": "image/png"}]
        assert colours_at_corners(read(embedded.write(path))) == UPRIGHT


def test_texture_info_of_gltf(tmp_path):
    gltf = textured(tmp_path)
    gltf.json["samplers"] = [{"wrapS": 33071}]
    gltf.json["textures"][0]["sampler"] = 0
    transform = {"offset": [0.25, 0.5], "rotation": np.pi / 2, "scale": [2, 3]}
    info = gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]
    info["extensions"] = {"KHR_texture_transform": transform}
    texture = read(gltf.write(tmp_path / "a.gltf")).materials[0].base_color_texture
    assert texture.wrap == (CLAMP, REPEAT)
    # The extension's own words: translation * rotation * scale, rotation by
    # (cos, sin, 0; -sin, cos, 0) in columns' order (cos, -sin), (sin, cos).
    np.testing.assert_allclose(texture.transform @ (1, 0, 1), [0.25, 0.5 - 2], atol=1e-12)
    np.testing.assert_allclose(texture.transform @ (0, 1, 1), [0.25 + 3, 0.5], atol=1e-12)


def test_materials_of_gltf(tmp_path):
    gltf = Gltf().square(material=0).square(material=1).square().node(children=[1, 2, 3])
    for number in range(3):
        gltf.node(mesh=number)
    gltf.json["materials"] = [
        {
            "pbrMetallicRoughness": {
                "baseColorFactor": [0.1, 0.2, 0.3, 1],
                "metallicFactor": 0.25,
                "roughnessFactor": 0.5,
            },
            "emissiveFactor": [0.5, 1, 0],
            "extensions": {
                "KHR_materials_emissive_strength": {"emissiveStrength": 10},
                "KHR_materials_ior": {"ior": 2.0},
            },
        },
        {},
    ]
    mesh = read(gltf.write(tmp_path / "a.gltf"))
    first = mesh.materials[mesh.material_numbers[0]]
    assert first.base_color == (0.1, 0.2, 0.3) and first.emission == (5, 10, 0)
    assert (first.metallic, first.roughness) == (0.25, 0.5)
    assert first.coat_f0 == pytest.approx(1 / 9)
    for number in (2, 4):
        default = mesh.materials[mesh.material_numbers[number]]
        assert default.base_color == (1, 1, 1) and default.coat_f0 == pytest.approx(0.04)
        assert (default.metallic, default.roughness) == (1, 1)
    assert (mesh.emitted_luminance > 0).tolist() == [True, True] + [False] * 4


def test_hierarchy_is_baked(tmp_path):
    """A turn about y, then an uneven scale and a shift, and a mirror in between; a matrix too."""
    turn = {"rotation": [0, np.sqrt(0.5), 0, np.sqrt(0.5)]}  # x to -z
    gltf = Gltf().square().node(translation=[10, 0, 0], scale=[1, 2, 1], children=[1, 2])
    gltf.node(mesh=0, **turn)
    matrix = np.diag([-3.0, 1, 1, 1])
    matrix[:3, 3] = 0, 0, 5
    gltf.node(mesh=0, matrix=matrix.T.ravel().tolist())
    gltf.node(mesh=0)  # in no scene
    mesh = read(gltf.write(tmp_path / "a.gltf"))
    first = [[10, 0, 0], [10, 0, -1], [10, 2, -1], [10, 2, 0]]
    second = [[10, 0, 5], [7, 0, 5], [7, 2, 5], [10, 2, 5]]
    np.testing.assert_allclose(mesh.positions, first + second, atol=1e-6)
    np.testing.assert_allclose(mesh.normals, [[1, 0, 0]] * 4 + [[0, 0, 1]] * 4, atol=1e-6)
    ng = geometric_normals(mesh.positions, mesh.triangles, np.arange(4, dtype=np.int32))
    np.testing.assert_allclose(ng, [[1, 0, 0]] * 2 + [[0, 0, 1]] * 2, atol=1e-6)


def test_normals_stay_normal_under_uneven_scale(tmp_path):
    scene = trimesh.Scene()
    scene.add_geometry(ball(), transform=np.diag([1.0, 3.0, 0.5, 1.0]))
    scene.export(tmp_path / "a.glb", include_normals=True)
    mesh = read(tmp_path / "a.glb")
    expected = mesh.positions / np.float32([1, 9, 0.25])  # of an ellipsoid
    expected /= np.linalg.norm(expected, axis=1, keepdims=True)
    np.testing.assert_allclose(mesh.normals, expected, atol=2e-2)


def test_primitives_without_indices_strips_and_fans(tmp_path):
    for mode, order, count in ((4, [0, 1, 2, 0, 2, 3], 2), (5, [0, 1, 3, 2], 2), (6, range(4), 2)):
        gltf = Gltf().node(mesh=0)
        position = gltf.accessor(CORNERS[list(order)])
        primitive = {"attributes": {"POSITION": position}, "mode": mode}
        gltf.json["meshes"].append({"primitives": [primitive]})
        mesh = read(gltf.write(tmp_path / "a.gltf"))
        assert len(mesh.triangles) == count
        assert mesh.normals.tolist() == [[0, 0, 1]] * 6  # flat, and none turned over
        assert set(map(tuple, mesh.positions.tolist())) == set(map(tuple, CORNERS.tolist()))


def test_accessors_of_all_kinds(tmp_path):
    """Normalised coordinates, sparse positions, and strides: what quantised files have."""
    gltf = Gltf().node(mesh=0)
    flat = gltf.accessor(np.float32(CORNERS * [1, 1, 0]))
    rows, values = gltf.view(np.uint8([2]).tobytes()), gltf.view(np.float32([1, 1, 7]).tobytes())
    gltf.json["accessors"][flat]["sparse"] = {
        "count": 1,
        "indices": {"bufferView": rows, "componentType": 5121},
        "values": {"bufferView": values},
    }
    uvs = gltf.accessor((GLTF_UVS * 65535).astype(np.uint16), normalized=True)
    normals = gltf.accessor(np.tile(np.int8([0, 0, 127, 0]), (4, 1)), normalized=True, type="VEC3")
    gltf.json["bufferViews"][gltf.json["accessors"][normals]["bufferView"]]["byteStride"] = 4
    attributes = {"POSITION": flat, "TEXCOORD_0": uvs, "NORMAL": normals}
    indices = gltf.accessor(FACES.ravel().astype(np.uint8))
    gltf.json["meshes"].append({"primitives": [{"attributes": attributes, "indices": indices}]})
    gltf.json["extensionsRequired"] = ["KHR_mesh_quantization"]
    mesh = read(gltf.write(tmp_path / "a.gltf"))
    expected = CORNERS.copy()
    expected[2, 2] = 7
    np.testing.assert_array_equal(mesh.positions, expected)
    np.testing.assert_array_equal(mesh.uvs, GLTF_UVS)
    np.testing.assert_array_equal(mesh.normals, [[0, 0, 1]] * 4)


OBJ = """
mtllib {library}
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl one thing
f 1/1 2/2 3/3
usemtl other
f 1/1 3/3 4/4
"""
MTL = """
newmtl other
Kd 0.1 0.2 0.3
Ks 1 1 1
Pr 0.5
Pm 1
newmtl one thing
Kd 1 1 1
Ke 2 0 0
map_Kd {image}
"""


def write_obj(folder, mtl=MTL, library="some library.mtl") -> Path:
    Image.fromarray(IMAGE).save(folder / "an image.png")
    (folder / "some library.mtl").write_text(mtl.format(image="an image.png"))
    (folder / "a.obj").write_text(OBJ.format(library=library))
    return folder / "a.obj"


def test_relative_indices_of_obj_count_from_their_face(tmp_path):
    """Not from the end of the file, where other vertices follow."""
    triangles = ["v 0 0 0\nv 1 0 0\nv 0 1 0\n", "v 5 5 5\nv 6 5 5\nv 5 6 5\n"]
    (tmp_path / "back.obj").write_text("f -3 -2 -1\n".join([*triangles, ""]))
    (tmp_path / "plain.obj").write_text("".join(triangles) + "f 1 2 3\nf 4 5 \\\n 6\n")
    back, plain = (read(tmp_path / name) for name in ("back.obj", "plain.obj"))
    np.testing.assert_array_equal(back.positions[back.triangles], plain.positions[plain.triangles])
    assert back.positions[back.triangles].max() == 6 and len(back.triangles) == 2


def test_obj_with_a_byte_order_mark_and_tabs(tmp_path):
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    (tmp_path / "marked.obj").write_text("\ufeff" + text.replace(" ", "\t"))
    (tmp_path / "plain.obj").write_text(text)
    marked, plain = (read(tmp_path / name) for name in ("marked.obj", "plain.obj"))
    np.testing.assert_array_equal(marked.positions, plain.positions)


def test_materials_of_obj(tmp_path):
    mesh = read(write_obj(tmp_path))
    assert len(mesh.triangles) == 2
    for number, triangle in enumerate(mesh.triangles):
        material = mesh.materials[mesh.material_numbers[number]]
        if [0, 1, 0] in mesh.positions[triangle].tolist():
            assert material.base_color == (0.1, 0.2, 0.3)
            assert (material.metallic, material.roughness) == (1, 0.5)
        else:
            assert (material.coat_f0, material.metallic, material.emission) == (0, 0, (2, 0, 0))
            np.testing.assert_array_equal(material.base_color_texture.texels, IMAGE)
    assert sorted(mesh.emitted_luminance > 0) == [False, True]
    assert {tuple(row) for row in mesh.uvs.tolist()} == {tuple(row) for row in GLTF_UVS.tolist()}


def test_polygons_are_cut(tmp_path):
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    head = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    head += "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    (tmp_path / "a.ply").write_text(head + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
    for name in ("a.obj", "a.ply"):
        mesh = read(tmp_path / name)
        assert mesh.triangles.shape == (2, 3)
        ng = geometric_normals(mesh.positions, mesh.triangles, np.int32([0, 1]))
        assert ng.tolist() == [[0, 0, 1]] * 2
        assert mesh.materials[0].base_color == (0.8, 0.8, 0.8)


def test_the_scene_files_material_replaces_all(tmp_path):
    path = write_obj(tmp_path, library="gone.mtl")
    mesh = read(path, {"type": "conductor", "color": (0.5, 0.6, 0.7)})
    assert [material.base_color for material in mesh.materials] == [(0.5, 0.6, 0.7)]
    assert not mesh.material_numbers.any() and not mesh.is_emissive
    gltf = textured(tmp_path)
    (tmp_path / "an image.png").unlink()  # nor are its images read
    assert read(gltf.write(tmp_path / "b.gltf"), {"type": "shadow_catcher"}).catches_shadows


def errors(folder: Path) -> dict[str, tuple[Path, str, dict | None]]:
    """Files that cannot be read, each with its message and its material."""
    cases = {}

    def case(name, content, said, **material):
        path = folder / name
        if isinstance(content, Gltf):
            content.write(path)
        elif content is not None:
            path.write_bytes(content if isinstance(content, bytes) else content.encode())
        cases[name] = path, said, material or None

    case("gone.glb", None, "no such file")
    case("a.stl", "solid", r"ends with one of \.glb, \.gltf, \.obj, \.ply")
    case("empty.obj", "", "no triangles")
    case("points.obj", "v 0 0 0\nv 1 0 0\n", "no triangles")
    case("words.obj", "v 0 0 zero\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "cannot be read as .obj")
    (case("huge.obj", "v 0 0 1e20\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "at most 1e\\+18"),)
    case("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "positions must be finite")
    three = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
    case("far.obj", f"{three}f 1 2 9\n", r"far\.obj:6: a face names vertex 9; expected 1 to 3")
    case("zero.obj", f"{three}f 0 1 2\n", r"zero\.obj:6: a face names vertex 0; expected 1 to 3")
    case("back.obj", f"{three}f -1 -2 -4\n", "a face names vertex -4; expected 1 to 3, or -1 to -3")
    case("no uv.obj", f"{three}f 1/1 2/1 3/0\n", "a face names texture coordinate 0")
    case("far uv.obj", f"{three}f 1/1 2/1 3/2\n", "texture coordinate 2; expected 1 to 1")
    case("no normal.obj", f"{three}f 1//1 2//1 3//0\n", "a face names normal 0")
    case(
        "mixed.obj", f"{three}f 1 2 3\nf 1/1/1 2/1/1 3/1/9\n", r"mixed\.obj:7: a face names normal"
    )
    case("forms.obj", f"{three}f 1/1 2 3\n", r"forms\.obj:6: a face has the corners '1/1' and '3'")
    case("line.obj", f"{three}f 1 2\n", "no triangles")
    case("half.obj", f"{three}f 1 2 2.5\n", r"the corner '2\.5'; expected integers")
    case("noise.ply", b"\x00\x01\x02", "cannot be read as .ply")
    header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n0\n0\n"
    case("short.ply", header, "cannot be read as .ply")
    case("noise.glb", b"noise that is no glTF", "does not start as a .glb")
    case("cut.glb", b"glTF\x02\0\0\0\xff\0\0\0\xff\0\0\0JSON{}", "ends within a chunk")
    case("noise.gltf", "{nothing", "cannot be read as .gltf")
    case("list.gltf", "[]", "not a JSON object")
    case("old.gltf", '{"asset": {"version": "1.0"}}', "version 1.0, not 2")
    case("bare.gltf", '{"asset": {"version": "2.0"}}', "no triangles")
    case("bytes.gltf", b"\xff\xfe{}", "cannot be read as .gltf")
    loop = Gltf().square().node(mesh=0, children=[0])
    case("loop.gltf", loop, "node 0 is in its scene twice")
    buffer = Gltf().square().node(mesh=0)
    buffer.json["buffers"][0]["uri"] = "gone.bin"
    case("buffer.gltf", buffer, r"gone\.bin: No such file")
    short = Gltf().square().node(mesh=0)
    short.json["accessors"][0]["count"] = 5
    case("short.gltf", short, "5 items do not fit")
    wild = Gltf().square(indices=0).node(mesh=0)
    case("wild.gltf", wild, "cannot be read|outside")
    numbers = Gltf().square(material=7).node(mesh=0)
    case("numbers.gltf", numbers, "cannot be read as .gltf: an index is")
    draco = Gltf().square().node(mesh=0)
    draco.json["extensionsRequired"] = ["KHR_draco_mesh_compression"]
    case("draco.gltf", draco, "KHR_draco_mesh_compression; gltf-transform cp .* without Draco")
    lost = textured(folder)
    lost.json["images"][0]["uri"] = "lost.png"
    case("lost.gltf", lost, r"lost\.png: no such file")
    bad = textured(folder)
    bad.json["images"][0]["uri"] = data_uri(b"no image")
    case("bad.gltf", bad, r"bad\.gltf, image 0: cannot read the image")
    bright = Gltf().square(material=0).node(mesh=0)
    bright.json["materials"] = [{"pbrMetallicRoughness": {"metallicFactor": 2}}]
    case("bright.gltf", bright, r"outside \[0, 1\]")
    texture = {"type": "diffuse", "texture": "an image.png"}
    case("plain.gltf", Gltf().square(uvs=False).node(mesh=0), "no.* coordinates|none", **texture)
    bare = Gltf().square(uvs=False, material=0).node(mesh=0)
    bare.json |= {key: lost.json[key] for key in ("textures", "materials")}
    bare.json["images"] = [{"uri": "an%20image.png"}]
    case("bare_texture.gltf", bare, "a texture needs texture coordinates")
    return cases


def test_every_error_names_its_file(tmp_path):
    for name, (path, said, material) in errors(tmp_path).items():
        with pytest.raises(SceneError, match=said) as caught:
            read(path, material)
        message = str(caught.value)
        assert str(tmp_path) in message and "\n" not in message, name


def test_what_is_not_shown_is_said_once(tmp_path):
    gltf = textured(tmp_path)
    gltf.json["materials"][0] |= {
        "alphaMode": "BLEND",
        "extensions": {
            "KHR_materials_transmission": {"transmissionFactor": 1},
            "KHR_materials_volume": {"thicknessFactor": 1},
            "KHR_materials_clearcoat": {
                "clearcoatFactor": 1,
                "clearcoatNormalTexture": {"index": 0},
            },
            "KHR_materials_specular": {"specularColorFactor": [1, 0, 0]},
        },
    }
    gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = [1, 1, 1, 0.5]
    gltf.json["meshes"][0]["primitives"].append({"attributes": {"POSITION": 0}, "mode": 1})
    path = gltf.write(tmp_path / "a.gltf")
    with pytest.warns(MeshFileWarning) as caught:
        read(path)
    assert [str(warning.message) for warning in caught] == [
        f"{path}: not shown: alphaMode of transmissive materials, "
        "clear coats of transmissive materials, normal textures of clear coats, "
        "points and lines, refraction of partly transmissive materials, "
        "roughness of transmission, the colour of KHR_materials_specular"
    ]
    with pytest.warns(MeshFileWarning, match="not shown: points and lines$"):
        read(path, {"type": "diffuse"})
    gltf.json["meshes"][0]["primitives"][1] = {"attributes": {}}
    gltf.write(path)
    with pytest.warns(MeshFileWarning, match="not shown: primitives without POSITION$"):
        read(path, {"type": "diffuse"})


@pytest.mark.parametrize(
    ("mtl", "said"),
    [
        ("newmtl other\nKd 1 1 1\n", "material 'one thing', which is in no MTL file"),
        (MTL + "d 0.5\n", r"transparency \(d, Tr\)"),
        (MTL + "map_Bump an image.png\n", "textures other than map_Kd"),
    ],
)
def test_what_obj_does_not_show(tmp_path, mtl, said):
    with pytest.warns(MeshFileWarning, match=said):
        read(write_obj(tmp_path, mtl))


def test_materials_of_obj_that_are_not_there(tmp_path):
    with pytest.warns(MeshFileWarning, match=r"materials of gone\.mtl, which is not there"):
        read(write_obj(tmp_path, library="gone.mtl"))
    (tmp_path / "an image.png").unlink()
    path = write_obj(tmp_path)
    (tmp_path / "an image.png").unlink()
    with pytest.raises(SceneError, match=r"an image\.png: no such file"):
        read(path)


def test_colours_of_vertices_are_said_not_to_be_shown(tmp_path):
    square = trimesh_square(vertex_colors=np.full((4, 4), 200, np.uint8))
    square.export(tmp_path / "a.ply")
    with pytest.warns(MeshFileWarning, match="vertex colours"):
        read(tmp_path / "a.ply")
    read(tmp_path / "a.ply", {"type": "diffuse"})


@pytest.mark.data
def test_a_real_gltf_file(data_folder):
    path = data_folder / "mesh" / "FlightHelmet" / "FlightHelmet.gltf"
    mesh = read(path)
    assert mesh.triangles.shape == (94722, 3) and len(mesh.materials) == 6
    assert np.ptp(mesh.positions, axis=0) == pytest.approx([0.3666, 0.716, 0.3716], abs=1e-3)
    every = np.arange(len(mesh.triangles), dtype=np.int32)
    third = np.full(len(every), 1 / 3, np.float32)
    actual = mesh.scattering(every, third, third)
    ng = geometric_normals(mesh.positions, mesh.triangles, every)
    n = mesh.normals[mesh.triangles].sum(axis=1)
    assert (np.sum(n * ng, axis=1) > 0).mean() > 0.99
    for values in (actual.base_color, actual.alpha, actual.metallic):
        assert (values >= 0).all() and (values <= 1).all() and values.std() > 0.05
    assert not mesh.is_emissive
    # The lenses alone let light through, and its relief follows tangents of its own.
    table = mesh.transmittance
    tau = table.at(every, third, third, np.ones((len(every), 3), np.float32), every >= 0)
    lenses = [material.opacity_texture is not None for material in mesh.materials]
    assert not tau[~np.array(lenses)[mesh.material_numbers]].any() and tau.max() > 0.5
    given = mesh.shading_normals(every, third, third, ng, ng)
    derived = replace(mesh, tangents=None).shading_normals(every, third, third, ng, ng)
    assert np.mean(np.sum(given * derived, axis=1)) > 0.998
    assert np.mean(np.sum(given * n, axis=1) / np.linalg.norm(n, axis=1)) < 0.99


@pytest.mark.data
@pytest.mark.parametrize("name", ["Spot/spot/spot_triangulated.obj", "LeePerrySmith/head.obj"])
def test_real_obj_files(data_folder, name):
    mesh = read(data_folder / "mesh" / name)
    assert len(mesh.triangles) > 5000 and mesh.uvs is not None
    every = np.arange(len(mesh.triangles), dtype=np.int32)
    ng = geometric_normals(mesh.positions, mesh.triangles, every)
    n = mesh.normals[mesh.triangles].sum(axis=1)
    assert (np.sum(n * ng, axis=1) > 0).mean() > 0.99
