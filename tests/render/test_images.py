"""Image files and the film behind them."""

import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from rna_render.image.film import Film, Layers
from rna_render.image.images import read_attributes, read_exr, write_exr, write_png
from rna_render.image.output import Output
from rna_render.scene.scene_model import Scene
from rna_sdk.errors import SceneError
from rna_sdk.files.srgb import decode_srgb, encode_srgb


def test_an_exr_keeps_every_bit_and_every_channel(tmp_path):
    rng = np.random.default_rng(0)
    channels = {
        name: rng.normal(0, 1e3, (5, 7)).astype(np.float32)
        for name in ("R", "G", "B", "A", "normal.X", "position.Z", "visibility")
    }
    channels["assetId"] = rng.integers(0, 1 << 32, (5, 7), np.uint32)
    path = tmp_path / "image.exr"
    write_exr(path, channels, {"rnaSamples": "12"})
    read, header = read_exr(path)
    assert set(read) == set(channels)
    for name, plane in channels.items():
        assert read[name].dtype == plane.dtype, name
        np.testing.assert_array_equal(read[name], plane, err_msg=name)
    assert header["rnaSamples"] == "12"


def test_names_with_dots_are_layers(tmp_path):
    """OpenEXR's readers make one layer of what stands before the last dot."""
    import OpenEXR

    plane = np.arange(12, dtype=np.float32).reshape(3, 4)
    layers = ("", "denoised.", "light.key.", "light.rim_2.")
    channels = {
        layer + c: plane + 10 * i + j for i, layer in enumerate(layers) for j, c in enumerate("RGB")
    }
    write_exr(tmp_path / "image.exr", channels, {})
    read, _ = read_exr(tmp_path / "image.exr")
    for name, values in channels.items():
        np.testing.assert_array_equal(read[name], values, err_msg=name)
    with OpenEXR.File(str(tmp_path / "image.exr")) as file:
        assert set(file.channels()) == {"RGB", "denoised", "light.key", "light.rim_2"}
        rim = file.channels()["light.rim_2"].pixels
    np.testing.assert_array_equal(rim[..., 1], channels["light.rim_2.G"])


def test_attributes_come_back_from_both_kinds_of_file(tmp_path):
    attributes = {"rnaScene": '{"path": "Gerät.rna"}', "rnaSamples": "12"}
    write_exr(tmp_path / "a.exr", {"R": np.zeros((2, 2), np.float32)}, attributes)
    write_png(tmp_path / "a.png", np.zeros((2, 2, 3)), attributes=attributes)
    (tmp_path / "broken.exr").write_bytes((tmp_path / "a.exr").read_bytes()[:20])
    (tmp_path / "broken.png").write_bytes((tmp_path / "a.png").read_bytes()[:20])
    assert read_attributes(tmp_path / "a.exr") == read_attributes(tmp_path / "a.png") == attributes
    for name in ("broken.exr", "broken.png", "none.exr", "none.png"):
        assert read_attributes(tmp_path / name) == {}, name


def test_a_png_is_srgb_after_exposure(tmp_path):
    rgb = np.array([[[0.0, 0.25, 0.5], [1.0, 4.0, -1.0]]])
    path = tmp_path / "image.png"
    write_png(path, rgb, exposure=-1.0)
    assert np.asarray(Image.open(path)).tolist() == [[[0, 99, 137], [188, 255, 0]]]


def test_a_png_has_alpha_only_where_something_is_transparent(tmp_path):
    rgb, path = np.array([[[0.25, 0.25, 0.25], [0.0, 0.0, 0.0]]]), tmp_path / "image.png"
    write_png(path, rgb, alpha=np.array([[0.5, 0.0]]))
    assert np.asarray(Image.open(path)).tolist() == [[[188, 188, 188, 128], [0, 0, 0, 0]]]
    write_png(path, rgb, alpha=np.array([[1.0, 1.0]]))
    assert np.asarray(Image.open(path)).shape == (1, 2, 3)


def test_images_that_cannot_be_written_leave_nothing(tmp_path):
    plane = np.zeros((2, 2), np.float32)
    (tmp_path / "taken.exr").mkdir()
    (tmp_path / "taken.png").mkdir()
    with pytest.raises(SceneError, match=r"taken\.exr: cannot write"):
        write_exr(tmp_path / "taken.exr", {"R": plane}, {})
    with pytest.raises(SceneError, match=r"taken\.png: cannot write"):
        write_png(tmp_path / "taken.png", np.zeros((2, 2, 3)))
    with pytest.raises(SceneError, match="cannot write"):
        write_exr(tmp_path / "nowhere" / "image.exr", {"R": plane}, {})
    assert sorted(path.name for path in tmp_path.iterdir()) == ["taken.exr", "taken.png"]


def test_a_full_disk_is_an_error_and_leaves_nothing(tmp_path):
    script = """
import resource, signal, sys
from pathlib import Path
import numpy as np
from rna_render.image.images import write_exr, write_png
from rna_sdk.errors import SceneError
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
noise = np.random.default_rng(0).random((100, 100, 3), np.float32)
folder = Path(sys.argv[1])
for write in (
    lambda: write_exr(folder / "a.exr", {c: noise[..., i].copy() for i, c in enumerate("RGB")}, {}),
    lambda: write_png(folder / "a.png", noise),
):
    try:
        write()
    except SceneError as error:
        print(error)
"""
    done = subprocess.run(
        [sys.executable, "-c", script, tmp_path], capture_output=True, text=True, check=True
    )
    assert done.stdout.count("cannot write the image: ") == 2, done.stdout + done.stderr
    assert done.stdout.count("File too large") == 2 and not list(tmp_path.iterdir())


def test_what_is_no_exr_is_refused(tmp_path):
    (tmp_path / "text.exr").write_text("no image")
    for name in ("text.exr", "none.exr"):
        with pytest.raises(SceneError, match=name):
            read_exr(tmp_path / name)


def test_srgb_and_back():
    linear = np.linspace(0, 1, 1001)
    np.testing.assert_allclose(decode_srgb(encode_srgb(linear)), linear, atol=1e-7)
    assert encode_srgb(np.array([0.5]))[0] == pytest.approx(0.7353569, abs=1e-6)


def layers(hit, asset, normal=(0, 1, 0), position=(0, 0, 0), visibility=0.0, rgba=(0, 0, 0, 0)):
    """One sample of one pixel."""
    row = Layers.empty(1, 1, np.float32)
    row.hit[:], row.asset[:], row.light_samples[:] = hit, asset, (hit, visibility)
    row.normal_world[:], row.position_world[:], row.beauty[:] = normal, position, rgba
    return row


def test_a_group_of_lights_is_a_layer():
    film = Film((1, 1), ("key",))
    for red in (1.0, 3.0):
        sample = layers(1, 1)
        sample.groups[:] = red, 0, 5
        film.add([sample])
    read = {name: plane.item() for name, plane in film.channels().items()}
    assert [read[f"light.key.{c}"] for c in "RGB"] == [2, 0, 5]


def test_channels_other_than_colour_are_means_over_hits():
    film = Film((1, 1), ("key",))
    film.add([layers(0, 0, normal=(0, 0, 0), rgba=(8, 0, 0, 0))])
    film.add([layers(1, 3, (1, 0, 0), (2, 0, 0), 1.0, (0, 4, 0, 1))])
    film.add([layers(1, 2, (0, 1, 0), (4, 0, 0), 0.0, (0, 0, 0, 1))])
    film.add([layers(0, 0, normal=(0, 0, 0))])
    read = {name: plane.item() for name, plane in film.channels().items()}
    assert [read[c] for c in "RGBA"] == [2, 1, 0, 0.5]
    assert read["assetId"] == 3 and read["visibility"] == 0.5 and read["position.X"] == 3
    assert read["normal.X"] == read["normal.Y"] == pytest.approx(0.5**0.5)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("layer", ["beauty", "normal_world", "groups"])
def test_a_picture_that_is_not_finite_is_not_written(tmp_path, layer, value):
    film = Film((3, 2), ("key",))
    sample = Layers.empty(6, 1, np.float32)
    getattr(sample, layer)[4, 0] = value
    film.add([sample])
    camera = {"position": [0, 0, 1], "look_at": [0, 0, 0], "vertical_fov_deg": 40}
    scene = Scene.model_validate({"camera": camera, "ground": {}})
    output = Output(tmp_path / "out.exr", tmp_path / "out.png")
    with pytest.raises(SceneError, match=r"1 of 6 pixels .*the first at column 1, row 1"):
        output.write(scene, film)
    assert not list(tmp_path.iterdir())
