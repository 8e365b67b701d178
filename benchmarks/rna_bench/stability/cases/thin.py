"""Surfaces so near to one another that the triplane gives them the same features."""

import numpy as np
import torch
from matplotlib.figure import FigureBase

from rna_bench.stability.answers import of_model, picked
from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.chosen import ChosenSamples, Samples, rows_of
from rna_bench.stability.fixtures import Fixtures
from rna_bench.stability.view_errors import joined_views, relative_error
from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_sdk.package import Curves

FACTOR = 1.4  # the mark

SHAPES = {"leaf": "surface", "wire": "surface", "strands": "fiber"}
_SHOWN = {
    "folded": ("C1", "where surfaces share texels"),
    "alone": ("C0", "there, trained on one side"),
    "clear": ("C2", "where none share texels"),
}
_POINTS = 1_000_000  # that say which cells hold several surfaces


def measure(fixtures: Fixtures) -> list[Row]:
    rows = []
    for shape, kind in SHAPES.items():
        dataset = fixtures.capture(
            f"thin-{shape}",
            "thin.py",
            shape,
            lights=fixtures.some(300),
            rays=4096,
            samples=2,
            validation_views=4,
            validation_resolution=128,
            validation_samples=32,
        )
        preset = fixtures.preset(kind)
        model = fixtures.train("small", dataset, preset).model
        samples, halves = joined_views(dataset.validation_views())
        cells = Cells.of(model.triplane.low, model.triplane.high, model.config.resolution)
        folded = np.isin(cells.numbers(samples["position"]), folded_cells(dataset, cells))
        if shape == "leaf":
            # Its rim, where it folds, is a hard place, too: what would one side alone give there?
            up = facing_up(samples)
            one_side = ChosenSamples(dataset, lambda some: rows_of(some, facing_up(some)))
            alone = fixtures.train("one-side", one_side, preset).model
            models = {"folded": (model, folded & up), "alone": (alone, folded & up)}
        else:
            models = {"folded": (model, folded), "clear": (model, ~folded)}
        for where, (answering, points) in models.items():
            shaded = picked(of_model(answering), rows_of(samples, points))
            error = relative_error(shaded, halves[:, points])
            share = float(points.mean())
            rows.append({"shape": shape, "where": where, "share": share, "error": error})
    return rows


def facing_up(samples: Samples) -> np.ndarray:
    """Whether each normal is within 45 degrees of +Y: no two of these are opposed."""
    return samples["normal"][:, 1] > np.sqrt(0.5)


class Cells:
    """Cubes of one texel a side: points in one of them have the same texels on all planes."""

    def __init__(self, low: np.ndarray, high: np.ndarray, resolution: int):
        self._low, self._scale, self._resolution = low, resolution / (high - low), resolution

    @classmethod
    def of(cls, low: torch.Tensor, high: torch.Tensor, resolution: int) -> "Cells":
        return cls(low.numpy(), high.numpy(), resolution)

    def numbers(self, positions: np.ndarray) -> np.ndarray:
        """The cell of each position (n, 3), (n,) int64."""
        at = ((positions - self._low) * self._scale).astype(np.int64)
        x, y, z = np.clip(at, 0, self._resolution - 1).T
        return (x * self._resolution + y) * self._resolution + z


def folded_cells(dataset: DatasetPart, cells: Cells) -> np.ndarray:
    """Numbers of cells that hold both sides of a sheet, or points of several strands."""
    geometry = dataset.geometry()
    if isinstance(geometry, Curves):
        return several_strands(geometry, cells)
    points, normals = scene_of(dataset.dataset).sample_points(_POINTS, np.random.default_rng(31))
    return opposed(cells.numbers(points), normals)


def opposed(cell: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Numbers of the cells (n,) in which some normals (n, 3) point against others."""
    numbers, first, inverse = np.unique(cell, return_index=True, return_inverse=True)
    against = np.sum(normals * normals[first][inverse], axis=1) < 0.0
    return numbers[np.bincount(inverse, against, len(numbers)) > 0]


def several_strands(curves: Curves, cells: Cells) -> np.ndarray:
    """Numbers of the cells that more than one strand passes through."""
    strand = np.repeat(np.arange(len(curves.offsets) - 1), np.diff(curves.offsets.astype(int)))
    first = curves.segments()
    steps = np.linspace(0.0, 1.0, 32)[:, None, None]
    points = (1.0 - steps) * curves.points[first] + steps * curves.points[first + 1]
    cell = cells.numbers(points.reshape(-1, 3))
    pairs = np.unique(np.stack([cell, np.tile(strand[first], len(steps))]), axis=1)
    numbers, count = np.unique(pairs[0], return_counts=True)
    return numbers[count > 1]


def judge(rows: list[Row]) -> Verdict:
    folded = {row["shape"]: row["error"] for row in rows if row["where"] == "folded"}
    other = {row["shape"]: row["error"] for row in rows if row["where"] != "folded"}
    factors = {shape: error / other[shape] for shape, error in folded.items()}
    figures = ", ".join(f"{shape} {factor:.2f} times" for shape, factor in factors.items())
    return Verdict(
        max(factors.values()) <= FACTOR, f"the error where folded: {figures} that elsewhere"
    )


def draw(figure: FigureBase, rows: list[Row]) -> None:
    axes = figure.subplots()
    shapes = list(dict.fromkeys(values(rows, "shape")))
    for where, (colour, label) in _SHOWN.items():
        shown = [row for row in rows if row["where"] == where]
        at = [shapes.index(row["shape"]) + (0.2 if where == "folded" else -0.2) for row in shown]
        bars = axes.bar(at, values(shown, "error"), 0.4, color=colour, label=label)
        axes.bar_label(bars, [f"{row['share']:.0%} of pixels" for row in shown])
    axes.margins(y=0.12)
    axes.set_xticks(range(len(shapes)), shapes)
    axes.set_ylabel("error over the mean radiance there")
    axes.legend()


CASE = Case(
    name="thin",
    title="Thin and dense geometry",
    varies="several surfaces in one texel against one: a leaf, wires, strands of the suite's own",
    mark="error over mean radiance at most 1.4 times that where none are shared, or of one side",
    measure=measure,
    judge=judge,
    draw=draw,
)
