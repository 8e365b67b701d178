"""Error over CPU time of scenes rendered by rays and by lobes."""

from __future__ import annotations

from typing import Any

from matplotlib.figure import Figure

from rna_bench.plot_style import OURS, PAPER, figure

_COLUMNS = 4
_LINES = {"rays": ("environment by rays", OURS), "lobes": ("environment by lobes", PAPER)}


def draw_errors(scenes: dict[str, Any]) -> Figure:
    """scenes: by name, as `rna-bench lobes-scenes` measures them. One panel each."""
    rows = -(-len(scenes) // _COLUMNS)
    chart = figure(3.2 * min(_COLUMNS, len(scenes)), 2.6 * rows + 0.4)
    panels = chart.subplots(rows, min(_COLUMNS, len(scenes)), squeeze=False).reshape(-1)
    for panel, (name, scene) in zip(panels, scenes.items(), strict=False):
        for way, (label, colour) in _LINES.items():
            points = [(row["cpu_seconds"], row["error"]) for row in scene[way]]
            panel.loglog(*zip(*points, strict=True), "o-", color=colour, label=label)
        bias = scene["bias"]
        label = f"bias of lobes, {bias['samples']} samples"
        panel.axhline(bias["error"], color=PAPER, ls=":", lw=0.8, label=label)
        panel.set_title(name)
        panel.set_xlabel("CPU seconds")
    for panel in panels[len(scenes) :]:
        panel.set_axis_off()
    panels[0].set_ylabel("relative squared error")
    lines = panels[0].get_legend_handles_labels()
    chart.legend(*lines, loc="outside lower center", ncols=3)
    return chart
