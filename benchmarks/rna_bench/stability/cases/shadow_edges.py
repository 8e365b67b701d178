"""Where light ends: at the terminator and at edges of cast shadows.

Errors of radiance are larger there than elsewhere in any picture, as brightness changes within a
pixel; FLIP tells what of them is seen. Without the hint edges are smeared: 0.25 on the toy.
"""

from dataclasses import replace

import numpy as np
from matplotlib.figure import FigureBase

from rna_bench.stability.answers import Answers, of_model, picked
from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.chosen import ChosenSamples, Samples
from rna_bench.stability.fixtures import Fixtures
from rna_export.capture.dataset.validation_view import ValidationView, is_lit
from rna_export.metrics import display, flip

FLIP = 0.2  # the mark
NEAR = 2  # pixels from an edge on both sides

_REACH = 8  # pixels to both sides
_TERMINATOR = np.sin(np.radians(10.0))  # |n.wi| below: the surface turns away from the light
_SAME_SURFACE = 3.0  # neighbours within this many typical steps from pixel to pixel


def measure(fixtures: Fixtures) -> list[Row]:
    dataset = fixtures.dataset
    blind = ChosenSamples(dataset, without_hint, _view_without_hint)
    preset = fixtures.preset(dataset.kind)
    models = {
        "with the hint": of_model(fixtures.base.model),
        "without": _hint_blind(of_model(fixtures.train("no-hint", blind, preset).model)),
    }
    views = dataset.validation_views()
    return [
        {"model": name, **row}
        for name, answers in models.items()
        for row in profile(answers, views)
    ]


def without_hint(samples: Samples) -> Samples:
    """The samples with visibility 1, as for a model without the hint."""
    return {**samples, "visible": np.ones_like(samples["visible"])}


def _view_without_hint(view: ValidationView) -> ValidationView:
    return replace(view, samples=without_hint(view.samples))


def _hint_blind(answers: Answers) -> Answers:
    """One answer, whether the light is visible or not."""
    return lambda queries: (answers(queries)[0],) * 2


def profile(answers: Answers, views: list[ValidationView]) -> list[Row]:
    """Mean radiance and FLIP by the distance to the nearest edge, pixels; negative in shadow."""
    shaded = [picked(answers, view.samples) for view in views]
    shown = {
        "mean": display(np.concatenate([view.reference for view in views])).mean(axis=1),
        "ours": display(np.concatenate(shaded)).mean(axis=1),
        "flip": np.concatenate([_flips(v, s) for v, s in zip(views, shaded, strict=True)]),
    }
    placed = [signed_distance(view) for view in views]
    rows = []
    for kind in ("terminator", "cast shadow"):
        distance = np.concatenate([one[kind] for one in placed])
        for pixels in (*range(-_REACH, 0), *range(1, _REACH + 1)):
            at = distance == pixels
            if at.sum() >= 20:
                means = {name: float(each[at].mean()) for name, each in shown.items()}
                rows.append({"edge": kind, "pixels": pixels, "samples": int(at.sum()), **means})
    return rows


def _flips(view: ValidationView, radiance: np.ndarray) -> np.ndarray:
    """FLIP of the view's rows, (n,)."""
    _, error = flip(view.image(radiance), view.image(view.reference))
    return error.reshape(-1)[view.pixel]


def signed_distance(view: ValidationView) -> dict[str, np.ndarray]:
    """Distance to the nearest edge of each kind in pixels, (n,): 1 beside it, 0 out of reach.

    A terminator is where the surface itself turns away from the light; every other change between
    light and shadow on one surface is a cast shadow's. Fibers have cast shadows only.
    """
    n = view.resolution
    index = np.full(n * n, -1)
    index[view.pixel] = np.arange(len(view.pixel))
    index = np.pad(index.reshape(n, n), 1, constant_values=-1)
    lit, position = is_lit(view.samples["visible"]), view.samples["position"]
    turned = _turned_away(view.samples)
    seeds = {kind: np.zeros(len(lit), bool) for kind in ("terminator", "cast shadow")}
    for a, b in _neighbours(index):
        step = np.linalg.norm(position[a] - position[b], axis=1)
        edge = (lit[a] != lit[b]) & (step < _SAME_SURFACE * np.median(step))
        at_terminator = turned[a] & turned[b]
        for kind, rows in (("terminator", at_terminator), ("cast shadow", ~at_terminator)):
            seeds[kind][a[edge & rows]] = seeds[kind][b[edge & rows]] = True
    sign = np.where(lit, 1, -1)
    return {kind: sign * _grown(seed, index, lit) for kind, seed in seeds.items()}


def _turned_away(samples: Samples) -> np.ndarray:
    if "normal" not in samples:
        return np.zeros(len(samples["wi"]), bool)
    return np.abs(np.sum(samples["normal"] * samples["wi"], axis=1)) < _TERMINATOR


def _neighbours(index: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
    """Row numbers of pixels beside and above one another, both on the asset."""
    pairs = []
    for first, second in ((index[:, :-1], index[:, 1:]), (index[:-1], index[1:])):
        both = (first >= 0) & (second >= 0)
        pairs.append((first[both], second[both]))
    return pairs


def _grown(seed: np.ndarray, index: np.ndarray, lit: np.ndarray) -> np.ndarray:
    """Steps from the seeds within the light, or within the shadow, counted from 1."""
    distance = seed.astype(int)
    pairs = [(a, b) for a, b in _neighbours(index)]
    pairs = [(a[lit[a] == lit[b]], b[lit[a] == lit[b]]) for a, b in pairs]
    for steps in range(1, _REACH):
        front = distance == steps
        for a, b in pairs:
            for near, far in ((a, b), (b, a)):
                reached = far[front[near] & (distance[far] == 0)]
                distance[reached] = steps + 1
    return distance


def judge(rows: list[Row]) -> Verdict:
    ours = [row for row in rows if row["model"] == "with the hint"]
    result = {kind: flip_beside(ours, kind) for kind in ("terminator", "cast shadow")}
    figures = ", ".join(f"{k} {v:.3f}" for k, v in result.items() if v is not None)
    worst = max((v for v in result.values() if v is not None), default=0.0)
    return Verdict(worst <= FLIP, f"FLIP beside the edge: {figures}")


def flip_beside(rows: list[Row], edge: str) -> float | None:
    """Mean FLIP of the pixels within `NEAR` of such an edge; None where there is none."""
    near = [row for row in rows if row["edge"] == edge and abs(row["pixels"]) <= NEAR]
    if not near:
        return None
    return float(np.average([r["flip"] for r in near], weights=[r["samples"] for r in near]))


def draw(figure: FigureBase, rows: list[Row]) -> None:
    grid = figure.subplots(2, 2, sharex=True, sharey="row")
    models = list(dict.fromkeys(values(rows, "model")))
    for column, edge in enumerate(("terminator", "cast shadow")):
        means, flips = grid[:, column]
        for model in models:
            where = {"edge": edge, "model": model}
            pixels = values(rows, "pixels", **where)
            means.plot(pixels, values(rows, "ours", **where), "o-", label=f"ours, {model}")
            flips.plot(pixels, values(rows, "flip", **where), "o-")
        means.plot(pixels, values(rows, "mean", **where), "k--", label="Cycles")
        for axes in (means, flips):
            axes.axvspan(-_REACH, 0, color="black", alpha=0.08, label="in shadow")
        flips.axhline(FLIP, color="grey", linewidth=0.8)
        flips.set_xlabel(f"pixels from the edge, {edge}")
    grid[0, 0].set_ylabel("mean radiance")
    grid[1, 0].set_ylabel("FLIP")
    grid[0, 0].legend()


CASE = Case(
    name="shadow-edges",
    title="Shadow edges",
    varies="distance to the terminator and to edges of cast shadows; with and without the hint",
    mark="FLIP at most 0.2 within 2 pixels of an edge",
    measure=measure,
    judge=judge,
    draw=draw,
    needs=("dataset",),
)
