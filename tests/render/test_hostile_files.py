"""Files made to crash, hang or fill the memory: one line each, before anything is allocated."""

import json
import os
import struct
import tracemalloc
import zlib
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from rna_render.lights.files.environment_file import environment_image, read_environment
from rna_render.materials import read_mesh_object
from rna_render.materials.ggx_albedo import _place
from rna_render.materials.textures import read_texels
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import read_scene
from rna_sdk.errors import SceneError
from rna_trace.bilinear import CLAMP, MIRROR, REPEAT, texels_around
from tests.render.test_mesh_files import GLTF_UVS, Gltf, textured
from tests.time_limit import time_limit

HUGE = [np.nan, np.inf, -np.inf, 1e30, -1e30, 1e308, -1e308]
WRAPS = {REPEAT: 10497, CLAMP: 33071, MIRROR: 33648}


def read(path: Path):
    return read_mesh_object(path)


@contextmanager
def mebibytes(limit: float):
    tracemalloc.start()
    try:
        yield
        assert tracemalloc.get_traced_memory()[1] < limit * 2**20
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize("wrap", WRAPS)
@pytest.mark.parametrize("size", [1, 2, 7, 4096])
def test_texels_are_within_the_image_at_any_coordinate(wrap, size):
    for x in [*HUGE, 0.0, 1.0, -1e-17, 1 + 1e-16, 2.0, 0.5, -3.25, 1e15 + 0.5, 5e-324]:
        first, second, rest = texels_around(x, size, wrap)
        assert 0 <= first < size and 0 <= second < size and 0 <= rest <= 1, x


@pytest.mark.parametrize("value", HUGE)
def test_a_table_is_looked_up_within_itself(value):
    cell, _ = _place(min(value, 1.0) if value == value else value, 96)
    assert 0 <= cell <= 94


def transformed(folder: Path, wrap: int = REPEAT, uvs=None, **transform) -> Path:
    gltf = textured(folder)
    info = gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]
    info["extensions"] = {"KHR_texture_transform": transform}
    gltf.json["samplers"] = [{"wrapS": WRAPS[wrap], "wrapT": WRAPS[wrap]}]
    gltf.json["textures"][0]["sampler"] = 0
    gltf.json["materials"][0]["alphaMode"] = "MASK"
    if uvs is not None:
        place = gltf.accessor(np.float32(uvs))
        gltf.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = place
    return gltf.write(folder / "a.gltf")


@pytest.mark.parametrize("value", HUGE)
@pytest.mark.parametrize("key", ["offset", "scale", "rotation"])
def test_texture_transforms_are_finite(key, value, tmp_path):
    value = value if key == "rotation" else [1, value]
    with pytest.raises(SceneError, match=r"a\.gltf: .*texture transform has numbers"):
        read(transformed(tmp_path, **{key: value}))


@pytest.mark.parametrize("wrap", WRAPS)
def test_large_transforms_of_large_coordinates(wrap, tmp_path):
    """Coordinates within the limits are looked up within the image."""
    path = transformed(tmp_path, wrap, GLTF_UVS * np.float32(1e17), scale=[1e18, -1e18])
    at = np.zeros(50, np.int32), np.linspace(0, 1, 50).astype(np.float32), np.zeros(50, np.float32)
    actual = read(path).scattering(*at).base_color
    assert (actual >= 0).all() and (actual <= 1).all()


@pytest.mark.parametrize("value", HUGE[:4])
def test_texture_coordinates_are_finite(value, tmp_path):
    uvs = GLTF_UVS.copy()
    with np.errstate(over="ignore"):
        uvs[2, 1] = value
    with pytest.raises(SceneError, match=r"a\.gltf: texture coordinates must be finite"):
        read(transformed(tmp_path, uvs=uvs))
    corners = f"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 {value}\nvt 0 1\n"
    obj = corners + "f 1/1 2/2 3/3\n"
    (tmp_path / "a.obj").write_text(obj)
    with pytest.raises(SceneError, match=r"a\.obj: texture coordinates must be finite"):
        read(tmp_path / "a.obj")


@pytest.mark.parametrize("value", HUGE)
@pytest.mark.parametrize("key", ["translation", "scale", "rotation", "matrix"])
def test_transforms_of_nodes_are_finite(key, value, tmp_path):
    length = {"rotation": 4, "matrix": 16}.get(key, 3)
    gltf = Gltf().square().node(mesh=0, **{key: [value] + [1] * (length - 1)})
    path = gltf.write(tmp_path / "a.gltf")
    try:
        mesh = read(path)
    except SceneError as error:
        assert "a.gltf: it cannot be read as .gltf" in str(error)
    else:
        assert key == "rotation"  # of any length
        assert np.isfinite(mesh.positions).all() and np.isfinite(mesh.normals).all()


def test_a_rotation_of_no_length_is_refused_in_one_line(tmp_path):
    """numpy's warning of a division by 0 was printed."""
    path = Gltf().square().node(mesh=0, rotation=[0, 0, 0, 0]).write(tmp_path / "a.gltf")
    with pytest.raises(SceneError, match="a rotation is \\[0, 0, 0, 0\\]; expected a quaternion"):
        read(path)


@pytest.mark.parametrize("ior", [np.nan, np.inf, -1, -1.0001, 1e308])
def test_refractive_indices(ior, tmp_path):
    gltf = Gltf().square(material=0).node(mesh=0)
    gltf.json["materials"] = [{"extensions": {"KHR_materials_ior": {"ior": ior}}}]
    try:
        mesh = read(gltf.write(tmp_path / "a.gltf"))
    except SceneError:
        return
    assert 0 <= mesh.materials[0].coat_f0 < 1


def test_indices_are_whole_numbers(tmp_path):
    gltf = Gltf().square()
    indices = np.float32([0, 1, np.nan])
    gltf.json["meshes"][0]["primitives"][0]["indices"] = gltf.accessor(indices)
    with pytest.raises(SceneError, match="indices are of type float32, not unsigned integers"):
        read(gltf.node(mesh=0).write(tmp_path / "a.gltf"))


def test_an_accessor_without_data_is_small(tmp_path):
    gltf = Gltf().square().node(mesh=0)
    del gltf.json["accessors"][0]["bufferView"]
    gltf.json["accessors"][0]["count"] = 60_000_000
    path = gltf.write(tmp_path / "a.gltf")
    with mebibytes(10), pytest.raises(SceneError, match="60000000 items and no buffer view"):
        read(path)


def test_a_mesh_that_many_nodes_show_is_counted_first(tmp_path):
    gltf = Gltf().square()
    del gltf.json["accessors"][0]["bufferView"]
    gltf.json["accessors"][0]["count"] = 1 << 20
    for _ in range(65):
        gltf.node(mesh=0)
    gltf.json["scenes"] = [{"nodes": list(range(65))}]
    path = gltf.write(tmp_path / "a.gltf")
    with mebibytes(10), pytest.raises(SceneError, match=r"68157440 vertices .*; at most 67108864"):
        read(path)


@pytest.mark.parametrize("count", [-1, 2.5, "9", True, 1e300])
def test_a_count_is_a_whole_number(count, tmp_path):
    gltf = Gltf().square().node(mesh=0)
    gltf.json["accessors"][0]["count"] = count
    with pytest.raises(SceneError, match=r"a\.gltf: it cannot be read as \.gltf"):
        read(gltf.write(tmp_path / "a.gltf"))


MESHES = {
    "two numbers.obj": b"v 0 0 0\nv 1 0 0\nv 1 1\nf 1 2 3\n",
    "a zero byte.obj": b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf \xff\0\0\0 2 3\n",
    "a short line.ply": b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
    b"property float y\nproperty float z\nelement face 1\n"
    b"property list uchar int vertex_indices\nend_header\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n",
}


@pytest.mark.parametrize("name", MESHES)
def test_meshes_of_uneven_lines(name, tmp_path):
    (tmp_path / name).write_bytes(MESHES[name])
    try:
        assert read(tmp_path / name).positions.shape[1] == 3
    except SceneError as error:
        said = str(error)
        assert f"{name}: it cannot be read as" in said or f"{name}:6: a face has the corner" in said
        assert said.isprintable()


def png(width: int, height: int) -> bytes:
    def chunk(kind: bytes, data: bytes) -> bytes:
        end = struct.pack(">I", zlib.crc32(kind + data))
        return struct.pack(">I", len(data)) + kind + data + end

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    start = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
    return start + chunk(b"IDAT", zlib.compress(bytes(64))) + chunk(b"IEND", b"")


@pytest.mark.parametrize("size", [(30000, 30000), (2**31 - 1, 2**31 - 1), (11600, 11600)])
def test_a_texture_has_a_limit_of_pixels(size, tmp_path):
    (tmp_path / "a.png").write_bytes(png(*size))
    with mebibytes(10), pytest.raises(SceneError, match=r"a\.png: cannot read the image"):
        read_texels(tmp_path / "a.png", tmp_path / "a.png")


def test_no_decoder_of_a_texture_starts_a_program(tmp_path):
    """PIL hands PostScript to Ghostscript."""
    content = b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 4 4\n%%EndComments\nshowpage\n"
    (tmp_path / "a.png").write_bytes(content)
    with pytest.raises(SceneError, match="broken, or of a kind"):
        read_texels(tmp_path / "a.png", tmp_path / "a.png")


CAMERA = "camera: {position: [0, 0, 3], look_at: [0, 0, 0]}\n"
PIPES = {
    "objects: [{path: pipe.obj}]\n": "pipe.obj",
    "objects: [{path: pipe.gltf}]\n": "pipe.gltf",
    "assets: [{path: pipe.rna}]\n": "pipe.rna",
    "ground: {material: {type: diffuse, texture: pipe.png}}\n": "pipe.png",
}


@pytest.mark.parametrize("text", PIPES)
def test_a_pipe_is_no_file_of_a_scene(text, tmp_path):
    os.mkfifo(tmp_path / PIPES[text])
    (tmp_path / "scene.yaml").write_text(text + CAMERA)
    with time_limit(20), pytest.raises(SceneError, match="is a pipe or a device"):
        load_world(read_scene(tmp_path / "scene.yaml"))


def test_a_pipe_is_no_scene_nor_environment_nor_buffer(tmp_path):
    for name in ("scene.yaml", "sky.hdr", "buffer.bin"):
        os.mkfifo(tmp_path / name)
    gltf = Gltf().square().node(mesh=0)
    gltf.json["buffers"][0]["uri"] = "buffer.bin"
    gltf.write(tmp_path / "a.gltf")
    with time_limit(20):
        for load in (read_scene, read_environment, environment_image, read):
            name = {read_scene: "scene.yaml", read: "a.gltf"}.get(load, "sky.hdr")
            with pytest.raises(SceneError, match="is a pipe or a device"):
                load(tmp_path / name)


YAML = {
    "assets: " + "[" * 600: "too deep for a scene",
    "seed: " + "1:" * 20000 + "1\n" + CAMERA + "ground: {}\n": "seed: expected a whole number",
    "seed: " + "1" * 5000 + "\n" + CAMERA + "ground: {}\n": "too many digits",
    "seed: 0x" + "f" * 5000 + "\n" + CAMERA + "ground: {}\n": "a number of thousands of digits",
    'assets: [{path: "a\\0b.rna"}]\n' + CAMERA: r"assets\[0\].path: must not contain a NUL",
    f"assets: [{{path: {'a' * 300}.rna}}]\n" + CAMERA: r"assets\[0\].path: is too long",
    f"objects: [{{path: {'a/' * 3000}a.obj}}]\n" + CAMERA: r"objects\[0\].path: is too long",
    f"ground: {{material: {{type: diffuse, texture: {'a' * 300}}}}}\n" + CAMERA: "is too long",
    f"ground: {{}}\nlights: [{{type: environment, path: {'b' * 300}}}]\n" + CAMERA: "is too long",
}


@pytest.mark.parametrize("text", YAML, ids=range(len(YAML)))
def test_scenes_that_are_too_deep_or_too_long(text, tmp_path):
    (tmp_path / "scene.yaml").write_text(text)
    with pytest.raises(SceneError, match=YAML[text]) as caught:
        read_scene(tmp_path / "scene.yaml")
    assert len(str(caught.value)) < 500 + len(str(tmp_path))


def test_a_scene_file_has_a_limit_of_bytes(tmp_path):
    with (tmp_path / "scene.yaml").open("wb") as file:
        file.truncate((1 << 24) + 1)
    with mebibytes(1), pytest.raises(SceneError, match="has 16777217 bytes; a scene file has at"):
        read_scene(tmp_path / "scene.yaml")


@pytest.mark.parametrize("factor", [[1, 1, 1, 1], [], [1, 1], 1, "111", [1, 1, "x"], None])
def test_an_emission_is_three_numbers(factor, tmp_path):
    gltf = Gltf().square(material=0).node(mesh=0)
    gltf.json["materials"] = [{"emissiveFactor": factor}, {}]
    try:
        assert len(read(gltf.write(tmp_path / "a.gltf")).materials[0].emission) == 3
    except SceneError as error:
        assert "a.gltf: it cannot be read as .gltf" in str(error)


@pytest.mark.parametrize("name", ["a\0b.yaml", "a" * 300 + ".yaml", "a" * 300 + ".rna"])
def test_a_scene_of_a_name_that_no_file_can_have(name):
    with pytest.raises(SceneError):
        read_scene(Path(name))


def test_json_that_is_too_deep(tmp_path):
    (tmp_path / "a.gltf").write_text("[" * 100_000)
    with pytest.raises(SceneError, match=r"a\.gltf: it cannot be read as \.gltf"):
        read(tmp_path / "a.gltf")


@pytest.mark.parametrize("uri", ["a\0b.png", "a" * 5000, "%00", "../" * 2000])
def test_names_that_no_file_can_have(uri, tmp_path):
    gltf = textured(tmp_path)
    gltf.json["images"][0]["uri"] = uri
    (tmp_path / "a.gltf").write_text(json.dumps(gltf.json))
    with pytest.raises(SceneError, match=r"cannot read|no such file|a uri of \d+ characters"):
        read(tmp_path / "a.gltf")
