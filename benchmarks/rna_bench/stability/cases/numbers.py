"""Numbers at the edge of what floats hold, and planes and decoders of few bits."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import FigureBase

from rna_bench.one_part import load_one_part
from rna_bench.scenes.beside_cycles import OurScene
from rna_bench.scenes.stage import Stage
from rna_bench.stability.answers import Answers, Queries, of_model, of_package, picked
from rna_bench.stability.case import Case, Row, Verdict
from rna_bench.stability.chosen import Samples, rows_of
from rna_bench.stability.fixtures import Fixtures
from rna_bench.stability.view_errors import joined_views
from rna_export.capture.dataset.asset_arguments import evaluate_arguments
from rna_export.capture.dataset.validation_view import queries_of
from rna_export.metrics import psnr_without_noise
from rna_sdk.package import Package, decoder_from_bytes, float_planes
from rna_sdk.reference.queries import fiber_queries_reference, queries_reference
from rna_sdk.runtime import Asset

RELATIVE, LOST_DB = 1e-3, 0.2  # the mark

_QUERIES = 20_000
_FLOOR = 1e-3  # radiance: errors below count against this
_BRIGHT = 1e6


def measure(fixtures: Fixtures) -> list[Row]:
    samples, halves = joined_views(fixtures.dataset.validation_views())
    some = np.random.default_rng(41).integers(len(samples["visible"]), size=_QUERIES)
    queries = queries_of(rows_of(samples, some))
    answers = fixtures.answers()
    usual = answers(queries)
    rows = [checked("float64", usual, in_float64(fixtures.package, fixtures.asset, queries))]
    rows += odd_inputs(answers, queries)
    rows.append(_bright_light(fixtures))
    paths = fixtures.packages_of_base().items()
    packages = {precision: of_package(load_one_part(path, threads=1)) for precision, path in paths}
    full = picked(of_model(fixtures.base.model), samples)
    rows += _few_bits(packages, full, samples, halves)
    rows += _least_bits(packages["int8-int8"], queries)
    return rows


def in_float64(path: Path, asset: Asset, queries: Queries) -> tuple[np.ndarray, np.ndarray]:
    """Output of the tier's planes and decoder in double precision."""
    tier = asset.tier
    with Package.open(path) as package:
        planes, decoder = float_planes(package.planes(tier.name)), package.decoder(tier.name)
        reference = fiber_queries_reference if "tangent" in queries else queries_reference
        rows = evaluate_arguments(queries)
        at = reference(planes, asset.bounds, tier.parts[0].inputs, *rows)
        transport = decoder_from_bytes(decoder, tier.parts[0].decoder).run(at.astype(np.float64))
    return transport[:, :3], transport[:, 3:]


def odd_inputs(answers: Answers, queries: Queries) -> list[Row]:
    """Inputs that say the same as usual ones in odd numbers, and inputs that say nothing."""
    usual = answers(queries)
    directions: list[str] = [name for name in ("normal", "tangent", "wo", "wi") if name in queries]
    scaled = {
        name: queries | {d: queries[d] * np.float32(scale) for d in directions}
        for name, scale in (("directions of length 1e18", 1e18), ("of length 1e-18", 1e-18))
    }
    rows = [checked(name, answers(odd), usual) for name, odd in scaled.items()]
    denormal = {d: np.where(np.abs(queries[d]) < 1e-3, 1e-42, queries[d]) for d in directions}
    flushed = {d: np.where(np.abs(queries[d]) < 1e-3, 0.0, queries[d]) for d in directions}
    tiny, none = (
        queries | {k: v.astype(np.float32) for k, v in odd.items()} for odd in (denormal, flushed)
    )
    rows.append(checked("denormal parts", answers(tiny), answers(none)))
    far = queries | {"position": queries["position"] * np.float32(1e30)}
    rows.append(checked("positions of 1e30", answers(far)))
    for bad in (np.nan, np.inf, -np.inf):
        zero = np.zeros_like(usual[0])
        for name in queries:
            broken = queries | {name: np.full_like(queries[name], bad)}
            rows.append(checked(f"{name} {bad}", answers(broken), (zero, zero)))
    return rows


def checked(name: str, found: Any, expected: Any = None) -> Row:
    """Whether values are finite and non-negative, and their error where a reference is known."""
    found = np.concatenate(found).astype(np.float64)
    row = {
        "check": name,
        "finite": bool(np.isfinite(found).all()),
        "non_negative": bool((found >= 0.0).all()),
        "error": None,
        "lost_db": None,
    }
    if expected is not None:
        expected = np.concatenate(expected).astype(np.float64)
        error = np.abs(found - expected) / (np.abs(expected) + _FLOOR)
        row["error"] = float(np.nanmax(error, initial=0.0))
    return row


def _bright_light(fixtures: Fixtures) -> Row:
    """An image under a light of irradiance 1e6 is that under 1, a million times."""
    view = {"turn_deg": 0.0, "resolution": (48, 48)}
    path = fixtures.package.resolve()
    stage = Stage.of(fixtures.asset, path, fixtures.subject.tier, **view)
    images = []
    for irradiance in (1.0, _BRIGHT):
        light = {
            "type": "directional",
            "direction": tuple(stage.direction(75.0, 45.0)),
            "irradiance": (irradiance,) * 3,
        }
        images.append(OurScene(stage.scene(light)).render(4).pixels / irradiance)
    return checked("a light of 1e6", [images[1]], [images[0]])


def _few_bits(
    packages: dict[str, Answers], full: np.ndarray, samples: Samples, halves: np.ndarray
) -> list[Row]:
    """PSNR lost by packages of few bits against the model's own radiance, `full`."""
    best, rows = psnr_without_noise(full, *halves).db, []
    for precision, answers in packages.items():
        answer = picked(answers, samples)
        lost = best - psnr_without_noise(answer, *halves).db
        rows.append({**checked(precision, [answer]), "lost_db": float(lost)})
    return rows


def _least_bits(answers: Answers, queries: Queries) -> list[Row]:
    """Odd inputs of int8. How exact is not asked: its steps make a large change of a small one."""
    return [
        {**row, "check": f"int8-int8: {row['check']}", "error": None}
        for row in odd_inputs(answers, queries)
    ]


def judge(rows: list[Row]) -> Verdict:
    bad = [row["check"] for row in rows if not _is_met(row)]
    found = f"{len(rows) - len(bad)} of {len(rows)} checks"
    return Verdict(not bad, found + (f"; not {', '.join(bad)}" if bad else ""))


def _is_met(row: Row) -> bool:
    exact = row["error"] is None or row["error"] <= RELATIVE
    good = row["lost_db"] is None or row["lost_db"] <= LOST_DB
    return row["finite"] and row["non_negative"] and exact and good


def draw(figure: FigureBase, rows: list[Row]) -> None:
    left, right = figure.subplots(1, 2, width_ratios=(2, 1))
    known = [row for row in rows if row["error"] is not None and row["error"] > 0.0]
    left.barh([r["check"] for r in known], [r["error"] for r in known])
    left.axvline(RELATIVE, color="grey", linewidth=0.8)
    left.set_xscale("log")
    exact = sum(row["error"] == 0.0 for row in rows)
    left.set_xlabel(f"largest relative error; {exact} checks without any")
    bits = [row for row in rows if row["lost_db"] is not None]
    right.bar([r["check"] for r in bits], [r["lost_db"] for r in bits])
    right.axhline(LOST_DB, color="grey", linewidth=0.8)
    right.tick_params(axis="x", rotation=60)
    right.set_ylabel("PSNR lost, dB")


CASE = Case(
    name="numbers",
    title="Numbers",
    varies="float16 and int8, planes and decoder; huge, denormal and broken inputs; a light of 1e6",
    mark="finite, not negative, within 1e-3 of float64; at most 0.2 dB lost to few bits",
    advice="Rows with NaN or an infinity answer 0; nothing is to be done.",
    measure=measure,
    judge=judge,
    draw=draw,
    needs=("dataset",),
)
