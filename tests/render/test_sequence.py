"""Sequences: what moves from frame to frame, and frames that are rendered once only."""

import json
import os
import signal
import struct
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from pydantic import ValidationError

import rna_render.command.frame_worker
from rna_render.command.rna_run import INTERRUPTED, main
from rna_render.command.sequence import animated
from rna_render.image.images import read_exr, write_exr
from rna_render.scene.animation import frame_scene
from rna_render.scene.scene_file import read_scene
from rna_render.scene.scene_model import MotionModel, Scene
from rna_render.world.scene_sources import contents_key
from tests.render.assets import sphere
from tests.render.packages import ALBEDO, write_lambert_package

SCENE = """\
assets:
  - path: ball.rna
camera: {position: [0, 0, 5], look_at: [0, 0, 0], vertical_fov_deg: 5}
lights:
  - {type: directional, direction: [0, 0, 1], irradiance: [1, 2, 3]}
resolution: [12, 8]
samples: 4
animation:
  frames: 4
  turntable: {}
"""


@pytest.fixture
def folder(tmp_path):
    write_lambert_package(tmp_path / "ball.rna", sphere(4))
    (tmp_path / "scene.yaml").write_text(SCENE)
    return tmp_path


def run(folder: Path, *options: object, frames: str = "all", png: bool = False) -> int:
    files = ["--out", folder / "f.%04d.exr", *(["--png", folder / "f.%04d.png"] if png else [])]
    arguments = [folder / "scene.yaml", *files, "--frames", frames, *options]
    return main([str(argument) for argument in arguments])


def scene(**changes: object) -> Scene:
    return Scene.model_validate(
        {
            "assets": [{"path": "a.rna"}],
            "camera": {"position": [1, 2, 0], "look_at": [0, 1, 0], "up": [0, 1, 0.5]},
            "lights": [
                {"type": "directional", "direction": [0, 1, 1], "irradiance": [1, 1, 1]},
                {"type": "environment", "radiance": [1, 1, 1], "rotation_deg": 10},
                {"type": "point", "position": [1, 0, 0], "intensity": [1, 1, 1]},
            ],
            **changes,
        }
    )


def test_the_camera_goes_around_counter_clockwise_seen_from_above():
    animated = scene(animation={"frames": 4, "turntable": {}})
    first, second, third = (frame_scene(animated, number) for number in range(3))
    np.testing.assert_allclose(first.camera.position, [1, 2, 0])
    # +y comes out of a plan of x to the right and z down, where -z is a quarter turn from +x.
    np.testing.assert_allclose(second.camera.position, [0, 2, -1], atol=1e-12)
    np.testing.assert_allclose(second.camera.up, [0.5, 1, 0], atol=1e-12)
    np.testing.assert_allclose(third.camera.position, [-1, 2, 0], atol=1e-12)
    assert second.camera.look_at == (0, 1, 0) and second.lights == animated.lights
    assert second.animation is None


def test_a_sweep_turns_only_light_from_far_away():
    animated = scene(animation={"frames": 3, "light_sweep": {"degrees": -270}})
    lights = frame_scene(animated, 1).lights
    np.testing.assert_allclose(lights[0].direction, [-1, 1, 0], atol=1e-12)
    assert lights[1].rotation_deg == -80 and lights[2] == animated.lights[2]
    assert frame_scene(animated, 1).camera == animated.camera


def test_each_frame_has_noise_of_its_own(folder):
    sky = "{type: environment, radiance: [1, 1, 1]}"
    lit = SCENE.replace("{type: directional, direction: [0, 0, 1], irradiance: [1, 2, 3]}", sky)
    still = lit.replace("turntable: {}", "turntable: {degrees: 1.0e-6}")
    still = still.replace("[12, 8]", "[48, 32]").replace("deg: 5", "deg: 9")
    (folder / "own.yaml").write_text(still)
    (folder / "fixed.yaml").write_text(still + "  fixed_seed: true\n")
    correlations = {}
    for name in ("own", "fixed"):
        images = folder / f"{name}.%04d.exr"
        scene = [str(folder / f"{name}.yaml"), "--out", str(images), "--frames", "0-1"]
        assert main([*scene, "--samples", "2"]) == 0
        frames = [read_exr(folder / f"{name}.{i:04d}.exr")[0]["R"].ravel() for i in range(2)]
        correlations[name] = np.corrcoef(*frames)[0, 1]
    assert abs(correlations["own"]) < 0.1 and correlations["fixed"] > 0.99


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"animation": {"frames": 4}}, "nothing moves"),
        ({"animation": {"frames": 0, "turntable": {}}}, "greater than or equal to 1"),
        ({"animation": {"frames": 4, "light_sweep": {}}, "lights": ()}, "the scene has none"),
    ],
)
def test_animations_that_make_no_sense_are_refused(changes, message):
    with pytest.raises(ValidationError, match=message):
        scene(**changes)


def test_frames_show_what_moves(folder, capsys):
    assert run(folder, png=True) == 0
    # The light stays in front: the camera sees the lit, the dark and the other halves.
    means = [read_exr(folder / f"f.{i:04d}.exr")[0]["R"].mean() for i in range(4)]
    assert means[0] == pytest.approx(ALBEDO[0] / np.pi, rel=0.05)
    assert means[2] < 0.7 * means[0]
    printed = capsys.readouterr().out.splitlines()
    assert len(printed) == 4
    assert printed[1].startswith(f"frame 1 (2 of 4): wrote {folder / 'f.0001.exr'}, ")
    header = read_exr(folder / "f.0001.exr")[1]
    shot = json.loads(header["rnaScene"])
    assert shot["camera"]["position"][0] == pytest.approx(5) and shot["animation"] is None


def test_frames_without_an_animation_are_a_turntable(folder):
    (folder / "scene.yaml").write_text(SCENE.split("animation:")[0])
    assert run(folder, frames="0-3") == 0
    cameras = []
    for i in range(4):
        shot = json.loads(read_exr(folder / f"f.{i:04d}.exr")[1]["rnaScene"])
        cameras.append(shot["camera"]["position"])
    np.testing.assert_allclose(cameras, [[0, 0, 5], [5, 0, 0], [0, 0, -5], [-5, 0, 0]], atol=1e-6)


def test_frames_without_an_animation_play_motions(folder):
    (folder / "scene.yaml").write_text(SCENE.split("animation:")[0])
    file = read_scene(folder / "scene.yaml")
    asset = file.scene.assets[0].model_copy(update={"motion": MotionModel(path="walk.rnam")})
    moving = animated(file.with_changes(assets=(asset,)), 9).scene.animation
    assert moving is not None and moving.frames == 10 and moving.turntable is None


def test_a_still_of_an_animated_scene_is_its_first_frame(folder):
    out = folder / "still.exr"
    assert main([str(folder / "scene.yaml"), "--out", str(out)]) == 0
    assert run(folder, frames="0") == 0
    still, first = read_exr(out)[0], read_exr(folder / "f.0000.exr")[0]
    np.testing.assert_array_equal(still["R"], first["R"])


def times(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mtime_ns for path in folder.glob("f.*")}


def test_only_what_is_missing_or_was_made_otherwise_is_rendered(folder, capsys, monkeypatch):
    loads = []
    load = rna_render.command.frame_worker.load_world
    monkeypatch.setattr(
        rna_render.command.frame_worker,
        "load_world",
        lambda *given: loads.append(1) or load(*given),
    )

    def rendered(**options: object) -> list[int]:
        """The frames that a run renders."""
        before = times(folder)
        more = options.pop("more", [])
        assert run(folder, *more, png=True, **options) == 0
        after = times(folder)
        return sorted({int(name[2:6]) for name in after if after[name] != before.get(name)})

    assert rendered(frames="1-2") == [1, 2]
    assert len(loads) == 1
    assert rendered() == [0, 3]
    assert "frame 2: is there already" in capsys.readouterr().out
    assert rendered() == [] and len(loads) == 2
    (folder / "f.0003.png").unlink()
    assert rendered() == [3]
    (folder / "f.0001.exr").write_bytes(b"no image")
    assert rendered() == [1]
    assert rendered(more=["--samples", 2]) == [0, 1, 2, 3]
    assert rendered(more=["--samples", 2]) == []
    # Twice as many frames: two of the old ones stand where new ones do, one of them by its name.
    (folder / "scene.yaml").write_text(SCENE.replace("frames: 4", "frames: 2"))
    assert rendered(more=["--samples", 2]) == [1]
    later = time.time() + 5
    os.utime(folder / "ball.rna", (later, later))
    assert rendered(more=["--samples", 2]) == []


GLTF = json.dumps(
    {"asset": {"version": "2.0"}, "buffers": [{"uri": "a.bin"}], "images": [{"uri": "b%20c.png"}]}
).encode()
READ = {
    "a.gltf": GLTF,
    "a.bin": b"buffer",
    "b c.png": b"image",
    "d.glb": struct.pack("<4sIIII", b"glTF", 2, 28 + len(GLTF), len(GLTF), 0x4E4F534A) + GLTF,
    "e.obj": b"mtllib e.mtl",
    "e.mtl": b"newmtl e\nmap_Kd f.png",
    "f.png": b"texture",
    "g.png": b"ground",
}
"""Files that a scene reads, of which only the names count."""
OBJECTS = """\
objects: [{path: a.gltf}, {path: d.glb}, {path: e.obj}]
ground: {material: {type: diffuse, texture: g.png}}
"""


def test_contents_of_all_files_that_are_read_tell_frames_apart(folder):
    """Whatever their time stamps and sizes are."""
    for name, data in READ.items():
        (folder / name).write_bytes(data)
    (folder / "scene.yaml").write_text(SCENE + OBJECTS)
    scene_file = read_scene(folder / "scene.yaml")
    whole = contents_key(scene_file)
    for name in ("ball.rna", *READ):
        path = folder / name
        data, state = path.read_bytes(), path.stat()
        path.write_bytes(bytes([data[0], data[1] ^ 1]) + data[2:])
        os.utime(path, ns=(state.st_atime_ns, state.st_mtime_ns))
        assert contents_key(scene_file) != whole, name
        path.write_bytes(data)
    assert contents_key(scene_file) == whole


def test_an_asset_swapped_for_an_older_one_gets_new_frames(folder):
    assert run(folder, frames="0") == 0
    before = read_exr(folder / "f.0000.exr")
    write_lambert_package(folder / "ball.rna", sphere(2))
    os.utime(folder / "ball.rna", (0, 0))
    assert run(folder, frames="0") == 0
    after = read_exr(folder / "f.0000.exr")
    assert before[1]["rnaContents"] != after[1]["rnaContents"]
    assert not np.array_equal(before[0]["R"], after[0]["R"])


def test_frames_go_on_after_the_reader_of_their_lines_ended(folder):
    reading, writing = os.pipe()
    command = [
        sys.executable,
        "-m",
        "rna_render.command.rna_run",
        folder / "scene.yaml",
        "--frames",
        "all",
    ]
    files = ["--out", folder / "f.%04d.exr"]
    with subprocess.Popen([*command, *files], stdout=writing, stderr=writing) as process:
        os.close(writing)
        os.close(reading)
    assert process.returncode == 0
    assert len(list(folder.glob("f.*.exr"))) == 4


@pytest.mark.parametrize("name", ["ball.exr", "0004.exr"])
def test_frames_do_not_replace_what_the_scene_reads(folder, capsys, name):
    write_exr(folder / name, {c: np.ones((2, 4), np.float32) for c in "RGB"}, {})
    lights = SCENE.replace("lights:", f"lights:\n  - {{type: environment, path: {name}}}")
    (folder / "scene.yaml").write_text(lights.replace("frames: 4", "frames: 9"))
    before = (folder / name).read_bytes()
    if name == "ball.exr":
        command = ["--out", str(folder / name)]
    else:
        command = ["--out", str(folder / "%04d.exr"), "--frames", "4"]
    assert main([str(folder / "scene.yaml"), *command]) == 1
    assert f"{name}: is an input" in capsys.readouterr().err
    assert (folder / name).read_bytes() == before


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_a_sequence_that_was_stopped_goes_on(folder, capsys, number):
    (folder / "scene.yaml").write_text(SCENE.replace("frames: 4", "frames: 2000"))
    files = ["--out", folder / "f.%04d.exr", "--png", folder / "f.%04d.png", "--frames", "all"]
    command = [sys.executable, "-m", "rna_render.command.rna_run", folder / "scene.yaml", *files]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        for line in process.stdout:
            if line.startswith(b"frame 2 "):
                process.send_signal(number)
                break
        error = process.communicate(timeout=60)[1]
    if number == signal.SIGINT:
        assert process.returncode == INTERRUPTED
        assert "the same command goes on" in error.decode()
        assert not list(folder.glob(".*"))
    times_before = times(folder)
    if number == signal.SIGINT:
        whole = sum(
            name.endswith(".png") for name in times_before
        )  # the later one of a frame's files
        assert whole >= 2
        assert f"stopped: {whole} of 2000 frames are written, each of 4 samples; " in (
            error.decode()
        )
    for name in times_before:  # all of them are whole
        if name.endswith(".exr"):
            assert read_exr(folder / name)[1]["rnaSamples"] == "4"
    assert run(folder, frames="0-2", png=True) == 0
    assert capsys.readouterr().out.splitlines() == [
        f"frame {number}: is there already" for number in range(3)
    ]
    assert times(folder) == times_before


def test_ctrl_c_ends_a_sequence_at_the_frame_under_way(folder, capsys, monkeypatch):
    written = []

    def write(*given: object) -> None:
        written.append(given)
        if len(written) == 2:
            os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr("rna_render.image.output.Output.write", write)
    (folder / "scene.yaml").write_text(SCENE.replace("frames: 4", "frames: 100"))
    assert run(folder, "--samples", 1) == INTERRUPTED
    assert 2 <= len(written) < 100
    assert "were not written; the same command goes on" in capsys.readouterr().err


BAD_INPUT = [
    (SCENE.split("animation:")[0], "all", ":1: animation: is missing, and --frames all needs it"),
    (SCENE, "4", ":9: animation.frames: the scene has frames 0 to 3, and no frame 4"),
    (SCENE, "2-9", "and no frame 9"),
    (SCENE.replace("ball", "none"), "all", ":2: assets[0].path: no such file: "),
]


@pytest.mark.parametrize(("text", "frames", "message"), BAD_INPUT)
def test_bad_input_is_one_line_and_exits_with_1(folder, capsys, text, frames, message):
    (folder / "scene.yaml").write_text(text)
    assert run(folder, frames=frames) == 1
    error = capsys.readouterr().err
    assert error.startswith("error: ") and error.count("\n") == 1 and message in error
    assert not list(folder.glob("*.exr"))


def test_a_frame_that_cannot_be_written_is_one_line_and_takes_no_time(folder, capsys, monkeypatch):
    monkeypatch.setattr(rna_render.command.frame_worker, "load_world", None)
    (folder / "f.0002.png").mkdir()
    assert run(folder, frames="2", png=True) == 1
    error = capsys.readouterr().err
    assert error == f"error: {folder / 'f.0002.png'}: cannot be written: it is a folder\n"
    assert not list(folder.glob("*.exr"))


@pytest.mark.parametrize(
    "options",
    [
        ["--frames", "all", "--out", "f.exr"],
        ["--frames", "all", "--out", "f.%04d.exr", "--png", "f.png"],
        ["--frames", "all", "--out", "f.%d.%d.exr"],
        ["--frames", "all", "--out", "f.%s.exr"],
        ["--out", "f.%04d.exr"],
        ["--frames", "3-1", "--out", "f.%d.exr"],
        ["--frames", "some", "--out", "f.%d.exr"],
        ["--frames", "-1", "--out", "f.%d.exr"],
        ["--frames", "1-", "--out", "f.%d.exr"],
    ],
)
def test_bad_usage_exits_with_2(folder, options, capsys):
    with pytest.raises(SystemExit) as caught:
        main([str(folder / "scene.yaml"), *options])
    assert caught.value.code == 2
    assert "rna-run: error: " in capsys.readouterr().err
