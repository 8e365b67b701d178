"""What an export adds to a package: poster, stand-in materials and proxies."""

import io

import numpy as np
import pytest
import trimesh
from PIL import Image

from rna_export.export.poster_rendering import png_of
from rna_export.export.proxy import proxy_of
from rna_export.export.standin_textures import standin_material
from rna_sdk.package import Mesh


def samples_of(albedo: tuple[float, ...], specular: float, roughness: float) -> dict:
    """A Lambertian surface under a GGX lobe, lit and seen from all around."""
    rng = np.random.default_rng(1)
    n, wo, wi = (v / np.linalg.norm(v, axis=1)[:, None] for v in rng.normal(size=(3, 60_000, 3)))
    cos_i, cos_o = (np.einsum("ij,ij->i", n, w) for w in (wi, wo))
    half = wi + wo
    cos_h = np.einsum("ij,ij->i", n, half / np.linalg.norm(half, axis=1)[:, None])
    squared = roughness**4
    lobe = squared / (np.pi * (1 + cos_h**2 * (squared - 1)) ** 2) / (4 * np.maximum(cos_o, 1e-3))
    radiance = np.array(albedo) / np.pi * cos_i[:, None] + specular * lobe[:, None]
    visible = cos_i > 0
    radiance[~visible] = 0.7  # light from within: no part of the estimate
    fields = {"normal": n, "wo": wo, "wi": wi, "radiance": radiance, "visible": visible}
    return {name: np.float32(values) for name, values in fields.items()}


@pytest.mark.parametrize("roughness", [0.25, 0.5])
def test_standin_finds_colour_and_roughness(roughness):
    material = standin_material(samples_of((0.6, 0.3, 0.1), 0.04, roughness))
    np.testing.assert_allclose(material.base_color, (0.6, 0.3, 0.1), atol=0.03)
    assert material.roughness == pytest.approx(roughness, abs=0.051)
    assert material.metallic == 0.0


def test_standin_of_metal_has_the_colour_of_its_lobe():
    material = standin_material(samples_of((0.0, 0.0, 0.0), 0.8, 0.4))
    assert material.metallic == 1.0
    np.testing.assert_allclose(material.base_color, (0.8, 0.8, 0.8), atol=0.1)


def test_standin_of_a_print_under_clear_coat_is_no_metal():
    """The coat's narrow lobe is fitted by a wide one that reflects more than arrives."""
    material = standin_material(samples_of((0.5, 0.5, 0.5), 4.5, 0.1))
    assert material.metallic == 0.0
    np.testing.assert_allclose(material.base_color, (0.5, 0.5, 0.5), atol=0.05)


def test_standin_of_strands_has_the_colour_of_light_from_the_viewers_side():
    """And not of the glow that comes through hair from behind."""
    axis = np.float32([[0.0, 0.0, 1.0]] * 100)
    wi = np.where(np.arange(100)[:, None] % 2, axis, -axis)
    radiance = np.where(wi[:, 2:] > 0.0, np.float32([0.01, 0.005, 0.0]), np.float32(2.0))
    material = standin_material({"tangent": axis, "wo": axis, "wi": wi, "radiance": radiance})
    np.testing.assert_allclose(material.base_color, 8.0 * np.pi * radiance[1], atol=1e-3)
    assert material.roughness == 1.0


def test_poster_pixels_are_not_premultiplied():
    rgba = np.float32([[[0.5, 0.25, 0, 0.5], [0, 0, 0, 0], [4, 1, 1, 1]]])
    image = np.asarray(Image.open(io.BytesIO(png_of(rgba))))
    assert image.shape == (1, 3, 4)
    assert image[0, 0].tolist() == [255, 188, 0, 128]
    assert image[0, 1].tolist() == [0, 0, 0, 0]
    assert image[0, 2].tolist() == [255, 255, 255, 255]


def mesh_of(shape: trimesh.Trimesh) -> Mesh:
    """Flat shaded, a vertex for each corner."""
    return Mesh(
        np.float32(shape.triangles).reshape(-1, 3),
        np.repeat(np.float32(shape.face_normals), 3, axis=0),
        None,
        np.arange(3 * len(shape.faces), dtype=np.uint32).reshape(-1, 3),
    )


def test_proxy_has_fewer_triangles_the_smaller_it_is():
    ball = mesh_of(trimesh.creation.icosphere(6))
    counts = []
    for pixels in (64, 32):
        proxy = proxy_of(ball, pixels)
        counts.append(len(proxy.triangles))
        np.testing.assert_allclose(np.linalg.norm(proxy.positions, axis=1), 1, atol=0.02)
        # Smooth again, as nothing on a ball is a crease.
        cosines = np.einsum("ij,ij->i", proxy.positions, proxy.normals)
        assert np.percentile(cosines, 1) > 0.99
        assert proxy.quantised is not None
    assert counts[1] < 0.3 * counts[0] < len(ball.triangles)


def test_proxy_keeps_creases():
    box = mesh_of(trimesh.creation.box().subdivide().subdivide().subdivide().subdivide())
    proxy = proxy_of(box, 16)
    assert len(proxy.triangles) < len(box.triangles) / 2
    assert np.abs(proxy.normals).max(axis=1).min() > 0.999


def test_no_proxy_that_saves_nothing():
    assert proxy_of(mesh_of(trimesh.creation.icosphere(3)), 500) is None
