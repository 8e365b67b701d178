"""Transmittance of a hit: texture, cutoff and Fresnel, with values worked out by hand."""

from typing import Any

import numpy as np
import pytest

from rna_sdk.package import Mesh, Transmittance
from rna_sdk.runtime import transmittance
from rna_sdk.runtime.transmittance_lookup import fresnel

TEXELS = np.uint8([[0, 51], [102, 255]])[:, :, None]  # 0, 0.2; 0.4, 1
DOWN = np.float32([0, -1, 0])


def sheet(uvs: bool = True) -> Mesh:
    """The unit square of x and z seen from above, u along x, v along z: two triangles."""
    positions = np.float32([[0, 0, 0], [0, 0, 1], [1, 0, 1], [1, 0, 0]])
    normals = np.tile(np.float32([0, 1, 0]), (4, 1))
    flat = np.ascontiguousarray(positions[:, [0, 2]])
    return Mesh(positions, normals, flat if uvs else None, np.uint32([[0, 1, 2], [0, 2, 3]]))


def tau(record: Transmittance, x: float, z: float, d: Any = DOWN, mesh: Mesh | None = None) -> Any:
    """At a point of the first triangle (x <= z), barycentric by hand."""
    u, v = np.float32([z - x]), np.float32([x])
    mesh = mesh or sheet()
    return transmittance(mesh, [record], np.array([0]), u, v, np.float32([d]))[0]


def record(texture: np.ndarray = TEXELS, **changes: Any) -> Transmittance:
    return Transmittance(
        **{"first": 0, "count": 1, "cutoff": None, "ior": None} | changes, texture=texture
    )


@pytest.mark.parametrize(
    ("x", "z", "expected"),
    [
        (0.25, 0.25, 0.0),  # texel centres
        (0.25, 0.75, 0.4),
        (0.5, 0.75, 0.7),
        (0.5, 0.5, 0.4),  # the mean of all four
        (0.0, 0.75, 0.7),  # over the edge: half of each column
        (0.25, 1.0, 0.2),  # half of each row
        (0.0, 1.0, 0.4),
    ],
)
def test_lookup_is_bilinear_and_repeats(x, z, expected):
    np.testing.assert_allclose(tau(record(), x, z), expected, atol=1e-6)


def test_cutoff_makes_a_sharp_outline():
    for x, expected in ((0.40, 0), (0.42, 1)):  # 0.4 + 0.6 (2 x - 0.5) passes 0.6 at x = 5/12
        assert tau(record(cutoff=0.6), x, 0.75).tolist() == [expected] * 3
    at_the_cutoff = record(np.uint8([[[255]]]) // 5, cutoff=0.2)
    assert not tau(at_the_cutoff, 0.1, 0.2).any()  # more than it, not as much


def test_channels_are_the_texture_s():
    actual = tau(record(np.uint8([[[255, 51, 0]]])), 0.3, 0.6)
    np.testing.assert_allclose(actual, [1, 0.2, 0], atol=1e-7)


def test_one_texel_needs_no_coordinates():
    actual = tau(record(np.uint8([[[102]]])), 0.3, 0.6, mesh=sheet(uvs=False))
    np.testing.assert_allclose(actual, 0.4, atol=1e-7)


def test_triangles_of_no_record_are_opaque():
    one = np.uint8([[[255]]])
    half, both = np.float32([0.25] * 2), np.array([0, 1])
    d = np.float32([DOWN, DOWN])
    first = transmittance(sheet(), [record(one)], both, half, half, d)
    assert first.tolist() == [[1] * 3, [0] * 3]
    assert not transmittance(sheet(), [], both, half, half, d).any()
    halves = [record(one), record(one // 5, first=1)]
    np.testing.assert_allclose(
        transmittance(sheet(), halves, both, half, half, d), [[1] * 3, [0.2] * 3], atol=1e-7
    )


def test_fresnel_takes_its_share_from_either_side():
    clear = record(np.uint8([[[255]]]), ior=(1.5, 1 / 1.5))
    up = -DOWN
    assert tau(clear, 0.2, 0.6)[0] == pytest.approx(0.96)  # ((n - 1) / (n + 1))^2 = 0.04
    assert tau(clear, 0.2, 0.6, up)[0] == pytest.approx(0.96)
    slanted = np.array([np.sin(1.2), np.cos(1.2), 0])  # beyond 41.8 degrees: total reflection
    assert not tau(clear, 0.2, 0.6, slanted).any()
    assert 0 < tau(clear, 0.2, 0.6, slanted * [1, -1, 1])[0] < 0.9


@pytest.mark.parametrize("eta", [1.33, 1.5, 0.7])
def test_fresnel_is_that_of_the_two_polarisations(eta):
    angle = np.linspace(0, 1.5, 40)
    sine = np.sin(angle) / eta
    c, total = np.cos(angle), sine >= 1
    g = np.sqrt(1 - np.minimum(sine, 1) ** 2)
    s = ((c - eta * g) / (c + eta * g)) ** 2
    p = ((eta * c - g) / (eta * c + g)) ** 2
    expected = np.where(total, 1, (s + p) / 2)
    np.testing.assert_allclose(fresnel(np.full(40, eta), c), expected, atol=1e-12)
    assert fresnel(np.array([1.0]), np.array([0.0])) == 1
