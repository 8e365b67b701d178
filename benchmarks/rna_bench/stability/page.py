"""The suite's results as charts, one sheet of them, a table in Markdown and HTML, and JSON."""

from __future__ import annotations

import html
import io
import json
from pathlib import Path
from typing import Any

import matplotlib
from matplotlib.figure import Figure, FigureBase
from PIL import Image

from rna_bench.stability.case import Row
from rna_bench.stability.suite import CASES, Result

matplotlib.use("Agg")

_COLOURS = {"pass": "#2a7d2a", "fail": "#b3261e", "skipped": "#666666"}
_STYLE = {
    "font.size": 8,
    "legend.fontsize": 7,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "lines.markersize": 3.5,
}
_ACROSS, _SIZE = 3, (6.6, 3.2)  # charts of the sheet in a row; inches of one


def write_page(folder: Path, name: str, settings: dict[str, Any], results: list[Result]) -> None:
    """Write `results.json`, `summary.md`, `index.html`, `sheet.png` and a PNG a case."""
    folder.mkdir(parents=True, exist_ok=True)
    saved = {"asset": name, "settings": settings, "cases": [_as_json(r) for r in results]}
    (folder / "results.json").write_text(json.dumps(saved, separators=(",", ":")) + "\n")
    (folder / "summary.md").write_text(table(results))
    drawn = [result for result in results if not result.skipped]
    with matplotlib.rc_context(_STYLE):
        for result in drawn:
            figure = Figure(figsize=_SIZE, layout="constrained")
            _draw(figure, result)
            figure.savefig(folder / f"{result.case.name}.png", dpi=110)
        if drawn:
            _save_small(_sheet(drawn), folder / "sheet.png")
    (folder / "index.html").write_text(_page(name, settings, results))


def read_results(path: Path) -> tuple[str, dict[str, Any], list[Result]]:
    """What `write_page` left in `results.json`: name, settings, results."""
    saved = json.loads(path.read_text())
    by_name = {case.name: case for case in CASES}
    results = [Result(by_name[c["case"]], c["rows"], c["skipped"]) for c in saved["cases"]]
    return saved["asset"], saved["settings"], results


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
    size = (_ACROSS * _SIZE[0], down * _SIZE[1])
    sheet = Figure(figsize=size, layout="constrained")
    parts = sheet.subfigures(down, _ACROSS, squeeze=False).reshape(-1)
    for part, result in zip(parts, results, strict=False):
        _draw(part, result)
    return sheet


def _draw(figure: FigureBase, result: Result) -> None:
    figure.suptitle(
        f"{result.case.title}: {result.status}", color=_COLOURS[result.status], fontsize=9
    )
    result.case.draw(figure, result.rows)


def _page(name: str, settings: dict[str, Any], results: list[Result]) -> str:
    rows = "".join(_table_row(result) for result in results)
    charts = "".join(
        f'<h2 id="{r.case.name}">{html.escape(r.case.title)}</h2><p>{html.escape(r.case.advice)} '
        f"Must reach: {html.escape(r.case.mark)}. Found: {html.escape(_found(r))}.</p>"
        f'<img src="{r.case.name}.png" alt="chart">'
        for r in results
        if not r.skipped
    )
    return (
        f"<!doctype html><meta charset=utf-8><title>Stability of {html.escape(name)}</title>"
        "<style>body{font:15px/1.4 sans-serif;margin:2em auto;max-width:70em}"
        "td,th{padding:4px 10px;text-align:left;vertical-align:top}img{max-width:100%}</style>"
        f"<h1>Stability of {html.escape(name)}</h1><p>{html.escape(json.dumps(settings))}</p>"
        "<table><tr><th>case<th>varies<th>must reach<th>found<th></tr>"
        f"{rows}</table>{charts}\n"
    )


def _table_row(result: Result) -> str:
    case = result.case
    cells = (case.varies, case.mark, _found(result))
    colour = _COLOURS[result.status]
    return (
        f'<tr><td><a href="#{case.name}">{case.name}</a>'
        + "".join(f"<td>{html.escape(cell)}" for cell in cells)
        + f'<td style="color:{colour}">{result.status}</tr>'
    )
