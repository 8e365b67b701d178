"""The report of a comparison: a table of images, the numbers as JSON, and one sheet as PNG."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path

import numpy as np

from rna_export.compare.run import Pair
from rna_export.compare.sheet import comparison_sheet, pictures_of
from rna_export.html_pages import write_html
from rna_export.metrics import (
    FLIP_DEFINITION,
    PSNR_DEFINITION,
    WITHOUT_NOISE_DEFINITION,
    NoiselessPsnr,
)
from rna_export.pictures import write_picture
from rna_sdk.atomic_file import write_atomically

_NUMBERS = ("psnr", "flip", "coverage", "seconds_ours", "seconds_cycles")


def write_page(folder: Path, title: str, pairs: list[Pair], settings: dict[str, object]) -> None:
    """Write `index.html`, `results.json`, `sheet.png` and the single pictures into `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    rows, strips = [], []
    for number, pair in enumerate(pairs):
        images = _images(pair)
        strips.append((list(images.values()), _scores(pair)))
        pictures = [
            {"kind": kind, "file": f"{number}-{kind}.png", "caption": _caption(kind, pair)}
            for kind in images
        ]
        for picture, image in zip(pictures, images.values(), strict=True):
            write_picture(folder / picture["file"], image)
        rows.append((pair.shot.name, pictures))
    summary = _summary(pairs)
    write_html(
        folder / "index.html",
        "compare.html",
        title=title,
        settings=settings,
        summary=summary,
        rows=rows,
        psnr_definition=PSNR_DEFINITION,
        flip_definition=FLIP_DEFINITION,
        without_noise_definition=WITHOUT_NOISE_DEFINITION,
    )
    results = {"title": title, "settings": settings, **summary, "pictures": _numbers(pairs)}
    write_atomically(folder / "results.json", (json.dumps(results, indent=1) + "\n").encode())
    write_picture(folder / "sheet.png", comparison_sheet(strips))


def is_report(folder: Path) -> bool:
    """Whether a folder holds a report."""
    return all((folder / name).is_file() for name in ("index.html", "results.json", "sheet.png"))


def _images(pair: Pair) -> dict[str, np.ndarray]:
    pictures = pictures_of(pair.ours, pair.cycles)
    return dict(zip(("ours", "cycles", "difference", "flip"), pictures, strict=True))


def _scores(pair: Pair) -> str:
    clean = pair.psnr_without_noise
    bound = "at least " if clean.high is None else ""
    return f"{pair.shot.name}: PSNR without noise {bound}{clean.db:.1f} dB, FLIP {pair.flip:.3f}"


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
