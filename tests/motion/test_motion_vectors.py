"""Motion vectors, `forward.u` and `forward.v`, in pixels, against points projected by hand."""

import numpy as np
import pytest

from rna_render import load_world, make_integrator, render
from rna_render.scene import SceneFile, read_scene
from rna_sdk.motion import write_motion
from rna_sdk.runtime import Transform, load
from tests.motion.test_motion_render import BALL, TOY, matrix, scene

EYE, TARGET = np.array([1.4, 0.9, 1.2]), np.array([0.3, 0.2, -0.1])
WIDTH, HEIGHT, FOV_DEG = 64, 48, 30.0


def channels(file: SceneFile) -> dict[str, np.ndarray]:
    file = file.with_changes(samples=1, max_depth=1)
    integrator = make_integrator(file.resolved, load_world(file), file.camera_after)
    return render(file.scene, integrator).channels()


def in_image(x: np.ndarray, eye: np.ndarray = EYE) -> np.ndarray:
    """(n, 2) pixels to the right and up, of points (n, 3) seen by a camera at `eye`."""
    forward = (TARGET - eye) / np.linalg.norm(TARGET - eye)
    right = np.cross(forward, [0, 1, 0]) / np.linalg.norm(np.cross(forward, [0, 1, 0]))
    up = np.cross(right, forward)
    focal = HEIGHT / 2 / np.tan(np.radians(FOV_DEG) / 2)
    depth = (x - eye) @ forward
    return focal * np.stack([(x - eye) @ right / depth, (x - eye) @ up / depth], axis=1)


def seen(actual: dict[str, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Points and motion vectors of the pixels that show something: (n, 3), (n, 2)."""
    hit = actual["assetId"] > 0
    points = np.stack([actual[f"position.{k}"][hit] for k in "XYZ"], axis=1).astype(float)
    assert all((actual[f"forward.{k}"][~hit] == 0).all() for k in "uv")
    return points, np.stack([actual[f"forward.{k}"][hit] for k in "uv"], axis=1)


@pytest.mark.parametrize("package", [TOY, BALL], ids=["surface", "fiber"])
def test_of_a_rigid_motion_are_those_of_its_transform(tmp_path, package):
    part = load(package)
    geometry = part.curves if part.kind == "fiber" else part.mesh
    rest = geometry.points if part.kind == "fiber" else geometry.positions
    step = matrix() if part.kind == "surface" else np.eye(4)
    step[:3, 3] = 0.1, 0.05, -0.2
    frames = [[rest], [Transform(step).to_world_points(rest)]]
    write_motion(tmp_path / "rigid.rnam", [geometry], frames, count=2, rate=24)
    turn = Transform(np.diag([0.5, 0.5, 0.5, 1.0]))
    placed = "motion: rigid.rnam\n    transform: {scale: 0.5}"
    points, actual = seen(channels(read_scene(scene(tmp_path, placed, package=package))))
    local = turn.to_object_points(points.astype(np.float32)).astype(float)
    moved = turn.matrix[:3, :3] @ (step[:3, :3] @ local.T + step[:3, 3:])
    expected = in_image(moved.T) - in_image(points)
    assert np.abs(expected).max() > 2
    np.testing.assert_allclose(actual, expected, atol=2e-3)


def test_of_a_camera_that_turns_are_those_of_its_next_place(tmp_path):
    more = "animation: {frames: 10, turntable: {degrees: 100}}"
    path = scene(tmp_path, "tier: small", more)
    c, s = np.cos(np.radians(10)), np.sin(np.radians(10))
    turned = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    eyes = [TARGET + np.linalg.matrix_power(turned, k) @ (EYE - TARGET) for k in range(3)]
    for file, eye, after in (
        (read_scene(path), eyes[0], eyes[1]),  # a still image
        (read_scene(path).at(1), eyes[1], eyes[2]),
    ):
        points, actual = seen(channels(file))
        expected = in_image(points, after) - in_image(points, eye)
        assert np.abs(expected).max() > 1
        np.testing.assert_allclose(actual, expected, atol=1e-3)


def test_are_0_where_nothing_moves(tmp_path):
    mesh = load(TOY).mesh
    bent = mesh.positions + np.float32([0, 0.1, 0])
    write_motion(tmp_path / "up.rnam", [mesh], [[mesh.positions], [bent]], count=2, rate=24)
    for asset in ("tier: small", "motion: {path: up.rnam, start: 1}"):  # its last frame
        _, actual = seen(channels(read_scene(scene(tmp_path, asset))))
        assert len(actual) > 100
        assert not actual.any()
    _, actual = seen(channels(read_scene(scene(tmp_path, "motion: up.rnam"))))
    assert (actual[:, 1] > 1).all()
