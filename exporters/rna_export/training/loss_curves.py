"""The curves of a training: `metrics.csv`, one row per validation, and a plot."""

from __future__ import annotations

import csv
import gc
import io
from pathlib import Path

from rna_sdk.atomic_file import write_atomically
from rna_sdk.errors import TrainingError

_COLUMNS = ("step", "loss", "psnr", "flip", "emission_psnr")
"""step: steps done. loss: the mean since the row before. The others: see `Report`."""


class Curves:
    """Rows of `<folder>/metrics.csv`, from before step `done` on."""

    def __init__(self, folder: Path, done: int = 0):
        self._folder = folder
        self.rows = [row for row in read_curves(folder) if row["step"] <= done]

    @property
    def best_psnr(self) -> float:
        """Best PSNR of all rows; minus infinity if there are none."""
        return max((row["psnr"] for row in self.rows), default=float("-inf"))

    def add(self, row: dict[str, float]) -> None:
        """Write the file with one more row."""
        self.rows.append(row)
        text = io.StringIO()
        writer = csv.DictWriter(text, _COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(self.rows)
        write_atomically(self._folder / "metrics.csv", text.getvalue().encode())

    def draw(self) -> None:
        """Write `<folder>/curves.png`."""
        import matplotlib

        matplotlib.use("Agg")
        import matplotlib.pyplot as plt

        figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.5), layout="constrained")
        steps = [row["step"] for row in self.rows]
        left.semilogy(steps, [row["loss"] for row in self.rows], marker=".")
        left.set(xlabel="step", ylabel="training loss")
        right.plot(steps, [row["psnr"] for row in self.rows], marker="o")
        right.set(xlabel="step", ylabel="validation PSNR (dB, irradiance pi, [0, 1])")
        picture = io.BytesIO()
        figure.savefig(picture, format="png", dpi=100)
        write_atomically(self._folder / "curves.png", picture.getvalue())
        plt.close(figure)
        gc.collect()  # matplotlib's reference cycles hold all callers' frames, and their samples


def read_curves(folder: Path) -> list[dict[str, float]]:
    """The rows of `<folder>/metrics.csv`; none where there is no such file.

    Raises `TrainingError` for another kind of file.
    """
    path = folder / "metrics.csv"
    if not path.is_file():
        return []
    try:
        with path.open(newline="") as file:
            rows = [{k: float(v) for k, v in row.items() if v} for row in csv.DictReader(file)]
        return [{**row, "step": int(row["step"]), "psnr": row["psnr"]} for row in rows]
    except (KeyError, TypeError, ValueError) as error:
        raise TrainingError(f"{path}: not the curves of rna-train: {error!r}") from error
