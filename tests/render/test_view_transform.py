"""From linear radiance to the values of a screen."""

from typing import get_args

import numpy as np
import pytest

from rna_render.command.rna_run import VIEWS
from rna_render.image.view_transform import to_display
from rna_render.scene.scene_model import Scene
from rna_sdk.files.srgb import decode_srgb, encode_srgb


def grey(values, view: str) -> np.ndarray:
    """What the screen shows of grey radiances, as linear light: (n,)."""
    shown = decode_srgb(to_display(np.repeat(np.asarray(values)[:, None], 3, 1), view))
    np.testing.assert_allclose(shown, shown[:, :1].repeat(3, 1), atol=3e-5, err_msg="not grey")
    return shown[:, 0]


def test_the_command_line_and_the_scene_know_the_same_views():
    assert get_args(Scene.model_fields["view"].annotation) == VIEWS


def test_srgb_clamps():
    rgb = np.array([[-1.0, 0.18, 0.5], [1.0, 1.5, np.inf]])
    expected = encode_srgb(np.array([[0, 0.18, 0.5], [1, 1, 1]]))
    np.testing.assert_array_equal(to_display(rgb, "srgb"), expected)


def test_filmic_keeps_middle_grey_and_rolls_off_to_white():
    # By hand from the source's formula, at 1.461926 times the radiance.
    np.testing.assert_allclose(grey([0.18, 1.0, 4.0], "filmic"), [0.18, 0.7308, 0.9432], atol=1e-4)
    assert grey([0.0, 18.0, 1e30, np.inf], "filmic").tolist() == pytest.approx([0, 1, 1, 1])
    shown = decode_srgb(to_display(np.array([0.9, 0.2, 0.05]), "filmic"))
    np.testing.assert_allclose(shown, [0.7839, 0.2406, 0.0541], atol=1e-4)
    assert grey([17.0], "filmic")[0] < 1.0


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize("colour", [(1, 1, 1), (1, 0.5, 0.1), (0.1, 0.2, 1)])
def test_more_light_is_never_darker(view, colour):
    radiance = np.logspace(-4, 4, 500)[:, None] * colour
    shown = to_display(radiance, view)
    assert (shown >= 0).all() and (shown <= 1).all()
    luminance = decode_srgb(shown) @ [0.2126, 0.7152, 0.0722]
    assert (np.diff(luminance) >= -1e-9).all()


@pytest.mark.parametrize("view", VIEWS)
def test_exposure_is_stops(view):
    rgb = np.array([0.1, 0.2, 0.4])
    np.testing.assert_array_equal(to_display(rgb, view, 1.0), to_display(2 * rgb, view))
