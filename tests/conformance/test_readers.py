"""Readers pass the kit (the minimal host: test_cli.py); those wrong in one formula do not."""

from __future__ import annotations

import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from rna_render import conformance_reader, parts_scene, surface
from rna_render.surface import interpolate_positions
from rna_sdk.conformance import reader, twin_reader
from rna_sdk.conformance.cli import run_levels
from rna_sdk.conformance.kit import LEVELS, Kit
from rna_sdk.conformance.program import Command, Program, claimed_levels
from rna_sdk.conformance.scoring import Score
from rna_sdk.package import Curves, Package
from tests.conformance import float32_reader
from tests.conformance.conftest import InProcess
from tests.conformance.float32_reader import Formulas
from tests.conformance.kit.blocks import unit
from tests.conformance.kit.visibility import FiberHits, strands
from tests.conftest import REPOSITORY
from tests.render.round_cones import entries

C_HOST = REPOSITORY / "examples" / "hosts" / "c"


def failures(program: Program, kit: Kit, *levels: str) -> list[Score]:
    return [score for score in run_levels(program, kit, levels) if not score.passed]


def test_the_runtime_passes_every_level(kit: Kit) -> None:
    program = InProcess(reader.evaluate, conformance_reader.visibility, reader.check)
    assert claimed_levels(program) == LEVELS
    assert failures(program, kit, *LEVELS) == []


def test_the_numpy_twin_passes(kit: Kit) -> None:
    assert failures(InProcess(twin_reader.evaluate), kit, "evaluate") == []


@pytest.mark.parametrize("module", ["rna_sdk.conformance.reader", "rna_render.conformance_reader"])
def test_our_readers_are_programs(module: str, kit: Kit, tmp_path: Path) -> None:
    program = Command((sys.executable, "-m", module), timeout=300)
    had = claimed_levels(program)
    assert had == (LEVELS if "render" in module else ("evaluate", "validate"))
    one = replace(kit, evaluate=kit.evaluate[:1], visibility=(), validate=kit.validate[:1])
    assert failures(program, one, *had) == []
    refused = program.run("evaluate", str(tmp_path / "none.rna"), "small", "none", "none")
    assert refused.status == 2 and refused.stderr.startswith("error: ")


@pytest.mark.skipif(not (shutil.which("cc") and shutil.which("make")), reason="no cc or no make")
def test_the_c_host_passes_every_level(kit: Kit, tmp_path: Path) -> None:
    host = tmp_path / "conform"
    subprocess.run(
        ["make", "-s", "-C", C_HOST, f"BUILD={tmp_path}", "ARCH=", "CFLAGS=-O1", host], check=True
    )
    program = Command((str(host),), timeout=60)
    assert claimed_levels(program) == LEVELS
    assert failures(program, kit, *LEVELS) == []


def of_float32(minimal: ModuleType, formulas: Formulas) -> InProcess:
    def evaluate(package: str, tier: str, queries: np.ndarray) -> np.ndarray:
        with np.errstate(all="ignore"):
            return float32_reader.evaluate(minimal, formulas, Path(package), tier, queries)

    return InProcess(evaluate)


def test_float32_throughout_passes_with_the_safe_formulas(kit: Kit, minimal: ModuleType) -> None:
    assert failures(of_float32(minimal, Formulas()), kit, "evaluate") == []


@pytest.mark.parametrize("formula", ["half_vector", "gap", "cosines", "cos_phi", "sin_phi"])
def test_each_formula_that_loses_digits_fails(formula: str, kit: Kit, minimal: ModuleType) -> None:
    program = of_float32(minimal, replace(Formulas(), **{formula: False}))
    failed = failures(program, kit, "evaluate")
    kind = "surface" if formula in ("half_vector", "gap") else "fiber"
    assert len(failed) >= 2 and all(score.package.startswith(kind) for score in failed)
    assert all(score.right > 0.9 * score.rows for score in failed)


@pytest.mark.parametrize(
    ("mistake", "packages"),
    [
        ({"sign_of_sin_phi": -1.0}, {"fiber-float16", "fiber-int8", "fiber-one-channel"}),
        ({"h_clamped": False}, {"fiber-float16", "fiber-int8", "fiber-one-channel"}),
        ({"pair_sums_in_16_bits": True}, {"surface-int8-saturating"}),
        ({"subnormal_texels": False}, {"surface-odd"}),
        ({"rounded_bounds": False}, {"surface-tiny"}),
    ],
)
def test_a_reader_that_is_wrong_in_one_place_fails(
    mistake: dict[str, float], packages: set[str], kit: Kit, minimal: ModuleType
) -> None:
    program = of_float32(minimal, replace(Formulas(), **mistake))
    failed = failures(program, kit, "evaluate")
    assert {score.package for score in failed} == packages
    assert all("row" in score.note and "expected" in score.note for score in failed)


@pytest.mark.parametrize(
    ("rows", "steps", "passes"), [(7, 0.9, True), (8, 0.9, False), (1, 2, False)]
)
def test_few_rows_of_int8_may_differ_by_a_step(
    rows: int, steps: float, passes: bool, kit: Kit
) -> None:
    """2% of 388 are 7; of a float32 decoder, none may."""

    def evaluate(package: str, tier: str, queries: np.ndarray) -> np.ndarray:
        case = next(c for c in kit.evaluate if (str(c.package), c.tier) == (package, tier))
        found = case.expected.copy()
        found[:rows] += steps * case.step + 5 * (case.step == 0)
        return found

    scores = run_levels(InProcess(evaluate), kit, ["evaluate"])
    by_tier = {(score.package, score.tier): score for score in scores}
    int8, float32 = (by_tier["surface-int8", tier] for tier in ("small-int8", "small"))
    assert int8.passed == passes and not float32.passed
    assert int8.rows - int8.right == rows and (int8.in_tolerances < 1) == passes
    assert not passes or int8.note == "7 rows by one step of int8"


def test_planes_upside_down_fail_wherever_there_are_texels(kit: Kit, minimal: ModuleType) -> None:
    program = of_float32(minimal, Formulas(rows_upside_down=True))
    passed = {s.package for s in run_levels(program, kit, ["evaluate"]) if s.passed}
    assert passed == {"surface-one-texel", "fiber-one-channel"}


def without_lift(package: str, records: bytes) -> np.ndarray:
    """No ray starts on the smooth surface."""

    def none(*at):  # type: ignore[no-untyped-def]
        return 0 * interpolate_positions(at[0], *at[2:])

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(surface, "lifts", none)
        return conformance_reader.visibility(package, records)


def from_outside(package: str, records: bytes) -> np.ndarray:
    """All rays start on the side of the geometric normal."""

    def above(points, directions, extent):  # type: ignore[no-untyped-def]
        return points.x + np.float32(surface.OFFSET * extent) * points.ng

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(parts_scene, "leaving_origins", above)
        return conformance_reader.visibility(package, records)


def of_strands(own_strand: bool, neighbours: bool):  # type: ignore[no-untyped-def]
    """By brute force: is the whole strand of x passed through, are entries at joints left out?"""

    def visibility(package: str, records: bytes) -> np.ndarray:
        with Package.open(package) as opened:
            curves = opened.geometry()
        if not isinstance(curves, Curves):
            return conformance_reader.visibility(package, records)
        words = np.frombuffer(records, "<u4").reshape(-1, 8)
        segment, numbers = words[:, 0], words.view("<f4")
        if own_strand and neighbours:
            return FiberHits(segment, numbers[:, 1:4], numbers[:, 4:7]).visible(curves)
        t = entries(curves, numbers[:, 1:4], unit(numbers[:, 4:7].astype(np.float64)))
        strand, number = strands(curves), np.arange(len(strands(curves)))
        passed = strand == strand[segment][:, None] if own_strand else number == segment[:, None]
        return ~(np.isfinite(t) & ~passed).any(axis=1)

    return visibility


@pytest.mark.parametrize(
    ("visibility", "kind", "classes"),
    [
        (without_lift, "surface", ("terminator", "behind the facet")),
        (from_outside, "surface", ("backs",)),
        (of_strands(own_strand=False, neighbours=False), "fiber", ("own strand", "at joints")),
        (of_strands(own_strand=True, neighbours=False), "fiber", ("inside another strand",)),
    ],
)
def test_readers_with_a_simpler_visibility_fail(visibility, kind, classes, kit: Kit) -> None:  # type: ignore[no-untyped-def]
    failed = failures(InProcess(visibility=visibility), kit, "visibility")
    assert failed and all(score.package.startswith(kind) for score in failed)
    for name in classes:
        assert any(name in score.note for score in failed), [score.note for score in failed]
