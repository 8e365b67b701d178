"""Print finer than the planes is learnt through the base colour, and exported with it."""

import itertools
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import torch

from rna_export.export.decoder import decoders_of
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.optimization.samples import SampleTable
from rna_export.training.presets import ANALYTIC, PRESETS
from rna_export.training.training_run import Run, table_of
from rna_export.training.validation import answer
from tests.exporters.synthetic import samples_of_light, tiny
from tests.runtime.points import unit_vectors

BOUNDS = torch.tensor([[-1.1] * 3, [1.1] * 3])
CHECKS = 40  # along a side of the box; the planes have 16 texels
SHADOW = {"shadow_width": 16, "shadow_inputs": PRESETS["surface"]["paper-small"].model.inputs}


def printed_samples(rows: int) -> dict[str, np.ndarray]:
    """A ball of checks under a coat: diffuse light has their colour, highlights have none."""
    rng = np.random.default_rng(0)
    samples = samples_of_light(rng, unit_vectors(rng, rows))
    odd = np.floor(samples["position"] * CHECKS / 2).astype(int).sum(axis=1) % 2 == 1
    color = np.where(odd[:, None], np.float32([0.8, 0.1, 0.1]), np.float32([0.1, 0.1, 0.6]))
    rest = np.float32(0.03)
    samples["radiance"] = rest + color * (samples["radiance"] - rest)
    samples["base_color"] = color
    return samples


def trained(samples: dict[str, np.ndarray], uses_base_color: bool) -> NeuralAsset:
    preset = tiny(loss="log").with_model(uses_base_color=uses_base_color, **SHADOW)
    table = SampleTable(samples)
    torch.manual_seed(0)
    unit = table.usual_radiance, table.fields
    fitting = Fitting(preset, BOUNDS, 1.5 * table.largest_radiance, *unit)
    for step, rows in enumerate(itertools.islice(table, 300)):
        fitting.step(rows, step / 300)
    return fitting.model.eval()


def error(model: NeuralAsset, samples: dict[str, np.ndarray]) -> float:
    visible, shadowed = answer(model, samples)
    ours = np.where(samples["visible"][:, None] > 0, visible, shadowed)
    return float(np.square(ours - samples["radiance"]).mean())


def test_checks_finer_than_the_planes_are_learnt():
    samples = printed_samples(20_000)
    with_it, without = (error(trained(samples, uses), samples) for uses in (True, False))
    assert with_it < 0.1 * without


@pytest.mark.parametrize("shadow", [{"shadow_width": 0}, SHADOW])
@torch.no_grad()
def test_decoders_give_what_the_model_does(shadow):
    torch.manual_seed(0)
    model = NeuralAsset(tiny().model.model_copy(update={"uses_base_color": True, **shadow}), BOUNDS)
    model.triplane.planes.data.normal_()
    samples = printed_samples(500)
    at = {name: torch.from_numpy(np.ascontiguousarray(v)) for name, v in samples.items()}
    outputs = []
    for decoder in decoders_of(model):
        y = decoder.decoder(decoder.queries(at)).unflatten(1, (-1, 3))
        rest, factor = decoder.transport(y).chunk(2, dim=1)
        outputs.append(rest + at["base_color"][:, None] * factor)
    expected = model.transport(model(at))
    assert expected.std() > 0.01
    torch.testing.assert_close(torch.cat(outputs, dim=1), expected, rtol=1e-4, atol=1e-5)


PLAIN, IMAGE = SimpleNamespace(image=None), SimpleNamespace(image="checks.png")
SURFACE = PRESETS["surface"]


@pytest.mark.parametrize(
    ("preset", "record", "is_read"),
    [
        (SURFACE["small"], PLAIN, True),
        (SURFACE["hq"], PLAIN, False),  # wide decoders learn plain colours themselves
        (SURFACE["hq"], IMAGE, True),
        (SURFACE["paper-small"], IMAGE, False),
        (SURFACE["paper-hq"].with_model(width=16), PLAIN, False),
        (ANALYTIC, IMAGE, False),
    ],
)
def test_rows_have_the_base_colour_that_the_model_reads(preset, record, is_read):
    dataset: Any = SimpleNamespace(captured=SimpleNamespace(base_color=(record,)))
    table = table_of(Run(dataset, preset, "any", Path("none")), printed_samples(50))
    assert ("base_color" in table.fields) == is_read
    assert table.rows.shape == (50, 19 if is_read else 16)
