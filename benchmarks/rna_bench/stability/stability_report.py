"""The suite's results as charts, a table in Markdown, and JSON."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rna_bench.plot_style import FAIL, PASS, QUIET, figure, save_chart
from rna_bench.results import write_results
from rna_bench.stability.case import Case, Result

_COLOURS = {"pass": PASS, "fail": FAIL, "skipped": QUIET}
_SIZE = 6.6, 3.2  # inches of a chart


def write_report(
    folder: Path,
    stamp: dict[str, Any] | None,
    name: str,
    settings: dict[str, Any],
    results: list[Result],
) -> None:
    """Write `results.json`, `summary.md` and an SVG a case."""
    saved = {"asset": name, "settings": settings, "cases": [_as_json(r) for r in results]}
    write_results(folder / "results.json", stamp, saved)
    (folder / "summary.md").write_text(table(results))
    for result in (result for result in results if not result.skipped):
        chart, title = figure(*_SIZE), f"{result.case.title}: {result.status}"
        chart.suptitle(title, color=_COLOURS[result.status], fontsize=9)
        result.case.draw(chart, result.rows)
        save_chart(chart, folder / f"{result.case.name}.svg")


def read_results(
    path: Path, cases: Sequence[Case]
) -> tuple[dict[str, Any] | None, str, dict[str, Any], list[Result]]:
    """Stamp (None in old ones), name, settings and results that `write_report` left."""
    saved, by_name = json.loads(path.read_text()), {case.name: case for case in cases}
    results = [Result(by_name[c["case"]], c["rows"], c["skipped"]) for c in saved["cases"]]
    return saved.get("stamp"), saved["asset"], saved["settings"], results


def table(results: list[Result]) -> str:
    """Markdown: a row a case."""
    lines = ["| case | varies | must reach | found | |", "| --- | --- | --- | --- | --- |"]
    for r in results:
        lines.append(
            f"| {r.case.name} | {r.case.varies} | {r.case.mark} | {r.found} | {r.status} |"
        )
    return "\n".join(lines) + "\n"


def _as_json(result: Result) -> dict[str, Any]:
    return {
        "case": result.case.name,
        "mark": result.case.mark,
        "status": result.status,
        "found": result.found,
        "skipped": result.skipped,
        "rows": result.rows,
    }
