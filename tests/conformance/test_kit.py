"""The kit is what its script makes, and covers what it says."""

import json
from collections.abc import Iterator

import numpy as np
import pytest

from rna_sdk.package import INPUT_BLOCKS, Package, Part
from rna_sdk.package.container.zip_container import MANIFEST_NAME
from tests.conformance.conftest import KIT
from tests.conformance.kit import hits, shapes
from tests.conformance.kit.files import differences, kit_files
from tests.conformance.kit.visibility import Body, MeshHits, stable, visibility
from tests.package.builders import read_entries
from tests.package.corpus.every import CASES
from tests.package.corpus.schema_cases import UNREACHED
from tests.package.corpus.schema_walk import Constraint, all_constraints, broken_constraints

ONLY_IN_LARGE_FILES = {"MANIFEST_TOO_LARGE", "DECODER_TOO_LARGE", "STANDIN_TEXTURE"}


def test_the_kit_is_what_the_script_makes():
    assert differences(KIT, kit_files()) == []


def test_a_changed_file_is_noticed(tmp_path):
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


def test_it_is_small():
    sizes = [
        record["size"] for record in json.loads((KIT / "kit.json").read_text())["files"].values()
    ]
    assert sum(sizes) < 14 * 2**20 and max(sizes) <= 48 * 1024


def test_packages_cover_the_format(kit):
    seen = set()
    for path in sorted({case.package for case in kit.evaluate}):
        with Package.open(path) as package:
            seen |= {part.kind for part in package.manifest.parts}
            seen |= {name for part in package.manifest.parts for name in features_of(part)}
            seen.add("two tiers" if len(package.manifest.tiers) > 1 else "one tier")
            for tier in package.manifest.tiers:
                for part in tier.parts:
                    seen |= {*part.inputs, f"{part.plane_precision} planes"}
                    seen |= {f"{part.decoder_precision} decoder", f"R = {part.resolution}"}
                    seen |= {f"C = {part.channels}"}
                    seen |= {decoder.form.name for decoder in part.decoders}
                    if part.uses_base_color:
                        seen |= {
                            f"{d.precision} {d.form.name} of base colour" for d in part.decoders
                        }
                    if part.emission:
                        seen |= {f"{part.emission.decoder_precision} emission"}
    precisions = {f"{p} planes" for p in ("int8", "float16", "float32")}
    assert {*INPUT_BLOCKS, *precisions, "int8 decoder", "float32 decoder"} <= seen
    assert {"R = 1", "C = 1", "C = 2", "two tiers", "surface", "fiber"} <= seen
    assert {"float32 emission", "int8 emission", "cutoff", "ior", "texture"} <= seen
    for form in ("float32 transport", "int8 transport", "float32 visible", "int8 shadowed"):
        assert f"{form} of base colour" in seen
    assert {"transport", "visible", "shadowed", "image", "base colour"} <= seen


def features_of(part: Part) -> Iterator[str]:
    for record in part.transmittance:
        yield "cutoff" if record.cutoff else "ior" if record.ior else "texture"
    for color in part.base_color:
        yield "image" if color.image else "base colour"


def test_every_code_of_the_corpus_is_there(kit):
    codes = {case.code for case in kit.validate}
    assert {case.code for case in CASES} - codes == ONLY_IN_LARGE_FILES


def test_no_constraint_of_the_schemas_is_unguarded(kit):
    """Each has a broken package in which nothing else is wrong."""
    guarded: set[Constraint] = set()
    for case in (case for case in kit.validate if case.package.stem.startswith("schema-")):
        broken = broken_constraints(json.loads(read_entries(case.package)[MANIFEST_NAME]))
        assert len(broken) == 1 and not case.valid, case.package
        guarded |= broken
    assert all_constraints() - guarded == UNREACHED


def test_every_row_has_a_class_and_a_tolerance(kit):
    for case in (*kit.evaluate, *kit.environment):
        ends = np.cumsum([c.rows for c in case.classes])
        assert [c.first for c in case.classes] == [0, *ends[:-1]] and ends[-1] == len(case.expected)
        by_rule = (case.expected == 0).all(axis=1)
        assert (case.tolerance[by_rule] == 0).all() and (case.tolerance[~by_rule] > 0).all()
        numbers, lengths = (12, 8) if case.output == "transport" else (9, 5)
        if case.level == "environment":
            numbers, lengths = 5, 4
        assert by_rule.sum() >= lengths + 3 * numbers


def test_light_and_shadow_are_on_every_geometry(kit):
    for case in kit.visibility:
        clear, dark = (case.expected == v for v in (1, 0))
        if clear.all():  # around a strand that stands alone
            assert case.package.stem in ("fiber-lone", "fiber-straight")
            continue
        assert 0.1 < clear.mean() < 0.9 and 0.1 < dark.mean() < 0.9, case.package
        between = ~(clear | dark)
        assert between.any() == case.package.stem.endswith(("lantern", "screens"))
        assert not between.any() or between.mean() > 0.05


def test_facets_that_face_light_behind_the_smooth_surface_block_it(kit):
    """Glass weakens it; triangles wound against their normals have the side of the facet."""
    seen = {}
    for case in kit.visibility:
        for c in case.classes:
            part, actual, _ = c.name.partition("behind the smooth surface")
            if actual:
                rows = slice(c.first, c.first + c.rows)
                seen[case.package.stem, part.strip(": ")] = case.expected[rows]
    assert not seen["surface-float32", ""].any()
    assert seen["parts-head", "skin"].all()
    glass = seen["parts-lantern", "panes"]
    assert glass.max() < 1.0 and (glass > 0.0).mean() > 0.5


def test_normals_are_bent_in_every_way(kit):
    (case,) = (case for case in kit.normals if case.package.stem == "surface-relief")
    rows = {c.name: c.rows for c in case.classes}
    assert set(rows) == {
        *("ordinary", "mirrored", "no area in the texture", "no map", "edges and corners")
    }
    assert min(rows.values()) > 100 and sum(rows.values()) == len(case.expected)
    np.testing.assert_allclose(np.linalg.norm(case.expected, axis=1), 1)
    assert case.tolerance.min() >= 1e-4 and case.tolerance.max() <= 1e-3


@pytest.mark.parametrize("beyond", [0.0, 1e-2])
def test_hits_next_to_a_decision_are_left_out(beyond):
    """A ray that passes the edge of the hovering sheet exactly, or clears it."""
    mesh = shapes.steps()
    x = np.array([0.0, -0.5, 0.0])
    start = np.array([0.0, -0.5 + 2.0**-18 * 0.9, 0.0])  # where the ray leaves the floor
    wi = hits.unit((np.array([0.3 + beyond, -0.45, 0.0]) - start)[None])
    v = mesh.positions[mesh.triangles[0]].astype(np.float64)
    b1, b2 = np.linalg.lstsq((v[1:] - v[0]).T, x - v[0], rcond=None)[0]
    hit = MeshHits(np.uint32([0]), np.float32([b1]), np.float32([b2]), wi.astype(np.float32))
    bodies = [Body(mesh)]
    assert len(stable(hit, bodies, 0)) == (beyond > 0)
    assert beyond == 0 or visibility(bodies, hit.rays(bodies, 0)).tolist() == [[1, 1, 1]]
