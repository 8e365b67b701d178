"""Runs the cases, one after the other, and keeps their results."""

import json
from collections.abc import Callable, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

from rna_bench.stability.case import Case, Result
from rna_bench.stability.cases import CASE_NAMES
from rna_bench.stability.fixtures import Fixtures
from rna_sdk.errors import TrainingError
from rna_sdk.files.atomic_file import write_atomically

CASES: tuple[Case, ...] = tuple(
    import_module(f"rna_bench.stability.cases.{name.replace('-', '_')}").CASE for name in CASE_NAMES
)


def run_cases(
    cases: Sequence[Case],
    fixtures: Fixtures,
    folder: Path,
    settings: dict[str, Any],
    again: bool,
    say: Callable[[str], None],
) -> list[Result]:
    """A result a case; rows that `folder` has already are not measured again, unless `again`.

    Raises TrainingError where rows were measured with other settings.
    """
    folder.mkdir(parents=True, exist_ok=True)
    results = []
    for case in cases:
        path, rows, reason = folder / f"{case.name}.json", [], why_not(case, fixtures)
        if reason is None and (again or not path.is_file()):
            say(f"{case.name}: {case.varies}")
            saved = {"settings": settings, "rows": case.measure(fixtures)}
            write_atomically(path, json.dumps(saved).encode())
        if reason is None:
            saved = json.loads(path.read_text())
            if saved["settings"] != settings:
                raise TrainingError(
                    f"{path} was measured with {saved['settings']}, found {settings}: choose "
                    "another --out, or use --again"
                )
            rows = saved["rows"]
        results.append(Result(case, rows, reason))
        say(results[-1].summary)
    return results


def why_not(case: Case, fixtures: Fixtures) -> str | None:
    """Why a case is left out, or None."""
    missing = [name for name in case.needs if name not in fixtures.subject.given]
    if missing:
        return f"no {' and no '.join(missing)} given"
    kind = fixtures.kind
    if kind is not None and kind not in case.kinds:
        return f"not for assets of kind {kind}"
    return None
