"""int8 tiers: the decoder is its twin's, near the trained one; planes and names are right."""

from dataclasses import replace

import numpy as np
import onnx
import pytest
import torch

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.export.decoder import compare_int8_decoder, export_decoder, random_queries
from rna_export.export.int8_decoder import int8_decoder
from rna_export.export.package_build import build_package
from rna_export.export.precision import Precision, precision_word, precisions_of, stored_planes
from rna_export.export.rna_export import main
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.presets import PRESETS
from rna_export.training.report import Curves
from rna_export.training.training_run import Run, train
from rna_sdk.errors import ExportError
from rna_sdk.package import Int8Planes, Package, decoder_from_bytes, validate
from rna_sdk.package.decoder.saturation import PAIR_LIMIT, can_saturate, pair_sums
from rna_sdk.runtime import load
from rna_sdk.runtime.engine.decoder_graph import fast_graph
from rna_sdk.runtime.engine.decoder_sessions import Decoder
from tests.exporters.synthetic import hurried_packages, make_dataset, tiny
from tests.exporters.test_decoder_export import make_model, run


@pytest.mark.parametrize(
    ("kind", "preset"), [(kind, preset) for kind in PRESETS for preset in PRESETS[kind]]
)
@torch.no_grad()
def test_onnx_is_the_twin_and_near_the_trained(kind, preset):
    model = make_model(preset, kind)
    queries = random_queries(model, 5000, 7)
    layers = int8_decoder(model.decoder, queries)
    decoder = export_decoder(model, layers)
    agreement = compare_int8_decoder(decoder, model, layers, random_queries(model, 2000, 8))
    assert 0.0 < agreement.max_absolute < 12.5
    y, exact = layers(queries), model.decoder(queries)
    assert float((y - exact).square().mean()) < 1e-3 * float(exact.square().mean())


@pytest.mark.parametrize("preset", ["small", "paper-small"])
@torch.no_grad()
def test_the_runtime_runs_the_exported_integers(preset):
    model = make_model(preset)
    queries = random_queries(model, 5000, 7)
    decoder = export_decoder(model, int8_decoder(model.decoder, queries))
    runtime = Decoder(decoder_from_bytes(decoder, "decoder"))
    for inputs in (queries, 1e30 * queries, -queries):
        actual, expected = runtime.run(inputs.numpy()), run(decoder, inputs)
        close = np.isclose(actual, expected, rtol=1e-4, atol=1e-5).all(axis=1)
        assert close.mean() > 0.98
    # Those four nodes and the layers are not in what onnxruntime runs.
    fast = fast_graph(decoder_from_bytes(decoder, "decoder"), np.inf)
    assert fast is not None
    fused, entry = fast
    assert entry is not None and len(entry.gain) == queries.shape[1]
    operators = {node.op_type for node in onnx.load_from_string(fused).graph.node}
    assert not {"QuantizeLinear", "DequantizeLinear", "Gemm", "Add"} & operators


@pytest.mark.parametrize("columns", [22, 17, 24])
@torch.no_grad()
def test_a_row_does_not_depend_on_the_number_of_rows(columns):
    layers = (torch.nn.Linear(columns, 16), torch.nn.ReLU(), torch.nn.Linear(16, 6))
    model = replace(make_model(), decoder=torch.nn.Sequential(*layers))
    queries = torch.randn(2000, columns)
    exported = export_decoder(model, int8_decoder(model.decoder, queries))
    runtime = Decoder(decoder_from_bytes(exported, "decoder"))
    expected = runtime.run(queries.numpy())
    assert runtime.columns == columns and expected.std() > 0.01
    for rows in (1, 3, 16, 100):
        np.testing.assert_array_equal(
            runtime.run(queries[7 : 7 + rows].numpy()), expected[7:][:rows]
        )


@pytest.mark.parametrize(
    "change",
    [
        lambda layer: replace(layer, weight=layer.weight.flip(0)),
        lambda layer: replace(layer, bias=layer.bias + 400),
        lambda layer: replace(layer, input_scale=1.02 * layer.input_scale),
    ],
    ids=["weight", "bias", "scale"],
)
def test_another_decoder_is_refused(change):
    model = make_model()
    queries = random_queries(model, 5000, 7)
    layers = int8_decoder(model.decoder, queries)
    decoder = export_decoder(model, layers)
    others = replace(layers, layers=(*layers.layers[:-1], change(layers.layers[-1])))
    with pytest.raises(ExportError, match="differs from its PyTorch reference"):
        compare_int8_decoder(decoder, model, others, queries)


def test_output_is_finite_and_never_negative_whatever_is_asked():
    model = make_model()
    decoder = export_decoder(model, int8_decoder(model.decoder, random_queries(model, 5000, 7)))
    values = torch.tensor([0.0, -0.0, 1e30, -1e30, 3e38, -3e38, 1e-45, 65504.0])
    actual = run(decoder, values[torch.randint(8, (500, model.decoder[0].in_features))])
    assert np.isfinite(actual).all() and actual.min() >= 0.0 and actual.max() <= 12.6


def test_a_neuron_that_never_fires_and_an_input_that_never_varies_do_no_harm():
    model = make_model()
    model.decoder[0].bias.data[3] = -1e4
    queries = random_queries(model, 5000, 7)
    queries[:, 2] = 0.25
    with torch.no_grad():
        y, exact = int8_decoder(model.decoder, queries)(queries), model.decoder(queries)
    assert float((y - exact).square().mean()) < 1e-3 * float(exact.square().mean())


def test_int8_planes_are_within_half_a_step():
    planes = np.random.default_rng(0).normal(size=(3, 8, 8, 4)).astype(np.float32)
    planes[1, :, :, 2] = 0.0
    planes[2] *= 100.0
    stored = stored_planes(planes, "int8")
    assert isinstance(stored, Int8Planes)
    assert np.abs(stored.texels).max(axis=(1, 2)).tolist()[0] == [127] * 4
    assert np.all(np.abs(stored.decoded() - planes) <= 0.501 * stored.scales[:, None, None, :])
    assert not stored.decoded()[1, :, :, 2].any()


def test_names_of_tiers():
    pairs = [("float32", "int8"), ("int8", "int8"), ("int8", "float16"), ("float32", "float32")]
    names = [Precision(*pair).tier_name("hq") for pair in pairs]
    assert names == ["hq", "hq-int8", "hq-int8-float16", "hq-float32"]


@pytest.fixture(scope="module")
def checkpoint(tmp_path_factory):
    folder = tmp_path_factory.mktemp("int8")
    dataset = make_dataset(folder / "ball.rays")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Curves, "draw", lambda _: None)
        return train(Run(dataset, tiny(steps=200), "small", folder / "small"))


def test_the_command_writes_a_tier_a_precision(checkpoint, tmp_path):
    path = tmp_path / "ball.rna"
    assert main([str(checkpoint), "--precision", "float32", "int8", "--out", str(path)]) == 0
    assert validate(path) == []
    with Package.open(path) as package:
        plain, int8 = package.manifest.tiers
    assert (plain.name, int8.name) == ("small", "small-int8")
    part = int8.parts[0]
    assert (part.decoder_precision, part.plane_precision) == ("int8", "int8")
    assert int8.cost.multiply_adds == plain.cost.multiply_adds
    assert int8.validation.psnr > plain.validation.psnr - 0.5
    assert load(path, min_psnr=int8.validation.psnr - 0.01).tier.name == "small-int8"


def test_precisions_are_for_all_presets_or_for_one():
    plain, int8 = Precision(), Precision("int8")

    def of(*words: str) -> dict[str, list[Precision]]:
        return precisions_of([precision_word(word) for word in words], ["small", "hq"])

    assert of("float32", "hq=int8") == of("hq=int8") == {"small": [plain], "hq": [int8]}
    assert of("float32", "int8", "int8") == {"small": [plain, int8], "hq": [plain, int8]}


@pytest.mark.parametrize("word", ["int4", "small=int4", "=int8=", "small="])
def test_another_precision_is_bad_usage(word, capsys):
    with pytest.raises(SystemExit, match="2"):
        main(["best.ckpt", "--precision", word, "--out", "ball.rna"])
    assert f"found {word}, expected [PRESET=]float32|int8|" in capsys.readouterr().err


def test_a_precision_of_another_preset_is_refused(checkpoint, tmp_path, capsys):
    path = tmp_path / "ball.rna"
    assert main([str(checkpoint), "--precision", "tiny=int8", "--out", str(path)]) == 1
    assert "found preset 'tiny', expected one of small" in capsys.readouterr().err
    assert not path.exists()


def test_presets_have_precisions_of_their_own(checkpoint, tmp_path):
    small = load_checkpoint(checkpoint)
    trained = [small, replace(small, preset_name="hq")]
    path, precisions = tmp_path / "two.rna", {"small": [Precision()], "hq": [Precision("int8")]}
    dataset = Dataset(small.dataset)
    with hurried_packages():
        build_package(trained, dataset, path, None, "CC0-1.0", lambda _: None, precisions)
    with Package.open(path) as package:
        assert [tier.name for tier in package.manifest.tiers] == ["small", "hq-int8"]


def test_tiers_of_any_pair_share_their_entries(checkpoint, tmp_path):
    pairs = [Precision(d, p) for d in ("float32", "int8") for p in ("float16", "int8")]
    trained = load_checkpoint(checkpoint)
    path = tmp_path / "every.rna"
    dataset = Dataset(trained.dataset)
    with hurried_packages():
        build_package([trained], dataset, path, None, "CC0-1.0", lambda _: None, pairs)
    with Package.open(path) as package:
        manifest = package.manifest
    assert len(manifest.tiers) == 4
    assert len(manifest.entries) == 1 + 2 + 2 * 2  # two precisions of planes and of decoders


def test_a_tier_that_loses_too_much_is_refused(checkpoint, tmp_path, capsys):
    path = tmp_path / "ball.rna"
    arguments = [str(checkpoint), "--precision", "int8", "--out", str(path)]
    with hurried_packages():
        assert main([*arguments, "--max-loss", "-20"]) == 1
        said = capsys.readouterr().err
        assert "small-int8" in said and "at most -20 dB (--max-loss)" in said
        assert not path.exists()
        assert main([*arguments, "--max-loss", "1"]) == 0


@pytest.mark.parametrize("kind", PRESETS)
@torch.no_grad()
def test_no_exported_weights_can_saturate(kind):
    for preset in PRESETS[kind]:
        model = make_model(preset, kind)
        for parameter in model.decoder.parameters():
            parameter.abs_()  # of one sign: the worst of pairs
        layers = int8_decoder(model.decoder, random_queries(model, 2000, 7)).layers
        assert not any(can_saturate(layer.weight.T.numpy()) for layer in layers)
        # No step is larger than it must be: some pair, or weight, is at its limit.
        for layer in layers:
            full = pair_sums(layer.weight.T.numpy()).max(axis=0) / PAIR_LIMIT
            single = np.abs(layer.weight.numpy().astype(int)).max(axis=1) / 127
            assert (np.maximum(full, single) > 0.95).all()
