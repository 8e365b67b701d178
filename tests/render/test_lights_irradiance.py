"""What lights bring to a plane with nothing in the way, against closed forms."""

import numpy as np
import pytest

from rna_render.lights import Light
from tests.render.lights import Quad, light, samples

ORIGIN = (0.0, 0.0, 0.0)
UP = (0.0, 0.0, 1.0)
RGB = np.array([1.0, 2.0, 3.0])
TOLERANCE = 0.005


def irradiance(
    of: Light,
    x: tuple[float, float, float] = ORIGIN,
    normal: tuple[float, float, float] = UP,
    n: int = 1 << 16,
) -> np.ndarray:
    """Monte Carlo, on a plane through x: (3,)."""
    drawn = samples(of, x, n)
    cosine = np.maximum(drawn.wi_world @ np.asarray(normal) / np.linalg.norm(normal), 0.0)
    weight = np.divide(cosine, drawn.pdf, out=np.zeros(n), where=drawn.pdf > 0)
    return np.mean(drawn.radiance.astype(np.float64) * weight[:, None], axis=0)


def assert_brings(of: Light, expected: float, **where) -> None:
    np.testing.assert_allclose(irradiance(of, **where), RGB * expected, rtol=TOLERANCE)


@pytest.mark.parametrize("diameter", [0, 0.01, 0.53, 30, 90, 180])
def test_a_plane_that_faces_a_directional_light_gets_its_irradiance(diameter):
    sun = light("directional", direction=(3, 0, 4), irradiance=RGB, angular_diameter_deg=diameter)
    assert sun.delta == (diameter == 0)
    assert_brings(sun, 1.0, normal=(3, 0, 4))
    if diameter < 50:
        assert_brings(sun, 0.8, normal=UP)


def spot(inner: float, outer: float) -> Light:
    return light(
        "spot",
        position=(0, 0, 2),
        look_at=(0, 0, 1),
        intensity=RGB,
        inner_angle_deg=inner,
        outer_angle_deg=outer,
    )


def test_a_spot_falls_as_that_of_cycles():
    """kernel/light/spot.h and scene/light.cpp of Cycles 5.0, with the blend of SpotLight's docs."""
    inner, outer = np.cos(np.radians([20, 40]))
    blend = (inner - outer) / (1 - outer)
    spot_smooth = 1 / ((1 - outer) * blend)
    for angle in (22, 27, 33, 39):
        sine, cosine = np.sin(np.radians(angle)), np.cos(np.radians(angle))
        t = (cosine - outer) * spot_smooth
        drawn = samples(spot(20, 40), (sine, 0, 2 - cosine), 1)
        assert drawn.radiance[0] == pytest.approx(RGB * (3 * t**2 - 2 * t**3), rel=1e-5)


def test_a_spot_with_a_hard_edge():
    assert (samples(spot(40, 40), (0, 0, 0), 1).radiance == np.float32(RGB / 4)).all()
    assert (samples(spot(40, 40), (3, 0, 0), 1).radiance == 0).all()


@pytest.mark.parametrize(("inner", "outer"), [(20, 40), (40, 40), (0, 90)])
def test_the_power_of_a_spot_is_the_integral_of_its_intensity(inner, outer):
    cosine = np.linspace(0, 1, 20_001)
    sine = np.sqrt(1 - cosine**2)
    x = np.stack([sine, 0 * sine, 2 - cosine], axis=1).astype(np.float32)
    drawn = spot(inner, outer).sample(x, np.zeros((len(x), 2)))
    luminance = drawn.radiance @ [0.2126, 0.7152, 0.0722]
    assert spot(inner, outer).power(1) == pytest.approx(2 * np.pi * luminance.mean(), rel=1e-3)


def parallel_rectangle(x0: float, x1: float, y0: float, y1: float, h: float) -> float:
    """Irradiance over radiance below a rectangle, from the corner formula.

    Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-4.
    """

    def corner(x: float, y: float) -> float:
        a, b = x / h, y / h
        p, q = np.sqrt(1 + a * a), np.sqrt(1 + b * b)
        return (a / p * np.arctan(b / p) + b / q * np.arctan(a / q)) / 2

    return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0)


@pytest.mark.parametrize(
    "x", [(0, 0, 0), (0.9, -0.2, 1.5), (3, 2, 0), (0.3, 0.1, 1.999), (9, 9, 1)]
)
def test_a_parallel_rectangle(x):
    lamp = light("rectangle", position=(0, 0, 2), look_at=(0, 0, 0), size=(2, 1), radiance=RGB)
    expected = parallel_rectangle(-1 - x[0], 1 - x[0], -0.5 - x[1], 0.5 - x[1], 2 - x[2])
    assert_brings(lamp, expected, x=x)


def test_a_rectangle_far_away():
    lamp = light("rectangle", position=(0, 0, 4e4), look_at=(0, 0, 0), size=(2, 1), radiance=RGB)
    assert_brings(lamp, 2 / 4e4**2)


def test_width_and_height_follow_up():
    """Beside a wide lamp that stands upright on its short side there is less light."""
    lamp = light(
        "rectangle", position=(0, 0, 2), look_at=(0, 0, 0), up=(1, 0, 0), size=(2, 1), radiance=RGB
    )
    assert_brings(lamp, parallel_rectangle(-0.5 - 2, 0.5 - 2, -1, 1, 2), x=(2, 0, 0))


@pytest.mark.parametrize("h", [0.1, 1.0, 30.0])
def test_a_disk_on_its_axis(h):
    lamp = light("disk", position=(0, 0, h), look_at=(0, 0, 0), radius=0.5, radiance=RGB)
    assert_brings(lamp, np.pi * 0.25 / (0.25 + h * h), n=1 << 18)


@pytest.mark.parametrize(("d", "r"), [(2.0, 0.5), (2.0, 1.99), (500.0, 0.01)])
def test_a_sphere_above(d, r):
    lamp = light("sphere", position=(0, 0, d), radius=r, radiance=RGB)
    assert_brings(lamp, np.pi * (r / d) ** 2)


def test_a_mesh_is_as_bright_as_the_integral_over_it():
    quad, x = Quad(), np.array([0.2, 0.1, 1.5])
    rng = np.random.default_rng(4)
    u, v = rng.random((2, 500_000))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    normal, expected = np.array([0, 0, -1.0]), 0.0
    for number, corners in enumerate(quad.positions[quad.triangles].astype(np.float64)):
        e1, e2 = corners[1] - corners[0], corners[2] - corners[0]
        cross = np.cross(e1, e2)
        points = corners[0] + u[:, None] * e1 + v[:, None] * e2 - x
        r = np.linalg.norm(points, axis=1)
        kernel = np.abs(points @ cross) / 2 * np.maximum(points @ normal, 0) / r**4
        expected += np.mean(kernel * quad.strength[number] * (1 + u))
    got = irradiance(quad.light, x=tuple(x), normal=tuple(normal))
    np.testing.assert_allclose(got, [expected] * 3, rtol=TOLERANCE)


@pytest.mark.parametrize("kind", ["rectangle", "disk", "sphere", "mesh"])
def test_power_is_what_passes_a_sphere_around_the_light(kind):
    """Irradiance from outside in, over a sphere: W. Every light is whole within it."""
    if kind == "mesh":
        lamp, middle = Quad().light, np.array([0, 0.5, 0])
    else:
        shape = {"size": (2, 1)} if kind == "rectangle" else {"radius": 0.6}
        aim = {} if kind == "sphere" else {"look_at": (1, 2, 3)}
        lamp = light(kind, position=ORIGIN, radiance=(1, 1, 1), **shape, **aim)
        middle = np.zeros(3)
    rng = np.random.default_rng(5)
    outwards = rng.normal(size=(200_000, 3))
    outwards /= np.linalg.norm(outwards, axis=1, keepdims=True)
    x = (middle + 3 * outwards).astype(np.float32)
    drawn = lamp.sample(x, rng.random((len(x), 2)))
    cosine = np.maximum(-np.sum(drawn.wi_world * outwards, axis=1), 0)
    weight = np.divide(cosine, drawn.pdf, out=np.zeros(len(x)), where=drawn.pdf > 0)
    flux = np.mean(drawn.radiance[:, 0] * weight) * 4 * np.pi * 9
    assert lamp.power(100.0) == pytest.approx(flux, rel=0.01)
