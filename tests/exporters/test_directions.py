import numpy as np
import pytest

from rna_export.capture.rays.capture_directions import (
    around,
    direction_seen_from,
    frame,
    light_direction,
    reflect,
    sphere,
)


def test_sphere_fills_equal_areas_equally():
    directions = sphere(np.random.default_rng(0).random((64_000, 2)))
    y = np.clip((directions[:, 1] + 1.0) * 4.0, 0, 7.999).astype(int)
    phi = np.arctan2(directions[:, 2], directions[:, 0])
    column = np.clip((phi + np.pi) / (2.0 * np.pi) * 8.0, 0, 7.999).astype(int)
    counts = np.bincount(8 * y + column, minlength=64)
    chi_squared = np.sum((counts - 1000.0) ** 2 / 1000.0)
    assert chi_squared < 103.4  # 63 degrees of freedom, p = 0.001


def test_hemisphere_looks_up():
    directions = sphere(np.random.default_rng(0).random((1000, 2)), "hemisphere")
    assert directions[:, 1].min() >= 0.0
    assert directions[:, 1].mean() == pytest.approx(0.5, abs=0.03)


@pytest.mark.parametrize("domain", ["sphere", "hemisphere"])
@pytest.mark.parametrize("count", [64, 333])
def test_lights_are_spread_at_any_count(count, domain):
    lights = np.array([light_direction(k, 3, domain) for k in range(count)])
    cosine = lights @ lights.T - 2.0 * np.eye(count)
    nearest = np.arccos(np.clip(cosine.max(axis=1), -1.0, 1.0))
    area = (4.0 if domain == "sphere" else 2.0) * np.pi / count
    # Independent uniform directions come as near as 0.01 to 0.2 of this.
    assert nearest.min() > 0.25 * np.sqrt(area)


def test_a_light_from_behind_is_opposite_or_as_far_as_there_is_one():
    above = np.array([0.0, 2.0, 0.0])
    lights = [seen_from("sphere", above, True, k / 50, k) for k in range(50)]
    assert max(light[1] for light in lights) <= -0.5
    assert np.ptp(lights, axis=0).min() > 0.4  # not one and the same
    horizon = seen_from("hemisphere", above, True, 0.5, 0)
    assert 0.0 <= horizon[1] < 0.1


def test_lights_seen_from_the_front_have_angles_spread_evenly():
    above = np.array([0.0, 2.0, 0.0])
    height = np.array([seen_from("sphere", above, False, k / 50, k)[1] for k in range(50)])
    assert height.min() > -0.5
    expected = np.linspace(-0.5, 1.0, 50)  # equal areas
    assert np.abs(height - expected).max() < 0.25  # by chance alone it would be up to 1.5
    assert np.abs(height - expected).mean() < 0.06


def seen_from(region: str, eye: np.ndarray, behind: bool, rank: float, seed: int) -> np.ndarray:
    """A light by its angle to the eye."""
    return direction_seen_from(region, eye, behind, rank, np.random.default_rng(seed))


def test_lights_depend_on_the_seed():
    assert not np.array_equal(light_direction(0, 0, "sphere"), light_direction(0, 1, "sphere"))


def test_frame_is_orthonormal_at_the_poles_too():
    n = np.concatenate([np.eye(3), -np.eye(3), sphere(np.random.default_rng(1).random((500, 2)))])
    s, t = frame(n)
    assert np.allclose(np.cross(s, t), n, atol=1e-6)
    assert np.allclose(np.sum(s * t, axis=1), 0.0, atol=1e-6)


def test_around_keeps_the_polar_angle():
    rng = np.random.default_rng(2)
    n, cosine = sphere(rng.random((200, 2))), rng.uniform(-1, 1, 200)
    directions = around(n, cosine, 2.0 * np.pi * rng.random(200))
    assert np.allclose(np.sum(directions * n, axis=1), cosine, atol=1e-5)
    assert np.allclose(np.linalg.norm(directions, axis=1), 1.0, atol=1e-5)


def test_reflect_has_h_in_the_middle():
    rng = np.random.default_rng(3)
    wi, h = sphere(rng.random((2, 100, 2)).reshape(-1, 2)).reshape(2, 100, 3)
    wo = reflect(wi, h)
    assert np.allclose(np.cross(wi + wo, h), 0.0, atol=1e-5)
    assert np.allclose(np.linalg.norm(wo, axis=1), 1.0, atol=1e-5)
