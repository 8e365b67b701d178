"""Light returned from a white world: its samples, the figure, and where it is said."""

import numpy as np
import pytest

from rna_export.albedo import albedo, white_views
from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_tasks import WhiteRays
from rna_export.capture.dataset.sample_files import write_parts
from rna_export.capture.dataset.validation_view import WhiteView
from rna_export.capture.rays.light_samples import LIGHTS, fiber_lights, surface_lights
from rna_export.export.package_build import build_package
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.training_run import Run, train
from rna_export.training.training_summary import closing_lines
from rna_sdk.package import Package
from rna_sdk.package.command.package_info import info_lines, package_info
from tests.exporters.meshes import sphere
from tests.exporters.synthetic import hurried_packages, make_dataset, tiny, transport, white_samples
from tests.exporters.test_tasks import Teacher, make

NARROW = 0.02**2  # alpha of the smoothest material


def test_a_model_that_returns_a_third_is_reported_as_such(tmp_path):
    view = make_dataset(tmp_path).white_view()
    assert view is not None
    at = view.samples
    right, _ = transport(at["normal"], at["wo"], at["wi"])
    whole, third = albedo([(right, view)]), albedo([(right / 3.0, view)])
    assert whole is not None and third is not None
    assert whole.ratio == pytest.approx(1.0, abs=0.02)
    for name in ("ratio", "facing", "at60", "at80"):
        assert getattr(third, name) == pytest.approx(getattr(whole, name) / 3.0, rel=1e-5)


def test_light_that_is_missing_at_grazing_views_is_found_there():
    view = _view({})
    right, _ = transport(*(view.samples[name] for name in ("normal", "wo", "wi")))
    facing = view.cosine > np.cos(np.radians(70.0))
    found = albedo([(right * facing[:, None], view)])
    assert found is not None and found.at80 == 0.0
    assert found.facing == pytest.approx(1.0, abs=0.05)
    assert found.ratio < 0.97


def test_nothing_is_said_of_black_assets_and_of_bands_without_light():
    black = _view({"radiance": np.zeros_like(white_samples()["radiance"])})
    assert albedo([(black.reference, black)]) is None
    dark = white_samples()["radiance"].copy()
    dark[_view({}).cosine < np.cos(np.radians(70.0))] = 0.0
    view = _view({"radiance": dark})
    found = albedo([(view.reference, view)])
    assert found is not None and found.at80 is None and found.at60 is not None


def _view(changes: dict[str, np.ndarray]) -> WhiteView:
    samples = {**white_samples(), **changes}
    rows = np.arange(len(samples["wi"]), dtype=np.int32)
    return WhiteView(0, len(rows), rows, samples, samples["radiance"][None])


@pytest.mark.parametrize("angle_deg", [0.0, 60.0, 80.0])
@pytest.mark.parametrize("alpha", [NARROW, 0.01, 0.1])
def test_the_directions_integrate_lobes_of_any_width(angle_deg, alpha):
    """GGX's D cos(n, h) / (4 cos(wo, h)) integrates to 1 over all mirrors wi of wo."""
    count, rng = 500, np.random.default_rng(3)
    n = np.tile(np.float32([0, 0, 1]), (count, 1))
    a = np.radians(angle_deg)
    wo = np.tile(np.float32([np.sin(a), 0, np.cos(a)]), (count, 1))
    lobe, ones = np.zeros(count), np.zeros(count)
    for wi, pdf in surface_lights(n, wo, NARROW, rng):
        h = wi.astype(np.float64) + wo
        h *= np.sign(h[:, 2:]) / np.linalg.norm(h, axis=1, keepdims=True)
        sine2 = h[:, 0] ** 2 + h[:, 1] ** 2
        d = alpha**2 / (np.pi * (h[:, 2] ** 2 * alpha**2 + sine2) ** 2)
        lobe += d * h[:, 2] / (4.0 * np.abs(np.sum(h * wo, axis=1))) / pdf / LIGHTS
        ones += 1.0 / pdf / LIGHTS
    assert lobe.mean() == pytest.approx(1.0, abs=0.02)
    assert lobe.std() < 0.3  # of a ray: thousands of them are known within a percent
    assert ones.mean() == pytest.approx(4.0 * np.pi, rel=0.02)


def test_directions_of_strands_cover_the_sphere():
    tangent = np.tile(np.float32([1, 0, 0]), (500, 1))
    wo = np.tile(np.float32([0.6, 0.0, 0.8]), (500, 1))
    lights = fiber_lights(tangent, wo, np.random.default_rng(3))
    covered = np.mean([np.mean(1.0 / pdf) for _, pdf in lights])
    assert covered == pytest.approx(4.0 * np.pi, rel=0.02)


def test_rays_in_a_white_world_are_captured_from_the_domain_alone(tmp_path):
    part = make(tmp_path, sphere(4), domain="hemisphere")
    teacher = Teacher()
    WhiteRays().run(part.dataset, scene_of(part.dataset), teacher)
    view = part.white_view()
    assert view is not None
    at = view.samples
    assert at["wo"][:, 1].min() >= 0.0
    assert np.array_equal(at["weight"] > 0.0, at["wi"][:, 1] >= 0.0)
    assert teacher.lit_by[-1].region == "hemisphere"
    half = albedo([(np.where(at["wi"][:, 1:2] < 0.0, 9.0, 0.5 * view.reference), view)])
    assert half is not None and half.ratio == pytest.approx(np.pi, rel=0.03)


@pytest.fixture(scope="module")
def trained(tmp_path_factory):
    """A dataset, and a checkpoint of a short training."""
    folder = tmp_path_factory.mktemp("albedo")
    part = make_dataset(folder / "ball.rays")
    return part, train(Run(part, tiny(loss="log"), "small", folder / "run"), say=lambda _: None)


def test_packages_record_it_and_commands_say_it(trained, tmp_path):
    part, best = trained
    tripled = {**white_samples(), "radiance": 3.0 * white_samples()["radiance"]}
    found = {}
    for name, samples in {"right": white_samples(), "tripled": tripled}.items():
        write_parts(part.dataset.white_path, {"asset": samples})
        path = tmp_path / f"{name}.rna"
        with hurried_packages():
            build_package([load_checkpoint(best)], part.dataset, path, None, "CC0-1.0", _quiet)
        with Package.open(path) as package:
            validation = package.manifest.tiers[0].validation
        assert validation is not None and validation.albedo is not None
        found[name] = validation.albedo
        said = f"reflects {validation.albedo.ratio:.0%} of the light that Cycles' asset does"
        assert any(said in line for line in info_lines(package_info(path)))
        assert any(said in line for line in closing_lines(best, part))
        assert "albedo: luminance" in validation.definition
    assert found["tripled"].ratio == pytest.approx(found["right"].ratio / 3.0, rel=1e-3)


def test_a_dataset_without_a_white_world_has_no_albedo(trained, tmp_path):
    part, best = trained
    part.dataset.white_path.unlink()
    assert white_views(part.dataset.parts) is None
    path = tmp_path / "old.rna"
    with hurried_packages():
        build_package([load_checkpoint(best)], part.dataset, path, None, "CC0-1.0", _quiet)
    with Package.open(path) as package:
        validation = package.manifest.tiers[0].validation
    assert validation is not None and validation.albedo is None
    assert not any("reflects" in line for line in closing_lines(best, part))


def _quiet(_: str) -> None:
    """Says nothing."""
