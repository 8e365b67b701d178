"""One look for all charts: import it before drawing; colours mean the same everywhere."""

from pathlib import Path

import matplotlib
from cycler import cycler
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

matplotlib.use("Agg")

OURS, CYCLES, PAPER, OPPONENT, QUIET = "#2f6fb3", "#b0407a", "#d9822b", "#3d8f5f", "#8a8f98"
PASS, FAIL = "#2a7d2a", "#b3261e"

matplotlib.rcParams.update(
    {
        "font.size": 9,
        "axes.titlesize": 9,
        "axes.titlelocation": "left",
        "legend.fontsize": 8,
        "axes.grid": True,
        "grid.alpha": 0.25,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.prop_cycle": cycler(color=[OURS, PAPER, OPPONENT, CYCLES, QUIET]),
        "lines.markersize": 4,
        "lines.linewidth": 1.2,
        "svg.fonttype": "none",
        "svg.hashsalt": "rna-bench",
    }
)


def figure(width: float, height: float) -> Figure:
    """An empty figure of the given size in inches."""
    return Figure(figsize=(width, height), layout="constrained")


def log_ticks(axis: Axis) -> None:
    """Ticks of a logarithmic axis of a decade or two: 1, 2, 5, written as plain numbers."""
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())


def save_chart(chart: Figure, path: Path) -> None:
    """Writes SVG (the same bytes for the same chart) or PNG, chosen by the suffix."""
    chart.savefig(path, dpi=110, metadata={"Date": None} if path.suffix == ".svg" else None)
