import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from safetensors.numpy import load_file

from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.sample_files import write_arrays
from rna_sdk.errors import CaptureError
from rna_sdk.package import Mesh, quantise
from tests.exporters.meshes import merged, moved, sphere
from tests.exporters.synthetic import BALL_PART, LIGHTS_A_SHARD, RAYS, make_dataset, manifest_of


@pytest.fixture
def dataset(tmp_path):
    return make_dataset(tmp_path / "ball.rays").dataset


def test_reads_back_what_was_written(dataset):
    again = Dataset(dataset.folder)
    assert again.manifest == dataset.manifest
    assert np.array_equal(again.only.geometry().positions, sphere(3).positions)
    assert np.array_equal(again.only.geometry().triangles, sphere(3).triangles)
    assert again.only.geometry().uvs is None


def test_unfinished_shards_and_views_are_left_out(dataset):
    whole = dataset.only.training_samples()
    assert len(whole["visible"]) == 3 * LIGHTS_A_SHARD * RAYS
    dataset.train_path(1).unlink()
    dataset.validation_path(0, 1).unlink()
    part = dataset.only.training_samples()
    finished = np.r_[
        0 : LIGHTS_A_SHARD * RAYS, 2 * LIGHTS_A_SHARD * RAYS : 3 * LIGHTS_A_SHARD * RAYS
    ]
    assert np.array_equal(part["wi"], whole["wi"][finished])
    assert [view.index for view in dataset.only.validation_views()] == [1]


def test_a_view_is_the_mean_of_its_halves_as_an_image(dataset):
    view = dataset.only.validation_views()[0]
    assert np.allclose(view.samples["radiance"], view.halves.mean(axis=0))
    image = view.image(view.samples["radiance"])
    assert image.shape == (24, 24, 3)
    assert np.array_equal(image.reshape(-1, 3)[view.pixel], view.samples["radiance"])
    assert not image[0, 0].any()


@pytest.mark.parametrize("part", ["train", "validation"])
def test_nothing_finished_is_an_error(dataset, part):
    for path in (dataset.folder / part).iterdir():
        path.unlink()
    with pytest.raises(CaptureError, match="no finished"):
        dataset.only.training_samples() if part == "train" else dataset.only.validation_views()


def test_a_folder_without_a_manifest_is_no_dataset(tmp_path):
    with pytest.raises(CaptureError, match=r"manifest\.json"):
        Dataset(tmp_path)


@pytest.mark.parametrize(
    "change", [{"surprise": 1}, {"settings": {"samples": 0}}, {"blender": None}], ids=str
)
def test_a_manifest_that_says_something_else_is_refused(dataset, change):
    path = dataset.folder / "manifest.json"
    path.write_text(json.dumps(json.loads(path.read_text()) | change))
    with pytest.raises(CaptureError, match=next(iter(change))):
        Dataset(dataset.folder)


def _cut(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:-8])


def _without_a_field(path: Path) -> None:
    write_arrays(path, {k: v for k, v in load_file(path).items() if k != "asset/wi"})


def _of_other_lengths(path: Path) -> None:
    arrays = load_file(path)
    write_arrays(path, {**arrays, "asset/wo": arrays["asset/wo"][:-1]})


def _empty(path: Path) -> None:
    path.write_bytes(b"")


@pytest.mark.parametrize("damage", [_cut, _without_a_field, _of_other_lengths, _empty])
def test_a_damaged_file_is_named(dataset, damage):
    damage(dataset.train_path(1))
    damage(dataset.validation_path(0, 1))
    with pytest.raises(CaptureError, match=r"00001\.safetensors: damaged .*delete it"):
        dataset.only.training_samples()
    with pytest.raises(CaptureError, match=r"00-1\.safetensors: damaged .*delete it"):
        dataset.only.validation_views()


def _more(scale: float) -> Callable[[np.ndarray], np.ndarray]:
    return lambda values: (values.astype(np.float64) * scale).astype(values.dtype)


@pytest.mark.parametrize(
    ("folder", "name", "change"),
    [
        ("train", "asset/wo", lambda v: v[:, :2]),
        ("train", "asset/radiance", lambda v: v[:, 0]),
        ("train", "asset/visible", lambda v: np.stack([v, v], axis=1)),
        ("train", "asset/position", _more(1e20)),
        ("train", "asset/position", _more(3.0)),
        ("train", "asset/radiance", _more(1e30)),
        ("train", "asset/normal", _more(1e17)),
        ("train", "asset/wo", _more(1.1)),
        ("train", "asset/wi", _more(1e17)),
        ("validation", "asset/pixel", lambda v: v + 24 * 24),
        ("validation", "asset/pixel", lambda v: v - 1000),
        ("validation", "asset/pixel", lambda v: v.astype(np.float32)),
        ("validation", "asset/weight", _more(1e30)),
        ("validation", "asset/weight", lambda v: v[:, None] * np.ones(3)),
        ("geometry", "triangles", lambda v: v + np.uint32(100_000)),
        ("geometry", "positions", _more(1e20)),
        ("geometry", "normals", _more(0.0)),
        ("geometry", "normals", _more(1e17)),
        ("geometry", "normals", _more(float("nan"))),
    ],
)
def test_arrays_of_strangers_are_refused_in_one_line(dataset, folder, name, change):
    for path in (dataset.folder / folder).iterdir():
        arrays = load_file(path)
        if name in arrays:
            write_arrays(path, {**arrays, name: change(arrays[name])})
    read = {
        "train": dataset.only.training_samples,
        "validation": dataset.only.validation_views,
        "geometry": dataset.only.geometry,
    }[folder]
    if name == "asset/weight":
        read = dataset.only.white_view
    with pytest.raises(CaptureError, match=r"\.safetensors: damaged \(") as refused:
        read()
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    "bounds",
    [
        [[-1e300, -1, -1], [1, 1, 1]],
        [[1, 1, 1], [1, 1, 1]],
        [[1, -1, -1], [-1, 1, 1]],
        [[float("nan"), -1, -1], [1, 1, 1]],
        [[1e9, 0, 0], [1e9 + 1, 1, 1]],
    ],
)
def test_bounds_that_are_no_box_are_refused(dataset, bounds):
    path = dataset.folder / "manifest.json"
    manifest = json.loads(path.read_text())
    manifest["parts"][0]["bounds"] = bounds
    path.write_text(json.dumps(manifest))
    with pytest.raises(CaptureError, match=r"manifest\.json: parts\.0: .*found bounds") as refused:
        Dataset(dataset.folder)
    assert "\n" not in str(refused.value)


def test_halves_of_other_pixels_are_refused(dataset):
    path = dataset.validation_path(0, 1)
    rows = load_file(path).items()
    write_arrays(path, {name: values[len(values) // 4 :] for name, values in rows})
    with pytest.raises(CaptureError, match=r"00-1\.safetensors: damaged .*first half"):
        dataset.only.validation_views()


def test_damaged_geometry_is_named(dataset):
    _cut(dataset.folder / "geometry" / "asset.safetensors")
    with pytest.raises(CaptureError, match=r"asset\.safetensors: damaged"):
        dataset.only.geometry()


def test_rays_meet_the_mesh_as_it_was_before_its_package_rounds_it(tmp_path):
    exact = moved(sphere(3, radius=1e-3), (1.0, 2.0, 3.0))
    wide = merged(exact, moved(sphere(1), (50.0, 0.0, 0.0)))
    low, high = wide.box()
    part = BALL_PART.model_copy(update={"bounds": (tuple(low.tolist()), tuple(high.tolist()))})
    manifest = manifest_of(CaptureSettings(), parts=(part,))
    dataset = Dataset.create(
        tmp_path / "exact.rays", manifest, {"asset": quantise(wide)}, exact={"asset": wide}
    )
    met = dataset.only.met_by_rays()
    assert isinstance(met, Mesh) and met.quantised is None
    for name in ("positions", "normals", "triangles"):
        assert np.array_equal(getattr(met, name), getattr(wide, name))
    rounded = dataset.only.geometry()
    assert isinstance(rounded, Mesh) and rounded.quantised is not None
    hits = scene_of(dataset).shade_points(np.float32([[1, 2.1, 3]]), np.float32([[0, -1, 0]]))
    assert hits.position[0, 1] == pytest.approx(2.001, abs=2e-6)
    assert np.abs(rounded.positions - wide.positions).max() > 2e-4


def test_a_dataset_without_rounding_has_one_mesh(tmp_path):
    part = make_dataset(tmp_path / "ball.rays")
    assert np.array_equal(part.met_by_rays().positions, part.geometry().positions)
