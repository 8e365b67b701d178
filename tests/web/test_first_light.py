"""An environment for the viewer's first look: bright directions, and the rest prefiltered."""

import base64
import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rna_export.lobes.bright_directions import split_environment

pytestmark = pytest.mark.skipif(shutil.which("node") is None, reason="needs Node")

KAPPAS = 0.25 * 2 ** (np.arange(19) / 2)


def first_light(image: np.ndarray) -> dict[str, Any]:
    """What the viewer makes of an image (h, w, 3); `levels` (19, rows, columns, 3)."""
    height, width = image.shape[:2]
    command = ["node", Path(__file__).with_name("first_light.mjs"), str(width), str(height)]
    done = subprocess.run(command, input=image.astype("<f4").tobytes(), capture_output=True)
    actual = json.loads(done.stdout)
    rest = actual["rest"]
    texels = np.frombuffer(base64.b64decode(rest["texels"]), "<f2").astype(np.float64)
    shape = rest["levels"], rest["height"], rest["width"], 4
    actual["levels"] = rest["unit"] * texels.reshape(shape)[..., :3]
    return actual


def sphere(height: int, width: int) -> tuple[np.ndarray, np.ndarray]:
    """Directions (h, w, 3) of the texels, and solid angles (h, 1)."""
    theta = np.pi * (np.arange(height) + 0.5) / height
    phi = 2 * np.pi * ((np.arange(width) + 0.5) / width - 0.5)
    sine = np.sin(theta)[:, None]
    y = np.repeat(np.cos(theta)[:, None], width, axis=1)
    d = np.stack([sine * np.sin(phi), y, -sine * np.cos(phi)], axis=-1)
    edges = np.cos(np.pi * np.arange(height + 1) / height)
    return d, (edges[:-1] - edges[1:])[:, None] * 2 * np.pi / width


def sky(suns: bool) -> np.ndarray:
    """A smooth sky; suns: with a small sun and a long lamp."""
    d, _ = sphere(128, 256)
    image = (0.6 + 0.3 * d[..., 1:2] + 0.2 * d[..., :1]) * np.array([0.8, 1.0, 1.3])
    if suns:
        image[d @ np.array([0.48, 0.6, 0.64]) > np.cos(0.03)] += [900.0, 800.0, 600.0]
        long, across = np.array([0.6, 0.0, -0.8]), np.array([0.0, 1.0, 0.0])
        lamp = (np.abs(d @ long + 0.1) < 0.35) & (np.abs(d @ across - 0.4) < 0.1)
        image[lamp & (d[..., 0] < 0)] += [12.0, 14.0, 15.0]
    return image


def mean_under(image: np.ndarray, axis: np.ndarray, kappa: float) -> np.ndarray:
    """The image's mean under a von Mises-Fisher distribution, RGB."""
    d, solid = sphere(*image.shape[:2])
    density = kappa / (2 * np.pi * -np.expm1(-2 * kappa)) * np.exp(kappa * (d @ axis - 1))
    return np.asarray((image * (density * solid)[..., None]).sum(axis=(0, 1)))


def test_bright_directions_are_those_of_the_benchmark():
    image = sky(suns=True)
    actual, expected = first_light(image), split_environment(image)
    assert len(actual["lights"]) == len(expected.directions) == 8
    for light in actual["lights"]:
        away = np.linalg.norm(expected.directions - light["direction"], axis=1)
        nearest = int(np.argmin(away))
        assert away[nearest] < 0.05
        # Where a cluster is cut, a cell goes to one side or the other.
        assert light["colour"] == pytest.approx(expected.flux[nearest], rel=0.3)
    total = np.sum([light["colour"] for light in actual["lights"]], axis=0)
    assert total == pytest.approx(expected.flux.sum(axis=0), rel=0.02)
    d, solid = sphere(*image.shape[:2])
    up = (image * (solid * np.maximum(0, d[..., 1]))[..., None]).sum(axis=(0, 1))
    split = sum(
        np.multiply(light["colour"], max(0, light["direction"][1])) for light in actual["lights"]
    )
    assert split + actual["up"] == pytest.approx(up, rel=5e-3)


def test_levels_are_means_of_the_environment():
    image = sky(suns=False)
    actual = first_light(image)
    assert actual["lights"] == []
    _, rows, columns, _ = actual["levels"].shape
    for level, row, column in ((0, 0, 5), (6, 20, 100), (12, 64, 0), (18, 31, 127), (18, 0, 3)):
        theta, phi = np.pi * row / (rows - 1), 2 * np.pi * ((column + 0.5) / columns - 0.5)
        sine = np.sin(theta)
        axis = np.array([sine * np.sin(phi), np.cos(theta), -sine * np.cos(phi)])
        expected = mean_under(image, axis, KAPPAS[level])
        assert actual["levels"][level, row, column] == pytest.approx(expected, rel=5e-3)


def test_an_even_environment_stays_even():
    """However few its texels are."""
    actual = first_light(np.full((4, 8, 3), 2.5))
    assert actual["lights"] == []
    assert actual["levels"] == pytest.approx(np.full_like(actual["levels"], 2.5), rel=2e-3)
