"""The report of a fit: candidates, costs, and why the next cheaper one failed."""

from __future__ import annotations

import base64
import io
from pathlib import Path

import matplotlib
import numpy as np

from rna_export.fit.fit_run import Fit
from rna_export.fit.search import FRACTIONS
from rna_export.html_pages import write_html
from rna_export.metrics import FLIP_DEFINITION, PSNR_DEFINITION

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def write_page(fit: Fit, asset: str, path: Path) -> None:
    """Write one HTML file that needs no other."""
    path.parent.mkdir(parents=True, exist_ok=True)
    write_html(
        path,
        "fit.html",
        fit=fit,
        asset=asset,
        why=_why(fit),
        chart=_chart(fit),
        rungs=[max(1, fit.steps // fraction) for fraction in FRACTIONS],
        psnr_definition=PSNR_DEFINITION,
        flip_definition=FLIP_DEFINITION,
    )


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


def _chart(fit: Fit) -> str:
    """Cost against error, a line for each model from rung to rung: a data address."""
    figure, axis = plt.subplots(figsize=(10, 4.2), layout="constrained")
    sign = 1.0 if fit.goal.metric == "max_error" else -1.0
    for candidate in fit.candidates:
        known = candidate.errors(fit.goal)
        errors = np.array([_readable(error, sign) for _, error in known])
        colour = "#2f6fb3" if candidate is fit.chosen else "#8a8f98"
        axis.plot([candidate.ns] * len(known), errors, "-", color=colour, lw=0.8, alpha=0.6)
        sizes = [12 + 14 * k for k in range(len(known))]
        axis.scatter([candidate.ns] * len(known), errors, s=sizes, c=colour)
    if fit.goal.limits_cost:
        axis.axvline(fit.goal.value, color="#d9822b", lw=1)
    else:
        axis.axhline(fit.goal.value, color="#d9822b", lw=1)
    axis.set(xscale="log", xlabel="ns/query, all threads")
    axis.set_ylabel("mean FLIP" if sign > 0.0 else "PSNR, dB")
    if sign > 0.0:
        axis.set_yscale("log")
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=110)
    plt.close(figure)
    return "data:image/png;base64," + base64.b64encode(buffer.getvalue()).decode()


def _readable(error_db: float, sign: float) -> float:
    return 10.0 ** (error_db / 10.0) if sign > 0.0 else -error_db
