from __future__ import annotations

from itertools import islice

import numpy as np
import pytest
import torch

from rna_export.training.optimization.samples import SampleTable, columns

N = 1000


def make_table(seed: int = 0, batch: int = 100, done: int = 0) -> SampleTable:
    numbered = np.arange(N, dtype=np.float32)
    samples = {
        name: numbered[:, None] + np.float32([0.0, 0.1, 0.2]) + 10 * k
        for k, name in enumerate(("position", "normal", "wo", "wi", "radiance"))
    }
    visible = (numbered % 2).astype(np.uint8)
    return SampleTable({**samples, "visible": visible}, batch, seed, "cpu", done)


def test_columns_are_found_again() -> None:
    rows = next(iter(make_table()))
    at = columns(rows, make_table().fields)
    number = at["position"][:, 0]
    for k, name in enumerate(("position", "normal", "wo", "wi", "radiance")):
        assert torch.allclose(at[name], number[:, None] + torch.tensor([0.0, 0.1, 0.2]) + 10 * k)
    assert torch.equal(at["visible"], number % 2)


def test_each_sample_once_an_epoch() -> None:
    batches = list(islice(iter(make_table()), 20))
    for epoch in (batches[:10], batches[10:]):
        numbers = torch.cat([rows[:, 0] for rows in epoch])
        assert torch.equal(numbers.sort().values, torch.arange(N, dtype=torch.float32))
    assert not torch.equal(batches[0], batches[10])


def test_a_seed_repeats() -> None:
    first, again, other = (list(islice(iter(make_table(seed)), 15)) for seed in (1, 1, 2))
    assert all(torch.equal(a, b) for a, b in zip(first, again, strict=True))
    assert not torch.equal(first[0], other[0])


@pytest.mark.parametrize("done", [0, 3, 10, 27])
def test_a_stopped_run_goes_on_where_it_was(done: int) -> None:
    whole = list(islice(iter(make_table()), 30))
    rest = list(islice(iter(make_table(done=done)), 30 - done))
    assert all(torch.equal(a, b) for a, b in zip(whole[done:], rest, strict=True))


def test_fewer_samples_than_a_batch() -> None:
    rows = next(iter(make_table(batch=10 * N)))
    assert len(rows) == N
