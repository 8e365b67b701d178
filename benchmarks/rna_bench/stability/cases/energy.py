"""More light out than in, or less than in Cycles."""

import numpy as np
from matplotlib.figure import FigureBase

from rna_bench.stability.answers import Answers, of_model, picked
from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.cases.sharp import returned
from rna_bench.stability.fixtures import Fixtures
from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.dataset.validation_view import is_lit
from rna_export.capture.rays.asset_scene import AssetScene, ShadePoints
from rna_export.capture.rays.capture_directions import sphere
from rna_export.capture.rays.view_rays import sample_view_rays

MOST, SHARE = 1.01, 0.01  # the mark: at most that share of the points above
LEAST = 0.97  # and at least that much of the light that Cycles' asset returns

_POINTS, _DIRECTIONS = 1000, 1024


def measure(fixtures: Fixtures) -> list[Row]:
    white = fixtures.capture_white()
    count = fixtures.some(_POINTS)
    preset = fixtures.preset("surface", resolution=128)
    models = {"white": (of_model(fixtures.train("small", white, preset).model), white)}
    if fixtures.subject.dataset is not None:
        models["given"] = fixtures.answers(), fixtures.dataset
    rows: list[Row] = []
    for name, (answers, dataset) in models.items():
        of_asset = {"asset": name, "albedo": returned(answers, dataset)["albedo"]}
        rows += [{**of_asset, **row} for row in furnace(answers, scene_of(dataset.dataset), count)]
    return rows


def furnace(answers: Answers, scene: AssetScene, count: int) -> list[Row]:
    """The integral of T over wi at points that random views see: radiance in a white furnace."""
    rng = np.random.default_rng(21)
    rays = sample_view_rays(scene, np.array([0.0, 1.0, 0.0], np.float32), count, "sphere", rng)
    points = scene.shade_points(rays.origins, rays.directions)
    total, seen = integral(answers, scene, points, -rays.directions, rng)
    axis = points.on[0].fields.get("normal", points.geometric_normal)  # every ray hits
    n_wo = np.abs(np.sum(axis * -rays.directions, axis=1))
    return [
        {
            "integral": round(float(total[k].max()), 5),  # of the brightest channel
            "n_wo": round(float(n_wo[k]), 4),
            "open": round(float(seen[k]), 4),
            "position": points.position[k].round(4).tolist() if total[k].max() > MOST else None,
        }
        for k in np.flatnonzero(points.hit)
    ]


def integral(
    answers: Answers,
    scene: AssetScene,
    points: ShadePoints,
    wo: np.ndarray,
    rng: np.random.Generator,
) -> tuple[np.ndarray, np.ndarray]:
    """Integral of T over all wi for each point, (n, 3), and the fraction that is visible, (n,)."""
    n = len(wo)
    total, seen = np.zeros((n, 3)), np.zeros(n)
    fields = {name: np.ascontiguousarray(v) for name, v in points.on[0].fields.items()}
    turn = rng.random(n)  # the same lattice everywhere, turned about the vertical
    for height, azimuth in _lattice(_DIRECTIONS):
        wi = sphere(np.stack([np.full(n, height), (azimuth + turn) % 1.0], axis=1))
        visible = scene.visible(points, wi)
        samples = {**fields, "wo": wo, "wi": wi, "visible": visible}
        total += picked(answers, samples)
        seen += is_lit(visible)
    return total * (4.0 * np.pi / _DIRECTIONS), seen / _DIRECTIONS


def _lattice(count: int) -> np.ndarray:
    """(count, 2) in [0, 1): a Fibonacci lattice of equal heights and golden azimuths."""
    k = np.arange(count)
    return np.stack([(k + 0.5) / count, (k * (np.sqrt(5.0) - 1.0) / 2.0) % 1.0], axis=1)


def judge(rows: list[Row]) -> Verdict:
    figures, passed = [], True
    for asset in dict.fromkeys(values(rows, "asset")):
        total = np.array(values(rows, "integral", asset=asset))
        above = float((total > MOST).mean())
        passed &= above <= SHARE
        found = f"{asset}: {above:.1%} above 1.01, mean {total.mean():.2f}"
        albedo = values(rows, "albedo", asset=asset)[0]
        if albedo is not None:
            passed &= albedo >= LEAST
            found += f", {albedo:.1%} of Cycles'"
        figures.append(found)
    return Verdict(passed, "; ".join(figures))


def draw(figure: FigureBase, rows: list[Row]) -> None:
    left, right = figure.subplots(1, 2, sharey=True)
    for asset in dict.fromkeys(values(rows, "asset")):
        total = values(rows, "integral", asset=asset)
        for axes, name in ((left, "n_wo"), (right, "open")):
            x = values(rows, name, asset=asset)
            axes.plot(x, total, ".", markersize=3, label=asset, rasterized=True)
    for axes in (left, right):
        axes.axhline(MOST, color="grey", linewidth=0.8)
    left.set_xlabel("|n.wo|")
    right.set_xlabel("share of directions that are free")
    left.set_ylabel("integral of T over wi")
    left.legend()


CASE = Case(
    name="energy",
    title="Energy",
    varies="points and views in a white furnace; the suite's white asset, and the given asset",
    mark="the integral of T over wi at most 1.01, at 99% of the points; at least 97% of the light "
    "that Cycles' asset returns from a white world",
    measure=measure,
    judge=judge,
    draw=draw,
)
