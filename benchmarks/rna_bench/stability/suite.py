"""Runs the cases, one after the other, and keeps what each gave."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from rna_bench.stability.case import Case, Result, Row
from rna_bench.stability.cases import (
    energy,
    grazing,
    little_data,
    luck,
    motion,
    near_light,
    noise,
    numbers,
    shadow_edges,
    sharp,
    thin,
    unseen,
    zoom,
)
from rna_bench.stability.fixtures import Fixtures
from rna_export.machine import keep_freed_memory
from rna_sdk.atomic_file import write_atomically
from rna_sdk.errors import TrainingError
from rna_work.executors import Executor, check_shared, this_machine
from rna_work.pool import Pool

CASES: tuple[Case, ...] = tuple(
    module.CASE
    for module in (
        sharp,
        grazing,
        near_light,
        unseen,
        shadow_edges,
        thin,
        zoom,
        noise,
        little_data,
        luck,
        numbers,
        energy,
        motion,
    )
)


def run_cases(
    cases: Sequence[Case],
    fixtures: Fixtures,
    folder: Path,
    settings: dict[str, Any],
    again: bool,
    say: Callable[[str], None],
    executor: Executor | None = None,
) -> list[Result]:
    """A result a case; rows that `folder` has already are not measured again, unless `again`.

    executor: what the cases run on, None for this machine. Raises TrainingError where rows were
    measured with other settings.
    """
    folder.mkdir(parents=True, exist_ok=True)
    reasons = [why_not(case, fixtures) for case in cases]
    wanted = [
        case
        for case, reason in zip(cases, reasons, strict=True)
        if reason is None and (again or not _path(folder, case).is_file())
    ]
    if wanted:
        _measure(wanted, fixtures, folder, settings, say, executor or this_machine())
    results = []
    for case, reason in zip(cases, reasons, strict=True):
        rows = [] if reason else _rows(_path(folder, case), settings)
        results.append(Result(case, rows, reason))
        if case not in wanted:
            say(results[-1].told)
    return results


def _path(folder: Path, case: Case) -> Path:
    return folder / f"{case.name}.json"


def _measure(
    cases: list[Case],
    fixtures: Fixtures,
    folder: Path,
    settings: dict[str, Any],
    say: Callable[[str], None],
    executor: Executor,
) -> None:
    """Measure cases and write their rows. Raises the first failure, after the others are done."""
    check_shared(executor, folder)
    backend, cores = executor.whole_machines(None)
    make = partial(_CaseWorker, fixtures.with_workers(cores) if executor.far else fixtures)
    failures = []
    pool: Pool[Case, list[Row]] = Pool(backend, make, tell=say)
    with pool:
        for outcome in pool.run(_told(cases, say)):
            if outcome.failure is not None:
                say(f"{outcome.item.name}: {outcome.failure}")
                failures.append(outcome.failure)
                continue
            rows = outcome.value()
            saved = {"settings": settings, "rows": rows}
            write_atomically(_path(folder, outcome.item), json.dumps(saved).encode())
            say(Result(outcome.item, rows).told)
    if failures:
        raise failures[0]


def _told(cases: list[Case], say: Callable[[str], None]) -> Iterator[Case]:
    for case in cases:
        say(f"{case.name}: {case.varies}")
        yield case


@dataclass
class _CaseWorker:
    """Measures cases: see `rna_work.workers.Worker`."""

    fixtures: Fixtures
    name: str

    def __enter__(self) -> _CaseWorker:
        keep_freed_memory()
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def run(self, case: Case) -> list[Row]:
        return case.measure(self.fixtures)

    def kill(self) -> None:
        """The worker is a process, or whoever waits for it is interrupted."""


def why_not(case: Case, fixtures: Fixtures) -> str | None:
    """Why a case is left out, or None."""
    missing = [name for name in case.needs if name not in fixtures.subject.given]
    if missing:
        return f"no {' and no '.join(missing)} given"
    kind = fixtures.kind
    if kind is not None and kind not in case.kinds:
        return f"not for assets of kind {kind}"
    return None


def _rows(path: Path, settings: dict[str, Any]) -> list[Row]:
    saved = json.loads(path.read_text())
    if saved["settings"] != settings:
        raise TrainingError(
            f"{path} was measured with {saved['settings']}, found {settings}: choose another "
            "--out, or use --again"
        )
    return saved["rows"]
