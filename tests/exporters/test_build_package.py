"""From checkpoints to a package: two tiers, measured through the runtime, valid."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
import torch

from rna_export.asset_flip import ImageFlip, asset_flip, luminance_level, scene_exposures
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.export.package_build import build_package
from rna_export.export.rna_export import main
from rna_export.metrics import psnr
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.report import Curves
from rna_export.training.training_run import Run, train
from rna_export.training.validation import score, shade
from rna_sdk.package import Package, validate
from rna_sdk.runtime import load
from tests.exporters.synthetic import make_dataset, tiny


@dataclass(frozen=True)
class Exported:
    dataset: DatasetPart
    checkpoints: dict[str, Path]
    package: Path
    said: str


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    folder = tmp_path_factory.mktemp("export")
    dataset = make_dataset(folder / "ball.rays", domain="hemisphere")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Curves, "draw", lambda _: None)
        checkpoints = {
            name: train(Run(dataset, tiny(name, steps=60), name, folder / name))
            for name in ("small", "paper-small")
        }
    package = folder / "ball.rna"
    arguments = [*map(str, checkpoints.values()), "--out", str(package), "--license", "CC0-1.0"]
    with pytest.MonkeyPatch.context() as patch:
        said: list[str] = []
        patch.setattr("builtins.print", lambda *a, **_: said.append(" ".join(map(str, a))))
        assert main([*arguments, "--source", "a ball"]) == 0
    return Exported(dataset, checkpoints, package, "\n".join(said))


def evaluate(package: Path, tier: str, dataset: DatasetPart) -> list[np.ndarray]:
    """Radiance of the validation views, as a host would ask for it."""
    asset, radiance = load(package, tier=tier), []
    for view in dataset.validation_views():
        rows = [view.samples[name] for name in ("position", "normal", "wo", "wi")]
        visible, shadowed = asset.evaluate(*rows)
        radiance.append(np.where(view.samples["visible"][:, None] > 0, visible, shadowed))
    return radiance


def test_the_package_is_valid(exported):
    assert validate(exported.package) == []


def test_an_asset_is_named_for_its_source_or_as_one_wishes(exported):
    """A name for people: no file is named so, whatever characters it has."""
    with Package.open(exported.package) as package:
        assert package.manifest.name == "ball" and package.manifest.provenance.source == "a ball"
    models = [load_checkpoint(exported.checkpoints["small"])]
    out, name = exported.package.with_name("named.rna"), "Bälle/Größe: 1"
    files = {path.name for path in out.parent.iterdir()}
    whole, quiet = exported.dataset.dataset, lambda _: None
    build_package(models, whole, out, None, "CC0-1.0", quiet, is_measured=False, name=name)
    assert validate(out) == [] and load(out).name == name
    with Package.open(out) as package:
        assert package.manifest.provenance.source.startswith(f"{whole.manifest.source} (sha256 ")
    assert {path.name for path in out.parent.iterdir()} - files == {out.name}


def test_a_tier_a_checkpoint_in_their_order(exported):
    with Package.open(exported.package) as package:
        assert [tier.name for tier in package.manifest.tiers] == ["small", "paper-small"]
        assert package.manifest.tiers[0].parts[0].inputs == tiny("small").model.inputs
        assert package.manifest.tiers[1].parts[0].inputs == tiny("paper-small").model.inputs


@pytest.mark.parametrize("tier", ["small", "paper-small"])
def test_the_runtime_answers_what_pytorch_answers(exported, tier):
    model = load_checkpoint(exported.checkpoints[tier]).model
    views = exported.dataset.validation_views()
    for actual, view in zip(evaluate(exported.package, tier, exported.dataset), views, strict=True):
        expected = shade(model, view)
        # Planes are float16 in the package.
        assert np.abs(actual - expected).max() < 5e-3 * max(1.0, float(expected.max()))
        assert np.abs(actual - expected).mean() < 5e-4


@pytest.mark.parametrize("tier", ["small", "paper-small"])
def test_the_recorded_error_is_what_a_host_gets(exported, tier):
    radiance = evaluate(exported.package, tier, exported.dataset)
    views = exported.dataset.validation_views()
    with Package.open(exported.package) as package:
        record = package.tier(tier)
    references = [view.samples["radiance"] for view in views]
    actual = np.mean([psnr(r, t) for r, t in zip(radiance, references, strict=True)])
    assert record.validation is not None
    assert record.validation.psnr == pytest.approx(actual, abs=1e-4)
    assert record.validation.flip == pytest.approx(score(radiance, views).flip, abs=1e-6)
    assert record.validation.images == 2
    assert "irradiance pi" in record.validation.definition


@pytest.mark.parametrize("tier", ["small", "paper-small"])
def test_the_error_of_small_images_is_recorded(exported, tier):
    radiance = evaluate(exported.package, tier, exported.dataset)
    views = exported.dataset.validation_views()
    with Package.open(exported.package) as package:
        record = package.tier(tier).validation
    whole, half = record.flip_at_height
    assert (whole.height, half.height) == (24, 12)
    assert whole.flip == record.flip
    # Every second row and column of a picture that is twice as large, block by block.
    exposures = scene_exposures([luminance_level(v.reference) for v in views])
    assert all(e.is_lit for e in exposures)
    flips = []
    for v, rows, e in zip(views, radiance, exposures, strict=True):
        images = [v.image(of) for of in (rows, np.ones_like(rows), *v.halves)]
        corners = [(0, 0), (0, 1), (1, 0), (1, 1)]
        ours, covered, *halves = (
            sum(image[y::2, x::2] / 4 for y, x in corners) for image in images
        )
        flips.append(ImageFlip.of(ours, np.stack(halves), covered[..., 0], e.factor))
    assert half.flip == pytest.approx(asset_flip(flips).mean, abs=1e-6)


def test_cost_and_agreement_are_recorded(exported):
    with Package.open(exported.package) as package:
        small, paper = package.manifest.tiers
    of_shadows = 20 * 8 + 2 * 8 * 8 + 8 * 3  # a decoder of its own
    for tier, columns, last in ((small, 28, 16 * 3 + of_shadows), (paper, 17, 16 * 6)):
        assert tier.cost.multiply_adds == columns * 16 + 16 * 16 + last
        assert tier.cost.ns_per_query > 0.0 and tier.cost.machine
        assert 0.0 <= tier.parts[0].agreement.max_relative < 1e-4


def test_where_it_came_from_is_recorded(exported):
    with Package.open(exported.package) as package:
        manifest = package.manifest
    assert (manifest.domain.wo, manifest.domain.wi) == ("hemisphere", "hemisphere")
    assert manifest.license == "CC0-1.0"
    assert manifest.provenance.source == "a ball"
    assert manifest.provenance.training["small"]["steps"] == 60
    assert manifest.provenance.capture["rays"] == exported.dataset.manifest.settings.rays
    low, high = manifest.parts[0].bounds.corners()
    assert np.all(low < -1.0) and np.all(high > 1.0)


def refusal(capsys, *arguments: object) -> str:
    assert main([str(a) for a in arguments]) == 1
    error = capsys.readouterr().err
    assert error.startswith("error: ") and error.count("\n") == 1
    return error


def test_the_same_preset_twice_is_refused(exported, tmp_path, capsys):
    one = exported.checkpoints["small"]
    assert "asset, asset; expected one of each part: asset" in refusal(
        capsys, one, one, "--out", tmp_path / "x.rna"
    )
    assert not (tmp_path / "x.rna").exists()


def test_another_assets_checkpoint_is_refused(exported, tmp_path, capsys):
    other = make_dataset(tmp_path / "other.rays", seed=9)
    error = refusal(
        capsys,
        exported.checkpoints["small"],
        "--dataset",
        other.folder,
        "--out",
        tmp_path / "x.rna",
    )
    assert "expected the dataset's" in error


def test_planes_that_float16_cannot_hold_are_refused(exported, tmp_path, capsys):
    saved = torch.load(exported.checkpoints["small"], weights_only=True)
    for name, value in saved["model"].items():
        if name.startswith("triplane.") and value.ndim == 4:
            value[0, 0, 0, 0] = 1e6
    torch.save(saved, tmp_path / "bright.ckpt")
    precision = "--precision", "float32-float16"
    refusal(capsys, tmp_path / "bright.ckpt", "--out", tmp_path / "x.rna", *precision)
    assert not (tmp_path / "x.rna").exists()
