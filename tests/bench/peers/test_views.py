"""Views in NRHints' layout: read folders, and one line for broken ones."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rna_bench.peers.scoring import HeldOut, reduced
from rna_bench.peers.sphere.lambert_sphere import ALBEDO, CENTRE, RADIUS, sphere_views
from rna_bench.peers.views_plan import INTENSITY, ViewsPlan
from rna_bench.peers.views_reader import read_views, splits_of
from rna_render import write_exr
from rna_sdk.errors import SceneError

PLAN = ViewsPlan(3, 2, 1, 4, 1, 1)


def write_folder(folder: Path) -> dict[str, Any]:
    """A folder of three EXR views of 4 x 4 pixels; its JSON."""
    meta = {"camera_angle_x": 0.5, "light_intensity": INTENSITY, "frames": PLAN.frames("train")}
    meta |= {"sphere_centre": [0.0, 0.5, 0.0], "sphere_radius": 2.0}
    (folder / "train").mkdir()
    rng = np.random.default_rng(0)
    for frame in meta["frames"]:
        image = rng.random((4, 4, 4), np.float32)
        channels = {c: np.ascontiguousarray(image[..., k]) for k, c in enumerate("RGBA")}
        write_exr(folder / (frame["file_path"] + ".exr"), channels, {})
        depth = {"Z": np.full((4, 4), 4.0, np.float32)}
        write_exr(folder / (frame["file_path"] + "_depth.exr"), depth, {})
    (folder / "transforms_train.json").write_text(json.dumps(meta))
    return meta


def test_cameras_and_lights_stand_where_they_should():
    frames = PLAN.frames("train")
    assert frames == ViewsPlan(9, 2, 1, 4, 1, 1).frames("train")[:3]
    assert frames[0] != PLAN.frames("val")[0]
    for frame in frames:
        to_world, light = np.array(frame["transform_matrix"]), np.array(frame["pl_pos"])
        eye = to_world[:3, 3]
        assert 4.0 <= np.linalg.norm(eye) <= 5.0 and 4.0 <= np.linalg.norm(light) <= 5.0
        np.testing.assert_allclose(to_world[:3, 2] * np.linalg.norm(eye), eye)
        np.testing.assert_allclose(to_world[:3, :3] @ to_world[:3, :3].T, np.eye(3), atol=1e-12)
        assert np.linalg.det(to_world[:3, :3]) > 0.0 and to_world[1, 1] > 0.0
    for frame in PLAN.frames("train_collocated"):
        np.testing.assert_allclose(np.array(frame["transform_matrix"])[:3, 3], frame["pl_pos"])


def test_a_folder_is_read_as_it_was_written(tmp_path):
    meta = write_folder(tmp_path)
    views = read_views(tmp_path, "train")
    assert splits_of(tmp_path) == ["train"] and views.size == (4, 4) and len(views) == 3
    assert views.fov_x == 0.5 and views.intensity == INTENSITY
    np.testing.assert_allclose(views.lights[1], meta["frames"][1]["pl_pos"])
    assert views.depth is not None and (views.depth == 4.0).all()
    batch = views.batch(np.array([16, 47]))
    assert (batch.colour == views.rgba.reshape(-1, 4)[[16, 47], :3]).all()
    np.testing.assert_allclose(batch.lights, views.lights[[1, 2]], rtol=1e-6)
    np.testing.assert_allclose(batch.origins, views.to_world[[1, 2], :3, 3], rtol=1e-6)


def test_an_image_that_is_missing_is_one_line(tmp_path):
    write_folder(tmp_path)
    (tmp_path / "train/r_0000.exr").unlink()
    with pytest.raises(SceneError, match=r"train/r_0000\.exr: cannot read the image"):
        read_views(tmp_path, "train")


def test_a_folder_without_views_is_one_line(tmp_path):
    with pytest.raises(SceneError, match=r"transforms_val\.json: cannot read it: No such file"):
        read_views(tmp_path, "val")
    (tmp_path / "transforms_val.json").write_text("[")
    with pytest.raises(SceneError, match="not as `rna-bench peers-data` writes it"):
        read_views(tmp_path, "val")


def test_the_sphere_is_lamberts():
    views = sphere_views(4, 32)
    assert views.depth is not None
    k = int(np.argmax(views.rgba[..., 0]))
    batch = views.batch(np.array([k]))
    depth = views.depth.reshape(-1)[k]
    point = batch.origins[0] + depth * batch.directions[0]
    assert np.linalg.norm(point - CENTRE) == pytest.approx(RADIUS, abs=1e-5)
    way = batch.lights[0] - point
    cosine = (point - CENTRE) @ way / RADIUS / np.linalg.norm(way)
    expected = ALBEDO / np.pi * INTENSITY * cosine / (way @ way)
    np.testing.assert_allclose(batch.colour[0], expected, rtol=0.02)
    assert views.rgba[..., :3].max() < 1.0


def test_scores_are_of_the_asset_and_of_all_pixels():
    views = sphere_views(2, 16)
    held = HeldOut(reduced(views, 8), 1.0)
    assert held.views.rgba.shape == (2, 8, 8, 4)
    images = [image[..., :3] + 0.1 for image in held.views.rgba]
    actual = held.score(images)
    assert [actual.psnr, actual.psnr_everywhere] == pytest.approx([20.0, 20.0], abs=0.01)
    assert len(actual.each) == 2 and 0.0 < actual.flip < 1.0
    with pytest.raises(SceneError, match="--size 7: expected one that divides 16 x 16"):
        reduced(views, 7)
