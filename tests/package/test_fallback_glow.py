"""Emission of a fallback: a texture of hues, and a place in it for each vertex."""

import numpy as np
import pytest

from rna_sdk.package.gltf.fallback_glow import Palette, palette_of

RED, BLUE, GREEN = np.array([[6.0, 2.0, 0.5], [0.2, 1.0, 4.0], [0.1, 3.0, 0.1]])
SHARE = np.random.default_rng(0).random((500, 1))
STRENGTH = np.random.default_rng(1).random((500, 1))

LIGHTS = {
    "one hue": STRENGTH * RED,
    "two hues": STRENGTH * np.where(SHARE < 0.3, RED, BLUE),
    "three hues": STRENGTH * np.where(SHARE < 0.3, RED, np.where(SHARE < 0.6, BLUE, GREEN)),
    "mixed": STRENGTH * (SHARE * RED + (1.0 - SHARE) * BLUE),
    "a small lamp on a noisy dark body": np.where(SHARE < 0.02, RED, 0.05 * SHARE * BLUE),
}


def looked_up(palette: Palette, places: np.ndarray) -> np.ndarray:
    """Radiance (n, 3) at texture coordinates (n, 2): bilinear, of linear texels."""
    texels = palette.texels / 255.0
    linear = np.where(texels <= 0.04045, texels / 12.92, ((texels + 0.055) / 1.055) ** 2.4)
    height, width = linear.shape[:2]
    x, y = places[:, 0] * width - 0.5, places[:, 1] * height - 0.5
    i = np.clip(np.floor(x).astype(int), 0, width - 1)
    j = np.clip(np.floor(y).astype(int), 0, height - 1)
    a, b = (x - i)[:, None], (y - j)[:, None]
    right, below = np.minimum(i + 1, width - 1), np.minimum(j + 1, height - 1)
    upper = (1 - a) * linear[j, i] + a * linear[j, right]
    lower = (1 - a) * linear[below, i] + a * linear[below, right]
    return palette.strength * ((1 - b) * upper + b * lower)


@pytest.mark.parametrize("name", LIGHTS)
def test_light_at_vertices_is_kept(name):
    light = LIGHTS[name].astype(np.float32)
    palette = palette_of(light, np.zeros((0, 3), np.uint32))
    assert palette is not None and palette.strength == light.max()
    limit = 0.08 if name == "mixed" else 0.01
    np.testing.assert_allclose(looked_up(palette, palette.places), light, atol=limit * light.max())


def test_a_triangle_fades_to_its_dark_corner_in_its_own_hue():
    light = np.float32([RED, RED, [0, 0, 0], BLUE, BLUE, [0, 0, 0]])
    palette = palette_of(light, np.uint32([[0, 1, 2], [5, 3, 4]]))
    assert palette is not None
    for lit, dark in ((0, 2), (3, 5)):
        middle = palette.places[[lit, dark]].mean(axis=0, keepdims=True)
        np.testing.assert_allclose(looked_up(palette, middle)[0], light[lit] / 2, atol=0.05)


def test_no_light_is_no_palette():
    assert palette_of(np.full((9, 3), 1e-3, np.float32), np.zeros((0, 3), np.uint32)) is None
