"""The clamp that keeps specks out of pictures: how large it is, and that one key turns it off."""

import numpy as np
import pytest
import trimesh

from rna_render.command.terminal import tell_clamp
from rna_render.image.film import Film, Layers
from rna_render.image.images import write_exr
from rna_render.paths.bands import render
from rna_render.paths.integrator_factory import AUTO, indirect_clamp, make_integrator
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import Scene
from tests.render.lights import light
from tests.render.specks import brightest_around
from tests.render.stage import SKY, rgb

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
    scene = {"ground": {}, "camera": CAMERA, "lights": [SKY]}
    assert Scene.model_validate(scene).clamp_indirect == "auto"
    assert Scene.model_validate(scene | {"clamp_indirect": None}).clamp_indirect is None
    assert Scene.model_validate(scene | {"clamp_indirect": 2}).clamp_indirect == 2.0


def test_there_are_no_specks(tmp_path):
    """No pixel is above 10 times what a converged image has around it; without the clamp some are.

    A polished ball reflects a small sun onto the ground.
    """
    trimesh.creation.icosphere(4, 0.5).export(tmp_path / "ball.ply")
    sky = np.full((32, 64), 0.2, np.float32)
    sky[6, 20] = 400.0
    write_exr(tmp_path / "sky.exr", dict.fromkeys("RGB", sky), {})
    scene = Scene.model_validate(
        {
            "objects": [
                {
                    "path": tmp_path / "ball.ply",
                    "material": {"type": "conductor", "roughness": 0.1},
                    "transform": {"translation": (0, 0.5, 0)},
                }
            ],
            "ground": {},
            "camera": {"position": (0, 1.5, 3), "look_at": (0, 0.3, 0), "vertical_fov_deg": 35},
            "lights": [{"type": "environment", "path": tmp_path / "sky.exr"}],
            "resolution": (96, 54),
        }
    )
    world = load_world(SceneFile(tmp_path / "scene.yaml", scene, {}))

    def image(samples: int, seed: int, clamp: str | None) -> np.ndarray:
        changes = {"samples": samples, "seed": seed, "clamp_indirect": clamp}
        changed = scene.model_copy(update=changes)
        return rgb(render(changed, make_integrator(changed, world)).channels())

    around = brightest_around(image(256, 9, "auto"))
    for clamp, specked in (("auto", False), (None, True)):
        largest = max((image(4, seed, clamp) / around).max() for seed in (1, 2, 3))
        assert (largest > 10.0) == specked


def test_what_it_takes_is_told(capsys):
    """In the second of two samples the clamp took 1 of 7."""
    scene = Scene.model_validate({"ground": {}, "camera": CAMERA, "lights": [SKY]})
    film = Film((2, 1))
    band = Layers.empty(2, 0, np.float32)
    band.beauty[:, :3] = [[1.0, 2.0, 3.0], [0.5, 1.0, 1.5]]
    film.add([band])
    tell_clamp(scene, film)
    assert capsys.readouterr().err == ""
    band.clamped[1] = 1.0
    film.add([band])
    assert film.clamped_share == pytest.approx(1.0 / (1.0 + 2.0 * 3.0))
    tell_clamp(scene, film)
    assert "clamp_indirect: auto took 14.29% of the image's light" in capsys.readouterr().err
