"""The clamp that keeps specks out of pictures: how large it is, and that one key turns it off."""

from __future__ import annotations

import numpy as np
import pytest

from rna_render.indirect_clamp import AUTO, indirect_clamp
from rna_render.scene_model import Scene
from tests.render.lights import light
from tests.render.stage import SKY

SUN = {"direction": (0, 1, 0), "irradiance": (2, 2, 2)}
CAMERA = {"position": (0, 1, 2), "look_at": (0, 0, 0)}


@pytest.mark.parametrize("radius", [0.01, 1.0, 300.0])
def test_it_follows_the_light_of_the_scene(radius):
    """A white ball under a sky of radiance L sends L, and under a sun of irradiance E a quarter of
    E / pi on average, whatever the scene's size."""
    sky = light("environment", radiance=(0.3, 0.3, 0.3))
    sun = light("directional", **SUN)
    assert indirect_clamp("auto", [sky], radius) == pytest.approx(AUTO * 0.3)
    both = AUTO * (0.3 + 2.0 / (4.0 * np.pi))
    assert indirect_clamp("auto", [sky, sun], radius) == pytest.approx(both)


def test_a_number_is_taken_and_null_is_none():
    sky = light("environment")
    assert indirect_clamp(3.0, [sky], 1.0) == 3.0
    assert indirect_clamp(None, [sky], 1.0) is None


def test_a_scene_without_light_has_none():
    assert indirect_clamp("auto", [], 1.0) is None
    assert indirect_clamp("auto", [light("environment", radiance=(0, 0, 0))], 1.0) is None


def test_scenes_have_one_unless_they_say_null():
    told = {"ground": {}, "camera": CAMERA, "lights": [SKY]}
    assert Scene.model_validate(told).clamp_indirect == "auto"
    assert Scene.model_validate(told | {"clamp_indirect": None}).clamp_indirect is None
    assert Scene.model_validate(told | {"clamp_indirect": 2}).clamp_indirect == 2.0
