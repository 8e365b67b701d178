"""Which directions a domain holds."""

import numpy as np
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import Cone, Domain, Package
from rna_sdk.runtime import in_region, load
from tests.package.builders import make_tiny_package

UP, FRONT = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
CONES = (Cone(axis=UP, half_angle=0.1), Cone(axis=FRONT, half_angle=0.5))


def tilted(angle: float) -> np.ndarray:
    """From straight up towards the front, (1, 3)."""
    return np.float32([[0.0, np.cos(angle), np.sin(angle)]])


@pytest.mark.parametrize(
    ("angle", "within"),
    [(0.0, True), (0.099, True), (0.101, False), (1.06, False), (1.08, True), (3.0, False)],
)
def test_cones_hold_what_is_near_any_axis(angle, within):
    assert in_region(CONES, tilted(angle)).tolist() == [within]


def test_a_cone_without_width_holds_its_axis():
    axis = np.array([0.48, 0.6, 0.64])
    cone = Cone(axis=tuple(axis.tolist()), half_angle=0.0)
    assert in_region((cone,), axis[None].astype(np.float32)).all()


@pytest.mark.parametrize(
    ("length", "angle", "within"), [(0.9991, 0.01, True), (1.0009, 0.04, False)]
)
def test_the_length_of_an_axis_changes_nothing(length, angle, within):
    cone = Cone(axis=(0.0, length, 0.0), half_angle=0.02)
    assert in_region((cone,), tilted(angle)).tolist() == [within]


def test_sphere_and_hemisphere():
    down = np.float32([[0, -1, 0], [0, 1, 0], [1, 0, 0]])
    assert in_region("sphere", down).tolist() == [True, True, True]
    assert in_region("hemisphere", down).tolist() == [False, True, True]


def test_other_arrays_are_refused():
    with pytest.raises(QueryError, match=r"region: expected sphere.* found 'nosuch'"):
        in_region("nosuch", np.zeros((1, 3), np.float32))
    with pytest.raises(QueryError, match="directions"):
        in_region("sphere", np.zeros((2, 2), np.float32))


def test_cones_go_through_a_package(tmp_path):
    domain = Domain(wo=CONES, wi="hemisphere")
    path = make_tiny_package(tmp_path / "a.rna", domain=domain)
    assert load(path).domain == domain
    with Package.open(path) as package:
        assert package.manifest.domain == domain
