"""Runs the cases, one after the other, and keeps what each gave."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rna_bench.stability.case import Case, Row, Verdict
from rna_bench.stability.cases import (
    energy,
    grazing,
    little_data,
    luck,
    near_light,
    noise,
    numbers,
    posed,
    shadow_edges,
    sharp,
    thin,
    unseen,
    zoom,
)
from rna_bench.stability.workshop import Workshop
from rna_export.capture.sample_files import write_atomically
from rna_sdk.errors import TrainingError

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
        posed,
    )
)


@dataclass(frozen=True)
class Result:
    """What a case gave: rows, or why there are none."""

    case: Case
    rows: list[Row]
    skipped: str | None = None

    @property
    def verdict(self) -> Verdict | None:
        """None where it was skipped."""
        return None if self.skipped else self.case.judge(self.rows)

    @property
    def status(self) -> str:
        """One word for the table."""
        return "skipped" if self.verdict is None else ("pass" if self.verdict.passed else "fail")


def run_cases(
    cases: Sequence[Case],
    workshop: Workshop,
    folder: Path,
    settings: dict[str, Any],
    again: bool,
    say: Callable[[str], None],
) -> list[Result]:
    """A result a case; rows that `folder` has already are not measured again, unless `again`.

    Raises TrainingError where those were measured with other settings.
    """
    folder.mkdir(parents=True, exist_ok=True)
    results = []
    for case in cases:
        path = folder / f"{case.name}.json"
        reason = why_not(case, workshop)
        if reason is None and (again or not path.is_file()):
            say(f"{case.name}: {case.varies}")
            saved = {"settings": settings, "rows": case.measure(workshop)}
            write_atomically(path, json.dumps(saved).encode())
        rows = [] if reason else _rows(path, settings)
        results.append(Result(case, rows, reason))
        found = reason or results[-1].verdict.found
        say(f"{case.name}: {results[-1].status}, {found}")
    return results


def why_not(case: Case, workshop: Workshop) -> str | None:
    """Why a case is left out, or None."""
    missing = [name for name in case.needs if name not in workshop.subject.given]
    if missing:
        return f"no {' and no '.join(missing)} given"
    kind = workshop.kind
    if kind is not None and kind not in case.kinds:
        return f"not for assets of kind {kind}"
    return None


def _rows(path: Path, settings: dict[str, Any]) -> list[Row]:
    saved = json.loads(path.read_text())
    if saved["settings"] != settings:
        raise TrainingError(
            f"{path} was measured with {saved['settings']}, found {settings}: choose another "
            "--out, or --again"
        )
    return saved["rows"]
