"""The preview's text for a scene file: what it shows, read back."""

import numpy as np
import pytest
import yaml

from rna_render.preview.lighting import Lighting, lit
from rna_render.preview.scene_text import scene_text
from rna_render.scene.scene_model import Scene

SCENE = """
assets: [{path: ball.rna}]
camera: {position: [0.123456789, 0, 4], look_at: [0, 0, 0], vertical_fov_deg: 5}
lights:
  - {type: directional, direction: [0, 0, 1], irradiance: [1, 2, 3]}
  - {type: environment, path: maps/sky.hdr, radiance: [0.5, 0.5, 0.5]}
  - {type: point, position: [0, 1, 2], intensity: [1, 1, 1]}
  - {type: sphere, position: [0, 3, 0], radius: 0.5, radiance: [9, 9, 9]}
resolution: [32, 24]
exposure: 0.5
view: filmic
"""


def test_what_is_shown_is_read_back(tmp_path):
    scene = Scene.model_validate(yaml.safe_load(SCENE))
    shown = lit(scene, Lighting("own", None), 30.0)
    changes = yaml.safe_load(scene_text(shown, tmp_path))
    assert list(changes) == ["camera", "exposure", "view", "lights"]
    actual = Scene.model_validate({**yaml.safe_load(SCENE), **changes})
    assert actual.camera.position == pytest.approx(shown.camera.position, rel=1e-5)
    assert (actual.exposure, actual.view) == (0.5, "filmic")
    for one, expected in zip(actual.lights, shown.lights, strict=True):
        for name, value in expected.model_dump().items():
            if isinstance(value, tuple | float):
                np.testing.assert_allclose(getattr(one, name), value, rtol=1e-5, atol=1e-9)
            else:
                assert getattr(one, name) == value


def test_lights_with_a_shape_stay_under_other_lights():
    scene = Scene.model_validate(yaml.safe_load(SCENE))
    shown = lit(scene, Lighting("none", ()), 90.0)
    assert shown.lights == (scene.lights[3],)


def test_images_beside_the_scene_are_relative(tmp_path):
    scene = Scene.model_validate(yaml.safe_load(SCENE))
    sky = scene.lights[1].model_copy(update={"path": tmp_path / "maps" / "sky.hdr"})
    text = scene_text(scene.model_copy(update={"lights": (sky,)}), tmp_path)
    assert yaml.safe_load(text)["lights"][0]["path"] == "maps/sky.hdr"
