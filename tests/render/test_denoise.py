"""Intel Open Image Denoise, if it is installed, and the message if it is not."""

import sys

import numpy as np
import pytest

from rna_render.command.rna_run import main
from rna_render.image.denoise import Denoiser, blended
from rna_render.image.images import read_exr
from rna_sdk.errors import SceneError
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package

SCENE = """\
assets: [{path: ball.rna}]
camera: {position: [0, 0, 5], look_at: [0, 0, 0], vertical_fov_deg: 30}
lights: [{type: environment, radiance: [1, 2, 3], visible_to_camera: false}]
resolution: [64, 48]
samples: 4
"""


@pytest.fixture
def scene(tmp_path):
    write_lambert_package(tmp_path / "ball.rna", sphere(4))
    (tmp_path / "scene.yaml").write_text(SCENE)
    return tmp_path / "scene.yaml"


def need_denoiser() -> None:
    pytest.importorskip("pyoidn", reason="Intel Open Image Denoise (pyoidn) is not installed")


def test_noise_goes_and_bright_light_stays():
    need_denoiser()
    rng = np.random.default_rng(0)
    clean = np.where(np.arange(96)[None, :, None] < 48, [4.0, 2.0, 1.0], 0.1) * np.ones((96, 1, 1))
    noisy = (clean * rng.gamma(2.0, 0.5, clean.shape)).astype(np.float32)
    before = noisy.copy()
    result = Denoiser(threads=2)(noisy)
    np.testing.assert_array_equal(noisy, before)
    assert result.dtype == np.float32 and result.shape == noisy.shape
    error = np.abs(result - clean).mean() / np.abs(noisy - clean).mean()
    assert error < 0.25
    np.testing.assert_allclose(result[:, 8:40].mean((0, 1)), [4, 2, 1], rtol=0.1)
    np.testing.assert_array_equal(Denoiser(threads=1)(noisy), result)


def test_normals_keep_edges_that_the_noise_hides():
    need_denoiser()
    rng = np.random.default_rng(0)
    stripe = np.arange(96) // 6 % 2 == 0
    clean = np.where(stripe[None, :, None], 1.0, 0.6) * np.ones((96, 1, 3))
    noisy = (clean * rng.gamma(1.0, 1.0, (96, 96, 1))).astype(np.float32)
    normal = np.where(stripe[None, :, None], [0.6, 0, 0.8], [-0.6, 0, 0.8]) * np.ones((96, 1, 1))
    denoiser = Denoiser(threads=2)
    alone, guided = (
        np.abs(denoiser(noisy, guide) - clean).mean() for guide in (None, normal.astype(np.float32))
    )
    assert guided < 0.8 * alone


def test_texture_is_kept_and_noise_is_not():
    """Both next to each other; the filter is a mean over 9 pixels."""
    rng = np.random.default_rng(0)
    clean = np.ones((64, 128, 3), np.float32)
    clean[:, :64] += 0.3 * rng.choice([-1.0, 1.0], (64, 64, 1))
    deviation = np.where(np.arange(128) < 64, 0.02, 0.3)[None, :, None].astype(np.float32)
    noisy = clean + deviation * rng.standard_normal(clean.shape).astype(np.float32)
    filtered = np.stack([np.roll(noisy, k, axis=1) for k in range(-4, 5)]).mean(axis=0)
    result = blended(noisy, filtered, deviation**2 * np.ones_like(clean))
    error = {name: np.square(image - clean) for name, image in [("raw", noisy), ("it", result)]}
    assert error["it"][:, 8:56].mean() < 1.1 * error["raw"][:, 8:56].mean()
    assert error["it"][:, 72:120].mean() < 0.25 * error["raw"][:, 72:120].mean()


def test_rare_bright_noise_is_no_texture():
    """Few samples have a widely scattered variance from two halves; the filter is right."""
    halves = np.random.default_rng(0).gamma(0.2, 5.0, (2, 96, 96, 3))
    noisy = halves.mean(axis=0).astype(np.float32)
    variance = np.square(halves[0] - halves[1]) / 4
    clean = np.ones_like(noisy)
    error = np.square(blended(noisy, clean, variance) - clean).mean()
    assert error < 0.03 * np.square(noisy - clean).mean()


def test_a_speck_is_taken_out_where_all_about_it_is_clean():
    filtered = np.full((64, 64, 3), 0.5, np.float32)
    image, variance = filtered.copy(), np.full((64, 64, 3), 1e-6)
    image[40, 20], variance[40, 20] = 2.0, 2.0
    assert abs(blended(image, filtered, variance)[40, 20] - 0.5).max() < 0.05


def test_an_image_without_noise_is_not_changed():
    rng = np.random.default_rng(0)
    image = rng.random((32, 48, 3)).astype(np.float32)
    result = blended(image, np.full_like(image, 0.5), np.zeros_like(image))
    np.testing.assert_array_equal(result, image)


def test_black_and_very_bright_images_stay_finite():
    for value in (0.0, 3e38):
        image = np.full((16, 16, 3), value, np.float32)
        np.testing.assert_array_equal(blended(image, image, np.full_like(image, 3e38)), image)


def test_the_exr_keeps_the_noise_and_has_the_denoised_colour_beside_it(scene, tmp_path):
    need_denoiser()
    for name, more in (("plain", []), ("denoised", ["--denoise"])):
        files = ["--out", str(tmp_path / f"{name}.exr"), "--png", str(tmp_path / f"{name}.png")]
        assert main([str(scene), *files, *more]) == 0
    plain, plain_header = read_exr(tmp_path / "plain.exr")
    both, header = read_exr(tmp_path / "denoised.exr")
    assert set(both) - set(plain) == {"denoised.R", "denoised.G", "denoised.B"}
    for name, plane in plain.items():
        np.testing.assert_array_equal(both[name], plane, err_msg=name)
    assert not np.array_equal(both["denoised.R"], both["R"])
    assert header["rnaDenoised"].startswith("Intel Open Image Denoise 2.")
    assert "rnaDenoised" not in plain_header
    assert (tmp_path / "plain.png").read_bytes() != (tmp_path / "denoised.png").read_bytes()


def test_without_it_one_line_says_how_to_get_it_before_anything_is_rendered(
    scene, tmp_path, capsys, monkeypatch
):
    monkeypatch.setitem(sys.modules, "pyoidn", None)
    assert main([str(scene), "--out", str(tmp_path / "out.exr"), "--denoise"]) == 1
    error = capsys.readouterr().err
    assert error.startswith("error: ") and error.count("\n") == 1
    assert "pip install pyoidn" in error
    assert not (tmp_path / "out.exr").exists()


def test_a_library_that_does_not_load_is_an_error(monkeypatch):
    class Broken:
        def Device(self):
            raise OSError("no such library")

    monkeypatch.setitem(sys.modules, "pyoidn", Broken())
    with pytest.raises(SceneError, match="cannot be loaded: no such library"):
        Denoiser(threads=1)
