"""Image files and the film behind them."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image

from rna_render.film import Film, Layers
from rna_render.images import read_exr, write_exr, write_png
from rna_render.srgb import decode_srgb, encode_srgb
from rna_sdk.errors import SceneError


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


def test_the_same_image_is_the_same_file(tmp_path):
    channels = {"R": np.arange(12, dtype=np.float32).reshape(3, 4)}
    for name in ("a.exr", "b.exr"):
        write_exr(tmp_path / name, channels, {"k": "v"})
    assert (tmp_path / "a.exr").read_bytes() == (tmp_path / "b.exr").read_bytes()


def test_a_png_is_srgb_after_exposure(tmp_path):
    rgb = np.array([[[0.0, 0.25, 0.5], [1.0, 4.0, -1.0]]])
    path = tmp_path / "image.png"
    write_png(path, rgb, exposure=-1.0)
    assert np.asarray(Image.open(path)).tolist() == [[[0, 99, 137], [188, 255, 0]]]


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
    row = Layers.empty(1, np.float32)
    row.hit[:], row.asset[:], row.visibility[:] = hit, asset, visibility
    row.normal_world[:], row.position_world[:], row.beauty[:] = normal, position, rgba
    return row


def test_channels_other_than_colour_are_means_over_hits():
    film = Film((1, 1))
    film.add(layers(0, 0, normal=(0, 0, 0), rgba=(8, 0, 0, 0)))
    film.add(layers(1, 3, (1, 0, 0), (2, 0, 0), 1.0, (0, 4, 0, 1)))
    film.add(layers(1, 2, (0, 1, 0), (4, 0, 0), 0.0, (0, 0, 0, 1)))
    film.add(layers(0, 0, normal=(0, 0, 0)))
    read = {name: plane.item() for name, plane in film.channels().items()}
    assert [read[c] for c in "RGBA"] == [2, 1, 0, 0.5]
    assert read["assetId"] == 3 and read["visibility"] == 0.5 and read["position.X"] == 3
    assert read["normal.X"] == read["normal.Y"] == pytest.approx(0.5**0.5)
