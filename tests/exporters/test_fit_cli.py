"""`rna-fit` from a dataset to a package and the page that explains it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.fit.rna_fit import main
from rna_export.trials import grid as grid_module
from rna_export.trials.trial import Trial
from rna_sdk.runtime import load
from tests.exporters.synthetic import hurried_packages, make_dataset, tiny


def grid(kind: str, steps: int) -> list[Trial]:
    preset = tiny(steps=steps)
    return [
        Trial(name="narrow", family="ours", preset=preset),
        Trial(name="wide", family="ours", preset=preset.with_model(width=64)),
        Trial(name="theirs", family="paper", preset=preset),
    ]


@pytest.fixture(scope="module", autouse=True)
def hurried() -> Iterator[None]:
    with hurried_packages():
        yield


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> DatasetPart:
    return make_dataset(tmp_path_factory.mktemp("data") / "ball.rays")


@pytest.fixture(autouse=True)
def few_models(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(grid_module, "short_grid", grid)


def run(dataset: DatasetPart, out: Path, *limit: str) -> int:
    common = ["--out", str(out), "--steps", "32", "--workers", "1", "--device", "cpu"]
    return main([str(dataset.folder), *limit, *common])


def test_package_meets_the_limit_and_the_page_says_why(
    dataset: DatasetPart, tmp_path: Path
) -> None:
    out = tmp_path / "ball.rna"
    assert run(dataset, out, "--max-error", "0.9") == 0
    tier = load(out).tier
    assert tier.validation.flip <= 0.9 and tier.cost.ns_per_query > 0.0
    page = (tmp_path / "ball.fit" / "index.html").read_text()
    assert "mean FLIP of at most 0.9" in page and "chosen: the cheapest" in page
    assert "narrow int8-int8" in page and "theirs" not in page
    assert not list((tmp_path / "ball.fit" / "2").glob("theirs"))


def test_impossible_limit_is_one_line(
    dataset: DatasetPart, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "ball.rna"
    assert run(dataset, out, "--budget-us", "1e-6") == 1
    error = capsys.readouterr().err
    assert error.startswith("error: no model has a cost of at most 1e-06 us per query: ")
    assert not out.exists()


@pytest.mark.parametrize(
    "limit", [(), ("--max-error", "0"), ("--max-error", "1", "--min-psnr", "3")]
)
def test_one_limit_above_zero_is_needed(dataset: DatasetPart, tmp_path: Path, limit: tuple) -> None:
    with pytest.raises(SystemExit) as ended:
        run(dataset, tmp_path / "ball.rna", *limit)
    assert ended.value.code == 2
