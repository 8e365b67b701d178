"""Training curves: `metrics.csv` as Lightning writes it, and a picture of it."""

from __future__ import annotations

import csv
from pathlib import Path


def draw_curves(folder: Path) -> None:
    """Write `<folder>/curves.png` from `<folder>/metrics.csv`, if that exists yet."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    path = folder / "metrics.csv"
    if not path.is_file():
        return
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.5), layout="constrained")
    left.semilogy(*_column(rows, "loss"))
    left.set(xlabel="step", ylabel="training loss")
    right.plot(*_column(rows, "psnr"), marker="o")
    right.set(xlabel="step", ylabel="validation PSNR (dB, irradiance pi, [0, 1])")
    figure.savefig(folder / "curves.png", dpi=100)
    plt.close(figure)


def _column(rows: list[dict[str, str]], name: str) -> tuple[list[int], list[float]]:
    pairs = [(int(r["step"]), float(r[name])) for r in rows if r.get(name)]
    return [step for step, _ in pairs], [value for _, value in pairs]
