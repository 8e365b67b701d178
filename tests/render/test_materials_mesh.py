"""Textures, and what meshes are made of at the points that rays hit."""

import numpy as np
import pytest
from PIL import Image
from pydantic import TypeAdapter

from rna_render.materials import Material, MeshObject, Texture, ground, make_material
from rna_render.materials.ggx import MIN_ALPHA
from rna_render.materials.mesh_object import LUMINANCE
from rna_render.materials.textures import LINEAR, SRGB, read_texels
from rna_render.scene.material_models import MaterialModel
from rna_render.scene.scene_model import CameraModel, GroundModel
from rna_sdk.errors import SceneError
from rna_trace.bilinear import CLAMP, MIRROR, REPEAT
from rna_trace.surface import geometric_normals

ADAPTER = TypeAdapter(MaterialModel)

# Two rows of three texels: 0 to 50 in red, the row in green.
TEXELS = np.array(
    [[[0, 0, 7], [10, 0, 7], [20, 0, 7]], [[30, 90, 7], [40, 90, 7], [50, 90, 7]]], np.uint8
)


def red(texture, u, v) -> float:
    return float(texture.lookup(np.float32([[u, v]]))[0, 0] * 255)


def square_of(*materials, numbers=(0, 0), uvs=True) -> MeshObject:
    """A unit square in x and y, with v down; its two triangles have the given materials."""
    corners = np.float32([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    flipped = corners[:, :2] * (1, -1) + (0, 1)
    return MeshObject(
        positions=corners,
        normals=np.tile(np.float32([0, 0, 1]), (4, 1)),
        uvs=flipped.astype(np.float32) if uvs else None,
        triangles=np.array([[0, 1, 2], [0, 2, 3]], np.uint32),
        material_numbers=np.array(numbers, np.int32),
        materials=materials,
    )


def hits(*rows) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    triangle, u, v = zip(*rows, strict=True)
    return np.int32(triangle), np.float32(u), np.float32(v)


def test_texel_centres_give_texels():
    texture = Texture(TEXELS, LINEAR)
    for row in range(2):
        for column in range(3):
            actual = texture.lookup(np.float32([[(column + 0.5) / 3, (row + 0.5) / 2]]))
            np.testing.assert_allclose(actual[0] * 255, TEXELS[row, column], atol=1e-4)


def test_between_centres_is_bilinear():
    texture = Texture(TEXELS, LINEAR)
    assert red(texture, 1 / 3, 0.25) == pytest.approx(5)  # half way between 0 and 10
    assert red(texture, 0.5, 0.5) == pytest.approx(25)  # 10 and 40
    assert red(texture, 1.75 / 3, 0.75) == pytest.approx(42.5)


@pytest.mark.parametrize(
    ("wrap", "u", "expected"),
    [
        (REPEAT, 0.0, 10),  # between 20 on the left and 0
        (REPEAT, 1.0, 10),
        (REPEAT, -0.5 / 3, 20),
        (REPEAT, 4 + 1.5 / 3, 10),
        (REPEAT, -7 + 1.5 / 3, 10),
        (CLAMP, 0.0, 0),
        (CLAMP, -5.3, 0),
        (CLAMP, 1.2, 20),
        (MIRROR, -1.5 / 3, 10),
        (MIRROR, 1 + 0.5 / 3, 20),
        (MIRROR, 2 + 1.5 / 3, 10),
        (MIRROR, 1.0, 20),
    ],
)
def test_outside_of_the_image(wrap, u, expected):
    assert red(Texture(TEXELS, LINEAR, (wrap, REPEAT)), u, 0.25) == pytest.approx(
        expected, abs=1e-3
    )
    turned = Texture(np.ascontiguousarray(TEXELS.transpose(1, 0, 2)), LINEAR, (REPEAT, wrap))
    assert red(turned, 0.25, u) == pytest.approx(expected, abs=1e-3)


def test_filtering_is_of_linear_values():
    """Half way between black and white is half the light, not half the code."""
    texels = np.array([[[0] * 3, [255] * 3, [188] * 3]], np.uint8)
    assert red(Texture(texels, SRGB), 1 / 3, 0.5) == pytest.approx(127.5)
    assert red(Texture(texels, SRGB), 2.5 / 3, 0.5) / 255 == pytest.approx(0.5029, abs=1e-4)
    np.testing.assert_allclose(
        Texture(texels, SRGB).mean(), [(0 + 1 + 0.502886) / 3] * 3, atol=1e-5
    )


def test_transform_comes_before_the_lookup():
    transform = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])  # u and v swapped
    texture = Texture(TEXELS, LINEAR, transform=transform)
    assert red(texture, 0.75, 0.5 / 3) == pytest.approx(30)


@pytest.mark.parametrize(
    ("mode", "expected"), [("L", 100), ("RGBA", 100), ("P", 102), ("I;16", 100)]
)
def test_images_of_several_kinds(tmp_path, mode, expected):
    path = tmp_path / "image.png"
    if mode == "I;16":
        Image.fromarray(np.full((2, 2), 100 * 257, np.uint16)).save(path)
    else:
        grey = Image.fromarray(np.full((2, 2, 3), 100, np.uint8))
        grey.convert(mode).save(path)
    np.testing.assert_array_equal(read_texels(path, path), np.full((2, 2, 3), expected))
    np.testing.assert_array_equal(read_texels(path.read_bytes(), "x"), np.full((2, 2, 3), expected))


def test_images_that_cannot_be_read(tmp_path):
    with pytest.raises(SceneError, match=r"none\.png: no such file"):
        read_texels(tmp_path / "none.png", tmp_path / "none.png")
    broken = tmp_path / "broken.png"
    broken.write_bytes(b"\x89PNG\r\n\x1a\n and nothing")
    with pytest.raises(SceneError, match=r"broken\.png: cannot read the image"):
        read_texels(broken, broken)
    Image.fromarray(np.zeros((2, 2), np.float32)).save(tmp_path / "deep.tiff")
    with pytest.raises(SceneError, match="floating point"):
        read_texels(tmp_path / "deep.tiff", "deep.tiff")


def test_materials_of_scene_files(tmp_path):
    Image.fromarray(TEXELS).save(tmp_path / "t.png")

    def make(**data) -> Material:
        textures = {k: tmp_path / v for k, v in data.items() if k == "texture"}
        return make_material(ADAPTER.validate_python(data | textures))

    diffuse = make(type="diffuse", color=(0.1, 0.2, 0.3), texture="t.png", emission=(1, 2, 3))
    assert diffuse.base_color == (0.1, 0.2, 0.3) and diffuse.emission == (1, 2, 3)
    assert diffuse.metallic == 0 and diffuse.coat_f0 == 0
    np.testing.assert_array_equal(diffuse.base_color_texture.texels, TEXELS)
    assert diffuse.base_color_texture.decode is SRGB
    metal = make(type="conductor", roughness=0.5)
    assert (metal.metallic, metal.roughness) == (1, 0.5)
    coat = make(type="coated", roughness=0.2, ior=1.5)
    assert (coat.metallic, coat.roughness, coat.coat_f0) == (0, 0.2, pytest.approx(0.04))
    assert make(type="shadow_catcher").base_color == (1, 1, 1)
    with pytest.raises(SceneError, match=r"gone\.png: no such file"):
        make(type="diffuse", texture="gone.png")


def test_scattering_gathers_factors():
    first = Material((0.1, 0.2, 0.3), 1.0, 0.5, 0.0, (1, 0, 0))
    second = Material((0.4, 0.5, 0.6), 0.0, 0.0, 0.04)
    mesh = square_of(first, second, numbers=(1, 0), uvs=False)
    actual = mesh.scattering(*hits((0, 0.2, 0.3), (1, 0.5, 0.5), (1, 0, 0)))
    np.testing.assert_allclose(actual.base_color, [[0.4, 0.5, 0.6]] + [[0.1, 0.2, 0.3]] * 2)
    np.testing.assert_allclose(actual.alpha, [MIN_ALPHA, 0.25, 0.25])
    np.testing.assert_allclose(actual.metallic, [0, 1, 1])
    np.testing.assert_allclose(actual.coat_f0, [0.04, 0, 0])
    np.testing.assert_allclose(actual.emission, [[0, 0, 0], [1, 0, 0], [1, 0, 0]])
    for values in (
        actual.base_color,
        actual.alpha,
        actual.metallic,
        actual.coat_f0,
        actual.emission,
    ):
        assert values.dtype == np.float32
    nothing = mesh.scattering(np.zeros(0, np.int32), *np.zeros((2, 0), np.float32))
    assert nothing.base_color.shape == (0, 3)


def test_textures_multiply_factors():
    """Roughness is in green, metallic in blue: glTF 2.0, section 3.9.2."""
    metal_rough = np.array([[[255, 128, 51], [255, 255, 255]]], np.uint8)
    material = Material(
        base_color=(0.5, 1.0, 1.0),
        metallic=0.5,
        roughness=0.8,
        coat_f0=0.04,
        emission=(2.0, 4.0, 0.0),
        base_color_texture=Texture(TEXELS, LINEAR),
        metallic_roughness_texture=Texture(metal_rough, LINEAR, (CLAMP, CLAMP)),
        emission_texture=Texture(TEXELS, LINEAR),
    )
    plain = Material((0.9, 0.9, 0.9))
    mesh = square_of(material, plain, numbers=(0, 1))
    # x = u + v and y = v in the first triangle; the image is upright, so y = 1/4 is its lower row.
    actual = mesh.scattering(*hits((0, 1 / 6, 0), (0, 0.25, 0.25), (1, 0.1, 0.1)))
    lower = mesh.scattering(*hits((0, 0.25, 0.25)))
    np.testing.assert_allclose(lower.base_color[0] * 255, [0.5 * 40, 90, 7], rtol=1e-5)
    np.testing.assert_allclose(lower.emission[0] * 255, [2 * 40, 4 * 90, 0], rtol=1e-5)
    np.testing.assert_allclose(actual.alpha[0], (0.8 * 128 / 255) ** 2, rtol=1e-5)
    np.testing.assert_allclose(actual.metallic[0], 0.5 * 51 / 255, rtol=1e-5)
    np.testing.assert_allclose(actual.base_color[2], 0.9)
    np.testing.assert_allclose(actual.metallic[2], 0.0)
    again = mesh.emission(*hits((0, 0.25, 0.25), (1, 0.1, 0.1)))
    np.testing.assert_allclose(again, [lower.emission[0], [0, 0, 0]])


def test_emitted_luminance():
    dark, lamp = Material(), Material(emission=(1.0, 2.0, 3.0))
    mesh = square_of(dark, lamp, numbers=(0, 1), uvs=False)
    expected = [0, LUMINANCE @ (1, 2, 3)]
    np.testing.assert_allclose(mesh.emitted_luminance, expected, rtol=1e-6)
    assert mesh.is_emissive and not square_of(dark, uvs=False).is_emissive


def test_emitted_luminance_of_textures():
    """Near the true mean for a smooth image; more than 0 for a spot that all estimates miss."""
    ramp = np.repeat(np.arange(256, dtype=np.uint8)[None, :, None], 3, axis=2)
    lamp = Material(emission=(1.0, 1.0, 1.0), emission_texture=Texture(ramp, LINEAR))
    mesh = square_of(lamp)
    np.testing.assert_allclose(mesh.emitted_luminance, [2 / 3, 1 / 3], atol=0.03)
    assert mesh.emitted_luminance.dtype == np.float32
    spot = np.zeros((256, 256, 3), np.uint8)
    spot[3, 5] = 255
    lamp = Material(emission=(1.0, 1.0, 1.0), emission_texture=Texture(spot, SRGB))
    assert (square_of(lamp).emitted_luminance > 0).all()
    black = Material(emission=(1.0, 1.0, 1.0), emission_texture=Texture(0 * spot, SRGB))
    assert not square_of(black).is_emissive


def test_ground():
    camera = CameraModel(position=(0, 0, 0), look_at=(0, 0, -1))
    model = GroundModel(height=-0.5, size=4.0)
    plane = ground(model, camera)
    assert plane.positions[:, 1].tolist() == [-0.5] * 4
    assert np.ptp(plane.positions, axis=0).tolist() == [4, 0, 4]
    assert plane.normals.tolist() == [[0, 1, 0]] * 4
    ng = geometric_normals(plane.positions, plane.triangles, np.int32([0, 1]))
    assert ng.tolist() == [[0, 1, 0]] * 2
    np.testing.assert_array_equal(plane.uvs, plane.positions[:, [0, 2]])
    actual = plane.scattering(*hits((0, 0.3, 0.3), (1, 0.3, 0.3)))
    np.testing.assert_allclose(actual.base_color, 0.8)
    assert not plane.catches_shadows and not plane.is_emissive
    catcher = GroundModel.model_validate({"material": {"type": "shadow_catcher"}})
    assert ground(catcher, camera).catches_shadows


def test_a_ground_without_a_size_has_no_end_and_no_gaps():
    camera = CameraModel(position=(100_000.25, 3, -7.5), look_at=(100_002.25, 3, -7.5))
    plane = ground(GroundModel(height=1), camera)
    assert np.abs(plane.positions).max() > 1e6 and (plane.positions[:, 1] == -2).all()
    corners = plane.positions[plane.triangles].astype(np.float64)
    doubled = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (doubled[:, 1] > 0).all() and not doubled[:, [0, 2]].any()
    assert doubled[:, 1].sum() / 2 == pytest.approx(np.ptp(plane.positions[:, 0]) ** 2)
    uvs = plane.uvs - plane.positions[:, [0, 2]]
    np.testing.assert_allclose(uvs[:4], [[0.25, 0.5]] * 4)
