"""The suite's results as charts, a table in Markdown and HTML, and JSON."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from rna_bench.bench_pages import write_html
from rna_bench.plot_style import FAIL, PASS, QUIET, figure, save_chart
from rna_bench.results import write_results
from rna_bench.stability.case import Case, Result, Row

_COLOURS = {"pass": PASS, "fail": FAIL, "skipped": QUIET}
_SIZE = 6.6, 3.2  # inches of a chart


def write_page(
    folder: Path,
    stamp: dict[str, Any] | None,
    name: str,
    settings: dict[str, Any],
    results: list[Result],
) -> None:
    """Write `results.json`, `summary.md`, `index.html` and an SVG a case."""
    saved = {"asset": name, "settings": settings, "cases": [_as_json(r) for r in results]}
    write_results(folder / "results.json", stamp, saved)
    (folder / "summary.md").write_text(table(results))
    drawn = [result for result in results if not result.skipped]
    for result in drawn:
        save_chart(_chart(result), folder / f"{result.case.name}.svg")
    told = [(result, result.found, _COLOURS[result.status]) for result in results]
    page = folder / "index.html"
    write_html(page, "stability.html", name=name, stamp=stamp, settings=settings, results=told)


def read_results(
    paths: Sequence[Path], cases: Sequence[Case]
) -> tuple[dict[str, Any] | None, str, dict[str, Any], list[Result]]:
    """Stamp (None in old ones), name, settings and results of the cases that `write_page` left.

    Rows of a case that several files have are joined; stamp, name and settings are the first
    file's, with the other stamps as the stamp's `joined`.
    """
    first, *others = (json.loads(path.read_text()) for path in paths)
    by_name = {case.name: case for case in cases}
    known: dict[str, tuple[list[Row], str | None]] = {}
    for one in (one for saved in (first, *others) for one in saved["cases"]):
        if one["case"] in by_name:  # not those of earlier suites
            rows, _ = known.get(one["case"], ([], None))
            known[one["case"]] = [*rows, *one["rows"]], one["skipped"]
    results = [_read(by_name[name], *found) for name, found in known.items()]
    stamp = first.get("stamp")
    if others:
        stamp = {**(stamp or {}), "joined": [saved.get("stamp") for saved in others]}
    return stamp, first["asset"], first["settings"], results


def _read(case: Case, rows: list[Row], skipped: str | None) -> Result:
    """Rows of an earlier definition of the case, which lack what it judges by now, are left out."""
    result = Result(case, rows, skipped)
    try:
        _ = result.verdict
    except KeyError as missing:
        return Result(case, rows, f"measured before there was {missing.args[0]}: measure again")
    return result


def table(results: list[Result]) -> str:
    """Markdown: a row a case."""
    lines = ["| case | varies | must reach | found | |", "| --- | --- | --- | --- | --- |"]
    for r in results:
        lines.append(
            f"| {r.case.name} | {r.case.varies} | {r.case.mark} | {r.found} | {r.status} |"
        )
    return "\n".join(lines) + "\n"


def _as_json(result: Result) -> dict[str, Any]:
    rows: list[Row] = result.rows
    return {
        "case": result.case.name,
        "mark": result.case.mark,
        "status": result.status,
        "found": result.found,
        "skipped": result.skipped,
        "rows": rows,
    }


def _chart(result: Result) -> Figure:
    chart = figure(*_SIZE)
    chart.suptitle(
        f"{result.case.title}: {result.status}", color=_COLOURS[result.status], fontsize=9
    )
    result.case.draw(chart, result.rows)
    return chart
