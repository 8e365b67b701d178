"""What a capture of fibers records: points on strands, and direct light apart from the rest."""

import numpy as np
import pytest

from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.capture_run import CaptureWorkers, begin, finish
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.dataset.dataset_manifest import SAMPLE_FIELDS
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.view_rays import sample_view_rays
from rna_sdk.package import Curves
from tests.exporters.scenes import fur, write_scene
from tests.render.strands import curls

WI = np.float32([0.36, 0.8, 0.48])
CURLS = curls(60)
FUR = fur(400, bend=0.3, root=0.03, tip=0.01, melanin=0.2)


def distance_to_axis(curves: Curves, points: np.ndarray, segment: np.ndarray) -> np.ndarray:
    first = curves.segments()[segment]
    root, tip = curves.points[first].astype(float), curves.points[first + 1].astype(float)
    axis = tip - root
    along = np.sum((points - root) * axis, axis=1) / np.sum(axis**2, axis=1)
    return np.linalg.norm(points - root - np.clip(along, 0, 1)[:, None] * axis, axis=1)


@pytest.fixture(scope="module")
def scene():
    return AssetScene([CURLS])


def test_every_view_ray_hits_a_strand(scene):
    rays = sample_view_rays(scene, WI, 2000, "sphere", np.random.default_rng(0))
    assert len(rays) == 2000
    points = scene.shade_points(rays.origins, rays.directions)
    assert points.hit.all()
    segment = points.on[0].points.segment
    apart = distance_to_axis(CURLS, points.position, segment)
    radius = CURLS.radii[CURLS.segments()[segment]]
    assert np.all(apart < radius * 1.01) and np.all(apart > 0.3 * radius)


def test_h_is_the_offset_of_the_ray_from_the_axis(scene):
    """A ray that passes the axis at a distance of h radii, on the side of t x wo."""
    straight = Curves(
        np.float32([[0, -1, 0], [0, 1, 0]]), np.float32([0.1, 0.1]), np.uint32([0, 2])
    )
    x = np.linspace(-0.099, 0.099, 23, dtype=np.float32)
    origins = np.stack([x, np.zeros_like(x), np.full_like(x, 2)], axis=1)
    points = AssetScene([straight]).shade_points(origins, np.tile(np.float32([0, 0, -1]), (23, 1)))
    at = points.on[0].fields
    assert np.allclose(at["tangent"], [0, 1, 0])
    assert np.allclose(at["h"], x / 0.1, atol=1e-4)  # t x wo is +x


def test_sampled_points_lie_on_strands_by_area(scene):
    points, normals = scene.sample_points(4000, np.random.default_rng(0))
    assert np.allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-5)
    curves, first = CURLS, CURLS.segments()
    near = np.array(
        [distance_to_axis(curves, np.tile(p, (len(first), 1)), np.arange(len(first))).min()
         for p in points[:50]]
    )  # fmt: skip
    assert near.max() <= curves.radii.max() * 1.001


def test_highlight_views_lie_about_the_cone_of_mirrored_light(scene):
    rays = sample_view_rays(scene, WI, 1500, "sphere", np.random.default_rng(1))
    points = scene.shade_points(rays.origins, rays.directions)
    rows, wo = scene.highlight_views(points, WI, np.random.default_rng(2))
    total = np.sum(points.on[0].points.tangent[rows] * (wo + WI), axis=1)
    assert np.median(np.abs(total)) < 0.12
    assert np.std(np.arctan2(wo[:, 1], wo[:, 0])) > 1.0  # all azimuths


@pytest.mark.blender
def test_direct_light_has_no_noise_and_is_there_where_we_see_the_light(
    open_worker,
):
    worker = open_worker(FUR)
    ours = AssetScene([worker.export_curves()])
    rays = sample_view_rays(ours, WI, 4096, "sphere", np.random.default_rng(0))
    points = ours.shade_points(rays.origins, rays.directions)
    visible = ours.visible(points, np.tile(WI, (len(rays), 1)))
    first, again = (worker.render_rays(rays.origins, rays.directions, WI, 1, k) for k in (1, 2))
    assert np.mean(np.any(first.direct != again.direct, axis=1)) < 0.002
    assert np.mean(visible == (first.direct > 0.0).any(axis=1)) > 0.998
    assert np.all(first.radiance >= first.direct - 1e-6)
    scattered = [(r.radiance - r.direct).mean() for r in (first, again)]
    assert min(scattered) > 0.1 * first.direct.mean()
    assert scattered[0] == pytest.approx(scattered[1], rel=0.2)


@pytest.mark.blender
def test_a_dataset_of_fibers(tmp_path, blender_python):
    source = Source(write_scene(tmp_path, "fur", FUR))
    settings = {"lights": 3, "rays": 300, "validation_views": 1, "validation_resolution": 24}
    workers = CaptureWorkers(blender_python, tmp_path / "scratch", 1)
    said: list[str] = []
    dataset = begin(source, settings, tmp_path / "fur.rays", workers, None, said.append)
    assert any("\ngain: " in line and "a path of Cycles takes" in line for line in said)
    finish(dataset, source, workers)
    dataset = dataset.only
    usual = CaptureSettings.usual("fiber")
    assert dataset.kind == "fiber"
    assert dataset.manifest.settings.samples == usual.samples != CaptureSettings().samples
    assert len(dataset.geometry().offsets) == 401
    samples = dataset.training_samples()
    assert list(samples) == list(SAMPLE_FIELDS["fiber"])
    assert len(samples["h"]) == pytest.approx(900, abs=3)
    assert np.all(samples["direct"] <= samples["radiance"] + 1e-6)
    low, high = np.array(dataset.bounds)
    assert np.all(samples["position"] >= low - 1e-5) and np.all(samples["position"] <= high + 1e-5)
    view = dataset.validation_views()[0]
    assert list(view.queries) == ["position", "tangent", "h", "wo", "wi"]
