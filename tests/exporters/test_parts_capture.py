"""A ball with strands on it: rays, samples and images of both parts together."""

import numpy as np
import pytest

from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.capture_run import CaptureWorkers, begin, finish
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.rays.asset_scene import AssetScene, part_counts
from rna_export.capture.rays.view_rays import _Draw, outside_rays, sample_view_rays
from rna_sdk.errors import CaptureError
from tests.exporters.meshes import moved, sphere
from tests.exporters.scenes import fur, write_scene
from tests.exporters.two_parts import make, spikes

WI = np.float32([0.36, 0.8, 0.48])


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    both = {"surface": sphere(4), "hair": spikes(60)}
    return make(tmp_path_factory.mktemp("two") / "two.rays", both)


def test_each_part_has_the_samples_of_its_own_hits(dataset):
    skin, hair = (part.training_samples() for part in dataset.parts)
    assert len(skin["wo"]) + len(hair["wo"]) == 4 * 300
    assert list(skin) == ["position", "normal", "wo", "wi", "radiance", "visible"]
    assert list(hair)[1:3] == ["tangent", "h"] and "direct" in hair
    assert np.allclose(np.linalg.norm(skin["position"], axis=1), 1.0, atol=0.01)
    assert np.linalg.norm(hair["position"], axis=1).max() < 1.52
    for at in (skin, hair):
        assert np.allclose(at["radiance"], np.abs(at["wo"]) + 0.1, atol=1e-6)


def test_a_part_is_shadowed_by_the_others(dataset):
    """Strands that stand behind the ball see no light; alone, straight ones block next to none."""
    hair = dataset.part("hair").training_samples()
    away = np.sum(hair["position"] * hair["wi"], axis=1)
    aside = hair["position"] - away[:, None] * hair["wi"]
    behind = (away < 0.0) & (np.linalg.norm(aside, axis=1) < 0.98)
    assert behind.sum() > 50 and not hair["visible"][behind].any()
    assert hair["visible"][away > 0.1].mean() > 0.9


def test_a_whole_view_is_its_parts(dataset):
    for whole in dataset.whole_views():
        image = whole.image(whole.reference)
        assert np.allclose(image, sum(part.image(part.reference) for part in whole.parts))
        pixels = np.concatenate([part.pixel for part in whole.parts])
        assert len(np.unique(pixels)) == len(pixels) == len(whole.reference)
        assert whole.halves.shape == (2, len(pixels), 3)


def test_parts_are_named(dataset):
    assert [part.name for part in dataset.parts] == ["surface", "hair"]
    with pytest.raises(CaptureError, match="found no part 'beard', expected one of surface, hair"):
        dataset.part("beard")
    with pytest.raises(CaptureError, match="found parts surface, hair; expected an asset of one"):
        _ = dataset.only


def test_a_part_in_none_of_the_images_is_named(tmp_path):
    inside = {"shell": sphere(3), "core": sphere(2, radius=0.1)}
    dataset = make(tmp_path / "inside.rays", inside)
    assert len(dataset.part("shell").validation_views()) == 2
    with pytest.raises(CaptureError, match=r"shows part core.*: hide it from renders or"):
        dataset.part("core").validation_views()


@pytest.mark.parametrize("domain", ["sphere", "hemisphere"])
def test_a_thin_part_gets_its_share_of_rays(domain):
    """Three spikes of a thousandth of the ball's width: chords alone would hit them 0.1%."""
    scene = AssetScene([sphere(4), spikes(3, radius=0.001)])
    rays = sample_view_rays(scene, WI, 2000, domain, np.random.default_rng(0))
    part = scene.part_hit(rays.origins, rays.directions)
    assert len(rays) == 2000
    assert np.mean(part == 1) == pytest.approx(0.25, abs=0.02)
    assert (part >= 0).all()


def test_a_part_that_no_camera_outside_sees_leaves_those_rays_to_the_others():
    scene = AssetScene([sphere(3), sphere(2, radius=0.1)])
    rays = sample_view_rays(scene, WI, 1000, "sphere", np.random.default_rng(0))
    assert len(rays) == 1000
    inside = scene.part_hit(rays.origins, rays.directions) == 1
    assert inside.mean() < 0.1 and np.linalg.norm(rays.origins[inside], axis=1).max() < 1.0


def test_aimed_rays_are_spread_as_the_chords_that_meet_the_part():
    """Beside a ball that hides some of it, and at grazing views."""
    scene = AssetScene([sphere(4), moved(sphere(4), (1.5, 0, 0))])
    rng = np.random.default_rng(0)
    spread = []
    for rays in (
        outside_rays(scene, 200_000, "sphere", rng),
        _Draw(scene, "sphere", rng).seen(200_000, np.array([1.0, 0.0])),
    ):
        points = scene.shade_points(rays.origins, rays.directions).on[0]
        wo = -rays.directions[points.rows]
        cosine = np.sum(points.fields["normal"] * wo, axis=1)
        bins = points.fields["position"][:, 0], cosine, wo[:, 0]
        counts, _ = np.histogramdd(np.stack(bins, axis=1), 4, [(-1, 1), (0, 1), (-1, 1)])
        assert counts.sum() > 20_000
        spread.append(counts / counts.sum())
    assert np.abs(spread[0] - spread[1]).max() < 0.003


def test_counts_add_up():
    assert part_counts(10, np.array([0.25, 0.25, 0.5])).tolist() == [2, 3, 5]
    assert part_counts(7, np.full(16, 1 / 16)).sum() == 7


@pytest.mark.blender
def test_cycles_agrees_where_light_reaches_hair_beside_a_ball(tmp_path, blender_python):
    body = "add(*BALL, diffuse((0.8, 0.4, 0.2)), smooth=True, matrix=HALF)\n"
    half = "HALF = [[0.6, 0, 0, 0], [0, 0.6, 0, 0], [0, 0, 0.6, 0], [0, 0, 0, 1]]\n"
    hair = fur(400, bend=0.2, root=0.012, tip=0.006, melanin=0.3)
    source = Source(write_scene(tmp_path, "furry", half + body + hair))
    settings = {"lights": 3, "rays": 2000, "validation_views": 1, "validation_resolution": 24}
    workers = CaptureWorkers(blender_python, tmp_path / "scratch", 1)
    dataset = begin(source, settings, tmp_path / "furry.rays", workers, None, lambda _: None)
    finish(dataset, source, workers)
    assert dataset.manifest.settings.samples == CaptureSettings.usual("both").samples
    skin, hair_samples = (part.training_samples() for part in dataset.parts)
    assert len(skin["wo"]) + len(hair_samples["wo"]) == pytest.approx(6000, abs=20)
    lit = (hair_samples["direct"] > 0.0).any(axis=1)
    assert np.mean(lit == (hair_samples["visible"] > 0)) > 0.998
    # One bounce on a diffuse ball: dark where something blocks the light, however it faces.
    facing = np.sum(skin["normal"] * skin["wi"], axis=1) > 0.2
    seen = skin["visible"] > 0
    bright, dark = (skin["radiance"][facing & rows].mean() for rows in (seen, ~seen))
    assert dark < 0.25 * bright
