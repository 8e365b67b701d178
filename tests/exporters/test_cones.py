"""Cones of directions, towards balls and merged."""

import numpy as np
import pytest

from rna_export.capture.rays.capture_directions import around, sphere
from rna_export.capture.rays.cones import EVERYWHERE, Cap, around_both, cap_towards, merged
from rna_sdk.package.limits import MAX_CONES
from rna_sdk.runtime import in_region

UP, FRONT = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])


def directions(cap: Cap, count: int = 500) -> np.ndarray:
    """Spread over a cap, its edge included."""
    rng = np.random.default_rng(0)
    cosine = 1.0 - (1.0 - np.cos(cap.half_angle)) * np.minimum(1.1 * rng.random(count), 1.0)
    return around(np.tile(cap.axis, (count, 1)), cosine, 2.0 * np.pi * rng.random(count))


def test_a_cap_holds_all_directions_between_two_balls():
    rng = np.random.default_rng(1)
    centre = np.array([3.0, -1.0, 2.0])
    points, targets = sphere(rng.random((5000, 2))), centre + 0.5 * sphere(rng.random((5000, 2)))
    between = targets - 0.7 * points
    between /= np.linalg.norm(between, axis=1, keepdims=True)
    cap = cap_towards(centre, 0.7 + 0.5)
    angle = np.arccos(between @ cap.axis)
    assert angle.max() < cap.half_angle < angle.max() + 0.02


def test_a_ball_that_touches_is_everywhere():
    assert cap_towards(np.array([1.0, 0.0, 0.0]), 1.0).half_angle == np.pi


@pytest.mark.parametrize(
    ("a", "b"),
    [
        (Cap(UP, 0.2), Cap(FRONT, 0.4)),
        (Cap(UP, 0.0), Cap(FRONT, 0.0)),
        (Cap(UP, 0.5), Cap(-UP, 0.3)),
        (Cap(UP, 1.0), Cap(UP, 0.2)),
        (Cap(UP, 2.0), Cap(-UP, 1.5)),
    ],
)
def test_the_cap_around_two_holds_both_and_no_more(a, b):
    both = around_both(a, b)
    assert both.holds(a) and both.holds(b)
    for cap in (a, b):
        assert (directions(cap) @ both.axis >= np.cos(both.half_angle) - 1e-6).all()
    widest = max(a.half_angle, b.half_angle)
    assert both.half_angle <= min(max(widest, (a.angle_to(b) + 2 * widest) / 2.0), np.pi) + 1e-9


def test_many_caps_become_few_cones_that_hold_them_all():
    turned = np.linspace(0.0, 2.0 * np.pi, 200, endpoint=False)
    caps = [Cap(np.array([np.sin(t), 0.5, np.cos(t)]) / np.sqrt(1.25), 0.05) for t in turned]
    region = merged(caps, margin=0.02)
    assert 1 < len(region) <= MAX_CONES
    for cap in caps:
        assert in_region(region, directions(Cap(cap.axis, 0.069), 50)).all()
    spread = sphere(np.random.default_rng(2).random((20_000, 2)))
    # The band of the turn is 0.14 wide, 0.07 of the sphere at most; cones that hold it are more.
    assert in_region(region, spread).mean() < 0.35


def test_caps_within_others_are_left_out():
    region = merged([Cap(UP, 0.1), Cap(UP, 0.3), Cap(UP, 0.2)], margin=0.0)
    assert [cone.half_angle for cone in region] == [pytest.approx(0.3)]


def test_all_directions_are_the_sphere():
    assert merged([Cap(UP, 0.1), EVERYWHERE], margin=0.1) == "sphere"
    assert merged([], margin=0.1) == "sphere"
