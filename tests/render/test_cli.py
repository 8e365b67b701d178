"""rna-run, from a scene file to images."""

import json
import signal
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from rna_render.command.rna_run import INTERRUPTED, main
from rna_render.image.images import read_exr
from rna_render.paths.integrator import Integrator
from tests.render.assets import sphere
from tests.render.packages import ALBEDO, write_lambert_package

SCENE = """\
assets:
  - path: ball.rna
camera: {position: [0, 4, 0], look_at: [0, 0, 0], up: [0, 0, -1], vertical_fov_deg: 5}
lights:
  - {type: directional, direction: [0, LIGHT, 0], irradiance: [1, 2, 3]}
resolution: [12, 8]
samples: 4
exposure: 1
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Two scenes and their package; tests write their images elsewhere."""
    folder = tmp_path_factory.mktemp("scene")
    write_lambert_package(folder / "ball.rna", sphere(4), tiers=("small", "hq"))
    (folder / "lit.yaml").write_text(SCENE.replace("LIGHT", "1"))
    (folder / "backlit.yaml").write_text(SCENE.replace("LIGHT", "-1"))
    return folder


def run(*arguments: object) -> int:
    return main([str(argument) for argument in arguments])


def test_a_scene_becomes_an_exr_and_a_png(folder, tmp_path, capsys):
    out, png = tmp_path / "out.exr", tmp_path / "out.png"
    assert run(folder / "lit.yaml", "--out", out, "--png", png) == 0
    channels, header = read_exr(out)
    # The camera looks down the light's direction at a ball: cosines from 1 to about 0.98.
    expected = np.divide(ALBEDO, np.pi) * [1, 2, 3]
    rgb = np.stack([channels[c] for c in "RGB"], axis=-1)
    np.testing.assert_allclose(rgb, np.broadcast_to(expected, (8, 12, 3)), rtol=0.05)
    assert (channels["visibility"] == 1).all() and (channels["assetId"] == 1).all()
    assert json.loads(header["rnaScene"])["samples"] == 4 and header["rnaSamples"] == "4"
    assert np.asarray(Image.open(png)).shape == (8, 12, 3)
    printed = capsys.readouterr()
    assert printed.out.splitlines() == [f"wrote {out}", f"wrote {png}"]
    assert "first pixels after" in printed.err


def test_what_the_camera_sees_nothing_of_is_transparent_and_far(folder, tmp_path):
    (folder / "wide.yaml").write_text(
        SCENE.replace("LIGHT", "1").replace("fov_deg: 5", "fov_deg: 60")
    )
    out, png = tmp_path / "out.exr", tmp_path / "out.png"
    assert run(folder / "wide.yaml", "--out", out, "--png", png) == 0
    channels, _ = read_exr(out)
    pixels = np.asarray(Image.open(png))
    assert pixels.shape == (8, 12, 4) and pixels[0, 0].tolist() == [0, 0, 0, 0]
    assert pixels[4, 6, 3] == 255
    assert channels["Z"][0, 0] == 1e10
    assert channels["Z"][4, 6] == pytest.approx(4.0 - 1.0, abs=0.1)  # the unit ball's front


def test_a_lens_blurs_what_is_out_of_focus(folder, tmp_path):
    """An edge of a ball is as wide as the circle of confusion; in focus it is sharp."""
    text = (
        SCENE.replace("LIGHT", "1")
        .replace("fov_deg: 5", "fov_deg: 60")
        .replace("[12, 8]", "[60, 40]")
    )
    partly = {}
    for name, more in (("sharp", ""), ("blurred", ", aperture: 1, focus: 2")):
        scene = text.replace("fov_deg: 60", f"fov_deg: 60{more}").replace(
            "samples: 4", "samples: 64"
        )
        (folder / f"{name}.yaml").write_text(scene)
        assert run(folder / f"{name}.yaml", "--out", tmp_path / f"{name}.exr") == 0
        alpha = read_exr(tmp_path / f"{name}.exr")[0]["A"]
        partly[name] = ((alpha > 0.02) & (alpha < 0.98)).sum(), alpha.mean()
    assert partly["blurred"][0] > 4 * partly["sharp"][0]
    assert partly["blurred"][1] == pytest.approx(partly["sharp"][1], rel=0.2)


def test_options_replace_what_the_scene_says(folder, tmp_path):
    options = ["--samples", 2, "--resolution", "6x5", "--seed", 9, "--tier", "hq", "--threads", 1]
    assert run(folder / "lit.yaml", "--out", tmp_path / "out.exr", *options) == 0
    channels, header = read_exr(tmp_path / "out.exr")
    assert channels["R"].shape == (5, 6)
    scene = json.loads(header["rnaScene"])
    assert (scene["samples"], scene["seed"], scene["assets"][0]["tier"]) == (2, 9, "hq")


def test_another_view_changes_the_png_alone(folder, tmp_path):
    for view in ("srgb", "filmic"):
        files = ["--out", tmp_path / f"{view}.exr", "--png", tmp_path / f"{view}.png"]
        assert run(folder / "lit.yaml", *files, "--view", view) == 0
    plain, filmic = (read_exr(tmp_path / f"{view}.exr") for view in ("srgb", "filmic"))
    np.testing.assert_array_equal(plain[0]["R"], filmic[0]["R"])
    assert json.loads(filmic[1]["rnaScene"])["view"] == "filmic"
    assert (tmp_path / "srgb.png").read_bytes() != (tmp_path / "filmic.png").read_bytes()


def test_an_image_that_cannot_be_written_is_one_line_before_the_render(folder, tmp_path, capsys):
    (tmp_path / "out.exr").mkdir()
    assert run(folder / "lit.yaml", "--out", tmp_path / "out.exr") == 1
    error = capsys.readouterr().err
    assert error == f"error: {tmp_path / 'out.exr'}: cannot be written: it is a folder\n"


def test_a_fault_of_the_renderer_is_one_line_and_no_file(folder, tmp_path, capsys, monkeypatch):
    whole = Integrator.render

    def faulty(self, pixels, sampler):
        band = whole(self, pixels, sampler)
        band.beauty[0] = np.nan
        return band

    monkeypatch.setattr(Integrator, "render", faulty)
    out = tmp_path / "out.exr"
    assert run(folder / "lit.yaml", "--out", out, "--png", tmp_path / "out.png") == 1
    assert "not written: 1 of 96 pixels are not finite" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "options",
    [
        [],
        ["--out", "out.jpg"],
        ["--out", "out.exr", "--png", "out.jpg"],
        ["--out", "no/such/folder/out.exr"],
        ["--out", "out.exr", "--samples", "0"],
        ["--out", "out.exr", "--samples", "1.5"],
        ["--out", "out.exr", "--resolution", "640"],
        ["--out", "out.exr", "--resolution", "0x480"],
        ["--out", "out.exr", "--seed", "-1"],
        ["--out", "out.exr", "--threads", "0"],
        ["--out", "out.exr", "--view", "raw"],
        ["--out", "out.exr", "--every", "-1"],
        ["--out", "out.exr", "--every", "1", "--cluster", "auto"],
        ["--preview", "--every", "0"],
        ["--out", "out.exr", "--unknown"],
    ],
)
def test_bad_usage_exits_with_2(folder, options, capsys):
    with pytest.raises(SystemExit) as caught:
        run(folder / "lit.yaml", *options)
    assert caught.value.code == 2
    assert "rna-run: error: " in capsys.readouterr().err


BAD_INPUT = [
    (lambda text: None, "No such file or directory"),
    (lambda text: text.replace("ball", "none"), ":2: assets[0].path: no such file: "),
    (lambda text: text.replace("ball.rna", "bad.yaml"), "bad.yaml"),
    (lambda text: text.replace("path:", "tier: huge\n    path:"), ":2: assets[0].tier: "),
    (lambda text: text.replace("samples: 4", "samples: x"), ":7: samples: "),
]


@pytest.mark.parametrize(("change", "message"), BAD_INPUT)
def test_bad_input_is_one_line_and_exits_with_1(folder, tmp_path, capsys, change, message):
    (tmp_path / "ball.rna").symlink_to(folder / "ball.rna")
    text = change(SCENE.replace("LIGHT", "1"))
    if text is not None:
        (tmp_path / "bad.yaml").write_text(text)
    assert run(tmp_path / "bad.yaml", "--out", tmp_path / "out.exr") == 1
    error = capsys.readouterr().err
    assert error.startswith("error: ") and error.count("\n") == 1 and message in error
    assert not (tmp_path / "out.exr").exists()


def test_debug_shows_the_traceback(tmp_path, capsys):
    assert run(tmp_path / "none.yaml", "--out", tmp_path / "out.exr", "--debug") == 1
    assert "Traceback" in capsys.readouterr().err


@pytest.fixture
def long_render(folder, tmp_path):
    """rna-run with more samples than anyone waits for, stopped by the test."""
    command = [
        sys.executable,
        "-m",
        "rna_render.command.rna_run",
        folder / "lit.yaml",
        "--samples",
        "1000000",
    ]
    started = subprocess.Popen(
        [*command, "--out", tmp_path / "out.exr"], stderr=subprocess.PIPE, stdout=subprocess.PIPE
    )
    yield started
    started.kill()
    started.communicate()


def test_ctrl_c_writes_the_mean_of_the_finished_samples(long_render, tmp_path):
    said = b""
    while b"first pixels" not in said:
        said += long_render.stderr.read1()
    while b"/96.0M" not in said:  # the bar shows finished work of 12 x 8 x 1,000,000 rays
        said += long_render.stderr.read1()
    long_render.send_signal(signal.SIGINT)
    out, error = long_render.communicate(timeout=60)
    assert long_render.returncode == INTERRUPTED
    channels, header = read_exr(tmp_path / "out.exr")
    assert 1 <= int(header["rnaSamples"]) < 1_000_000
    assert f"the image is the mean of {header['rnaSamples']} of 1000000 samples" in error.decode()
    assert f"wrote {tmp_path / 'out.exr'}" in out.decode()
    np.testing.assert_allclose(channels["R"], ALBEDO[0] / np.pi, rtol=0.05)


def test_the_image_so_far_is_written_after_the_first_sample_and_then_so_often(folder, tmp_path):
    from rna_render.image import output

    seen = []
    write = output.write_linear

    def watched(path, channels, attributes):
        write(path, channels, attributes)
        with np.load(path) as arrays:
            seen.append((str(arrays["rnaSamples"]), arrays["R"].mean()))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(output, "write_linear", watched)
        assert run(folder / "lit.yaml", "--out", tmp_path / "all.npz", "--every", 0) == 0
        assert run(folder / "lit.yaml", "--out", tmp_path / "few.npz", "--every", 1e6) == 0
    assert [samples for samples, _ in seen] == ["1", "2", "3", "4", "1", "4"]
    np.testing.assert_allclose([mean for _, mean in seen], ALBEDO[0] / np.pi, rtol=0.05)
    assert run(folder / "lit.yaml", "--out", tmp_path / "out.exr") == 0
    channels, header = read_exr(tmp_path / "out.exr")
    with np.load(tmp_path / "all.npz") as arrays:
        assert str(arrays["rnaScene"]) == header["rnaScene"]
        for name, channel in channels.items():
            np.testing.assert_array_equal(arrays[name], channel, strict=True)
