from itertools import islice

import numpy as np
import pytest
import torch

from rna_export.training.optimization.samples import (
    SampleTable,
    columns,
    without_stray_highlights,
)

N = 1000


def make_table(seed: int = 0, batch: int = 100, done: int = 0) -> SampleTable:
    numbered = np.arange(N, dtype=np.float32)
    samples = {
        name: numbered[:, None] + np.float32([0.0, 0.1, 0.2]) + 10 * k
        for k, name in enumerate(("position", "normal", "wo", "wi", "radiance"))
    }
    visible = (numbered % 2).astype(np.uint8)
    return SampleTable({**samples, "visible": visible}, batch, seed, "cpu", done)


def test_columns_are_found_again():
    rows = next(iter(make_table()))
    at = columns(rows, make_table().fields)
    number = at["position"][:, 0]
    for k, name in enumerate(("position", "normal", "wo", "wi", "radiance")):
        assert torch.allclose(at[name], number[:, None] + torch.tensor([0.0, 0.1, 0.2]) + 10 * k)
    assert torch.equal(at["visible"], number % 2)


def test_each_sample_once_an_epoch():
    batches = list(islice(iter(make_table()), 20))
    for epoch in (batches[:10], batches[10:]):
        numbers = torch.cat([rows[:, 0] for rows in epoch])
        assert torch.equal(numbers.sort().values, torch.arange(N, dtype=torch.float32))
    assert not torch.equal(batches[0], batches[10])


def test_a_seed_repeats():
    first, again, other = (list(islice(iter(make_table(seed)), 15)) for seed in (1, 1, 2))
    assert all(torch.equal(a, b) for a, b in zip(first, again, strict=True))
    assert not torch.equal(first[0], other[0])


@pytest.mark.parametrize("done", [0, 3, 10, 27])
def test_a_stopped_run_goes_on_where_it_was(done):
    whole = list(islice(iter(make_table()), 30))
    rest = list(islice(iter(make_table(done=done)), 30 - done))
    assert all(torch.equal(a, b) for a, b in zip(whole[done:], rest, strict=True))


@pytest.mark.parametrize(("share", "lit"), [(0.3, 30), (0.004, 1), (0.999, 99)])
def test_samples_that_see_the_light_come_first_in_every_batch(share, lit):
    visible = (np.arange(N) >= (1.0 - share) * N).astype(np.uint8)
    zeros = np.zeros((N, 3), np.float32)
    table = SampleTable({"position": zeros, "radiance": zeros, "visible": visible}, 100)
    assert table.lit == lit
    for rows in islice(iter(table), 25):
        assert torch.equal(rows[:, -1] > 0.5, torch.arange(100) < lit)


@pytest.mark.parametrize(
    ("fields", "batch"),
    [
        ({"visible": np.ones(N)}, 100),
        ({"visible": np.tile([[1.0, 0.5, 0.0]], (N, 1))}, 100),  # in colours
        ({"visible": np.arange(N) % 2, "direct": np.zeros((N, 3))}, 100),  # strands
        ({"visible": np.arange(N) % 2}, 1),
        ({}, 100),  # of emission
    ],
)
def test_other_samples_are_mixed(fields, batch):
    zeros = np.zeros((N, 3), np.float32)
    table = SampleTable({"position": zeros, "radiance": zeros, **fields}, batch)
    assert table.lit is None


def test_fewer_samples_than_a_batch():
    rows = next(iter(make_table(batch=10 * N)))
    assert len(rows) == N


def shadowed_and_lit(**fields: np.ndarray) -> dict[str, np.ndarray]:
    """1,000 samples, the second half lit; two shadowed ones are highlights."""
    radiance = np.random.default_rng(0).uniform(0.0, 0.1, (N, 3)).astype(np.float32)
    radiance[N // 2 :] += 5.0
    radiance[:2] = 20.0
    visible = (np.arange(N) >= N // 2).astype(np.uint8)
    normal, wi = (np.tile(np.float32(v), (N, 1)) for v in ((0, 1, 0), (0.995, 0.1, 0)))
    wo = wi * np.float32([-1, 1, 1])  # where the light is mirrored, at the terminator
    directions = {"normal": normal, "wo": wo, "wi": wi}
    return {"radiance": radiance, "visible": visible, **directions, **fields}


def test_stray_highlights_in_shadow_are_clipped():
    samples = shadowed_and_lit()
    clipped = without_stray_highlights(samples)["radiance"]
    assert np.all(clipped[:2] < 1.0)
    assert np.all(clipped[:2] > 0.5)  # 8 times the 99th percentile of the others
    assert np.array_equal(clipped[2:], samples["radiance"][2:])


@pytest.mark.parametrize(
    ("wo", "wi"), [((0, 1, 0), (0.995, 0.1, 0)), ((-0.995, 0.1, 0), (0.995, -0.1, 0))]
)
def test_light_that_metal_reflects_into_shadow_is_kept(wo, wi):
    """Beside the highlight of the light itself, or where the surface faces away from it."""
    directions = {k: np.tile(np.float32(v), (N, 1)) for k, v in (("wo", wo), ("wi", wi))}
    samples = shadowed_and_lit(**directions)
    np.testing.assert_array_equal(
        without_stray_highlights(samples)["radiance"], samples["radiance"]
    )


def test_light_of_strands_is_not_clipped():
    samples = shadowed_and_lit(direct=np.zeros((N, 3), np.float32))
    assert without_stray_highlights(samples) is samples


def test_an_asset_that_is_black_in_shadow_is_not_clipped():
    samples = shadowed_and_lit()
    samples["radiance"][2 : N // 2] = 0.0
    assert without_stray_highlights(samples) is samples
