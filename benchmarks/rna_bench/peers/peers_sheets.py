"""Sheets like the paper's: reference, ours and other methods, whole and close, PSNR below."""

from dataclasses import dataclass
from pathlib import Path
from textwrap import wrap
from typing import Any

import numpy as np

from rna_bench.peers.scoring import HeldOut
from rna_bench.peers.study import Plan, rendered
from rna_bench.plot_style import figure, save_chart
from rna_export.metrics import IRRADIANCE, to_png

Row = dict[str, Any]

TITLES = {"val": "light and camera apart", "val_collocated": "light at the camera"}
_CROP = 0.4  # of the picture's side, in the close-up


@dataclass(frozen=True)
class Sheet:
    """A figure. methods: its columns behind ours. splits, views: its rows."""

    title: str
    methods: tuple[str, ...]
    splits: tuple[str, ...] = ("val",)
    views: int = 2


SHEETS = {
    "comparison": Sheet("Other methods", ("nrhints", "fields", "fields-fur", "analytic")),
    "geometry": Sheet(
        "NRHints with more and more geometry",
        ("nrhints", "nrhints-geometry-low", "nrhints-geometry", "nrhints-known"),
    ),
    "lights": Sheet(
        "Trained with the light at the camera, shown with that light and another",
        ("fields", "fields-fur"),
        ("val_collocated", "val"),
        views=1,
    ),
}


def write_sheets(out: Path, plan: Plan, rows: list[Row], ours: list[Row]) -> list[str]:
    """Write `sheet-NAME.png` of each sheet that has a method; returns the files' names.

    Methods are shown with their first seed.
    """
    written = []
    first = {row["method"]: row for row in reversed(rows)}
    for name, sheet in SHEETS.items():
        shown = [first[method] for method in sheet.methods if method in first]
        splits = [split for split in sheet.splits if split in plan.held_out]
        if not shown or not splits:
            continue
        file = f"sheet-{name}.png"
        save_chart(_drawn(out, plan, sheet, splits, shown, ours), out / file)
        written.append(file)
    return written


def training_share(point: Row) -> str:
    """The share of the published schedule that a training had."""
    share = point["share_of_schedule"]
    return "schedule not published" if share is None else f"{100.0 * share:.2g}% of the schedule"


def _drawn(
    out: Path, plan: Plan, sheet: Sheet, splits: list[str], shown: list[Row], ours: list[Row]
) -> Any:
    cells = [(s, k) for s in splits for k in range(min(sheet.views, len(plan.held_out[s].views)))]
    columns = 1 + len(ours) + len(shown)
    chart = figure(2.1 * columns, 0.3 + 4.9 * len(cells))
    title = f"{sheet.title}; {', then '.join(TITLES[split] for split in splits)}"
    chart.suptitle("\n".join(wrap(title, 20 * columns)))
    grid = chart.subplots(2 * len(cells), columns, squeeze=False)
    for pair, (split, k) in enumerate(cells):
        held = plan.held_out[split]
        images = [("reference", held.views.rgba[k, ..., :3], "")]
        images += [(_of_ours(row), row["images"][split][k], _psnr(row, split, k)) for row in ours]
        for row in shown:
            image = rendered(out, row["method"], row["seed"], split)[k]
            images.append((_of_method(row), image, _psnr(row["points"][-1], split, k)))
        for column, (title, image, caption) in enumerate(images):
            _draw(grid[2 * pair : 2 * pair + 2, column], image, held, title, caption)
    return chart


def _of_ours(row: Row) -> str:
    return (
        f"{row['title']}\n{_size(row['parameters'])}, {row['frame_cpu_seconds']:.2g} CPU s a frame"
    )


def _of_method(row: Row) -> str:
    last = row["points"][-1]
    spent = f"{last['cpu_minutes']:.1f} CPU min, {training_share(last)}"
    frame = f"{_size(row['parameters'])}, {last['frame_cpu_seconds']:.2g} CPU s a frame"
    return f"{row['title']}\n{spent}\n{frame}"


def _size(parameters: int) -> str:
    return f"{parameters / 1e6:.2f} M parameters"


def _psnr(scored: Row, split: str, k: int) -> str:
    return f"{scored['scores'][split]['each'][k]:.2f} dB"


def _draw(axes: Any, image: np.ndarray, held: HeldOut, title: str, caption: str) -> None:
    picture = to_png(image / IRRADIANCE, held.exposure)
    size = picture.shape[0]
    low, high = round((0.5 - _CROP / 2) * size), round((0.5 + _CROP / 2) * size)
    for one, shown in zip(axes, (picture, picture[low:high, low:high]), strict=True):
        one.set_axis_off()
        one.imshow(shown, interpolation="nearest")
    lines = [line for part in title.split("\n") for line in wrap(part, 30)]
    axes[0].set_title("\n".join(lines), fontsize=6.5)
    axes[1].set_title(caption, fontsize=8)
