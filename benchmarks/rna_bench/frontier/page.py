"""The frontier as one page that needs nothing else: its numbers and pictures are inside."""

from __future__ import annotations

import base64
import html
import io
import json
from importlib.resources import files
from typing import TYPE_CHECKING, Any

import numpy as np
from PIL import Image

from rna_bench.frontier.chart import COLOURS, LABELS
from rna_bench.frontier.findings import sentences
from rna_bench.frontier.paper_tables import paper_tables
from rna_bench.frontier.pictures import brightest, cut
from rna_bench.frontier.points import COSTS, ERRORS, label_of
from rna_export.capture.validation_view import ValidationView
from rna_export.metrics import to_png

if TYPE_CHECKING:
    from rna_bench.frontier.study import Study

_PICTURE_BYTES = 4_000_000
_ONE_PICTURE_BYTES = 5_000  # about
_QUALITY = 80


def write_page(report: dict[str, Any], study: Study, views: list[ValidationView]) -> None:
    """Write `index.html` with as many views a model as stay within a few MB."""
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
            _encoded(to_png(views[k].image(views[k].samples["radiance"]))) for k in chosen
        ],
        "pictures": _pictures(report, study, chosen, views[0].resolution),
    }
    text = json.dumps(data, separators=(",", ":")).replace("</", "<\\/")
    page = files("rna_bench.frontier").joinpath("page.html").read_text()
    title = f"{report['dataset']['name']}: cost against accuracy"
    page = page.replace("__TITLE__", html.escape(title)).replace("__DATA__", text)
    (study.out / "index.html").write_text(page)


def _pictures(
    report: dict[str, Any], study: Study, chosen: list[int], size: int
) -> dict[str, dict[str, list[str]]]:
    """Point -> `render` and `flip` -> data addresses, one a chosen view."""
    labels = [label_of(p["name"], p["precision"]) for p in report["points"]]
    if report["cycles"]:
        labels += [f"cycles-{point['samples']}" for point in report["cycles"]["points"]]
    return {
        label: {
            what: [_encoded(view) for view in cut(study.strip(label, what), chosen, size)]
            for what in ("render", "flip")
        }
        for label in labels
    }


def _encoded(pixels: np.ndarray) -> str:
    buffer = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(pixels)).save(buffer, "WEBP", quality=_QUALITY, method=6)
    return "data:image/webp;base64," + base64.b64encode(buffer.getvalue()).decode()
