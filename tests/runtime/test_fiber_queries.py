"""The blocks of fibers: kernel against numpy twin, and both against the optics of a cylinder."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest

from rna_sdk.package.blocks import blocks_for
from rna_sdk.runtime import offset_across
from tests.package.builders import FIBER_INPUTS, make_planes
from tests.reference.queries import fiber_queries_reference
from tests.runtime.filling import CORNERS, filled
from tests.runtime.points import FiberPoints, random_fiber_points, unit_vectors

ALL = tuple(blocks_for("fiber"))
PLANES = make_planes(8, 4)
ETA = 1.55


def assert_equals_twin(
    points: FiberPoints, inputs: tuple[str, ...] = FIBER_INPUTS, atol: float = 2e-6
) -> np.ndarray:
    """The kernel's queries, all of them valid and as the twin has them."""
    queries, valid = filled(PLANES, points, inputs)
    assert valid.all()
    expected = fiber_queries_reference(PLANES, CORNERS, inputs, *points)
    np.testing.assert_allclose(queries, expected, rtol=1e-6, atol=atol)
    return queries


@pytest.mark.parametrize(
    "inputs",
    [FIBER_INPUTS, ALL, ALL[::-1], ("fiber_lobes",), ("h", "fiber_angles"), ("tangent", "wi")],
)
def test_equals_its_twin(inputs):
    assert_equals_twin(random_fiber_points(2000, reach=2.5), inputs)


def test_equals_its_twin_where_directions_and_edges_meet():
    t = random_fiber_points(40).tangents
    other = random_fiber_points(40, seed=1)
    directions = [t, -t, other.wo, -other.wo, other.wi]
    for wo, wi, h in product(directions, directions, [-1, -0.5, 0, 1, 3]):
        points = FiberPoints(other.positions, t, np.full(40, h, np.float32), wo, wi)
        queries = assert_equals_twin(points)
        assert np.abs(queries).max() < 4


@pytest.mark.parametrize("angle", [1e-4, 1e-3, 1e-2])
def test_equals_its_twin_near_the_tangent(angle):
    points = random_fiber_points(500)
    near = points.tangents + np.float32(angle) * points.wo
    # Unit vectors of float32 tell phi no better than this: the D of spec/RNA.md, 8.2.
    atol = 1e-5 + 3e-7 / angle
    assert_equals_twin(replace(points, wo=near), atol=atol)
    assert_equals_twin(replace(points, wi=near), atol=atol)


def test_along_the_fiber_phi_is_zero():
    points = random_fiber_points(100)
    queries, _ = filled(PLANES, replace(points, wo=points.tangents), ("fiber_angles",))
    np.testing.assert_array_equal(queries[:, 4:], np.tile(np.float32([1, 0]), (100, 1)))


def test_a_row_that_cannot_be_filled_is_zero():
    expected, _ = filled(PLANES, random_fiber_points(10), ALL)
    for argument in range(5):
        points = random_fiber_points(10)
        list(points)[argument][3] = np.nan
        queries, valid = filled(PLANES, points, ALL)
        assert valid.tolist() == [k != 3 for k in range(10)]
        assert not queries[3].any()
        np.testing.assert_array_equal(queries[valid], expected[valid])


def test_length_of_directions_does_not_count():
    points = random_fiber_points(100)
    scaled = FiberPoints(
        points.positions,
        points.tangents * 2.0**20,
        points.h,
        points.wo * 2.0**-60,
        points.wi * 2.0**60,
    )
    np.testing.assert_array_equal(filled(PLANES, scaled, ALL)[0], filled(PLANES, points, ALL)[0])


def lobes(t: np.ndarray, n: np.ndarray, wo: np.ndarray, wi: np.ndarray) -> np.ndarray:
    """(n, 3): cos(phi - Phi_p) for points with normal n, from h as hosts compute it."""
    t, n, wo, wi = (a.astype(np.float32) for a in (t, n, wo, wi))
    points = FiberPoints(np.zeros_like(t), t, offset_across(n, t, wo), wo, wi)
    return assert_equals_twin(points, ("fiber_lobes",))


def in_frame(t: np.ndarray, azimuth: float | np.ndarray, elevation: float) -> np.ndarray:
    """Directions this far around t, and above the plane across it."""
    side = np.cross(t, np.roll(t, 1, axis=1) + np.array([0.3, -0.2, 0.1]))
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    azimuth = np.broadcast_to(azimuth, len(t))[:, None]
    around = np.cos(azimuth) * side + np.sin(azimuth) * np.cross(t, side)
    return np.cos(elevation) * around + np.sin(elevation) * t


def dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.sum(a * b, axis=1, keepdims=True)


def refracted(d: np.ndarray, n: np.ndarray, eta: float) -> np.ndarray:
    """Snell's law for direction d that meets a surface whose normal n is against it."""
    cos_i = -dot(d, n)
    cos_t = np.sqrt(1 - (1 - cos_i**2) / eta**2)
    return d / eta + (cos_i / eta - cos_t) * n


def next_normal(d: np.ndarray, n: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Outward normal where a ray along d, inside from the wall at n, meets the wall again."""
    across = d - dot(d, t) * t
    return n - 2 * dot(n, across) / dot(across, across) * across


@pytest.mark.parametrize("elevation", [0.0, 0.3, -1.2])
@pytest.mark.parametrize("turn", [0.0, 1.0, -2.0])
def test_lobes_peak_where_a_glass_cylinder_sends_the_ray(elevation, turn):
    """Rays traced through a cylinder in space, by Snell's law for vectors and no shortcut."""
    rng = np.random.default_rng(0)
    t = unit_vectors(rng, 300).astype(np.float64)
    t /= np.linalg.norm(t, axis=1, keepdims=True)
    wo = in_frame(t, 0.0, elevation)
    n = in_frame(t, rng.uniform(-1.55, 1.55, 300), 0.0)

    inside = refracted(-wo, n, ETA)
    far = next_normal(inside, n, t)
    back = inside - 2 * dot(inside, far) * far
    last = next_normal(back, far, t)
    exits = [
        2 * dot(wo, n) * n - wo,
        refracted(inside, -far, 1 / ETA),
        refracted(back, -last, 1 / ETA),
    ]
    for p, wi in enumerate(exits):
        np.testing.assert_allclose(dot(wi, t), -dot(wo, t), atol=1e-12)  # on the cone
        turned = np.cos(turn) * wi + np.sin(turn) * np.cross(t, wi)
        turned += (1 - np.cos(turn)) * dot(t, wi) * t
        actual = lobes(t, n, wo, turned)[:, p]
        np.testing.assert_allclose(actual, np.cos(turn), atol=2e-4 if turn else 2e-6)


def test_straight_through_the_middle():
    """h = 0 seen from across: R comes back, TT goes on, TRT comes back."""
    t = unit_vectors(np.random.default_rng(0), 50)
    wo = in_frame(t, 0.0, 0.0)
    actual = lobes(t, wo, wo, -wo)
    np.testing.assert_allclose(actual, np.tile([-1, 1, -1], (50, 1)), atol=1e-6)


def test_lobes_do_not_see_a_mirror():
    """A mirror image, h included, has the same lobes and the opposite sin(phi)."""
    points = random_fiber_points(300)
    points.tangents[:] = [0, 1, 0]
    flip = np.float32([-1, 1, 1])
    mirrored = replace(points, h=-points.h, wo=points.wo * flip, wi=points.wi * flip)
    inputs = ("fiber_lobes", "fiber_angles")
    here, _ = filled(PLANES, points, inputs)
    there, _ = filled(PLANES, mirrored, inputs)
    np.testing.assert_allclose(there[:, :8], here[:, :8], atol=1e-6)
    np.testing.assert_allclose(there[:, 8], -here[:, 8], atol=1e-6)
