"""A part that moves: its model answers as it was captured, at rest."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import FigureBase

from rna_bench.stability.answers import Answers, of_model, picked
from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.chosen import Samples
from rna_bench.stability.fixtures import Fixtures
from rna_bench.stability.view_errors import joined_views, relative_error
from rna_export.capture.dataset.dataset_folder import Dataset

MOST, AT_DEG = 2.0, 30.0  # the mark: times a part's error at rest, at that angle

ANGLES = (10.0, 30.0, 60.0)  # degrees, of the arm from rest
PARTS = ("body", "arm")
SHOULDER = np.array([0.15, 0.42, 0.0])  # of assets/posed.py, here +Y up; the arm turns about +z
_VIEWS = 6


def measure(fixtures: Fixtures) -> list[Row]:
    rest = capture(fixtures, 0.0, lights=fixtures.some(500), rays=4096)
    preset = fixtures.preset("surface")
    models = {
        name: of_model(fixtures.train(f"small-{name}", rest.part(name), preset).model)
        for name in PARTS
    }
    # What a pose is asked for is its images alone.
    moved = {angle: capture(fixtures, angle, lights=1, rays=64) for angle in ANGLES}
    return [
        {"angle_deg": angle, **row}
        for angle, dataset in ({0.0: rest} | moved).items()
        for row in errors(models, dataset, angle)
    ]


def capture(fixtures: Fixtures, angle_deg: float, lights: int, rays: int) -> Dataset:
    """The figure in a pose, body and arm a part each."""
    return fixtures.capture_parts(
        f"posed-{angle_deg:g}",
        "posed.py",
        "--angle",
        f"{angle_deg:g}",
        parts="objects",
        lights=lights,
        rays=rays,
        samples=4,
        validation_views=_VIEWS,
        validation_resolution=96,
        validation_samples=fixtures.some(256),
    )


def errors(models: dict[str, Answers], dataset: Dataset, angle_deg: float) -> list[Row]:
    """Errors of each part, and of both, in the images of a pose.

    Whether light is visible is traced against the parts where they are now: the images say it.
    """
    shaded, halves = {}, {}
    for name, answers in models.items():
        samples, halves[name] = joined_views(dataset.part(name).validation_views())
        asked = at_rest(samples, angle_deg) if name == "arm" else samples
        shaded[name] = picked(answers, asked)
    shaded["both"] = np.concatenate(list(shaded.values()))
    halves["both"] = np.concatenate(list(halves.values()), axis=1)
    return [
        {
            "where": where,
            "error": relative_error(shaded[where], halves[where]),
            "brightness": float(shaded[where].mean() / halves[where].mean()),
        }
        for where in shaded
    ]


def at_rest(samples: Samples, angle_deg: float) -> Samples:
    """Samples of the turned arm in the space that its model was trained in."""
    back = rotation(-angle_deg)
    turned = {name: samples[name] @ back.T for name in ("normal", "wo", "wi")}
    position = (samples["position"] - SHOULDER) @ back.T + SHOULDER
    moved = {name: v.astype(np.float32) for name, v in ({"position": position} | turned).items()}
    return samples | moved


def rotation(angle_deg: float) -> np.ndarray:
    """(3, 3) about +z, counter-clockwise."""
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def rises(rows: list[Row], where: str) -> dict[float, float]:
    """Angle -> error over that at rest."""
    error = {row["angle_deg"]: row["error"] for row in rows if row["where"] == where}
    return {angle: error[angle] / error[0.0] for angle in error if angle}


def judge(rows: list[Row]) -> Verdict:
    told, passed = [], True
    for part in PARTS:
        rise = rises(rows, part)
        passed &= rise[AT_DEG] <= MOST
        told.append(f"{part} " + ", ".join(f"{times - 1.0:+.0%}" for times in rise.values()))
    at = ", ".join(f"{angle:g}" for angle in ANGLES)
    return Verdict(passed, f"error over that at rest, at {at} degrees: {'; '.join(told)}")


def draw(figure: FigureBase, rows: list[Row]) -> None:
    axes = figure.subplots()
    for where in dict.fromkeys(values(rows, "where")):
        angle = values(rows, "angle_deg", where=where)
        axes.plot(angle, values(rows, "error", where=where), "o-", label=where)
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel("angle of the arm from rest, degrees")
    axes.set_ylabel("RMSE over the mean")
    axes.legend()


CASE = Case(
    name="posed",
    title="Posed",
    varies="a part turned by 10 to 60 degrees after the capture; a figure of the suite's own",
    mark="at 30 degrees no part has more than twice its error at rest",
    advice="A part that moves keeps its own transport; light between parts goes stale.",
    measure=measure,
    judge=judge,
    draw=draw,
)
