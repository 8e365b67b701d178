"""The page that explains a fit: what was tried, what it costs, why the next cheaper one failed."""

from __future__ import annotations

import base64
import html
import io
from pathlib import Path

import matplotlib
import numpy as np

from rna_export.fit.candidate import Candidate
from rna_export.fit.run import Fit
from rna_export.fit.search import FRACTIONS
from rna_export.metrics import FLIP_DEFINITION, PSNR_DEFINITION

matplotlib.use("Agg")
import matplotlib.pyplot as plt

_STYLE = (
    "body{font:14px/1.5 sans-serif;margin:2em auto;max-width:1100px;background:#181818;color:#ddd}"
    "table{border-collapse:collapse}th,td{padding:4px 14px 4px 0;text-align:right;"
    "border-bottom:1px solid #333;white-space:nowrap}th:first-child,td:first-child,td:last-child,"
    "th:last-child{text-align:left;white-space:normal}tr.chosen{background:#26384a}"
    "img{max-width:100%}p{color:#aaa}"
)


def write_page(fit: Fit, asset: str, path: Path) -> None:
    """Write one HTML file that needs no other."""
    title = f"{asset}: {fit.goal}"
    chosen = fit.chosen
    page = (
        f"<!doctype html><html lang=en><meta charset=utf-8><title>{html.escape(title)}</title>"
        f"<style>{_STYLE}</style><h1>{html.escape(title)}</h1>"
        f"<h2>{html.escape(chosen.name)}, {chosen.ns:,.0f} ns a query</h2>"
        f"<p>{html.escape(_why(fit))}</p>{_chart(fit)}{_table(fit)}"
        f"<p>{fit.seconds:,.0f} s of training in all. Costs: {html.escape(fit.costs.machine)}, "
        f"{fit.costs.threads} threads, with random weights before any training.</p>"
        f"<p>{html.escape(PSNR_DEFINITION)}; FLIP: {html.escape(FLIP_DEFINITION)}</p>"
    )
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(page)


def _why(fit: Fit) -> str:
    found = fit.goal.error_db(fit.chosen.scores[fit.steps])
    said = f"After {fit.steps:,} steps it has {fit.goal.shown(found)}. "
    cheaper = [c for c in fit.candidates if c.ns < fit.chosen.ns]
    if fit.goal.limits_cost:
        dearer = [c for c in fit.candidates if c.ns > fit.goal.value]
        return said + f"{len(dearer)} of {len(fit.candidates)} models cost more than the limit."
    if not cheaper:
        return said + "No other model costs less."
    last = cheaper[-1]
    return said + f"The next cheaper one, {last.name} at {last.ns:,.0f} ns: {last.verdict}."


def _table(fit: Fit) -> str:
    rungs = [max(1, fit.steps // fraction) for fraction in FRACTIONS]
    heads = ["model", "ns a query", *(f"{steps:,} steps" for steps in rungs), ""]
    rows = "".join(_row(c, fit, rungs) for c in fit.candidates)
    return f"<table><tr>{''.join(f'<th>{h}</th>' for h in heads)}</tr>{rows}</table>"


def _row(candidate: Candidate, fit: Fit, rungs: list[int]) -> str:
    goal = fit.goal
    cells = [candidate.name, f"{candidate.ns:,.0f}"]
    for steps in rungs:
        scores = candidate.scores.get(steps)
        cells.append(goal.shown(goal.error_db(scores)) if scores else "")
    cells.append(candidate.verdict)
    mark = " class=chosen" if candidate is fit.chosen else ""
    return f"<tr{mark}>{''.join(f'<td>{html.escape(cell)}</td>' for cell in cells)}</tr>"


def _chart(fit: Fit) -> str:
    """Cost against error, a line for each model from rung to rung; embedded."""
    with plt.style.context("dark_background"):
        figure, axis = plt.subplots(figsize=(10, 4.2), layout="constrained")
        sign = 1.0 if fit.goal.metric == "max_error" else -1.0
        for candidate in fit.candidates:
            known = candidate.errors(fit.goal)
            errors = np.array([_readable(error, sign) for _, error in known])
            colour = "#5aa0e6" if candidate is fit.chosen else "#8a8f98"
            axis.plot([candidate.ns] * len(known), errors, "-", color=colour, lw=0.8, alpha=0.6)
            sizes = [12 + 14 * k for k in range(len(known))]
            axis.scatter([candidate.ns] * len(known), errors, s=sizes, c=colour)
        if fit.goal.limits_cost:
            axis.axvline(fit.goal.value, color="#e0a040", lw=1)
        else:
            axis.axhline(fit.goal.value, color="#e0a040", lw=1)
        axis.set(xscale="log", xlabel="ns a query, all threads")
        axis.set_ylabel("mean FLIP" if sign > 0.0 else "PSNR, dB")
        if sign > 0.0:
            axis.set_yscale("log")
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png", dpi=110)
        plt.close(figure)
    data = base64.b64encode(buffer.getvalue()).decode()
    return f'<img alt="cost against error" src="data:image/png;base64,{data}">'


def _readable(error_db: float, sign: float) -> float:
    return 10.0 ** (error_db / 10.0) if sign > 0.0 else -error_db
