"""What a task writes, with a teacher of our own in Blender's place."""

from pathlib import Path

import numpy as np
import pytest
from safetensors.numpy import load_file

from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.blender_process.exchanged_files import RenderedRays
from rna_export.capture.capture_run import say_dropped
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.capture_tasks import TrainingShard, ValidationHalf, all_tasks
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.rays.capture_directions import BEHIND, light_direction
from rna_sdk.errors import CaptureError
from rna_sdk.package import Mesh
from tests.exporters.meshes import ring, sphere
from tests.exporters.synthetic import manifest_of


class Teacher:
    """Answers rays with their direction as radiance; `spoil` changes the answer."""

    def __init__(self, spoil=lambda radiance, alpha: None):
        self.spoil, self.seeds, self.lit_by = spoil, [], []

    def render_rays(self, origins, directions, wi, samples, seed, reach=None, normals=False):
        self.seeds.append(seed)
        self.lit_by.append(wi)
        radiance, alpha = np.abs(directions) + np.float32(0.1), np.ones(len(origins), np.float32)
        self.spoil(radiance, alpha)
        return RenderedRays(radiance, alpha, origins, None)


def make(folder: Path, mesh: Mesh, cutouts: bool = False, **settings: object) -> DatasetPart:
    few = {"rays": 200, "lights": 5, "lights_per_shard": 2, **settings}
    manifest = manifest_of(CaptureSettings(**few), opaque_cutouts=cutouts)
    return Dataset.create(folder, manifest, {"asset": mesh}).only


def run_all(dataset: DatasetPart, teacher: Teacher) -> None:
    scene = scene_of(dataset.dataset)
    for task in all_tasks(dataset.dataset):
        task.run(dataset.dataset, scene, teacher)


def test_samples_are_what_the_teacher_said_of_the_ray(tmp_path):
    dataset = make(tmp_path, sphere(4))
    run_all(dataset, Teacher())
    at = dataset.training_samples()
    assert len(at["wo"]) == 5 * 200
    assert np.allclose(at["radiance"], np.abs(at["wo"]) + 0.1, atol=1e-6)
    assert np.allclose(np.linalg.norm(at["position"], axis=1), 1.0, atol=0.01)
    facing = np.sum(at["normal"] * at["wi"], axis=1)
    assert np.array_equal(
        at["visible"][np.abs(facing) > 0.05] > 0, facing[np.abs(facing) > 0.05] > 0
    )


def test_rays_take_turns_at_the_poses_of_which_rest_points_are_recorded(tmp_path):
    """In the second of two poses the ball is turned, and larger."""

    class Posed(Teacher):
        frame = None

        def show_frame(self, frame: int) -> None:
            self.frame = frame

        def render_rays(self, origins, directions, *arguments, **options):
            wanted = {1: 1.0, 9: 2.0}[self.frame]
            assert np.linalg.norm(origins, axis=1).max() > wanted
            self.seeds.append(self.frame)
            radiance = np.full_like(directions, wanted)
            return RenderedRays(radiance, np.ones(len(origins), np.float32), origins, None)

    mesh = sphere(4)
    plain = make(tmp_path, mesh, validation_resolution=32).dataset
    manifest = plain.manifest.model_copy(update={"poses": (1, 9)})
    poses = {9: {"asset": 2.0 * mesh.positions[:, [1, 2, 0]]}}
    part = Dataset.create(tmp_path, manifest, {"asset": mesh}, poses=poses).only
    teacher = Posed()
    run_all(part, teacher)
    assert teacher.seeds[-5:] == [1, 9, 1, 9, 1]  # of the lights; those of a shard by pose
    at = part.training_samples()
    assert np.allclose(np.linalg.norm(at["position"], axis=1), 1.0, atol=0.01)
    facing = np.sum(at["normal"] * at["wi"], axis=1)
    clear = np.abs(facing) > 0.05
    assert np.array_equal(at["visible"][clear] > 0, facing[clear] > 0)
    assert np.sum(at["normal"] * at["wo"], axis=1).min() > -0.01
    wi = {p: np.unique(at["wi"][at["radiance"][:, 0] == p], axis=0) for p in (1.0, 2.0)}
    light = [light_direction(k, manifest.settings.seed, "sphere") for k in range(5)]
    np.testing.assert_array_equal(np.unique(light[::2], axis=0), wi[1.0])
    turned = np.stack(light[1::2])[:, [2, 0, 1]]
    for row in wi[2.0]:
        assert np.abs(turned - row).max(axis=1).min() < 0.02
    shown = [view.samples["radiance"][0, 0] for view in part.validation_views()]
    assert shown[:8] == [1, 2, 1, 2, 2, 1, 2, 1]


def test_a_plan_is_every_light_once(tmp_path):
    dataset = make(tmp_path, sphere(2))
    run_all(dataset, Teacher())
    sizes = [len(load_file(dataset.dataset.train_path(k))["asset/wi"]) for k in range(3)]
    assert sizes == [400, 400, 200]
    assert len(np.unique(dataset.training_samples()["wi"], axis=0)) == 5


def drop(share: int):
    """A teacher that meets nothing along every so many rays."""

    def spoil(radiance, alpha):
        alpha[::share] = 0.0

    return spoil


@pytest.mark.parametrize(("share", "said"), [(2, 1), (1000, 0)])
def test_dropped_rays_are_counted_and_said(tmp_path, share, said):
    dataset = make(tmp_path, sphere(4))
    run_all(dataset, Teacher(drop(share)))
    lines: list[str] = []
    say_dropped(dataset.dataset, lines.append)
    assert len(lines) == said
    if said:
        assert lines[0].startswith("note: 500 of 1,000 view rays (50.0%) made no sample")


def test_a_capture_without_any_sample_is_an_error(tmp_path):
    dataset = make(tmp_path, sphere(4))
    say_dropped(dataset.dataset, print)  # nothing captured yet
    for task in all_tasks(dataset.dataset):
        if isinstance(task, TrainingShard):
            task.run(dataset.dataset, scene_of(dataset.dataset), Teacher(drop(1)))
    with pytest.raises(CaptureError, match="none of 1,000 view rays made a sample"):
        say_dropped(dataset.dataset, print)


@pytest.mark.parametrize(("cutouts", "count"), [(False, 100), (True, 200)])
def test_see_through_hits_are_kept_for_cutouts_only(tmp_path, cutouts, count):
    def spoil(radiance, alpha):
        alpha[::2] = 0.4

    dataset = make(tmp_path, sphere(3), cutouts, lights=1)
    TrainingShard(0).run(dataset.dataset, scene_of(dataset.dataset), Teacher(spoil))
    assert len(dataset.training_samples()["wo"]) == count


def test_radiance_that_is_not_finite_is_dropped(tmp_path):
    def spoil(radiance, alpha):
        radiance[:3, 1] = np.nan, np.inf, -np.inf

    dataset = make(tmp_path, sphere(3), lights=1)
    TrainingShard(0).run(dataset.dataset, scene_of(dataset.dataset), Teacher(spoil))
    assert len(dataset.training_samples()["wo"]) == 197


def test_the_seed_decides_rays_lights_and_noise(tmp_path):
    first, again, other = (
        make(tmp_path / name, sphere(3), seed=seed) for name, seed in (("a", 1), ("b", 1), ("c", 2))
    )
    seeds = []
    for dataset in (first, again, other):
        teacher = Teacher()
        run_all(dataset, teacher)
        seeds.append(teacher.seeds)
    assert seeds[0] == seeds[1] != seeds[2]
    a, b, c = (dataset.training_samples() for dataset in (first, again, other))
    assert all(np.array_equal(a[name], b[name]) for name in a)
    assert not np.array_equal(a["wi"], c["wi"]) and not np.array_equal(a["wo"], c["wo"])


def test_no_two_renders_of_a_capture_share_their_noise(tmp_path):
    teacher = Teacher()
    run_all(make(tmp_path, sphere(3)), teacher)
    assert len(set(teacher.seeds)) == len(teacher.seeds) == 5 + 2 * 128 + 1


def test_two_of_sixteen_views_are_close_ups_and_six_are_lit_from_behind(tmp_path):
    dataset = make(tmp_path, sphere(4), validation_views=32)
    run_all(dataset, Teacher())
    views = dataset.validation_views()
    covered = np.array([len(view.pixel) / view.resolution**2 for view in views])
    assert list(np.flatnonzero(covered == 1.0)) == [3, 15, 19, 31]
    assert all(0.5 < share < 0.85 for share in covered[covered < 1.0])
    eyes = [view.samples["wo"].mean(axis=0) for view in views]
    cosine = [e @ v.samples["wi"][0] / np.linalg.norm(e) for e, v in zip(eyes, views, strict=True)]
    behind = np.array(cosine) <= BEHIND
    assert list(np.flatnonzero(behind)) == [k for k in range(32) if k % 8 in (1, 3, 6)]


def test_hemisphere_looks_and_is_lit_from_above(tmp_path):
    dataset = make(tmp_path, ring(), domain="hemisphere", validation_resolution=32)
    run_all(dataset, Teacher())
    rows = [dataset.training_samples(), *(view.samples for view in dataset.validation_views())]
    for at in rows:
        assert at["wi"][:, 1].min() >= 0.0
    assert dataset.training_samples()["wo"][:, 1].min() >= 0.0


def test_every_view_sees_something(tmp_path):
    """Also of a ring, whose middle is empty."""
    dataset = make(tmp_path, ring(), validation_views=24, validation_resolution=32)
    scene, teacher = scene_of(dataset.dataset), Teacher()
    for view in range(24):
        for half in (0, 1):
            ValidationHalf(view, half).run(dataset.dataset, scene, teacher)
    assert all(len(view.pixel) > 10 for view in dataset.validation_views())
