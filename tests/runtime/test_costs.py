"""What a query costs on the processor at hand: measured once, kept, renewed when it must be."""

import pytest

from rna_sdk.runtime import is_no_worse, load
from rna_sdk.runtime.engine import costs
from tests.package.builders import (
    make_measured_tier,
    make_tier,
    make_tiny_fiber_package,
    make_tiny_package,
)


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache" / "rna-sdk" / "costs.json"


@pytest.mark.parametrize("make", [make_tiny_package, make_tiny_fiber_package])
def test_a_cost_is_measured_once(make, tmp_path, cache):
    path = make(tmp_path / "a.rna")
    first = load(path, threads=1).measured_ns_per_query()
    assert 1 < first < 1e6
    stored = cache.read_text()
    assert load(path, threads=1).measured_ns_per_query() == first
    assert cache.read_text() == stored
    load(path, threads=2).measured_ns_per_query()
    assert cache.read_text() != stored


def test_another_processor_or_a_damaged_file_is_measured_anew(cache, monkeypatch):
    numbers = iter([1.0, 2.0, 3.0])

    def ask() -> float:
        return costs.cached_cost(lambda: next(numbers), "package", 1)

    assert (ask(), ask()) == (1.0, 1.0)
    cache.write_text("{")
    assert (ask(), ask()) == (2.0, 2.0)
    monkeypatch.setattr(costs, "processor_key", lambda: "another")
    assert ask() == 3.0


def test_a_cache_that_cannot_be_written_does_no_harm(cache):
    cache.parent.parent.mkdir(parents=True)
    cache.parent.write_text("a file where the folder should be")
    assert costs.cached_cost(lambda: 5.0, "package") == 5.0


def test_a_tenth_of_a_decibel_less_is_no_worse():
    best = make_measured_tier("best", 0.02, 1)
    assert best.validation is not None
    for psnr, expected in ((29.91, True), (29.8, False), (31.0, True)):
        other = best.model_copy(
            update={"validation": best.validation.model_copy(update={"psnr": psnr})}
        )
        assert is_no_worse(other, best) == expected
    assert not is_no_worse(make_tier("unmeasured"), best)
