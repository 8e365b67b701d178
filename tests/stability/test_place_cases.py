"""Cases about places: edges of shadows, folded texels, zoom."""

from dataclasses import replace

import numpy as np
import pytest

from rna_bench.stability.cases import shadow_edges, thin, zoom
from rna_export.capture.dataset.validation_view import ValidationView
from rna_render.world.camera import Camera
from rna_sdk.package import Curves

SIZE = 32


def flat_view(n_wi: float = 0.7) -> ValidationView:
    """A plane seen from above; columns from 12 on are in shadow."""
    row, column = np.divmod(np.arange(SIZE**2), SIZE)
    position = np.stack([column, 0 * row, row], axis=1).astype(np.float32) / SIZE
    up = np.tile(np.float32([0, 1, 0]), (len(row), 1))
    wi = np.tile(np.float32([np.sqrt(1 - n_wi**2), n_wi, 0]), (len(row), 1))
    visible = (column < 12).astype(np.uint8)
    radiance = np.repeat(np.float32(0.1 + 0.1 * visible)[:, None], 3, axis=1)
    samples = {"position": position, "normal": up, "wo": up, "wi": wi, "radiance": radiance}
    pixel = np.arange(SIZE**2, dtype=np.int32)
    return ValidationView(0, SIZE, pixel, samples | {"visible": visible}, np.stack([radiance] * 2))


def test_distance_to_an_edge_counts_pixels():
    distance = shadow_edges.signed_distance(flat_view())["cast shadow"].reshape(SIZE, SIZE)
    expected = np.zeros(SIZE, int)
    expected[4:12], expected[12:20] = np.arange(8, 0, -1), -np.arange(1, 9)
    np.testing.assert_array_equal(distance, np.tile(expected, (SIZE, 1)))


def test_visibility_may_have_a_colour():
    view = flat_view()
    glass = np.float32([0.9, 0.8, 0.7]) * view.visible[:, None]
    through_glass = replace(view, samples={**view.samples, "visible": glass})
    expected = shadow_edges.signed_distance(view)["cast shadow"]
    actual = shadow_edges.signed_distance(through_glass)["cast shadow"]
    np.testing.assert_array_equal(actual, expected)


def test_a_terminator_is_where_the_surface_turns_away():
    distance = shadow_edges.signed_distance(flat_view(n_wi=0.05))
    assert not distance["cast shadow"].any() and distance["terminator"].any()


@pytest.mark.parametrize(("smear", "passes"), [(0.0, True), (0.05, False)])
def test_a_smeared_edge_fails(smear, passes):
    view = flat_view()

    def answers(queries: dict) -> tuple[np.ndarray, np.ndarray]:
        at_edge = np.abs(SIZE * queries["position"][:, :1] - 11.5) < 1.6
        error = 0.004 + smear * at_edge
        return 0.2 + error * np.ones(3), 0.1 + error * np.ones(3)

    rows = shadow_edges.profile(answers, [view])
    verdict = shadow_edges.judge([{"model": "with the hint", **row} for row in rows])
    assert verdict.passed == passes


def test_both_sides_of_a_sheet_fold():
    cells = thin.Cells(np.zeros(3), np.ones(3), 10)
    positions = np.float32([[0.51, 0.5, 0.5], [0.52, 0.5, 0.5], [0.1, 0.1, 0.1], [0.11, 0.1, 0.1]])
    normals = np.float32([[0, 0, 1], [0, 0, -1], [0, 0, 1], [0, 0.1, 1]])
    number = cells.numbers(positions)
    assert number[0] == number[1] and number[2] == number[3]
    assert thin.opposed(number, normals).tolist() == [number[0]]


def test_strands_fold_where_they_share_a_cell():
    points = np.float32([[0.1, 0, 0], [0.1, 0.4, 0], [0.13, 0, 0], [0.13, 0.4, 0], [0.9, 0, 0]])
    points = np.concatenate([points, np.float32([[0.9, 0.4, 0]])])
    curves = Curves(points, np.full(6, 0.01, np.float32), np.array([0, 2, 4, 6], np.uint32))
    cells = thin.Cells(np.zeros(3), np.ones(3), 10)
    folded = thin.several_strands(curves, cells)
    near, far = cells.numbers(np.float32([[0.12, 0.2, 0], [0.9, 0.2, 0]]))
    assert near in folded and far not in folded


@pytest.mark.parametrize(("error", "passes"), [(0.13, True), (0.2, False)])
@pytest.mark.parametrize("other", ["clear", "alone"])
def test_thin_geometry_is_judged_by_what_folding_costs(error, passes, other):
    rows = [
        {"shape": "leaf", "where": where, "error": value}
        for where, value in ((other, 0.1), ("folded", error))
    ]
    assert thin.judge(rows).passed == passes


def test_no_two_normals_that_face_up_are_opposed():
    normals = np.random.default_rng(0).normal(size=(400, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    up = normals[thin.facing_up({"normal": normals})]
    assert 20 < len(up) < 100 and (up @ up.T).min() > 0.0


def test_a_zoomed_pixel_has_its_width():
    eye, target = np.array([0.0, 0.0, 2.0]), np.array([0.0, 0.0, 0.5])
    camera = zoom.zoomed(eye, target, 1e-3)
    n = zoom.PIXELS
    middle = np.uint32([n // 2 * n + n // 2, n // 2 * n + n // 2 + 1])
    a, b = Camera(camera, (n, n)).directions(middle, np.full((2, 2), 0.5))
    a, b = (d * (1.5 / -d[2]) for d in (a, b))
    assert np.linalg.norm(a - b) == pytest.approx(1e-3, rel=1e-3)


@pytest.mark.parametrize(
    ("ours", "texture", "passes"), [(0.09, 0.0, True), (0.2, 0.14, True), (0.2, 0.12, False)]
)
def test_zoom_is_judged_at_the_finest_beside_a_texture(ours, texture, passes):
    rows = [{"texels": t, "flip": 0.5, "texture_flip": 0.0} for t in zoom.FOOTPRINTS[:-1]]
    rows.append({"texels": zoom.FOOTPRINTS[-1], "flip": ours, "texture_flip": texture})
    assert zoom.judge(rows).passed == passes


def test_a_texture_has_one_value_a_texel():
    image = np.random.default_rng(0).random((96, 96, 3), dtype=np.float32)
    assert zoom.as_texture(image, 1.0) is image
    shown = zoom.as_texture(image, 0.25)
    means = image.reshape(24, 4, 24, 4, 3).mean(axis=(1, 3))
    np.testing.assert_allclose(shown[1::4, 1::4] - means, 0.0, atol=0.2)
    inner = shown[2:-2, 2:-2].reshape(23, 4, 23, 4, 3)
    np.testing.assert_allclose(np.diff(inner, n=2, axis=1), 0.0, atol=1e-5)
