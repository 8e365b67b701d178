"""The frontier as one page that needs nothing else: its numbers and pictures are inside."""

from __future__ import annotations

import base64
import html
import io
import json
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib
import numpy as np
from PIL import Image

from rna_bench.frontier.chart import COLOURS, LABELS
from rna_bench.frontier.findings import sentences
from rna_bench.frontier.paper_tables import paper_tables
from rna_bench.frontier.points import COSTS, ERRORS, label_of
from rna_export.capture.dataset import ValidationView
from rna_export.metrics import display, to_png

if TYPE_CHECKING:
    from rna_bench.frontier.study import Study

_PICTURE_BYTES = 4_000_000
_ONE_PICTURE_BYTES = 5_000  # about
_QUALITY = 80


def write_page(report: dict[str, Any], study: Study) -> None:
    """Write `index.html` with as many views a model as stay within a few MB."""
    views = study.dataset.validation_views()
    models = len(report["points"]) + len((report["cycles"] or {"points": []})["points"])
    fitting = _PICTURE_BYTES // (2 * _ONE_PICTURE_BYTES * max(models, 1))
    chosen = _chosen(views, int(np.clip(fitting, 1, 4)))
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


def _chosen(views: list[ValidationView], count: int) -> list[int]:
    """The views with the most light in them, the best first."""
    light = [float(display(view.samples["radiance"]).sum()) for view in views]
    return sorted(range(len(views)), key=lambda k: -light[k])[:count]


def _pictures(
    report: dict[str, Any], study: Study, chosen: list[int], size: int
) -> dict[str, dict[str, list[str]]]:
    """Point -> `render` and `flip` -> data addresses, one a chosen view."""
    strips = {
        label_of(p["name"], p["precision"]): study.out / "trials" / p["name"] / p["precision"]
        for p in report["points"]
    }
    if report["cycles"]:
        for point in report["cycles"]["points"]:
            name = f"cycles-{point['samples']}"
            strips[name] = study.out / name
    return {
        label: {
            "render": _cut(Path(f"{stem}-render.png"), chosen, size),
            "flip": _cut(Path(f"{stem}-flip.png"), chosen, size),
        }
        for label, stem in strips.items()
    }


def _cut(path: Path, chosen: list[int], size: int) -> list[str]:
    """Views out of a strip of all; errors, which are grey, in FLIP's colours."""
    with Image.open(path) as image:
        strip = np.asarray(image)
    if strip.ndim == 2:
        strip = (255.0 * matplotlib.colormaps["magma"](strip)[..., :3]).astype(np.uint8)
    return [_encoded(strip[:, k * size : (k + 1) * size]) for k in chosen]


def _encoded(pixels: np.ndarray) -> str:
    buffer = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(pixels)).save(buffer, "WEBP", quality=_QUALITY, method=6)
    return "data:image/webp;base64," + base64.b64encode(buffer.getvalue()).decode()
