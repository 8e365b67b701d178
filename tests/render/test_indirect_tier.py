"""An asset may answer camera rays with one tier and all other rays with another."""

import numpy as np

from rna_render.paths.bands import render
from rna_render.paths.integrator_factory import make_integrator
from rna_render.world.placements import Placement
from rna_render.world.world import World
from tests.render.assets import LambertAsset, sphere, square
from tests.render.stage import SKY, rgb, stage

BALL = sphere(2, 0.5)
WHITE, RED = LambertAsset(BALL, (0.9, 0.9, 0.9)), LambertAsset(BALL, (0.9, 0.0, 0.0))
FLOOR = LambertAsset(square(3.0, -0.6), (0.8, 0.8, 0.8))
CAMERA = {"position": (0, 2, 3), "look_at": (0, -0.2, 0), "vertical_fov_deg": 40}


def picture(
    seen: LambertAsset, indirect: LambertAsset | None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The ball on the floor, by paths of two points; pixels of the ball alone, and of the floor."""
    changes = {"camera": CAMERA, "max_depth": 2, "resolution": (32, 24)}
    scene, _ = stage([(seen, {})], [SKY], **changes)
    world = World([Placement(seen, np.eye(4), indirect=indirect), Placement(FLOOR, np.eye(4))])
    channels = render(scene, make_integrator(scene, world)).channels()
    x = np.stack([channels[f"position.{axis}"] for axis in "XYZ"], axis=-1)
    ball = np.abs(np.linalg.norm(x, axis=-1) - 0.5) < 0.02
    floor = np.abs(x[..., 1] + 0.6) < 1e-4
    assert ball.sum() > 30 and floor.sum() > 200
    return rgb(channels), ball, floor


def test_the_floor_sees_the_other_tier_and_the_camera_does_not():
    white, ball, floor = picture(WHITE, None)
    red, _, _ = picture(RED, None)
    both, _, _ = picture(WHITE, RED)
    np.testing.assert_array_equal(both[floor], red[floor])
    np.testing.assert_array_equal(both[ball], white[ball])
    assert (white[floor, 2] > red[floor, 2]).mean() > 0.1
    assert (white[ball, 2] > red[ball, 2]).all()
