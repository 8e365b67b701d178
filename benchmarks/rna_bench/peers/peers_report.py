"""The report of `rna-bench peers`: JSON, curves and sheets like the paper's."""

from pathlib import Path
from typing import Any

from rna_bench.peers.peers_sheets import TITLES, training_share, write_sheets
from rna_bench.peers.scoring import DEFINITIONS
from rna_bench.peers.study import Plan
from rna_bench.plot_style import OURS, figure, save_chart
from rna_bench.results import write_results
from rna_export.metrics import FLIP_DEFINITION

Row = dict[str, Any]


def write_report(
    out: Path,
    stamp: dict[str, Any] | None,
    settings: dict[str, Any],
    plan: Plan,
    rows: list[Row],
    ours: list[Row],
) -> None:
    """Write `peers.json`, `curves.svg` and sheets, with the images in `out`."""
    report = {**settings, "definitions": DEFINITIONS, "methods": rows}
    report["ours"] = [{k: v for k, v in row.items() if k != "images"} for row in ours]
    report["train_views"] = len(plan.train)
    report["exposure"] = {split: held.exposure for split, held in plan.held_out.items()}
    write_results(out / "peers.json", stamp, report)
    save_chart(_curves(plan, rows, ours), out / "curves.svg")
    sheets = write_sheets(out, plan, rows, ours)
    print(f"wrote {', '.join(str(out / name) for name in ('peers.json', 'curves.svg', *sheets))}")


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
    share = training_share(row["points"][-1])
    return f"{row['title']}, seed {row['seed']} ({share})"
