"""Highlights narrower than the decoder's inputs can tell apart."""

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from matplotlib.figure import FigureBase

from rna_bench.stability.answers import Answers, of_model, picked
from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.fixtures import ASSETS, Fixtures
from rna_export.albedo import albedo
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_settings import SHARPEST
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.validation_view import is_lit, queries_of
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.capture_directions import frame, light_direction
from rna_export.capture.rays.view_rays import sample_view_rays
from rna_export.metrics import psnr

WIDTH, PEAK, INSIDE = 1.25, 1.25, 25.0  # the mark: factors, dB
ALBEDO, ALBEDO_OF_NARROWEST = 0.03, 0.05  # from Cycles', of all views; of roughness 0.02, grazing

_POINT = np.array([0.3, 0.8, 0.52])  # where on the ball the lobe is looked at
_INCLINATION = np.radians(40.0)  # of wi there
_TEST_LIGHTS, _TEST_RAYS = 8, 2048
_TIMES_LONGER = 3  # trainings, than the suite's: lobes are learnt last
_STYLES = {"ours": "-", "no highlight": "--", "the paper's": ":"}  # of the chart
_DRAWN = {"roughness-0.3": "C2", "roughness-0.1": "C1", "roughness-0.02": "C4"}
_STAYS = {"validation_views": 2, "validation_resolution": 64, "validation_samples": 16}


@dataclass(frozen=True)
class Material:
    """A ball's, and how narrow its narrowest lobe is."""

    name: str
    arguments: tuple[str, ...]
    roughness: float

    @property
    def highlight(self) -> float:
        """Angle between n and h where the highlight ends: three GGX alphas, 0.5 to 20 degrees.

        Beyond three alphas GGX has a hundredth of its peak.
        """
        return float(np.clip(3.0 * self.roughness**2, *np.radians([0.5, 20.0])))


def _plain(roughness: float) -> Material:
    name = f"roughness-{roughness:g}"
    return Material(name, ("--roughness", f"{roughness:g}"), roughness)


_COAT = ("--roughness", "0.5", "--coat", "1", "--coat-roughness", "0.05")
_ANISOTROPIC = ("--metallic", "1", "--roughness", "0.3", "--anisotropic", "0.8")
MATERIALS = (
    *map(_plain, (1.0, 0.3, 0.1, 0.05, 0.02)),
    Material("coat", _COAT, 0.05),
    Material("anisotropic", _ANISOTROPIC, 0.3),
)


def measure(fixtures: Fixtures) -> list[Row]:
    # A ball of one material needs no fine planes.
    ours = fixtures.preset("surface", resolution=64)
    ours = ours.with_training(steps=_TIMES_LONGER * fixtures.steps)
    known = tuple(block for block in ours.model.inputs if block != "highlight")
    models = {
        "ours": ours,
        "no highlight": ours.with_model(inputs=known),
        "the paper's": ours.with_model(inputs=fixtures.paper_inputs("surface")),
    }
    rows = []
    for material in MATERIALS:
        name = f"ball-{material.name}"
        lights = fixtures.some(300)
        views = {"rays": 4096, "samples": 1, "sharpest": min(material.roughness, SHARPEST)}
        dataset = fixtures.capture(
            name, "ball.py", *material.arguments, lights=lights, **views, **_STAYS
        )
        source = Source(ASSETS / "ball.py", material.arguments, clamp_direct=0.0)
        truth = fixtures.stored(name, partial(_from_cycles, fixtures, dataset, source))
        for label, preset in models.items():
            if label == "the paper's" and material.name not in _DRAWN:
                continue
            run = label.replace("'", "").replace(" ", "-")
            answers = of_model(fixtures.train(run, dataset, preset).model)
            row = {**_row(answers, truth, material), **returned(answers, dataset)}
            rows.append({"material": material.name, "inputs": label, **row})
    return rows


def _from_cycles(fixtures: Fixtures, dataset: DatasetPart, source: Source) -> dict[str, np.ndarray]:
    """Samples of unseen lights, and a scan through the highlight of one point (`scan-` names)."""
    scene = scene_of(dataset.dataset)
    with fixtures.cycles(source) as worker:
        parts = [_light(scene, worker, k) for k in range(_TEST_LIGHTS)]
        scan = _scan(scene, worker)
    test = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
    return test | {f"scan-{name}": rows for name, rows in scan.items()}


def _light(scene: AssetScene, worker: BlenderWorker, number: int) -> dict[str, np.ndarray]:
    wi = light_direction(number, 991, "sphere")
    rng = np.random.default_rng([991, number])
    rays = sample_view_rays(scene, wi, _TEST_RAYS, "sphere", rng)
    return _rendered(scene, worker, rays.origins, rays.directions, wi)


def _scan(scene: AssetScene, worker: BlenderWorker) -> dict[str, np.ndarray]:
    """One point under one light, seen along the plane of incidence through the mirror direction."""
    out = (_POINT / np.linalg.norm(_POINT))[None].astype(np.float32)
    start = scene.shade_points(scene.centre + 2.0 * scene.radius * out, -out)
    n = start.on[0].fields["normal"][0].astype(np.float64)
    side = frame(n[None])[0][0]
    wi = (np.cos(_INCLINATION) * n + np.sin(_INCLINATION) * side).astype(np.float32)
    half = np.radians(np.concatenate([[0.0], np.geomspace(0.005, 22.0, 80)]))
    half = np.concatenate([-half[:0:-1], half])  # between n and h
    angle = _INCLINATION + 2.0 * half
    wo = np.cos(angle)[:, None] * n - np.sin(angle)[:, None] * side
    origins = (start.position + scene.radius * wo).astype(np.float32)
    samples = _rendered(scene, worker, origins, (-wo).astype(np.float32), wi)
    return {**samples, "half": half.astype(np.float32)}


def _rendered(
    scene: AssetScene,
    worker: BlenderWorker,
    origins: np.ndarray,
    directions: np.ndarray,
    wi: np.ndarray,
) -> dict[str, np.ndarray]:
    """Rays that all meet the ball, as samples. One path is enough: one ball has no bounces."""
    points = scene.shade_points(origins, directions)
    rows = np.ascontiguousarray(np.broadcast_to(wi, origins.shape))
    rendered = worker.render_rays(origins, directions, wi, 1, 0)
    return {
        "position": points.position,
        "normal": points.on[0].fields["normal"],
        "wo": -directions,
        "wi": rows,
        "radiance": rendered.radiance,
        "visible": scene.visible(points, rows).astype(np.uint8),
    }


def _row(answers: Answers, truth: dict[str, np.ndarray], material: Material) -> dict[str, Any]:
    scan = {k.removeprefix("scan-"): v for k, v in truth.items() if k.startswith("scan-")}
    half = scan.pop("half")
    test = {k: v for k, v in truth.items() if not k.startswith("scan-")}
    lobe, reference = answers(queries_of(scan))[0], scan["radiance"]
    return {
        **in_and_out(picked(answers, test), test, material.highlight),
        **lobe_shape(half, lobe, ""),
        **lobe_shape(half, reference, "_cycles"),
        "half_deg": np.degrees(half).round(4).tolist(),
        "lobe": lobe.mean(axis=1).astype(float).round(4).tolist(),
        "lobe_cycles": reference.mean(axis=1).astype(float).round(4).tolist(),
    }


def returned(answers: Answers, dataset: DatasetPart) -> dict[str, float | None]:
    """Light returned from a white world over Cycles': of all rays, and of grazing ones."""
    view = dataset.white_view()
    found = None if view is None else albedo([(picked(answers, view.samples), view)])
    if found is None:
        return {"albedo": None, "albedo_at80": None}
    return {"albedo": found.ratio, "albedo_at80": found.at80}


def in_and_out(
    radiance: np.ndarray, samples: dict[str, np.ndarray], highlight: float
) -> dict[str, float]:
    """PSNR in the highlight and out of it, of samples where the light is visible.

    In the highlight it is of radiance as it is, against its peak: displayed, most of it is white.
    highlight: angle between n and h where it ends, radians.
    """
    h = samples["wi"] + samples["wo"]
    h = h / np.maximum(np.linalg.norm(h, axis=1, keepdims=True), 1e-6)
    inside = np.sum(h * samples["normal"], axis=1) > np.cos(highlight)
    visible = is_lit(samples["visible"])
    within, without = visible & inside, visible & ~inside
    return {
        "psnr_in": _psnr_of_peak(radiance[within], samples["radiance"][within]),
        "psnr_out": psnr(radiance[without], samples["radiance"][without]),
    }


def _psnr_of_peak(radiance: np.ndarray, reference: np.ndarray) -> float:
    error = np.mean((radiance.astype(np.float64) - reference) ** 2)
    return -10.0 * float(np.log10(max(error, 1e-12) / float(reference.max()) ** 2))


def lobe_shape(half: np.ndarray, lobe: np.ndarray, suffix: str) -> dict[str, float]:
    """Peak, and width in degrees: of the box of the same peak and area.

    half: (n,) ascending angles between n and h, radians. lobe: (n, 3) radiance; the lowest of it
    is taken for what is not highlight.
    """
    value = lobe.mean(axis=1, dtype=np.float64)
    above = value - value.min()
    area = float(np.sum(np.diff(np.degrees(half)) * (above[1:] + above[:-1])) / 2.0)
    width = area / above.max() if above.max() > 0.0 else 0.0
    return {f"peak{suffix}": float(value.max()), f"width_deg{suffix}": float(width)}


def judge(rows: list[Row]) -> Verdict:
    ours = [row for row in rows if row["inputs"] == "ours"]
    bad = [row["material"] for row in ours if not _is_met(row)]
    found = f"{len(ours) - len(bad)} of {len(ours)} materials"
    return Verdict(not bad, found + (f"; not {', '.join(bad)}" if bad else ""))


def _is_met(row: Row) -> bool:
    return (
        row["psnr_in"] >= INSIDE
        and _returns_enough(row)
        and 1.0 / PEAK <= row["peak"] / row["peak_cycles"] <= PEAK
        and 1.0 / WIDTH <= row["width_deg"] / max(row["width_deg_cycles"], 1e-9) <= WIDTH
    )


def _returns_enough(row: Row) -> bool:
    most = ALBEDO_OF_NARROWEST if row["material"] == "roughness-0.02" else ALBEDO
    limits = {"albedo": most, "albedo_at80": ALBEDO_OF_NARROWEST}
    return all(row[name] is None or abs(row[name] - 1.0) <= most for name, most in limits.items())


def draw(figure: FigureBase, rows: list[Row]) -> None:
    left, right = figure.subplots(1, 2)
    for inputs, style in _STYLES.items():
        names = values(rows, "material", inputs=inputs)
        inside = values(rows, "psnr_in", inputs=inputs)
        left.plot(names, inside, f"o{style}", color="C3", label=f"in the highlight, {inputs}")
    names = values(rows, "material", inputs="ours")
    left.plot(names, values(rows, "psnr_out", inputs="ours"), color="C0", label="out of it, ours")
    left.tick_params(axis="x", rotation=60)
    left.axhline(INSIDE, color="grey", linewidth=0.8)
    left.set_ylabel("PSNR, dB")
    left.set_ylim(0.0, 75.0)
    left.legend(fontsize=6, loc="upper right")
    for row in rows:
        if row["material"] in _DRAWN:
            _draw_lobe(right, row)
    right.set_xscale("log")
    right.set_yscale("log")
    right.set_xlabel("angle between n and h, degrees")
    right.set_ylabel("T; grey: Cycles")
    right.legend()


def _draw_lobe(axes: Any, row: Row) -> None:
    half, inputs = np.array(row["half_deg"]), row["inputs"]
    side = half > 0.0
    if inputs == "ours":
        axes.plot(half[side], np.array(row["lobe_cycles"])[side], color="lightgrey", linewidth=4)
    label = row["material"] if inputs == "ours" else None
    lobe = np.maximum(row["lobe"], 1e-3)[side]
    axes.plot(half[side], lobe, _STYLES[inputs], color=_DRAWN[row["material"]], label=label)


CASE = Case(
    name="sharp",
    title="Sharp reflection",
    varies="roughness 1 to 0.02, clear coat, anisotropic; balls of the suite's own",
    mark="peak and width within a factor of 1.25 of Cycles', 25 dB in the highlight; light of a "
    "white world within 3% of Cycles', 5% at 80 degrees and of roughness 0.02",
    measure=measure,
    judge=judge,
    draw=draw,
)
