"""Steps as graphs; where there is no GPU, with a recorder that only runs them again."""

from collections.abc import Callable

import numpy as np
import pytest
import torch

from rna_export.capture.dataset.dataset_manifest import SAMPLE_FIELDS
from rna_export.training.model import triplane
from rna_export.training.model.triplane import blurred
from rna_export.training.optimization import samples as samples_module
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.optimization.samples import SampleTable
from rna_export.training.optimization.step_graphs import StepGraphs
from tests.exporters.synthetic import tiny

BOUNDS = torch.tensor([[-1.0] * 3, [1.0] * 3])


def test_a_step_is_recorded_after_three_and_reads_the_new_rows():
    recorded, ran = [], []

    def step(kind: str, rows: torch.Tensor) -> torch.Tensor:
        ran.append((kind, rows.data_ptr()))
        return rows.sum()

    def record(step: Callable[[], torch.Tensor]) -> Callable[[], torch.Tensor]:
        recorded.append(len(ran))
        return step

    graphs = StepGraphs(step, record)
    kinds = ["log"] * 6 + ["unbiased"] * 5
    sums = [graphs.run(kind, torch.full((4,), float(k))) for k, kind in enumerate(kinds)]
    assert [float(s) for s in sums] == [4.0 * k for k in range(11)]  # none is overwritten
    assert recorded == [3, 9]
    assert len({pointer for _, pointer in ran[3:6] + ran[9:]}) == 1


def as_on_a_gpu(fitting: Fitting) -> Fitting:
    """With tensors and graphs as there, except their recording."""
    fitting._graphs = StepGraphs(fitting._descend, lambda step: step)
    fitting._footprint = torch.ones(())
    return fitting


@pytest.mark.parametrize("kind", ["surface", "fiber"])
def test_steps_of_graphs_learn_what_others_learn(kind):
    """Through blur, no blur and the loss of the end; blurred planes are PyTorch's on a GPU."""
    states = []
    for prepare in (lambda fitting: fitting, as_on_a_gpu):
        torch.manual_seed(0)
        fields = SAMPLE_FIELDS[kind]
        rows = torch.rand(256, sum(fields.values()))
        fitting = prepare(Fitting(tiny(kind=kind, loss="log"), BOUNDS, 9.0, 1.0, fields))
        for k in range(40):
            fitting.step(rows, k / 40)
        states.append(fitting.model.state_dict())
    assert states[0].keys() == states[1].keys()
    for name, values in states[0].items():
        assert torch.allclose(values, states[1][name], rtol=1e-2, atol=2e-3), name


@pytest.mark.parametrize("footprint", [1.01, 1.6, 2.5, 4.0])
def test_a_footprint_in_a_tensor_blurs_alike(footprint):
    planes = torch.randn(3, 12, 12, 2, generator=torch.Generator().manual_seed(0))
    kernel, normalisation = triplane._blur(12, footprint)
    radius = len(kernel) // 2
    matrix = sum(np.eye(12, k=d - radius) * kernel[d] for d in range(len(kernel)))
    m = torch.from_numpy((matrix * normalisation[:, None]).astype(np.float32))
    expected = torch.einsum("ab,kbcf,dc->kadf", m, planes, m)
    for given in (footprint, torch.tensor(footprint)):
        assert torch.allclose(blurred(planes, given), expected, atol=1e-5)


@pytest.mark.parametrize("done", [0, 7])
def test_rows_that_are_loaded_are_those_of_a_table_on_the_device(monkeypatch, done):
    """The host's part of it; a GPU only copies."""
    monkeypatch.setattr(samples_module, "_GATHERED", 2)
    monkeypatch.setattr(torch.Tensor, "pin_memory", lambda rows: rows)
    position = np.arange(3000, dtype=np.float32).reshape(1000, 3)
    table = SampleTable({"position": position}, 64, seed=3, done=done)
    batches = [torch.cat([next(actual) for _ in range(40)]) for actual in (iter(table),)]
    rows = (rows for group in table._loaded() for rows in group.split(64))
    assert torch.equal(batches[0], torch.cat([next(rows) for _ in range(40)]))
