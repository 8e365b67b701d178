"""The suite's results as charts, one sheet of them, a table in Markdown and HTML, and JSON."""

from __future__ import annotations

import io
import json
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure, FigureBase
from PIL import Image

from rna_bench.html_pages import write_html
from rna_bench.plot_style import FAIL, PASS, QUIET, figure
from rna_bench.results import write_results
from rna_bench.stability.case import Case, Row
from rna_bench.stability.suite import CASES, Result

_COLOURS = {"pass": PASS, "fail": FAIL, "skipped": QUIET}
_ACROSS, _SIZE = 3, (6.6, 3.2)  # charts of the sheet in a row; inches of one


def write_page(
    folder: Path,
    stamp: dict[str, Any] | None,
    name: str,
    settings: dict[str, Any],
    results: list[Result],
) -> None:
    """Write `results.json`, `summary.md`, `index.html`, `sheet.png` and a PNG a case."""
    saved = {"asset": name, "settings": settings, "cases": [_as_json(r) for r in results]}
    write_results(folder / "results.json", stamp, saved, indent=None)
    (folder / "summary.md").write_text(table(results))
    drawn = [result for result in results if not result.skipped]
    for result in drawn:
        chart = figure(*_SIZE)
        _draw(chart, result)
        chart.savefig(folder / f"{result.case.name}.png", dpi=110)
    if drawn:
        _save_small(_sheet(drawn), folder / "sheet.png")
    told = [(result, _found(result), _COLOURS[result.status]) for result in results]
    page = folder / "index.html"
    write_html(page, "stability.html", name=name, stamp=stamp, settings=settings, results=told)


def read_results(path: Path) -> tuple[dict[str, Any] | None, str, dict[str, Any], list[Result]]:
    """Stamp (None in old ones), name, settings and results that `write_page` left."""
    saved = json.loads(path.read_text())
    by_name = {case.name: case for case in CASES}
    results = [_read(by_name[c["case"]], c["rows"], c["skipped"]) for c in saved["cases"]]
    return saved.get("stamp"), saved["asset"], saved["settings"], results


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
            f"| {r.case.name} | {r.case.varies} | {r.case.mark} | {_found(r)} | {r.status} |"
        )
    return "\n".join(lines) + "\n"


def _found(result: Result) -> str:
    return result.skipped or result.verdict.found


def _as_json(result: Result) -> dict[str, Any]:
    rows: list[Row] = result.rows
    return {
        "case": result.case.name,
        "mark": result.case.mark,
        "status": result.status,
        "found": _found(result),
        "skipped": result.skipped,
        "rows": rows,
    }


def _save_small(figure: Figure, path: Path) -> None:
    """As a PNG of 128 colours, which charts do not need more of."""
    file = io.BytesIO()
    figure.savefig(file, dpi=80)
    Image.open(file).convert("RGB").quantize(128).save(path, optimize=True)


def _sheet(results: list[Result]) -> Figure:
    down = -(-len(results) // _ACROSS)
    sheet = figure(_ACROSS * _SIZE[0], down * _SIZE[1])
    parts = sheet.subfigures(down, _ACROSS, squeeze=False).reshape(-1)
    for part, result in zip(parts, results, strict=False):
        _draw(part, result)
    return sheet


def _draw(chart: FigureBase, result: Result) -> None:
    chart.suptitle(
        f"{result.case.title}: {result.status}", color=_COLOURS[result.status], fontsize=9
    )
    result.case.draw(chart, result.rows)
