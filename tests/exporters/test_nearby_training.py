"""Nearby light is traced from captured rows, kept, learnt linearly, and exported."""

import itertools

import numpy as np
import pytest
import torch

from rna_export.capture.dataset import nearby_rows
from rna_export.capture.dataset.nearby_rows import (
    TRAINING_RAYS,
    nearby_folder,
    usual_lengths,
    with_nearby_light,
)
from rna_export.capture.preflight.verdicts import MaterialVerdict
from rna_export.export.decoder import decoders_of
from rna_export.export.package_build import build_package
from rna_export.training import nearby_choice
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.model import neural_asset
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.optimization.samples import SampleTable
from rna_export.training.presets import PRESETS
from rna_export.training.report import Curves
from rna_export.training.training_run import Run, train
from rna_export.training.validation import answer, shade
from rna_sdk.errors import TrainingError
from rna_sdk.package import Mesh, Package, validate
from rna_sdk.runtime import load
from rna_trace import PartsScene, nearby_light
from tests.exporters.synthetic import make_dataset, printed_points, tiny
from tests.runtime.points import unit_vectors

LENGTHS = (0.01, 0.02, 0.06)
BOUNDS = torch.tensor([[-1.1] * 3, [1.1] * 3])
PACKAGEABLE = {
    "small": ("surface", {}),
    "print": ("surface", {"uses_base_color": True}),
    "one decoder": ("surface", {"shadow_width": 0}),
    "strands": ("fiber", {}),
}


def ground_under_tiles() -> Mesh:
    """A square, and small ones above it at random places: shadows finer than 16 texels show."""
    rng = np.random.default_rng(0)
    centres = np.concatenate([[[0, 0, 0]], rng.uniform(-0.9, 0.9, (150, 3))]).astype(np.float32)
    centres[1:, 1] = 0.05
    half = np.concatenate([[1.0], rng.uniform(0.02, 0.06, 150)]).astype(np.float32)
    corner = np.float32([[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]])
    positions = (centres[:, None] + half[:, None, None] * corner).reshape(-1, 3)
    normals = np.tile(np.float32([0, 1, 0]), (len(positions), 1))
    faces = np.uint32([[0, 2, 1], [0, 3, 2]])[None] + 4 * np.arange(len(centres))[:, None, None]
    return Mesh(positions, normals, None, faces.reshape(-1, 3).astype(np.uint32))


def glowing_rows(count: int) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """Points of the ground whose light is linear in nearby light, and the exact one."""
    rng = np.random.default_rng(1)
    mesh = ground_under_tiles()
    x = (rng.uniform(-0.9, 0.9, (count, 3)) * np.float32([1, 0, 1])).astype(np.float32)
    wi, wo = unit_vectors(rng, count), unit_vectors(rng, count)
    wi[:, 1], wo[:, 1] = np.abs(wi[:, 1]) + 0.5, np.abs(wo[:, 1])
    wi /= np.linalg.norm(wi, axis=1, keepdims=True)
    scene = PartsScene([mesh])
    s = nearby_light(scene, LENGTHS, x, wi, 128, seed=9)
    free = ~scene.occluded(x + np.float32([0, 1e-4, 0]), wi)
    light = (0.02 + 0.6 * s[:, 1:2] + 0.3 * s[:, 2:]) * np.float32([1.0, 0.5, 0.2])
    up = np.tile(np.float32([0, 1, 0]), (count, 1))
    rows = {"position": x, "normal": up, "wo": wo, "wi": wi, "radiance": light.astype(np.float32)}
    rough = nearby_light(scene, LENGTHS, x, wi, TRAINING_RAYS, seed=0)
    return {**rows, "visible": free.astype(np.uint8), "nearby": rough}, s


def error(rows: dict[str, np.ndarray], exact: np.ndarray, lengths: tuple[float, ...]) -> float:
    """Error of a short training, queried with exact nearby light."""
    preset = tiny(loss="unbiased").with_model(nearby=lengths)
    kept = {k: v for k, v in rows.items() if lengths or k != "nearby"}
    table = SampleTable(kept)
    torch.manual_seed(0)
    unit = table.usual_radiance, table.fields
    fitting = Fitting(preset, BOUNDS, 1.5 * table.largest_radiance, *unit, lit=table.lit)
    for step, batch in enumerate(itertools.islice(table, 300)):
        fitting.step(batch, step / 300)
    visible, shadowed = answer(fitting.model.eval(), {**kept, "nearby": exact})
    ours = np.where(rows["visible"][:, None] > 0, visible, shadowed)
    return float(np.square(ours - rows["radiance"]).mean())


def test_light_beside_shadows_is_learnt():
    rows, exact = glowing_rows(8000)
    assert error(rows, exact, LENGTHS) < 0.2 * error(rows, exact, ())


def test_outputs_below_0_are_those_of_packages_and_return():
    y = torch.tensor([-2.0, -2.0, 2.0, 2.0], requires_grad=True)
    cut = neural_asset._cut_off(y)
    assert cut.tolist() == [0.0, 0.0, 2.0, 2.0]
    cut.backward(torch.tensor([-1.0, 1.0, -1.0, 1.0]))
    assert y.grad is not None and y.grad.tolist() == pytest.approx([-0.01, 0.0, -1.0, 1.0])


@pytest.mark.parametrize("name", PACKAGEABLE)
@torch.no_grad()
def test_decoders_give_what_the_model_does(name):
    kind, fields = PACKAGEABLE[name]
    torch.manual_seed(0)
    model = NeuralAsset(tiny(kind=kind).with_model(nearby=LENGTHS, **fields).model, BOUNDS)
    model.triplane.planes.data.normal_()
    at = printed_points(500, kind) | {"nearby": torch.rand(500, 3)}
    outputs = []
    for decoder in decoders_of(model):
        y = decoder.decoder(decoder.queries(at)).unflatten(1, (-1, 3))
        own, *of_nearby = decoder.transport(y).chunk(4, dim=1)
        total = own + sum(
            s[:, None, None] * b for s, b in zip(at["nearby"].T, of_nearby, strict=True)
        )
        if model.config.uses_base_color:
            rest, factor = total.chunk(2, dim=1)
            total = rest + at["base_color"][:, None] * factor
        outputs.append(total)
    expected = model.transport(model(at))
    assert expected.std() > 0.01
    torch.testing.assert_close(torch.cat(outputs, dim=1), expected, rtol=1e-4, atol=1e-5)


def test_rows_are_traced_once(tmp_path, monkeypatch):
    part = make_dataset(tmp_path / "ball.rays", shards=1, views=1)
    samples, lengths = part.training_samples(), usual_lengths(part)
    assert lengths == pytest.approx(
        [2 * 3**0.5 * share for share in (0.005, 0.015, 0.045)], rel=2e-3
    )
    monkeypatch.setattr(nearby_rows, "_BLOCK", 1000)
    first = with_nearby_light(samples, part, lengths)
    files = sorted((tmp_path / "ball.rays" / "nearby").iterdir())
    assert len(files) == 3
    files[0].unlink()  # as of a stopped training
    files[1].write_bytes(b"damaged")
    traced: list[int] = []
    trace = nearby_rows.nearby_light
    monkeypatch.setattr(
        nearby_rows, "nearby_light", lambda *a: traced.append(len(a[2])) or trace(*a)
    )
    again = with_nearby_light(samples, part, lengths)
    assert len(traced) == 2 and np.array_equal(first["nearby"], again["nearby"])


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    folder = tmp_path_factory.mktemp("nearby")
    part = make_dataset(folder / "ball.rays")
    preset = tiny("small", steps=60).with_model(nearby=usual_lengths(part))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Curves, "draw", lambda _: None)
        best = train(Run(part, preset, "small", folder / "run"))
    package = folder / "ball.rna"
    models = [load_checkpoint(best)]
    build_package(models, part.dataset, package, "a ball", "CC0-1.0", print, is_measured=False)
    return part, best, package


def test_the_runtime_answers_what_pytorch_answers(exported):
    part, best, package = exported
    assert validate(package) == []
    asset, trained = load(package), load_checkpoint(best)
    assert asset.nearby_lengths == usual_lengths(part)
    for view in (*part.validation_views(), part.white_view()):
        expected, found = shade(trained.model, view), view.shaded_by(asset)
        assert found == pytest.approx(expected, rel=1e-2, abs=2e-3)


def test_means_stand_in_for_what_a_host_does_not_trace(
    exported,
):
    part, _, package = exported
    samples = part.training_samples()
    mean = with_nearby_light(samples, part, usual_lengths(part))["nearby"]
    with Package.open(package) as opened:
        record = opened.manifest.tiers[0].parts[0].nearby
    assert record is not None
    lit = samples["visible"] > 0
    assert record.visible == pytest.approx(mean[lit].mean(axis=0), rel=0.01)
    assert record.shadowed == pytest.approx(mean[~lit].mean(axis=0), rel=0.01, abs=1e-4)
    asset, rows = load(package), [samples[k][:64] for k in ("position", "normal", "wo", "wi")]
    means = [np.tile(np.float32(m), (64, 1)) for m in (record.visible, record.shadowed)]
    for k, found in enumerate(asset.evaluate(*rows)):
        assert np.array_equal(found, asset.evaluate(*rows, nearby=means[k])[k])
    assert np.array_equal(
        asset.evaluate(*rows, nearby=np.full((64, 3), np.nan, np.float32))[0], np.zeros((64, 3))
    )


def test_presets_without_it_are_told_as_before():
    assert "nearby" not in PRESETS["surface"]["small"].model_dump()["model"]


@pytest.mark.parametrize(("with_it", "counted"), [(0.097, True), (0.099, False), (0.12, False)])
def test_an_asset_that_gains_too_little_does_not_get_it(with_it, counted, tmp_path, monkeypatch):
    part = make_dataset(tmp_path / "ball.rays", shards=1, views=1)
    run, said = Run(part, tiny(steps=20), "small", tmp_path / "run"), []
    trials: list[Run] = []

    def flip(trial: Run, samples: dict[str, np.ndarray]) -> float:
        trials.append(trial)
        return with_it if trial.preset.model.nearby else 0.1

    monkeypatch.setattr(nearby_choice, "_flip", flip)
    for _ in range(2):  # the second time by what is kept
        chosen = nearby_choice.with_nearby(run, "auto", part.training_samples(), say=said.append)
        assert chosen.preset.model.nearby == (usual_lengths(part) if counted else ())
        assert chosen == run or counted
    assert len(trials) == 2 and "0.1000 without" in said[1]
    assert nearby_choice.with_nearby(run, "off", part.training_samples()) == run
    assert nearby_choice.with_nearby(
        run, "on", part.training_samples()
    ).preset.model.nearby == usual_lengths(part)
    (nearby_folder(part) / "verdict.json").write_text("[]")
    with pytest.raises(
        TrainingError, match=r"verdict\.json: not a verdict of rna-train; delete it"
    ):
        nearby_choice.with_nearby(run, "auto", part.training_samples())


def test_an_opaque_asset_is_told_by_its_materials(tmp_path):
    part = make_dataset(tmp_path / "ball.rays", shards=1, views=1)
    opaque = MaterialVerdict(name="steel", is_="metal", learnt="well", scatters=False)
    part.dataset.manifest = part.manifest.model_copy(update={"materials": (opaque,)})
    run, said = Run(part, tiny(), "small", tmp_path / "run"), []
    assert nearby_choice.with_nearby(run, "auto", part.training_samples(), say=said.append) == run
    assert said == ["nearby light: not counted, light enters no material"]


def test_presets_of_the_paper_do_not_get_it(tmp_path):
    part = make_dataset(tmp_path / "ball.rays", shards=1, views=1)
    run = Run(part, PRESETS["surface"]["paper-small"], "paper-small", tmp_path / "run")
    assert nearby_choice.with_nearby(run, "auto", part.training_samples()) == run


def test_short_trainings_leave_nothing_but_their_verdict(tmp_path, monkeypatch):
    part = make_dataset(tmp_path / "ball.rays", shards=1, views=1)
    monkeypatch.setattr(Curves, "draw", lambda _: None)
    run = Run(part, tiny(steps=20), "small", tmp_path / "run")
    nearby_choice.with_nearby(run, "auto", part.training_samples(), say=lambda _: None)
    assert not run.out.exists() and (nearby_folder(part) / "verdict.json").is_file()


def test_several_poses_do_not_get_it(tmp_path):
    part = make_dataset(tmp_path / "ball.rays", shards=1, views=1)
    manifest = part.manifest.model_copy(update={"poses": (1, 2)})
    part.dataset.manifest = manifest
    run, said = Run(part, tiny(), "small", tmp_path / "run"), []
    assert (
        nearby_choice.with_nearby(run, "auto", part.training_samples(), say=said.append) == run
        and "several poses" in said[0]
    )
    with pytest.raises(TrainingError, match="expected a capture of one pose"):
        nearby_choice.with_nearby(run, "on", part.training_samples())
