"""The scenes as one page that needs nothing else."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rna_bench.bench_pages import webp_address, write_html
from rna_bench.scenes.judge import shown_pictures
from rna_bench.scenes.measured_scene import MeasuredScene
from rna_bench.scenes.time_chart import svg_address

_QUALITY = 92


def write_page(
    path: Path, stamp: dict[str, Any], report: dict[str, Any], done: Sequence[MeasuredScene]
) -> None:
    """report: what `scenes.json` has."""
    pictures = {one.name: _pictures(one) for one in done}
    charts = {one.name: svg_address(report["scenes"][one.name]) for one in done}
    values = {"report": report, "pictures": pictures, "charts": charts}
    write_html(path, "scenes.html", stamp=stamp, **values)


def _pictures(measured: MeasuredScene) -> list[dict[str, Any]]:
    return [
        {
            "caption": shown.caption,
            "picture": webp_address(shown.picture, _QUALITY),
            "flip": None if shown.flip is None else webp_address(shown.flip, _QUALITY),
            "flip_mean": shown.flip_mean,
        }
        for shown in shown_pictures(measured)
    ]
