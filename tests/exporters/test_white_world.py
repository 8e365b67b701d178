"""A white world in Cycles: radiance 1 from all directions, or from those of a region."""

import numpy as np
import pytest

from rna_export.capture.blender_process.lighting import Light, WhiteWorld
from rna_sdk.package.manifest.manifest_fields import Cone

SQUARE = "add(*square(1), diffuse((0.8, 0.5, 0.2)))"
GLOWING = "add(*square(1), principled(Emission_Strength=5.0, Base_Color=(0.8, 0.5, 0.2, 1)))"
UP = (0.0, 1.0, 0.0)
CAP = np.radians(30.0)


@pytest.mark.blender
@pytest.mark.parametrize(
    ("region", "share"),
    [
        ("sphere", 1.0),
        ("hemisphere", 1.0),
        ((Cone(axis=UP, half_angle=CAP),), np.sin(CAP) ** 2),
        ((Cone(axis=UP, half_angle=CAP), Cone(axis=(0.0, -1.0, 0.0), half_angle=0.5)), 0.25),
        ((Cone(axis=(1.0, 0.0, 0.0), half_angle=np.pi / 2),), 0.5),
    ],
)
def test_a_diffuse_square_returns_its_albedo_of_the_light(region, share, open_worker):
    found = _seen_from_above(open_worker(SQUARE), WhiteWorld(region), 1024)
    assert found == pytest.approx(share * np.array([0.8, 0.5, 0.2]), rel=0.03)


@pytest.mark.blender
def test_the_asset_does_not_glow_there_and_the_sun_comes_back(open_worker):
    worker = open_worker(GLOWING)
    sun = np.array([0.0, 1.0, 0.0])
    before = _seen_from_above(worker, sun, 64)
    white = _seen_from_above(worker, WhiteWorld(), 64)
    after = _seen_from_above(worker, sun, 64)
    assert np.array_equal(before, after)
    assert before.max() < 1.0 and white.max() < 1.0
    assert _seen_from_above(worker, None, 64).max() > 4.0


def _seen_from_above(worker, light: Light, samples: int) -> np.ndarray:
    """Mean radiance (3,) of some rays."""
    origins = np.float32([[0.1 * k - 0.5, 2.0, 0.1] for k in range(10)])
    down = np.tile(np.float32([0.0, -1.0, 0.0]), (10, 1))
    rendered = worker.render_rays(origins, down, light, samples, 1)
    assert rendered.alpha == pytest.approx(1.0)
    return rendered.radiance.mean(axis=0)
