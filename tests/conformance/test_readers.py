"""Readers pass the kit (the minimal host: test_cli.py); those wrong in one formula do not."""

import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

from rna_render import conformance_reader
from rna_sdk.conformance import reader
from rna_sdk.conformance.kit import LEVELS, Kit
from rna_sdk.conformance.lobe_queries import LobeQueries
from rna_sdk.conformance.program import Command, Program, claimed_levels
from rna_sdk.conformance.rna_conform import run_levels
from rna_sdk.conformance.scoring import Score
from rna_sdk.errors import ConformanceError
from rna_sdk.package import Curves, NormalMap, Package, Transmittance
from rna_trace import parts_scene
from rna_trace.surface import OFFSET, SurfacePoints, leaving_origins
from tests.conformance import twin_reader
from tests.conformance.conftest import InProcess, with_geometry
from tests.conformance.kit.blocks import unit
from tests.conformance.kit.visibility import strands
from tests.conftest import REPOSITORY
from tests.render.round_cones import entries

C_HOST = REPOSITORY / "examples" / "hosts" / "c"


def failures(program: Program, kit: Kit, *levels: str) -> list[Score]:
    return [score for score in run_levels(program, kit, levels) if not score.passed]


def test_the_runtime_passes_every_level(kit):
    program = InProcess(
        reader.evaluate,
        conformance_reader.visibility,
        conformance_reader.normals,
        reader.check,
        reader.environment,
        reader.evaluate,
        reader.base_color,
        reader.geometry,
        reader.deformed,
    )
    assert claimed_levels(program) == LEVELS
    assert failures(program, kit, *LEVELS) == []


def test_the_references_pass(kit):
    twin = InProcess(environment=twin_reader.environment, base_color=twin_reader.base_color)
    assert failures(twin, kit, *claimed_levels(twin)) == []


@pytest.mark.parametrize("module", ["rna_sdk.conformance.reader", "rna_render.conformance_reader"])
def test_our_readers_are_programs(module, kit, tmp_path):
    program = Command((sys.executable, "-m", module), timeout=300)
    had = claimed_levels(program)
    assert had == (
        LEVELS
        if "render" in module
        else tuple(level for level in LEVELS if level not in ("visibility", "normals"))
    )
    one = replace(
        kit,
        evaluate=kit.evaluate[:1],
        environment=kit.environment[:1],
        nearby=kit.nearby[:1],
        visibility=(),
        geometry=kit.geometry[:1],
        deformed=kit.deformed[:1],
        validate=kit.validate[:1],
    )
    assert failures(program, one, *had) == []
    refused = program.run("evaluate", str(tmp_path / "none.rna"), "small", "0", "none", "none")
    assert refused.status == 2 and refused.stderr.startswith("error: ")


@pytest.mark.skipif(not (shutil.which("cc") and shutil.which("make")), reason="no cc or no make")
def test_the_c_host_passes_every_level(kit, tmp_path):
    host = tmp_path / "conform"
    subprocess.run(
        ["make", "-s", "-C", C_HOST, f"BUILD={tmp_path}", "ARCH=", "CFLAGS=-O1", host], check=True
    )
    program = Command((str(host),), timeout=60)
    known = tuple(level for level in LEVELS if level != "environment")
    assert claimed_levels(program) == known
    assert failures(program, kit, *known) == []


@pytest.mark.parametrize(
    ("rows", "steps", "passes"), [(8, 0.9, True), (9, 0.9, False), (1, 2, False)]
)
def test_few_rows_of_int8_may_differ_by_a_step(rows, steps, passes, kit):
    """2% of 412 are 8; of a float32 decoder, none may."""

    def evaluate(form: str, package: str, tier: str, part: int, _: object) -> np.ndarray:
        query = package, tier, part, form
        case = next(c for c in kit.evaluate if (str(c.package), c.tier, c.part, c.output) == query)
        actual = case.expected.copy()
        actual[:rows] += steps * case.step + 5 * (case.step == 0)
        return actual

    scores = run_levels(InProcess(evaluate), kit, ["evaluate"])
    by_tier = {(score.package, score.tier): score for score in scores}
    int8, float32 = (by_tier["surface-int8", tier] for tier in ("small-int8 0", "small 0"))
    assert int8.passed == passes and not float32.passed
    assert int8.rows - int8.right == rows and (int8.in_tolerances < 1) == passes
    assert not passes or int8.note == "8 rows by one step of int8"


def leaving_by(origins: Callable[..., np.ndarray], package: str, records: bytes) -> np.ndarray:
    """Visibility where rays leave points of meshes from other origins."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(parts_scene, "leaving_origins", origins)
        return conformance_reader.visibility(package, records)


def without_lift(package: str, records: bytes) -> np.ndarray:
    """No ray starts on the smooth surface."""

    def flat(points: SurfacePoints, *others) -> np.ndarray:  # type: ignore[no-untyped-def]
        return leaving_origins(replace(points, lift=np.zeros_like(points.lift)), *others)

    return leaving_by(flat, package, records)


def from_outside(package: str, records: bytes) -> np.ndarray:
    """All rays start on the side of the geometric normal."""

    def above(points: SurfacePoints, directions, extent, row) -> np.ndarray:  # type: ignore[no-untyped-def]
        origins = points.x + np.float32(OFFSET * extent) * points.ng
        return origins if row is None else origins[row]

    return leaving_by(above, package, records)


def beside_the_facet(package: str, records: bytes) -> np.ndarray:
    """The side is that of the geometric normal, but where rays start on the smooth surface."""

    def origins(points: SurfacePoints, directions, extent, row) -> np.ndarray:  # type: ignore[no-untyped-def]
        points = points if row is None else points.take(row)
        behind = np.sum(points.n * directions, axis=1, keepdims=True) < 0.0
        n, lift = np.where(behind, points.ng, points.n), np.where(behind, 0.0, points.lift)
        return leaving_origins(replace(points, n=n, lift=lift), directions, extent)

    return leaving_by(origins, package, records)


def of_strands(start_strand: bool):  # type: ignore[no-untyped-def]
    """By brute force, of one part: is the whole strand of x passed through? Entries at joints
    count."""

    def visibility(package: str, records: bytes) -> np.ndarray:
        with Package.open(package) as opened:
            curves, alone = opened.geometry(), len(opened.manifest.parts) == 1
        if not (alone and isinstance(curves, Curves)):
            return conformance_reader.visibility(package, records)
        words = np.frombuffer(records, "<u4").reshape(-1, 8)
        segment, numbers = words[:, 0], words.view("<f4")
        t = entries(curves, numbers[:, 1:4], unit(numbers[:, 4:7].astype(np.float64)))
        strand, number = strands(curves), np.arange(len(strands(curves)))
        passed = strand == strand[segment][:, None] if start_strand else number == segment[:, None]
        return as_colours(~(np.isfinite(t) & ~passed).any(axis=1))

    return visibility


def as_colours(seen: np.ndarray) -> np.ndarray:
    return np.repeat(seen[:, None], 3, axis=1).astype(np.float32)


@pytest.mark.parametrize(
    ("visibility", "kind", "classes"),
    [
        (without_lift, "surface", ("terminator", "behind the facet")),
        (from_outside, "surface", ("backs",)),
        (beside_the_facet, "surface", ("behind the smooth surface",)),
        (of_strands(start_strand=False), "fiber", ("own strand", "at joints")),
        (of_strands(start_strand=True), "fiber", ("inside another strand",)),
    ],
)
def test_readers_with_a_simpler_visibility_fail(visibility, kind, classes, kit):  # type: ignore[no-untyped-def]
    failed = failures(InProcess(visibility=visibility), kit, "visibility")
    assert failed and all(score.package.startswith((kind, "parts")) for score in failed)
    for name in classes:
        assert any(name in score.note for score in failed), [score.note for score in failed]


def by_its_own_part(package: str, records: bytes) -> np.ndarray:
    """Other parts block nothing."""
    scene_of = parts_scene.PartsScene

    def alone(geometries, transmittance):  # type: ignore[no-untyped-def]
        scenes = [scene_of([g], [t]) for g, t in zip(geometries, transmittance, strict=True)]
        return SimpleNamespace(visible=lambda part, *at: scenes[part].visible(0, *at))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(parts_scene, "PartsScene", alone)
        return conformance_reader.visibility(package, records)


def test_a_reader_in_which_parts_do_not_block_each_other_fails(kit):
    failed = failures(InProcess(visibility=by_its_own_part), kit, "visibility")
    notes = {score.package: score.note for score in failed}
    assert set(notes) == {"parts-head", "parts-lantern", "parts-pairs"}
    assert "towards another part" in notes["parts-head"] and notes["parts-lantern"]


def with_records(change: Callable[[Transmittance], Transmittance | None]):  # type: ignore[no-untyped-def]
    """Records of transmittance are read wrong, or not at all."""
    transmittance = Package.transmittance

    def changed(package: Package, part: int = 0) -> list[Transmittance]:
        return [new for old in transmittance(package, part) if (new := change(old))]

    def visibility(package: str, records: bytes) -> np.ndarray:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Package, "transmittance", changed)
            return conformance_reader.visibility(package, records)

    return visibility


@pytest.mark.parametrize(
    "change",
    [
        lambda record: None,
        lambda record: replace(record, cutoff=None),
        lambda record: replace(record, ior=None),
        lambda record: replace(record, ior=record.ior and record.ior[::-1]),
        lambda record: replace(record, texture=record.texture[::-1].copy()),
        lambda record: replace(record, texture=record.texture[:, :, :1].copy()),
        lambda record: replace(record, first=record.first + (record.count == 1)),
    ],
    ids=["opaque", "cutoff", "fresnel", "sides", "upside down", "grey", "triangles"],
)
def test_readers_that_get_transmittance_wrong_fail(change, kit):  # type: ignore[no-untyped-def]
    failed = failures(InProcess(visibility=with_records(change)), kit, "visibility")
    by_name = {score.package: score for score in failed}
    assert set(by_name) <= {"parts-lantern", "surface-screens"}
    assert by_name["parts-lantern"].right > 0.5 * by_name["parts-lantern"].rows


def test_a_reader_that_asks_the_first_part_alone_fails(kit):
    def evaluate(
        form: str, package: str, tier: str, part: int, arrays: dict[str, np.ndarray]
    ) -> np.ndarray:
        query = 0 if form == "transport" else part
        return reader.evaluate(form, package, tier, query, arrays)

    failed = failures(InProcess(evaluate), kit, "evaluate")
    assert {(score.package, score.tier) for score in failed} == {
        *(("parts-head", "small 1"), ("parts-head", "hq 1")),
        *(("parts-lantern", "small 1"), ("parts-lantern", "small 2")),
    }


def test_a_reader_without_emission_fails(kit):
    def evaluate(
        form: str, package: str, tier: str, part: int, arrays: dict[str, np.ndarray]
    ) -> np.ndarray:
        if form != "transport":
            raise ConformanceError(f"no {form} here")
        return reader.evaluate(form, package, tier, part, arrays)

    failed = failures(InProcess(evaluate), kit, "evaluate")
    assert {score.tier.split()[-1] for score in failed} == {"emission"} and len(failed) == 3
    assert "no emission here" in failed[0].note


def with_lobes(change: Callable[[LobeQueries], LobeQueries]):  # type: ignore[no-untyped-def]
    """Lobes of queries that are read wrong."""

    def environment(package: str, tier: str, part: int, queries: LobeQueries) -> np.ndarray:
        return reader.environment(package, tier, part, change(queries))

    return environment


@pytest.mark.parametrize(
    ("change", "packages"),
    [
        (lambda q: replace(q, free=np.ones_like(q.free)), {"surface-quantised", "fiber-quantised"}),
        (lambda q: replace(q, axis=-q.axis), {"surface-quantised", "fiber-quantised"}),
        (lambda q: replace(q, u=q.v, v=q.u), {"surface-quantised"}),
        (lambda q: replace(q, primitive=0 * q.primitive), {"surface-quantised"}),
        (lambda q: replace(q, h=-q.h), {"fiber-quantised"}),
    ],
    ids=["free", "turned", "corners", "first triangle", "other side"],
)
def test_readers_that_get_lobes_wrong_fail(change, packages, kit):  # type: ignore[no-untyped-def]
    failed = failures(InProcess(environment=with_lobes(change)), kit, "environment")
    assert {score.package for score in failed} == packages
    assert all("expected" in score.note for score in failed)


def with_maps(change: Callable[[NormalMap], NormalMap | None]):  # type: ignore[no-untyped-def]
    """Normal maps are read wrong, or not at all."""
    normal_maps = Package.normal_maps

    def changed(package: Package, part: int = 0) -> list[NormalMap]:
        return [new for old in normal_maps(package, part) if (new := change(old))]

    def normals(package: str, records: bytes) -> np.ndarray:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Package, "normal_maps", changed)
            return conformance_reader.normals(package, records)

    return normals


def turned(texture: np.ndarray, *factors: int) -> np.ndarray:
    """With other signs of x and y."""
    return np.clip(127 + (texture.astype(int) - 127) * factors, 0, 255).astype(np.uint8)


@pytest.mark.parametrize(
    "change",
    [
        lambda record: None,
        lambda record: replace(record, texture=turned(record.texture, 1, -1)),
        lambda record: replace(record, texture=turned(record.texture, -1, 1)),
        lambda record: replace(record, texture=record.texture[..., ::-1].copy()),
        lambda record: replace(record, texture=record.texture[::-1].copy()),
        lambda record: replace(record, first=record.first + 1),
    ],
    ids=["plain", "y down", "x back", "y first", "upside down", "triangles"],
)
def test_readers_that_get_normal_maps_wrong_fail(change, kit):  # type: ignore[no-untyped-def]
    notes = {
        s.package: s.note for s in failures(InProcess(normals=with_maps(change)), kit, "normals")
    }
    assert "expected" in notes["surface-relief"]


def angles_of_the_shape(host: ModuleType) -> None:
    """Corners weigh by their angles in the deformed shape."""
    rest_of_mesh, normals = host.rest_of_mesh, host.deformed_normals

    def changed(mesh, shape, *hits):  # type: ignore[no-untyped-def]
        host.deformed_normals = lambda _, *of: normals({**mesh, "positions": shape}, *of)
        return rest_of_mesh(mesh, shape, *hits)

    host.rest_of_mesh = changed


def facets_alone(host: ModuleType) -> None:
    """Q is that of the triangle."""
    host.smallest_rotations = lambda a, b: np.tile(np.eye(3), (len(a), 1, 1))


def unturned_roots(host: ModuleType) -> None:
    """A strand's first segment turns by the smallest angle."""
    host.root_rotation = lambda *strand: np.eye(3)


MESHES = {
    *("surface-float32", "surface-clip", "surface-quantised", "surface-relief", "surface-tiny"),
    "surface-folds",
}
STRANDS = {"fiber-float16", "fiber-int8", "fiber-one-channel", "parts-head", "fiber-lone"}


@pytest.mark.filterwarnings("ignore:invalid value:RuntimeWarning")  # a half turn has many axes
@pytest.mark.parametrize(
    ("change", "packages"),
    [(angles_of_the_shape, MESHES), (facets_alone, MESHES | STRANDS), (unturned_roots, STRANDS)],
)
def test_readers_that_turn_deformed_shapes_wrong_fail(change, packages, kit, deformed_host):
    change(deformed_host)
    failed = failures(with_geometry(deformed_host), kit, "deformed")
    assert {score.package for score in failed} == packages


@pytest.mark.parametrize(
    ("name", "change", "package"),
    [
        ("unit", lambda normals: normals, "surface-quantised"),
        ("rounded", lambda values: np.float16(values).astype(float), "fiber-quantised"),
    ],
)
def test_readers_that_restore_geometry_wrong_fail(name, change, package, kit, deformed_host):
    setattr(deformed_host, name, change)
    failed = failures(with_geometry(deformed_host), kit, "geometry")
    assert package in {score.package for score in failed}
