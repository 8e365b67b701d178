"""Threads of training steps: all on a quiet machine, one on a busy one, the same bits with both."""

import numpy as np
import pytest
import torch

from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.optimization import product_kernels
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.optimization.product_kernels import (
    Product,
    products_repeat,
    use_threads,
    weight_gradient,
)
from rna_export.training.optimization.samples import SampleTable
from rna_export.training.optimization.step_threads import StepThreads, step_products
from rna_export.training.presets import PRESETS
from rna_sdk.machine.kernel_threads import kernel_threads


class Machine:
    """A clock, on which steps take what `seconds` says of their number of threads."""

    def __init__(self, **seconds: float) -> None:
        self.now, self.threads = 0.0, 4
        self.seconds = seconds
        self.steps = {1: 0, 4: 0}

    def use(self, count: int) -> None:
        self.threads = count

    def step(self) -> None:
        self.steps[self.threads] += 1
        self.now += self.seconds["one" if self.threads == 1 else "all"]


def run(machine: Machine, threads: StepThreads, seconds: float) -> float:
    """Steps a second over so many seconds."""
    before, until = sum(machine.steps.values()), machine.now + seconds
    begun = machine.now
    while machine.now < until:
        threads.run(machine.step)
    return (sum(machine.steps.values()) - before) / (machine.now - begun)


def test_a_quiet_machine_has_nearly_the_speed_of_all_its_threads():
    machine = Machine(one=0.007, all=0.0045)
    with StepThreads(4, machine.use, lambda: machine.now) as threads:
        assert run(machine, threads, 60.0) > 0.97 / 0.0045
        assert machine.threads == 4


def test_a_busy_machine_has_nearly_the_speed_of_one_thread():
    machine = Machine(one=0.025, all=0.3)
    with StepThreads(4, machine.use, lambda: machine.now) as threads:
        assert run(machine, threads, 10.0) > 0.85 / 0.025
        assert run(machine, threads, 60.0) > 0.97 / 0.025
        assert machine.threads == 1
    assert machine.threads == 4  # as before


def test_load_that_comes_is_noticed_at_once_and_that_goes_within_half_a_minute():
    machine = Machine(one=0.007, all=0.0045)
    with StepThreads(4, machine.use, lambda: machine.now) as threads:
        run(machine, threads, 60.0)
        machine.seconds = {"one": 0.02, "all": 0.3}
        run(machine, threads, 1.0)
        assert machine.threads == 1
        run(machine, threads, 60.0)
        machine.seconds = {"one": 0.007, "all": 0.0045}
        run(machine, threads, 32.0)
        assert machine.threads == 4


def test_long_regions_have_all_threads_in_between():
    machine = Machine(one=0.025, all=0.3)
    with StepThreads(4, machine.use, lambda: machine.now) as threads:
        run(machine, threads, 5.0)
        with threads.all():
            assert machine.threads == 4
        assert machine.threads == 1


def test_one_thread_is_never_set_again():
    machine = Machine(one=0.01, all=0.01)
    with StepThreads(1, machine.use, lambda: machine.now) as threads:
        run(machine, threads, 10.0)
    assert machine.threads == 4


@pytest.mark.skipif(kernel_threads() < 2, reason="one core")
def test_numbers_of_threads_apply_to_kernels_and_torch():
    before = kernel_threads()
    try:
        assert use_threads(1) == 1
        assert (kernel_threads(), torch.get_num_threads()) == (1, 1)
    finally:
        use_threads(before)
    assert (kernel_threads(), torch.get_num_threads()) == (before, before)


@pytest.mark.parametrize("loss", ["log", "unbiased"])
def test_steps_give_the_same_bits_with_any_number_of_threads(loss):
    rng = np.random.default_rng(0)

    def directions() -> np.ndarray:
        v = rng.normal(size=(4096, 3))
        return np.asarray(v / np.linalg.norm(v, axis=1, keepdims=True), np.float32)

    samples = {
        "position": rng.uniform(-1, 1, (4096, 3)).astype(np.float32),
        **{name: directions() for name in ("normal", "wo", "wi")},
        "radiance": rng.random((4096, 3), np.float32),
        "visible": (np.arange(4096) % 3 == 0).astype(np.float32),
    }
    table = SampleTable(samples)
    preset = PRESETS["surface"]["small"].with_training(loss=loss)
    before, states = kernel_threads(), []
    try:
        for count in (1, before):
            use_threads(count)
            torch.manual_seed(0)
            bounds = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])
            fitting = Fitting(preset, bounds, 1.5, 0.5, table.fields, lit=table.lit)
            batches = iter(table)
            for k in range(3):
                fitting.step(next(batches), 0.2 * k)
            states.append(fitting.model.state_dict())
    finally:
        use_threads(before)
    for name, values in states[0].items():
        assert torch.equal(values, states[1][name]), name


def test_narrow_products_are_those_of_torch_and_repeat():
    generator = torch.Generator().manual_seed(0)
    gradient, value = (torch.randn(64, k, generator=generator) for k in (6, 16))
    exact = (gradient.double().t() @ value.double()).float()  # BLAS sums in orders of its own
    torch.testing.assert_close(weight_gradient(gradient, value), exact)
    before, sizes = kernel_threads(), (3, 6, 9, 12)
    try:
        narrow = [Product(n, 64, b, torch.float32) for n in (128, 512, 1024) for b in sizes]
        assert products_repeat(narrow, [], before)
    finally:
        use_threads(before)


def test_products_are_those_of_a_step():
    """Whose bits may depend on threads: visible light's in bfloat16, too, shadowed light's not."""
    preset = PRESETS["surface"]["hq"]
    model = NeuralAsset(preset.model, torch.tensor([[-1.0] * 3, [1.0] * 3]))
    model.multiplies_in_bfloat16 = True
    products = step_products(model, (2048, 256))
    assert (2048, 128, 128, torch.float32) in products
    assert {p.columns_out for p in products if p.dtype == torch.bfloat16} == {256, 3}
    of_own = step_products(model, (2048, 256), lit=900)
    assert {(p.rows, p.columns_out) for p in of_own} == {
        (900, 256),
        (900, 3),
        (1148, 128),
        (1148, 3),
    }


def test_products_that_differ_are_found(monkeypatch):
    def shared_sum(gradient: torch.Tensor, value: torch.Tensor) -> torch.Tensor:
        parts = zip(gradient.chunk(count), value.chunk(count), strict=True)
        return torch.stack([g.t() @ v for g, v in parts]).sum(dim=0)

    count = 1

    def use(threads: int) -> None:
        nonlocal count
        count = threads

    monkeypatch.setattr(product_kernels, "weight_gradient", shared_sum)
    monkeypatch.setattr(product_kernels, "use_threads", use)
    assert not products_repeat([Product(2048, 64, 64, torch.float32)], [], 7)
