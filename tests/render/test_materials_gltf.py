"""What glTF files say of relief, holes and layers, as it is read."""

import io
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from rna_render.materials.bumps import bumped_normals
from rna_sdk.errors import SceneError
from tests.render.test_mesh_files import FACES, GLTF_UVS, Gltf, read
from tests.runtime.points import unit_vectors

CENTRE = np.int32([0]), np.float32([1 / 3]), np.float32([1 / 3])
TOWARDS = np.float32([[0, 0, 1]])


def material(tmp_path, images=(), second_uvs=None, tangents=None, uvs=GLTF_UVS, **data):
    """The square, of one material and of images that are arrays."""
    gltf = Gltf()
    gltf.square(material=0).node(mesh=0)
    attributes = gltf.json["meshes"][0]["primitives"][0]["attributes"]
    attributes["TEXCOORD_0"] = gltf.accessor(np.float32(uvs))
    if second_uvs is not None:
        attributes["TEXCOORD_1"] = gltf.accessor(np.float32(second_uvs))
    if tangents is not None:
        attributes["TANGENT"] = gltf.accessor(np.float32(tangents))
    gltf.json["images"] = []
    for image in images:
        file = io.BytesIO()
        Image.fromarray(np.uint8(image)).save(file, "png")
        view = gltf.view(file.getvalue())
        gltf.json["images"].append({"bufferView": view, "mimeType": "image/png"})
    gltf.json["textures"] = [{"source": k} for k in range(len(images))]
    gltf.json["materials"] = [data]
    return read(gltf.write(tmp_path / "a.gltf"))


def uniform(*colour):
    return np.tile(np.uint8(colour), (2, 2, 1))


def tau(mesh) -> np.ndarray:
    """Transmittance of the middle of the first triangle, met straight on."""
    return mesh.transmittance.at(*CENTRE, -TOWARDS, np.ones(1, bool))[0]


def test_alpha_is_factor_times_texture(tmp_path):
    base = {"baseColorTexture": {"index": 0}, "baseColorFactor": [1, 1, 1, 0.5]}
    data = {"pbrMetallicRoughness": base, "images": [uniform(255, 0, 0, 102)]}
    blend = material(tmp_path, alphaMode="BLEND", **data)
    np.testing.assert_allclose(tau(blend), 0.8, atol=0.5 / 255)
    assert material(tmp_path, **data).transmittance is None
    for cutoff, expected in ((0.19, 0.0), (0.21, 1.0)):
        mask = material(tmp_path, alphaMode="MASK", alphaCutoff=cutoff, **data)
        assert (mask.transmittance is None) if expected == 0 else (tau(mask) == 1).all()
    solid = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
    whole = material(tmp_path, [uniform(1, 2, 3)], alphaMode="BLEND", **solid)
    assert whole.transmittance is None
    with pytest.raises(SceneError, match="alphaMode of 'DITHER'"):
        material(tmp_path, alphaMode="DITHER", **data)


def test_holes_are_where_the_image_has_them(tmp_path):
    """Only the upper left texel of 2 x 2 is there."""
    image = np.full((2, 2, 4), 255)
    image[..., 3] = [[255, 0], [0, 0]]
    data = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "alphaMode": "MASK"}
    mesh = material(tmp_path, [image], **data)
    points = {(0.25, 0.75): 0.0, (0.75, 0.75): 1.0, (0.3, 0.1): 1.0}
    for (x, y), expected in points.items():
        # Triangle 0 is (0,0) (1,0) (1,1), triangle 1 (0,0) (1,1) (0,1).
        where = (0, x - y, y) if x > y else (1, x, y - x)
        at = np.int32([where[0]]), np.float32([where[1]]), np.float32([where[2]])
        actual = mesh.transmittance.at(*at, -TOWARDS, np.ones(1, bool))
        assert (actual == expected).all(), (x, y)


def test_second_coordinates_and_transforms(tmp_path):
    image = np.zeros((1, 2, 4))
    image[0, 1] = 255
    for extra in ({"texCoord": 1}, {"extensions": {"KHR_texture_transform": {"texCoord": 1}}}):
        info = {"baseColorTexture": {"index": 0} | extra}
        data = {"pbrMetallicRoughness": info, "alphaMode": "BLEND"}
        right = np.tile(np.float32([0.75, 0.5]), (4, 1))
        mesh = material(tmp_path, [image], right, uvs=0 * right, **data)
        np.testing.assert_allclose(mesh.scattering(*CENTRE).base_color, 1)
        left = material(tmp_path, [image], right - [0.5, 0], **data)
        np.testing.assert_allclose(tau(left), 1)
    with pytest.raises(SceneError, match="needs texture coordinates"):
        material(tmp_path, [image], **data)


def test_relief_leans_towards_u_and_up_the_image(tmp_path):
    """A normal texture of one colour: x is towards +u, y against v, on both ways to tangents."""
    leaning = uniform(204, 153, 230)
    x, y, z = np.array([204, 153, 230]) / 127.5 - 1
    data = {"normalTexture": {"index": 0, "scale": 0.5}, "images": [leaning]}
    expected = np.array([0.5 * x, 0.5 * y, z]) / np.linalg.norm([0.5 * x, 0.5 * y, z])
    derived = material(tmp_path, **data)
    given = material(tmp_path, tangents=np.tile([1, 0, 0, 1], (4, 1)), **data)
    for mesh in (derived, given):
        for wo in (TOWARDS, -TOWARDS):
            actual = mesh.shading_normals(*CENTRE, TOWARDS, wo)
            np.testing.assert_allclose(actual[0], expected, atol=1e-5)
    mirrored = material(tmp_path, uvs=GLTF_UVS * (-1, 1), **data)
    actual = mirrored.shading_normals(*CENTRE, TOWARDS, TOWARDS)
    np.testing.assert_allclose(actual[0], expected * (-1, 1, 1), atol=1e-5)
    turned = material(tmp_path, tangents=np.tile([0, 1, 0, -1], (4, 1)), **data)
    actual = turned.shading_normals(*CENTRE, TOWARDS, TOWARDS)
    np.testing.assert_allclose(actual[0], expected[[1, 0, 2]], atol=1e-5)


def test_relief_mirrors_nothing_from_inside():
    """However relief leans, the mirror direction is above the surface; relief that does is kept."""
    rng = np.random.default_rng(2)
    m = 4000
    texture = rng.random((m, 3)).astype(np.float32)
    ng, wo = unit_vectors(rng, m), unit_vectors(rng, m)
    n = ng + np.float32(0.2) * unit_vectors(rng, m)
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    corners = np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    mesh = corners, corners[:, :2].copy(), None, np.uint32([[0, 1, 2]])
    hits = np.zeros(m, np.int32), np.zeros(m, np.float32), np.zeros(m, np.float32)
    actual = bumped_normals(texture, 1.0, mesh, hits, n, ng, wo).astype(np.float64)
    np.testing.assert_allclose(np.linalg.norm(actual, axis=1), 1, atol=1e-5)
    mirror = 2 * np.sum(actual * wo, axis=1)[:, None] * actual - wo
    side = np.sum(ng * wo, axis=1)
    above = np.sum(ng * mirror, axis=1) * np.sign(side)
    assert (above > np.minimum(0.8 * abs(side), 0.008)).all()


def test_layers_of_the_extensions(tmp_path):
    extensions = {
        "KHR_materials_clearcoat": {
            "clearcoatFactor": 0.8,
            "clearcoatTexture": {"index": 0},
            "clearcoatRoughnessFactor": 0.5,
            "clearcoatRoughnessTexture": {"index": 0},
        },
        "KHR_materials_specular": {"specularFactor": 0.5, "specularTexture": {"index": 0}},
    }
    images = [uniform(51, 102, 0, 204)]
    points = material(tmp_path, images, extensions=extensions).scattering(*CENTRE)
    assert points.clear.weight == pytest.approx(0.8 * 0.2)
    assert points.clear.alpha == pytest.approx((0.5 * 0.4) ** 2)
    np.testing.assert_allclose(points.clear.n, TOWARDS)
    np.testing.assert_allclose(points.weights, [[0.5 * 0.8, 1]], rtol=1e-6)
    assert material(tmp_path).scattering(*CENTRE).clear is None


def test_thin_glass(tmp_path):
    base = {"baseColorFactor": [0.8, 0.6, 0.4, 1], "roughnessFactor": 0, "metallicFactor": 0.5}
    glass = {"transmissionFactor": 0.5, "transmissionTexture": {"index": 0}}
    extensions = {"KHR_materials_transmission": glass, "KHR_materials_ior": {"ior": 2.0}}
    data = {"pbrMetallicRoughness": base, "extensions": extensions}
    mesh = material(tmp_path, [uniform(102, 0, 0)], **data)
    expected = 0.5 * 0.4 * 0.5 * np.array([0.8, 0.6, 0.4]) * (1 - 1 / 9)
    np.testing.assert_allclose(tau(mesh), expected, atol=0.5 / 255)
    np.testing.assert_allclose(mesh.scattering(*CENTRE).weights, [[1, 0.8]], rtol=1e-6)
    share = mesh.base_share(*CENTRE, TOWARDS, TOWARDS)
    np.testing.assert_allclose(share[0], 1 - tau(mesh), rtol=1e-6)
    opaque = replace(mesh, materials=(replace(mesh.materials[0], transmission=0.0),))
    assert opaque.base_share(*CENTRE, TOWARDS, TOWARDS) is None


def test_colours_of_vertices_are_factors_of_the_base_colour(tmp_path):
    """They count for their own primitive, interpolated, without their alpha."""
    colors = np.uint16(np.random.default_rng(3).integers(0, 65536, (4, 4)))
    gltf = Gltf().square(material=0).square(material=0, normals=False).node(mesh=0)
    gltf.node(mesh=1)
    gltf.json["scenes"] = [{"nodes": [0, 1]}]
    gltf.json["materials"] = [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 1.0, 0.25, 1.0]}}]
    attributes = gltf.json["meshes"][1]["primitives"][0]["attributes"]
    attributes["COLOR_0"] = gltf.accessor(colors, normalized=True)
    mesh = read(gltf.write(tmp_path / "a.gltf"))
    triangle = np.arange(4, dtype=np.int32)
    u, v = np.float32([0.2] * 4), np.float32([0.3] * 4)
    actual = mesh.scattering(triangle, u, v).base_color
    corners = (colors[:, :3] / 65535.0)[FACES]
    mixed = 0.5 * corners[:, 0] + 0.2 * corners[:, 1] + 0.3 * corners[:, 2]
    expected = np.concatenate([np.ones((2, 3)), mixed]) * [0.5, 1.0, 0.25]
    np.testing.assert_allclose(actual, expected, atol=1e-5)
    assert read(tmp_path / "a.gltf", {"type": "diffuse"}).colors is None
    attributes["COLOR_0"] = gltf.accessor(np.full((4, 3), 2, np.float32))
    with pytest.raises(SceneError, match=r"a\.gltf.*a vertex has a colour outside \[0, 1\]"):
        read(gltf.write(tmp_path / "a.gltf"))
