"""Views in NRHints' layout: what is read, and one line for what cannot be."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from rna_bench.peers.scoring import HeldOut, reduced
from rna_bench.peers.sphere.lambert_sphere import ALBEDO, CENTRE, RADIUS, sphere_views
from rna_bench.peers.views_plan import INTENSITY, ViewsPlan
from rna_bench.peers.views_reader import read_views, splits_of
from rna_render import write_exr
from rna_sdk.errors import SceneError

PLAN = ViewsPlan(3, 2, 1, 4, 1, 1)
Change = Callable[[dict[str, Any], Path], object]


def write_folder(folder: Path) -> dict[str, Any]:
    """A folder of three EXR views of 4 x 4 pixels; its JSON."""
    meta = {"camera_angle_x": 0.5, "light_intensity": INTENSITY, "frames": PLAN.frames("train")}
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


def test_cameras_and_lights_stand_where_they_should() -> None:
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


def test_a_folder_is_read_as_it_was_written(tmp_path: Path) -> None:
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


def test_pictures_of_others_are_decoded(tmp_path: Path) -> None:
    meta = write_folder(tmp_path)
    for frame in meta["frames"]:
        del frame["file_ext"]
        pixels = np.full((4, 4, 4), (188, 0, 255, 128), np.uint8)
        Image.fromarray(pixels).save(tmp_path / (frame["file_path"] + ".png"))
        (tmp_path / (frame["file_path"] + "_depth.exr")).unlink()
    (tmp_path / "transforms_train.json").write_text(json.dumps(meta))
    views = read_views(tmp_path, "train", limit=2)
    assert len(views) == 2 and views.depth is None
    np.testing.assert_allclose(
        views.rgba[0, 0, 0], np.array([0.5029, 0.0, 1.0, 1.0]) * (128 / 255), atol=1e-3
    )


def without_light(meta: dict[str, Any], _: Path) -> None:
    del meta["frames"][1]["pl_pos"]


def larger_image(_: dict[str, Any], folder: Path) -> None:
    write_exr(folder / "train/r_0002.exr", dict.fromkeys("RGBA", np.ones((5, 6), np.float32)), {})


def nan_image(_: dict[str, Any], folder: Path) -> None:
    channels = dict.fromkeys("RGBA", np.ones((4, 4), np.float32))
    channels["G"] = channels["G"].copy()
    channels["G"][2, 3] = np.nan
    write_exr(folder / "train/r_0001.exr", channels, {})


BROKEN: dict[str, tuple[Change, str]] = {
    "no light": (without_light, "train/r_0001: has no pl_pos, the place of its light"),
    "sizes": (larger_image, r"r_0002\.exr: found 6 x 5 pixels, the first image has 4 x 4"),
    "NaN": (nan_image, r"r_0001\.exr: found NaN or infinity at row 2, column 3"),
    "no image": (
        lambda meta, folder: (folder / "train/r_0000.exr").unlink(),
        r"train/r_0000\.exr: cannot read the image",
    ),
    "matrix": (
        lambda meta, _: meta["frames"][0]["transform_matrix"].pop(),
        r"transform_matrix: found \[\[.*expected 4 x 4 numbers",
    ),
    "no rotation": (
        lambda meta, _: meta["frames"][0].update(transform_matrix=np.diag([2, 1, 1, 1]).tolist()),
        "transform_matrix: expected a rotation and a translation",
    ),
    "angle": (
        lambda meta, _: meta.pop("camera_angle_x"),
        "camera_angle_x: found None, expected 0 to pi radians",
    ),
    "no frames": (lambda meta, _: meta.update(frames=[]), "found no frames"),
}


@pytest.mark.parametrize("case", BROKEN)
def test_what_is_wrong_is_one_line(case: str, tmp_path: Path) -> None:
    change, says = BROKEN[case]
    meta = write_folder(tmp_path)
    change(meta, tmp_path)
    (tmp_path / "transforms_train.json").write_text(json.dumps(meta))
    with pytest.raises(SceneError, match=says) as raised:
        read_views(tmp_path, "train")
    assert "\n" not in str(raised.value)


def test_a_folder_without_views_is_one_line(tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=r"transforms_val\.json: cannot read it: No such file"):
        read_views(tmp_path, "val")
    (tmp_path / "transforms_val.json").write_text("[")
    with pytest.raises(SceneError, match="not JSON"):
        read_views(tmp_path, "val")


def test_the_sphere_is_lamberts() -> None:
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


def test_scores_are_of_the_asset_and_of_all_pixels() -> None:
    views = sphere_views(2, 16)
    held = HeldOut(reduced(views, 8), 1.0)
    assert held.views.rgba.shape == (2, 8, 8, 4)
    images = [image[..., :3] + 0.1 for image in held.views.rgba]
    found = held.score(images)
    assert [found.psnr, found.psnr_everywhere] == pytest.approx([20.0, 20.0], abs=0.01)
    assert len(found.each) == 2 and 0.0 < found.flip < 1.0
    with pytest.raises(SceneError, match="--size 7: expected one that divides 16 x 16"):
        reduced(views, 7)
