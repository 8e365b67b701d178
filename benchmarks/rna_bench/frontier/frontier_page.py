"""The frontier as one page that needs nothing else: its numbers and pictures are inside."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.bench_pages import webp_address, write_html
from rna_bench.frontier.chart_points import COSTS, ERRORS, label_of
from rna_bench.frontier.findings import sentences
from rna_bench.frontier.frontier_chart import COLOURS, LABELS
from rna_bench.frontier.paper_tables import paper_tables
from rna_bench.frontier.render_strips import brightest, cut, strip_path
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.metrics import to_png

_PICTURE_BYTES = 4_000_000
_ONE_PICTURE_BYTES = 5_000  # about


def write_page(
    folder: Path, stamp: dict[str, Any], report: dict[str, Any], views: list[ValidationView]
) -> None:
    """Write `index.html` with as many views a model as stay within a few MB.

    folder: of the study.
    """
    models = len(report["points"]) + len((report["cycles"] or {"points": []})["points"])
    fitting = _PICTURE_BYTES // (2 * _ONE_PICTURE_BYTES * max(models, 1))
    chosen = brightest(views, int(np.clip(fitting, 1, 4)))
    data = {
        "report": report,
        "costs": COSTS,
        "errors": ERRORS,
        "colours": COLOURS,
        "labels": LABELS,
        "sentences": sentences(report["findings"]),
        "tables": paper_tables(report["points"]),
        "views": [views[k].index for k in chosen],
        "references": [
            webp_address(to_png(views[k].image(views[k].samples["radiance"]))) for k in chosen
        ],
        "pictures": _pictures(report, folder, chosen, views[0].resolution),
    }
    title = f"{report['dataset']['name']}: cost against accuracy"
    write_html(folder / "index.html", "frontier.html", title=title, stamp=stamp, data=data)


def _pictures(
    report: dict[str, Any], folder: Path, chosen: list[int], size: int
) -> dict[str, dict[str, list[str]]]:
    """Point -> `render` and `flip` -> data addresses, one a chosen view."""
    labels = [label_of(p["name"], p["precision"]) for p in report["points"]]
    if report["cycles"]:
        labels += [f"cycles-{point['samples']}" for point in report["cycles"]["points"]]

    def addresses(label: str, what: str) -> list[str]:
        return [webp_address(view) for view in cut(strip_path(folder, label, what), chosen, size)]

    return {
        label: {what: addresses(label, what) for what in ("render", "flip")} for label in labels
    }
