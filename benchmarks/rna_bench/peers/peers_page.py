"""The report of `rna-bench peers`: JSON, curves, a sheet like the paper's and a page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.bench_pages import write_html
from rna_bench.peers.scoring import DEFINITIONS, HeldOut
from rna_bench.peers.study import Plan, rendered
from rna_bench.plot_style import OURS, figure, save_chart
from rna_bench.results import write_results
from rna_export.metrics import FLIP_DEFINITION, IRRADIANCE, to_png

Row = dict[str, Any]

_SHOWN = 2  # views of a split in the sheet
_CROP = 0.4  # of the picture's side, in the close-up
TITLES = {"val": "light and camera apart", "val_collocated": "light at the camera"}


def write_page(
    out: Path,
    stamp: dict[str, Any] | None,
    settings: dict[str, Any],
    plan: Plan,
    rows: list[Row],
    ours: list[Row],
) -> None:
    """Write `peers.json`, `curves.svg`, `sheet.png` and `index.html`, with the images in `out`."""
    report = {**settings, "definitions": DEFINITIONS, "methods": rows}
    report["ours"] = [{k: v for k, v in row.items() if k != "images"} for row in ours]
    report["train_views"] = len(plan.train)
    report["exposure"] = {split: held.exposure for split, held in plan.held_out.items()}
    write_results(out / "peers.json", stamp, report)
    save_chart(_curves(plan, rows, ours), out / "curves.svg")
    _sheet(out, plan, rows, ours).savefig(out / "sheet.png", dpi=110)
    table = [(row, row["points"][-1], told_share(row["points"][-1])) for row in rows]
    values = {"name": settings["views"], "stamp": stamp, "settings": settings, "ours": ours}
    titles = {split: TITLES[split] for split in plan.held_out}
    write_html(out / "index.html", "peers.html", table=table, titles=titles, **values)
    print(f"wrote {out / 'index.html'}, {out / 'peers.json'}, {out / 'sheet.png'}")


def told_share(point: Row) -> str:
    """The share of the published schedule that a training had."""
    share = point["share_of_schedule"]
    return "schedule not published" if share is None else f"{100.0 * share:.2g}% of the schedule"


def _curves(plan: Plan, rows: list[Row], ours: list[Row]) -> Any:
    splits = list(plan.held_out)
    chart = figure(11.0, 3.2 * len(splits))
    grid = chart.subplots(len(splits), 3, squeeze=False)
    axes_of = (
        ("cpu_minutes", "psnr", "CPU minutes", "PSNR, dB"),
        ("cpu_minutes", "flip", "CPU minutes", FLIP_DEFINITION.split(" of ")[0]),
        ("samples", "psnr", "pixels seen", "PSNR, dB"),
    )
    for split, line in zip(splits, grid, strict=True):
        for axes, (x, y, x_title, y_title) in zip(line, axes_of, strict=True):
            for row in rows:
                xs = [point[x] for point in row["points"]]
                ys = [point["scores"][split][y] for point in row["points"]]
                axes.plot(xs, ys, "o-", label=_label(row))
            for row in ours:
                level = row["scores"][split][y]
                axes.axhline(level, color=OURS, linestyle="--", label=row["title"])
            axes.set(xscale="log", xlabel=x_title, ylabel=y_title, title=TITLES[split])
    lines = grid[0, 0].get_legend_handles_labels()
    chart.legend(*lines, loc="outside lower center", ncols=3)
    return chart


def _label(row: Row) -> str:
    share = told_share(row["points"][-1])
    return f"{row['title']}, seed {row['seed']} ({share})"


def _sheet(out: Path, plan: Plan, rows: list[Row], ours: list[Row]) -> Any:
    """Columns: reference, ours, peers of the first seed; pictures above close-ups."""
    first = [row for row in rows if row["seed"] == rows[0]["seed"]]
    columns = 1 + len(ours) + len(first)
    shown = [
        (s, k) for s, held in plan.held_out.items() for k in range(min(_SHOWN, len(held.views)))
    ]
    chart = figure(2.1 * columns, 4.9 * len(shown))
    grid = chart.subplots(2 * len(shown), columns, squeeze=False)
    for pair, (split, k) in enumerate(shown):
        held = plan.held_out[split]
        images = [("reference", held.views.rgba[k, ..., :3], "")]
        for row in ours:
            images.append((row["title"], row["images"][split][k], _told(row["scores"], split, k)))
        for row in first:
            image = rendered(out, row["method"], row["seed"], split)[k]
            last = row["points"][-1]
            title = f"{row['title']}\n{last['cpu_minutes']:.1f} CPU min, {told_share(last)}"
            images.append((title, image, _told(last["scores"], split, k)))
        for column, (title, image, told) in enumerate(images):
            _draw(grid[2 * pair : 2 * pair + 2, column], image, held, title, told)
    return chart


def _told(scores: Row, split: str, k: int) -> str:
    return f"{scores[split]['each'][k]:.2f} dB"


def _draw(axes: Any, image: np.ndarray, held: HeldOut, title: str, told: str) -> None:
    picture = to_png(image / IRRADIANCE, held.exposure)
    size = picture.shape[0]
    low, high = round((0.5 - _CROP / 2) * size), round((0.5 + _CROP / 2) * size)
    for one, shown in zip(axes, (picture, picture[low:high, low:high]), strict=True):
        one.set_axis_off()
        one.imshow(shown, interpolation="nearest")
    axes[0].set_title("\n".join(_wrapped(title)), fontsize=6.5)
    axes[1].set_title(told, fontsize=8)


def _wrapped(title: str) -> list[str]:
    from textwrap import wrap

    return [line for part in title.split("\n") for line in wrap(part, 26)]
