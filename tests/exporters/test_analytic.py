"""Analytic materials: against the renderer's own, in closed form, and fitted to samples."""

import math
from dataclasses import replace

import numpy as np
import pytest
import torch
import torch.nn.functional as F

from rna_export.export.rna_export import main as export_main
from rna_export.export.standin_textures import textures_of
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.model.analytic import (
    COAT_F0,
    GltfMaterial,
    gltf_material,
    gltf_radiance,
)
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.optimization.losses import sample_loss
from rna_export.training.optimization.samples import SampleTable
from rna_export.training.presets import ANALYTIC, PRESETS
from rna_export.training.report import Curves
from rna_export.training.rna_train import main as train_main
from rna_render.materials import Scattering
from rna_sdk.errors import ExportError
from tests.exporters.synthetic import make_dataset

BOUNDS = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])
STEPS = 250
UP = torch.tensor([[0.0, 0.0, 1.0]])


def of_unit_length(*shape: int, seed: int = 0) -> torch.Tensor:
    generator = torch.Generator().manual_seed(seed)
    return F.normalize(torch.randn(*shape, 3, generator=generator), dim=-1)


def plain(base, roughness: float, metallic: float, k: int = 1) -> GltfMaterial:
    columns = [
        torch.tensor([value]).float().reshape(1, -1) for value in (base, roughness, metallic)
    ]
    return GltfMaterial(*(c.expand(k, -1) for c in columns), torch.zeros(k, 3))


def test_gltf_is_the_renderers_own_material():
    k = 20_000
    n, wo, wi = of_unit_length(3, k)
    wo = torch.where((n * wo).sum(1, keepdim=True) < 0.05, F.normalize(n + 0.5 * wo, dim=1), wo)
    outputs = 2.0 * torch.randn(k, 8, generator=torch.Generator().manual_seed(1))
    outputs[:, 5:] *= 0.05
    material = gltf_material(outputs)
    actual = gltf_radiance(material, n, wo, wi)
    arrays = [x.squeeze(1).numpy() for x in (material.roughness**2, material.metallic)]
    reference = Scattering(
        material.base_color.numpy(), *arrays, np.full(k, COAT_F0, np.float32), np.zeros((k, 3))
    )
    normal = material.normal(n)
    seen = ((normal * wo).sum(1) > 1e-2).numpy() & ((n * wo).sum(1) > 0).numpy()
    seen &= ((n * wi).sum(1) > 0).numpy() | ((normal * wi).sum(1) < 0).numpy()
    expected = reference.evaluate(*(x.numpy() for x in (normal, n, wo, wi)))
    assert seen.mean() > 0.95 and (expected[seen] > 0).mean() > 0.4
    np.testing.assert_allclose(actual.numpy()[seen], expected[seen], rtol=5e-3, atol=1e-5)
    other_side = gltf_radiance(material._replace(tilt=-material.tilt), -n, wo, wi)
    np.testing.assert_allclose(other_side, actual, rtol=1e-5, atol=1e-7)


@pytest.mark.parametrize("cos_o", [0.2, 0.9])
def test_white_reflects_all_light(cos_o):
    side = 400
    z = (torch.arange(side) + 0.5) / side
    phi = 2.0 * math.pi * (torch.arange(side) + 0.5) / side
    z, phi = (x.reshape(-1, 1) for x in torch.meshgrid(z, phi, indexing="ij"))
    wi = torch.cat(
        [torch.sqrt(1 - z**2) * torch.cos(phi), torch.sqrt(1 - z**2) * torch.sin(phi), z], 1
    )
    wo = torch.tensor([[math.sqrt(1 - cos_o**2), 0.0, cos_o]]).expand_as(wi)
    values = gltf_radiance(plain((1, 1, 1), 0.5, 0, len(wi)), UP.expand_as(wi), wo, wi)
    assert float(values.mean()) * 2.0 * math.pi == pytest.approx(1.0, abs=0.01)


def known_samples(k: int) -> tuple[GltfMaterial, dict[str, torch.Tensor]]:
    position = torch.rand(k, 3, generator=torch.Generator().manual_seed(2)) * 2 - 1
    left = position[:, :1] < 0
    base = torch.where(left, torch.tensor([[0.7, 0.3, 0.1]]), torch.tensor([[0.9, 0.6, 0.3]]))
    roughness, metallic = torch.where(left, 0.6, 0.4), torch.where(left, 0.0, 1.0)
    material = GltfMaterial(base, roughness, metallic, torch.zeros(k, 3))
    wo, wi = of_unit_length(2, k, seed=3)
    n = F.normalize(UP + 0.3 * of_unit_length(k, seed=4), dim=1)
    wo, wi = (torch.where(w[:, 2:] < 0, -w, w) for w in (wo, wi))
    mirrored = 2.0 * (n * wo).sum(1, keepdim=True) * n - wo
    near = torch.arange(k)[:, None] % 2 == 0  # half of the lights near the highlight, as captured
    wi = torch.where(near, F.normalize(mirrored + 0.5 * wi, dim=1), wi)
    at = {"position": position, "normal": n, "wo": wo, "wi": wi}
    at["radiance"] = gltf_radiance(material, n, wo, wi)
    return material, {**at, "visible": ((n * wi).sum(1) > 0).float()}


def test_a_known_material_is_found_again():
    material, at = known_samples(40_000)
    preset = ANALYTIC.with_model(resolution=16, width=32)
    preset = preset.with_training(loss="log", unbiased_share=0.0, learning_rate=1e-2)
    table = SampleTable({name: values.numpy() for name, values in at.items()}, batch=2048)
    torch.manual_seed(0)
    fitting = Fitting(preset, BOUNDS, 100.0, table.usual_radiance, table.fields)
    for k, rows in zip(range(STEPS), table, strict=False):
        fitting.step(rows, k / STEPS)
    with torch.no_grad():
        model = fitting.model
        actual = gltf_material(model.decoder(model.queries(at)))
    inside = at["position"][:, 0].abs() > 0.15
    for name, tolerance in (("base_color", 0.04), ("roughness", 0.04), ("metallic", 0.1)):
        error = (getattr(actual, name) - getattr(material, name))[inside].abs().mean()
        assert float(error) < tolerance, name
    straight = (actual.normal(at["normal"]) * at["normal"]).sum(1)[inside]
    assert float(torch.rad2deg(torch.arccos(straight.clamp(max=1.0))).mean()) < 1.0


def test_shadowed_light_is_black_and_teaches_nothing():
    _, at = known_samples(64)
    at = {**at, "visible": torch.zeros(64)}
    model = NeuralAsset(ANALYTIC.with_model(resolution=16).model, BOUNDS)
    radiance = model.transport(model(at))
    assert (radiance[:, 0] > 0).any() and (radiance[:, 1] == 0).all()
    sample_loss(model, at, 1.0).backward()
    assert all((p.grad == 0).all() for p in model.decoder.parameters())


def test_a_training_says_its_score_and_no_package_takes_it(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(Curves, "draw", lambda _: None)
    dataset, runs, package = make_dataset(tmp_path / "ball.rays"), tmp_path / "run", "ball.rna"
    options = ["--preset", "analytic", "--steps", "10", "--out", str(runs)]
    assert train_main([str(dataset.folder), *options]) == 0
    printed = capsys.readouterr().out
    assert "analytic: FLIP" in printed and "10 of 20,000 steps" in printed
    assert "next:" not in printed
    trained = load_checkpoint(runs / "best.ckpt")
    actual, lines = textures_of([trained], dataset.dataset)
    assert actual == [None]
    assert lines == ["asset: a stand-in without textures: the mesh has no texture coordinates"]
    with pytest.raises(ExportError, match="--standin: found a checkpoint of analytic, expected"):
        textures_of([replace(trained, preset=PRESETS["surface"]["small"])], dataset.dataset)
    assert export_main([str(runs), "--out", str(tmp_path / package)]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert "the analytic checkpoint of asset is a model to compare with" in line
    assert not (tmp_path / package).exists()
