"""The paper's ablations row for row, its PSNR beside ours.

The paper's numbers are of its Lego asset, its own images and its own definition: columns compare
within themselves, not with each other.
"""

from typing import Any

from rna_bench.frontier.chart_points import label_of
from rna_bench.frontier.trials.grid import PAPER_ARCHITECTURES, PAPER_CHANNELS

_PAPER_ARCHITECTURE_PSNR = (27.47, 27.36, 28.77, 31.02, 32.68, 33.07, 33.80, 34.09, 34.20, 34.90)
_PAPER_CHANNELS_PSNR = (33.51, 34.09, 34.40, 34.33)

_ABLATIONS = {
    "our-optimizer": "with our optimizer",
    "no-h": "without h",
    "no-learned-normal": "without the learned normal",
    "paper-inputs": "with the paper's inputs",
}


Row = tuple[dict[str, Any], list[str]]
"""A point, and its cells."""


def paper_tables(points: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Tables of `title`, `head`, `rows` and each row's point, without untrained models."""
    on_lego = ["PSNR here", "the paper's, on Lego"]
    return [
        _table(
            "Architecture, the paper's models", ["layers x width", *on_lego], _architecture(points)
        ),
        _table("Channels, the paper's 4 x 512", ["channels", *on_lego], _channels(points)),
        _table("What a part is worth", ["model", "PSNR", "FLIP", "p99"], _ablations(points)),
    ]


def _table(title: str, head: list[str], rows: list[Row]) -> dict[str, Any]:
    return {
        "title": title,
        "head": head,
        "rows": [cells for _, cells in rows],
        "points": [label_of(p["name"], p["precision"]) for p, _ in rows],
    }


def _architecture(points: list[dict[str, Any]]) -> list[Row]:
    rows = []
    for (layers, width), psnr in zip(PAPER_ARCHITECTURES, _PAPER_ARCHITECTURE_PSNR, strict=True):
        for p in _of(points, "architecture"):
            if (p["hidden_layers"], p["width"]) == (layers, width):
                rows.append((p, [f"{layers} x {width}", f"{p['psnr']:.2f}", f"{psnr:.2f}"]))
    return rows


def _channels(points: list[dict[str, Any]]) -> list[Row]:
    rows = []
    for channels, psnr in zip(PAPER_CHANNELS, _PAPER_CHANNELS_PSNR, strict=True):
        for p in _of(points, "channels"):
            if p["channels"] == channels:
                rows.append((p, [str(channels), f"{p['psnr']:.2f}", f"{psnr:.2f}"]))
    return rows


def _ablations(points: list[dict[str, Any]]) -> list[Row]:
    """Each beside our model of the same width, planes and channels of a preset."""
    rows: list[Row] = []
    whole = [
        p for p in _first_precision(points) if p["family"] == "ours" and p["hidden_layers"] == 4
    ]
    for p in (p for p in _first_precision(points) if p["family"] == "ablation"):
        for q in whole:
            same = all(q[key] == p[key] for key in ("width", "resolution", "channels"))
            if same and (q, _cells(q["name"], q)) not in rows:
                rows.append((q, _cells(q["name"], q)))
        rows.append((p, _cells(f"{p['name']}: {_ABLATIONS[p['tables'][0]]}", p)))
    return rows


def _cells(name: str, p: dict[str, Any]) -> list[str]:
    return [name, f"{p['psnr']:.2f}", f"{p['flip']:.4f}", f"{p['p99']:.2f}"]


def _of(points: list[dict[str, Any]], table: str) -> list[dict[str, Any]]:
    return [p for p in _first_precision(points) if table in p["tables"]]


def _first_precision(points: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Each trial once, at the precision that loses nothing."""
    return list({p["name"]: p for p in reversed(points)}.values())[::-1]
