"""The page of a comparison: a table of pictures, the numbers as JSON, and one sheet as PNG."""

from __future__ import annotations

import html
import json
from dataclasses import asdict
from pathlib import Path

import numpy as np
from PIL import Image

from rna_export.compare.run import Pair
from rna_export.metrics import (
    FLIP_DEFINITION,
    PSNR_DEFINITION,
    WITHOUT_NOISE_DEFINITION,
    NoiselessPsnr,
    display,
    to_png,
)

_STYLE = (
    "body{font:15px/1.4 sans-serif;margin:2em;background:#181818;color:#ddd}"
    "img{width:100%;display:block}td{padding:4px;vertical-align:top;width:25%}"
    "table{border-collapse:collapse;width:100%}th{text-align:left}"
)
_NUMBERS = ("psnr", "flip", "coverage", "seconds_ours", "seconds_cycles")


def write_page(folder: Path, title: str, pairs: list[Pair], settings: dict[str, object]) -> None:
    """Write `index.html`, `results.json`, `sheet.png` and the single pictures into `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    rows, strips = [], []
    for number, pair in enumerate(pairs):
        cells, images = [], _images(pair)
        strips.append(np.concatenate(list(images.values()), axis=1))
        for kind, image in images.items():
            name = f"{number}-{kind}.png"
            Image.fromarray(image).save(folder / name)
            cells.append(f'<td><img src="{name}" alt="{kind}">{_caption(kind, pair)}</td>')
        rows.append(f'<tr><th colspan="4">{html.escape(pair.shot.name)}</th></tr>')
        rows.append(f"<tr>{''.join(cells)}</tr>")
    summary = _summary(pairs)
    page = (
        f"<!doctype html><meta charset=utf-8><title>{html.escape(title)}</title>"
        f"<style>{_STYLE}</style><h1>{html.escape(title)}</h1>"
        f"<p>{html.escape(json.dumps(settings))}</p><p>mean PSNR {summary['psnr']:.2f} dB, "
        f"mean FLIP {summary['flip']:.4f}</p><p>{html.escape(PSNR_DEFINITION)}; FLIP: "
        f"{html.escape(FLIP_DEFINITION)}; without the noise of Cycles: "
        f"{html.escape(WITHOUT_NOISE_DEFINITION)}</p><table>{''.join(rows)}</table>"
    )
    (folder / "index.html").write_text(page)
    results = {"title": title, "settings": settings, **summary, "pictures": _numbers(pairs)}
    (folder / "results.json").write_text(json.dumps(results, indent=1) + "\n")
    Image.fromarray(np.concatenate(strips, axis=0)).save(folder / "sheet.png")


def _images(pair: Pair) -> dict[str, np.ndarray]:
    difference = np.abs(display(pair.ours) - display(pair.cycles))
    heat = np.repeat(np.clip(255.0 * pair.flip_map, 0, 255).astype(np.uint8)[..., None], 3, axis=2)
    return {
        "ours": to_png(pair.ours),
        "cycles": to_png(pair.cycles),
        "difference": np.clip(255.0 * 4.0 * difference, 0, 255).astype(np.uint8),
        "flip": heat,
    }


def _caption(kind: str, pair: Pair) -> str:
    return {
        "ours": f"ours, {pair.seconds_ours:.2f} s",
        "cycles": f"Cycles, {pair.seconds_cycles:.2f} s",
        "difference": f"difference x 4, PSNR {pair.psnr:.2f} dB, without the noise of Cycles "
        f"{pair.psnr_without_noise}",
        "flip": f"FLIP {pair.flip:.4f}",
    }[kind]


def _summary(pairs: list[Pair]) -> dict[str, object]:
    clean = NoiselessPsnr.mean([pair.psnr_without_noise for pair in pairs])
    means = {name: float(np.mean([getattr(pair, name) for pair in pairs])) for name in _NUMBERS}
    return {**means, "psnr_without_noise": asdict(clean)}


def _numbers(pairs: list[Pair]) -> list[dict[str, object]]:
    return [
        {
            "name": p.shot.name,
            **{n: getattr(p, n) for n in _NUMBERS},
            "psnr_without_noise": asdict(p.psnr_without_noise),
        }
        for p in pairs
    ]
