"""Curves of USD as polylines: ends, bases, widths."""

import numpy as np
import pytest

from rna_export.blender.rna_sources.usd_splines import Spline

POINTS = np.array([[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 2], [3, 1, 2], [4, 0, 0], [5, 1, 1.0]])


@pytest.mark.parametrize("wrap", ["nonperiodic", "pinned", "periodic"])
@pytest.mark.parametrize("basis", ["bezier", "bspline", "catmullRom"])
def test_counts_are_those_of_openusd(basis, wrap):
    """Pieces of seven points, as in the schema's table "Number of segments"."""
    points = 6 if (basis, wrap) == ("bezier", "periodic") else 7
    pieces = {"bezier": (2, 2, 2), "bspline": (4, 6, 7), "catmullRom": (4, 6, 7)}[basis]
    spline = Spline(points, "cubic", basis, wrap)
    assert spline.pieces == pieces[("nonperiodic", "pinned", "periodic").index(wrap)]
    assert spline.varying == spline.pieces + (wrap != "periodic")
    assert len(spline.along(POINTS[:points])) == spline.samples == 4 * spline.pieces + 1


def test_a_bspline_is_that_of_cox_and_de_boor():
    def weight(i: int, degree: int, t: float) -> float:
        """Weight of point i with knots at the whole numbers."""
        if degree == 0:
            return float(i <= t < i + 1)
        rising, falling = (t - i) / degree, (i + degree + 1 - t) / degree
        return rising * weight(i, degree - 1, t) + falling * weight(i + 1, degree - 1, t)

    line = Spline(7, "cubic", "bspline", "nonperiodic").along(POINTS)
    expected = [[weight(i, 3, 3 + k / 4) for i in range(7)] @ POINTS for k in range(16)]
    np.testing.assert_allclose(line[:-1], expected, atol=1e-12)


def test_a_bezier_is_that_of_de_casteljau():
    line = Spline(7, "cubic", "bezier", "nonperiodic").along(POINTS)
    for k, t in enumerate((0.0, 0.25, 0.5, 0.75)):
        four = POINTS[3:7]
        while len(four) > 1:
            four = (1 - t) * four[:-1] + t * four[1:]
        np.testing.assert_allclose(line[4 + k], four[0], atol=1e-12)
    np.testing.assert_array_equal(line[[0, 4, 8]], POINTS[[0, 3, 6]])


@pytest.mark.parametrize("basis", ["bspline", "catmullRom"])
def test_pinned_curves_begin_and_end_at_their_points(basis):
    line = Spline(7, "cubic", basis, "pinned").along(POINTS)
    np.testing.assert_allclose(line[[0, -1]], POINTS[[0, -1]], atol=1e-12)


def test_a_catmull_rom_goes_through_its_points():
    line = Spline(7, "cubic", "catmullRom", "nonperiodic").along(POINTS)
    np.testing.assert_allclose(line[::4], POINTS[1:-1], atol=1e-12)


@pytest.mark.parametrize(("kind", "basis"), [("linear", ""), ("cubic", "bspline")])
def test_periodic_curves_are_closed(kind, basis):
    line = Spline(7, kind, basis, "periodic").along(POINTS)
    np.testing.assert_allclose(line[0], line[-1], atol=1e-12)


def test_varying_values_are_linear_from_end_to_end_of_a_piece():
    spline = Spline(7, "cubic", "bezier", "nonperiodic")
    np.testing.assert_allclose(
        spline.between(np.array([0.0, 4.0, 8.0])), np.arange(9.0), atol=1e-12
    )
    closed = Spline(6, "cubic", "bezier", "periodic").between(np.array([0.0, 4.0]))
    np.testing.assert_allclose(closed, [0, 1, 2, 3, 4, 3, 2, 1, 0], atol=1e-12)


def test_too_few_points_make_no_strand():
    assert len(Spline(3, "cubic", "bspline", "nonperiodic").along(POINTS[:3])) == 0
