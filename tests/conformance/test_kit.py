"""The kit is what its script makes, and covers what it says."""

from __future__ import annotations

import json

import numpy as np
import pytest

from rna_sdk.conformance.kit import Kit
from rna_sdk.package import INPUT_BLOCKS, Package
from tests.conformance.conftest import KIT
from tests.conformance.kit import hits, shapes
from tests.conformance.kit.files import differences, kit_files
from tests.conformance.kit.visibility import MeshHits, stable
from tests.package.corpus.registry import CASES

ONLY_IN_LARGE_FILES = {"MANIFEST_TOO_LARGE", "DECODER_TOO_LARGE"}


def test_the_kit_is_what_the_script_makes() -> None:
    assert differences(KIT, kit_files()) == []


def test_a_changed_file_is_noticed(tmp_path) -> None:
    files = {"packages/a.rna": b"abc", "expected/a.f64": np.float64([1, 2]).tobytes()}
    for name, data in files.items():
        (tmp_path / name).parent.mkdir()
        (tmp_path / name).write_bytes(data)
    assert differences(tmp_path, files) == []
    nearly = {**files, "expected/a.f64": np.float64([1, 2 + 1e-12]).tobytes()}
    assert differences(tmp_path, nearly) == []
    for name, other in (
        ("expected/a.f64", np.float64([1, 2.1]).tobytes()),
        ("packages/a.rna", b""),
    ):
        (line,) = differences(tmp_path, {**files, name: other})
        assert line.startswith(f"{name}: stale")
    assert differences(tmp_path, {}) == [f"{name}: not of the kit" for name in sorted(files)]
    assert differences(tmp_path, {**files, "more": b""}) == ["more: missing"]


def test_it_is_small() -> None:
    sizes = [
        record["size"] for record in json.loads((KIT / "kit.json").read_text())["files"].values()
    ]
    assert sum(sizes) < 3 * 2**20 and max(sizes) <= 48 * 1024


def test_packages_cover_the_format(kit: Kit) -> None:
    seen = set()
    for path in sorted({case.package for case in kit.evaluate}):
        with Package.open(path) as package:
            seen |= {part.kind for part in package.manifest.parts}
            seen.add("two tiers" if len(package.manifest.tiers) > 1 else "one tier")
            for tier in package.manifest.tiers:
                for part in tier.parts:
                    seen |= {*part.inputs, f"{part.plane_precision} planes"}
                    seen |= {f"{part.decoder_precision} decoder", f"R = {part.resolution}"}
                    seen |= {f"C = {part.channels}"}
    precisions = {f"{p} planes" for p in ("int8", "float16", "float32")}
    assert {*INPUT_BLOCKS, *precisions, "int8 decoder", "float32 decoder"} <= seen
    assert {"R = 1", "C = 1", "C = 2", "two tiers", "surface", "fiber"} <= seen


def test_every_code_of_the_corpus_is_there(kit: Kit) -> None:
    codes = {case.code for case in kit.validate}
    assert {case.code for case in CASES} - codes == ONLY_IN_LARGE_FILES


def test_every_row_has_a_class_and_a_tolerance(kit: Kit) -> None:
    for case in kit.evaluate:
        ends = np.cumsum([c.rows for c in case.classes])
        assert [c.first for c in case.classes] == [0, *ends[:-1]] and ends[-1] == len(case.expected)
        by_rule = (case.expected == 0).all(axis=1)
        assert (case.tolerance[by_rule] == 0).all() and (case.tolerance[~by_rule] > 0).all()
        assert by_rule.sum() >= 8 + 3 * 12


def test_both_picks_are_in_every_geometry(kit: Kit) -> None:
    for case in kit.visibility:
        assert set(case.picks) == {0, 1} and 0.1 < case.picks.mean() < 0.9, case.package


@pytest.mark.parametrize("beyond", [0.0, 1e-2])
def test_hits_next_to_a_decision_are_left_out(beyond: float) -> None:
    """A ray that passes the edge of the hovering sheet exactly, or clears it."""
    mesh = shapes.steps()
    x = np.array([0.0, -0.5, 0.0])
    start = np.array([0.0, -0.5 + 2.0**-18 * 0.9, 0.0])  # where the ray leaves the floor
    wi = hits.unit((np.array([0.3 + beyond, -0.45, 0.0]) - start)[None])
    v = mesh.positions[mesh.triangles[0]].astype(np.float64)
    b1, b2 = np.linalg.lstsq((v[1:] - v[0]).T, x - v[0], rcond=None)[0]
    hit = MeshHits(np.uint32([0]), np.float32([b1]), np.float32([b2]), wi.astype(np.float32))
    assert len(stable(hit, mesh)) == (beyond > 0)
    assert beyond == 0 or hit.visible(mesh).tolist() == [True]
