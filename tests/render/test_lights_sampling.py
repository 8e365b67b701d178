"""Every light that rays can meet: its samples follow its density, and rays agree with both."""

import numpy as np
import pytest

from tests.render.chi_squared import assert_directions_follow
from tests.render.lights import (
    Quad,
    distances,
    independent_samples,
    light,
    radiance_and_pdf,
    samples,
)

WHITE = (1.0, 1.0, 1.0)
ORIGIN = (0.0, 0.0, 0.0)

SQUARE = {"look_at": (0, 0, 0), "radiance": (1, 2, 3), "size": (2, 1)}
DISK = {"look_at": (0, 0, 0), "radiance": (1, 2, 3), "radius": 0.7}
SUN = {"direction": (1, 2, -1), "irradiance": (1, 2, 3)}


def ball(distance: float, radius: float = 0.5):
    return light("sphere", position=(0, 0, distance), radius=radius, radiance=(1, 2, 3))


# name: light, point, axis and half-angle (degrees) of a cone that holds the light.
CASES = {
    "sun": (light("directional", **SUN, angular_diameter_deg=0.53), ORIGIN, (1, 2, -1), 0.27),
    "wide sun": (light("directional", **SUN, angular_diameter_deg=90), ORIGIN, (1, 2, -1), 46),
    "half the sky": (light("directional", **SUN, angular_diameter_deg=180), ORIGIN, (1, 2, -1), 91),
    "rectangle": (light("rectangle", position=(0, 0, 2), **SQUARE), ORIGIN, (0, 0, 1), 30),
    "rectangle, aslant": (
        light("rectangle", position=(1, 1, 1), up=(1, 0, 0), **SQUARE),
        (0.3, -0.4, 0.2),
        (0.4, 0.8, 0.5),
        65,
    ),
    "rectangle, close": (
        light("rectangle", position=(0, 0, 2), **SQUARE),
        (0.5, 0.2, 1.99),
        (0, 0, 1),
        90.0,
    ),
    "rectangle, far away": (
        light("rectangle", position=(0, 0, 5000), **SQUARE),
        ORIGIN,
        (0, 0, 1),
        0.013,
    ),
    "disk": (light("disk", position=(0, 0, 2), **DISK), ORIGIN, (0, 0, 1), 20),
    "disk, aslant": (
        light("disk", position=(0, 1, 2), **DISK),
        (0.9, 0.5, 0.4),
        (-0.9, 0.5, 1.6),
        40,
    ),
    "sphere": (ball(2), ORIGIN, (0, 0, 1), 15),
    "sphere, close": (ball(2, 1.99), ORIGIN, (0, 0, 1), 88),
    "sphere, far away": (ball(2000), ORIGIN, (0, 0, 1), 0.015),
    "mesh": (Quad(), (0.2, 0.1, 1.5), (-0.2, 0.4, -1.5), 60),
    "mesh from behind": (Quad(), (0.2, 0.1, -1.5), (-0.2, 0.4, 1.5), 60),
    "environment": (light("environment", radiance=(1, 2, 3)), ORIGIN, (0, 0, 1), 180),
}


def sampled(of, x, n: int, independent: bool):
    draw = independent_samples if independent else samples
    return draw(of.light if isinstance(of, Quad) else of, x, n)


@pytest.mark.parametrize("name", CASES)
def test_directions_follow_the_density(name):
    of, x, axis, angle = CASES[name]
    drawn = sampled(of, x, 200_000, independent=True)
    valid = drawn.pdf > 0
    assert valid.mean() > 0.9999
    assert_directions_follow(
        drawn.wi_world[valid],
        lambda d: radiance_and_pdf(of, x, d)[1],
        axis,
        np.radians(angle),
        integral_tolerance=0.015,
    )


@pytest.mark.parametrize("name", CASES)
def test_rays_find_what_samples_promise(name):
    """Equal density and radiance, except for rays past the rim by rounding."""
    of, x, _, _ = CASES[name]
    drawn = sampled(of, x, 16_384, independent=False)
    radiance, pdf = radiance_and_pdf(of, x, drawn.wi_world)
    hit = pdf > 0
    assert hit.mean() > 0.995
    # A sample knows its direction in float64, a ray in float32.
    np.testing.assert_allclose(pdf[hit], drawn.pdf[hit], rtol=1e-4)
    np.testing.assert_allclose(radiance[hit], drawn.radiance[hit], rtol=2e-3)


SHAPES = [name for name in CASES if name.startswith(("rectangle", "disk", "sphere", "mesh"))]


@pytest.mark.parametrize("name", SHAPES)
def test_the_distance_is_that_of_the_hit(name):
    of, x, _, _ = CASES[name]
    drawn = sampled(of, x, 16_384, independent=False)
    t = distances(of, x, drawn.wi_world)
    hit = np.isfinite(t)
    assert hit.mean() > 0.995
    # At a sphere's rim the distance has no bound to its slope.
    np.testing.assert_allclose(np.sort(t[hit] / drawn.distance[hit])[[5, -5]], 1.0, rtol=1e-3)


INSIDE = {
    "inside the sphere": (ball(0), (0.1, 0.2, 0.1)),
    "at the middle of the sphere": (ball(0), ORIGIN),
    "on the sphere": (ball(0), (0.0, 0.0, 0.5)),
    "behind the rectangle": (light("rectangle", position=(0, 0, 2), **SQUARE), (0, 0, 3)),
    "in the rectangle's plane": (light("rectangle", position=(0, 0, 2), **SQUARE), (3, 0, 2)),
    "on the rectangle": (light("rectangle", position=(0, 0, 2), **SQUARE), (0.1, 0.1, 2)),
    "behind the disk": (light("disk", position=(0, 0, 2), **DISK), (0, 0, 3)),
    "in the disk's plane": (light("disk", position=(0, 0, 2), **DISK), (3, 0, 2)),
    "in the middle of the disk": (light("disk", position=(0, 0, 2), **DISK), (0, 0, 2)),
    "at the point light": (light("point", position=(1, 2, 3), intensity=WHITE), (1, 2, 3)),
    "at the spot": (
        light("spot", position=(1, 2, 3), look_at=(0, 0, 0), intensity=WHITE),
        (1, 2, 3),
    ),
    "behind the spot": (
        light("spot", position=(0, 2, 0), look_at=(0, 0, 0), intensity=WHITE),
        (0, 3, 0),
    ),
}


@pytest.mark.parametrize("name", INSIDE)
def test_where_nothing_arrives_the_density_is_zero_and_all_numbers_finite(name):
    of, x = INSIDE[name]
    drawn = samples(of, x, 256)
    assert (drawn.pdf == 0).all() and (drawn.radiance == 0).all()
    assert np.isfinite(drawn.wi_world).all() and np.isfinite(drawn.distance).all()
    if not of.delta:
        rng = np.random.default_rng(3)
        d = rng.normal(size=(1000, 3))
        d = (d / np.linalg.norm(d, axis=1, keepdims=True)).astype(np.float32)
        radiance, pdf = radiance_and_pdf(of, x, d)
        outwards = (x != (0.0, 0.0, 0.5)) | (d[:, 2] > 0)
        assert (pdf[outwards] == 0).all() and (radiance[outwards] == 0).all()


def test_a_mesh_that_does_not_shine_gives_nothing():
    quad = Quad()
    dark = type(quad.light)(
        quad.positions, quad.triangles, np.zeros(4), lambda t, u, v: np.zeros((len(t), 3))
    )
    drawn = samples(dark, (0, 0, 2), 64)
    assert dark.power(1.0) == 0
    assert (drawn.pdf == 0).all() and (drawn.radiance == 0).all()


@pytest.mark.parametrize("name", ["rectangle", "disk", "sphere", "mesh", "environment", "sun"])
def test_no_points_are_legal(name):
    of = CASES[name][0]
    drawn = (of.light if name == "mesh" else of).sample(
        np.zeros((0, 3), np.float32), np.zeros((0, 2))
    )
    assert drawn.wi_world.shape == (0, 3) and drawn.pdf.shape == (0,)
