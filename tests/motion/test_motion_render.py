"""`rna-run` with assets in motion: pictures, frames, motion blur, and refusals."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from rna_render import load_world, make_integrator, read_exr, render
from rna_render.command.rna_run import main
from rna_render.scene import read_scene
from rna_sdk.errors import SceneError
from rna_sdk.machine.kernel_threads import limit_kernel_threads
from rna_sdk.motion import write_motion
from rna_sdk.runtime import Transform, load
from tests.conftest import REPOSITORY
from tests.motion.gltf_files import bending_arm, moving_node, quaternion

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
BALL = REPOSITORY / "examples" / "fibers" / "curly_ball.rna"

ANGLE, SHIFT = 40.0, (0.1, 0.05, -0.2)


SUN = "{type: directional, direction: [0.5, 0.9, 0.6], irradiance: [2, 1.9, 1.8]}"
SKY = "{type: environment, radiance: [0.3, 0.4, 0.5]}"


def scene(
    folder: Path, asset: str, more: str = "", package: Path = TOY, lights: str = f"[{SUN}, {SKY}]"
) -> Path:
    path = folder / "scene.yaml"
    path.write_text(f"""
assets:
  - path: {package}
    {asset}
camera: {{position: [1.4, 0.9, 1.2], look_at: [0.3, 0.2, -0.1], vertical_fov_deg: 30}}
lights: {lights}
resolution: [64, 48]
samples: 8
{more}""")
    return path


def picture(path: Path, **changes: object) -> dict[str, np.ndarray]:
    file = read_scene(path).with_changes(**changes)
    return render(file.scene, make_integrator(file.resolved, load_world(file))).channels()


def matrix() -> np.ndarray:
    c, s = np.cos(np.radians(ANGLE)), np.sin(np.radians(ANGLE))
    result = np.eye(4)
    result[:3, :3], result[:3, 3] = [[c, 0, s], [0, 1, 0], [-s, 0, c]], SHIFT
    return result


@pytest.mark.parametrize("package", [TOY, BALL], ids=["surface", "fiber"])
def test_rigid_motion_is_the_transforms_picture_to_60_db(tmp_path, package, monkeypatch):
    """Off outlines, and off the edges of shadows, where a ray by rounding goes the other way.

    Under the sun alone, which needs no random directions, by the means of nearby light, whose
    columns are drawn in the space of the geometry.
    """
    part = load(package)
    monkeypatch.setattr(type(part), "nearby_lengths", None)
    geometry = part.curves if part.kind == "fiber" else part.mesh
    rest = geometry.points if part.kind == "fiber" else geometry.positions
    moved = Transform(matrix()).to_world_points(rest)
    write_motion(tmp_path / "rigid.rnam", [geometry], [[moved]], count=1, rate=24)
    (tmp_path / "a").mkdir(), (tmp_path / "b").mkdir()
    sun = {"package": package, "lights": f"[{SUN}]"}
    motion = picture(scene(tmp_path / "a", "motion: ../rigid.rnam", **sun))
    turn = f"{{translation: {list(SHIFT)}, rotation_deg: [0, {ANGLE}, 0]}}"
    placed = picture(scene(tmp_path / "b", f"transform: {turn}", **sun))
    inside = motion["A"] == 1.0
    for k in "XYZ":
        inside &= np.abs(motion[f"position.{k}"] - placed[f"position.{k}"]) < 1e-4
    inside &= np.abs(motion["visibility"] - placed["visibility"]) < 1e-6
    assert inside.mean() > 0.1
    error = np.sort(np.mean([np.square(motion[k] - placed[k])[inside] for k in "RGB"], axis=0))
    error = error[: int(0.995 * len(error))]  # a ray or two meet the strand's next segment
    peak = max(placed[k][inside].max() for k in "RGB")
    assert 10 * np.log10(peak**2 / error.mean()) > 60
    normals = np.stack([motion[f"normal.{k}"] - placed[f"normal.{k}"] for k in "XYZ"])
    assert np.quantile(np.abs(normals[:, inside]), 0.995) < 1e-3


def test_frames_of_a_motion_are_the_same_on_any_threads(tmp_path):
    bending_arm(tmp_path / "bend.gltf", load(TOY).mesh, 30)
    more = "animation: {frames: 3, fixed_seed: true}"
    path = scene(tmp_path, "motion: {path: bend.gltf, rate: 2}", more)
    images = []
    for threads in ("1", "2"):
        out = f"{tmp_path}/{threads}.%d.exr"
        assert main([str(path), "--frames", "1-2", "--out", out, "--threads", threads]) == 0
        images.append([read_exr(tmp_path / f"{threads}.{k}.exr")[0] for k in (1, 2)])
    limit_kernel_threads(2)
    for one, two in zip(*images, strict=True):
        assert all(np.array_equal(one[name], two[name]) for name in one)
    first, second = images[0]
    assert np.abs(first["R"] - second["R"]).mean() > 1e-3
    alone = scene(tmp_path, "motion: {path: bend.gltf, rate: 2, start: 2}")
    still = picture(alone)
    assert np.array_equal(still["position.X"], second["position.X"])


def test_motion_blur_is_the_mean_of_its_subframes(tmp_path):
    mesh, up = load(TOY).mesh, ("translation", [0, 1], [[0, 0, 0], [0, 0.5, 0]])
    moving_node(tmp_path / "up.gltf", mesh, [up])
    motion, blur = "motion: {path: up.gltf, rate: 1}", "shutter: 1, subframes: 2"
    path = scene(tmp_path, motion, f"animation: {{frames: 2, {blur}}}")
    assert main([str(path), "--frames", "0", "--out", f"{tmp_path}/%d.exr", "--samples", "2"]) == 0
    blurred = read_exr(tmp_path / "0.exr")[0]
    stills = {}
    for start, count in ((0.25, 1), (0.75, 1), (0.75, 2)):
        path = scene(tmp_path, f"motion: {{path: up.gltf, rate: 1, start: {start}}}")
        stills[start, count] = picture(path, samples=count)
    assert np.abs(stills[0.25, 1]["R"] - stills[0.75, 1]["R"]).mean() > 1e-2
    for k in "RGB":
        second = 2 * stills[0.75, 2][k] - stills[0.75, 1][k]  # the second sample alone
        np.testing.assert_allclose(blurred[k], (stills[0.25, 1][k] + second) / 2, atol=1e-5)


@pytest.mark.parametrize(
    ("asset", "message"),
    [
        ("motion: none.glb", "scene.yaml:4: assets\\[0\\].motion.path: no such file"),
        ("motion: {path: up.gltf, clip: Run}", "has no clip 'Run'; it has clip"),
        ("motion: {path: up.gltf, start: 30}", "has frames 0 to 24, and no frame 30"),
        ("motion: huge.gltf", "it is 100 times as large: in another unit"),
        ("motion: scene.rnam", "scene.rnam: found a header of"),
        ("motion: walk.blend", "rna-motion .*walk.blend toy.rna --out walk.rnam"),
        ("motion: {path: up.gltf, rate: 0}", "rate: expected a number, more than 0"),
    ],
)
def test_motions_that_do_not_fit_are_refused(tmp_path, asset, message):
    mesh = load(TOY).mesh
    track = ("rotation", [0, 1], [quaternion((0, 1, 0), a) for a in (0, 90)])
    moving_node(tmp_path / "up.gltf", mesh, [track])
    huge = replace(mesh, positions=100 * mesh.positions)
    moving_node(tmp_path / "huge.gltf", huge, [track])
    (tmp_path / "scene.rnam").write_bytes(b"not a motion file")
    (tmp_path / "walk.blend").write_bytes(b"BLENDER")
    with pytest.raises(SceneError, match=message) as caught:
        load_world(read_scene(scene(tmp_path, asset)))
    assert "\n" not in str(caught.value)


def test_a_motion_too_short_for_the_frames_is_refused_at_once(tmp_path, capsys):
    moving_node(tmp_path / "up.gltf", load(TOY).mesh, [("scale", [0, 1], [[1, 1, 1]] * 2)])
    path = scene(tmp_path, "motion: up.gltf", "animation: {frames: 40}")
    assert main([str(path), "--frames", "all", "--out", f"{tmp_path}/%02d.exr"]) == 1
    assert "has frames 0 to 24, and no frame 25" in capsys.readouterr().err
    assert not list(tmp_path.glob("*.exr"))
    looping = scene(tmp_path, "motion: {path: up.gltf, loop: true, start: 30}")
    load_world(read_scene(looping))


def test_a_loop_that_does_not_close_is_refused(tmp_path):
    moving_node(tmp_path / "up.gltf", load(TOY).mesh, [("scale", [0, 1], [[1, 1, 1], [1, 2, 1]])])
    load_world(read_scene(scene(tmp_path, "motion: up.gltf")))
    looping = scene(tmp_path, "motion: {path: up.gltf, loop: true}")
    with pytest.raises(SceneError, match=r"loop: frame 24 is up to 0\.\d+ m from frame 0"):
        load_world(read_scene(looping))


def test_an_animation_without_motion_is_refused(tmp_path):
    with pytest.raises(SceneError, match="nothing moves: give turntable, light_sweep, or"):
        read_scene(scene(tmp_path, "tier: small", "animation: {frames: 2}"))


def test_motion_is_for_the_cpu(tmp_path):
    from rna_render.paths.integrator_factory import check_device

    moving_node(tmp_path / "up.gltf", load(TOY).mesh, [("scale", [0, 1], [[1, 1, 1]] * 2)])
    file = read_scene(scene(tmp_path, "motion: up.gltf"))
    with pytest.raises(SceneError, match="is rendered on the CPU, not with --device gpu"):
        check_device("gpu", file)
