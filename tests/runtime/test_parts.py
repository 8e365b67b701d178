"""Assets of several parts, and what they emit: as by hand, and safe for any input."""

from dataclasses import fields

import numpy as np
import onnxruntime as ort
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import Package
from rna_sdk.runtime import CompositeAsset, FiberAsset, SurfaceAsset, load
from tests.package.builders import make_curves, make_tiny_package
from tests.package.lantern import make_lantern
from tests.reference.queries import queries_reference
from tests.runtime.points import random_fiber_points, random_points


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return make_lantern(tmp_path_factory.mktemp("lantern") / "lantern.rna")


def test_parts_are_assets_of_their_kind(path):
    asset = load(path, "hq", threads=2)
    assert isinstance(asset, CompositeAsset) and not hasattr(asset, "evaluate")
    assert (asset.name, asset.tier.name, asset.threads) == ("lantern", "hq", 2)
    body, tuft = asset.parts
    assert isinstance(body, SurfaceAsset) and isinstance(tuft, FiberAsset)
    assert [(part.name, part.kind) for part in asset.parts] == [
        ("body", "surface"),
        ("tuft", "fiber"),
    ]
    assert (body.emits, tuft.emits, asset.emits) == (True, False, True)
    assert body.tier_part == asset.tier.parts[0] and body.tier == asset.tier
    assert len(body.transmittance_records) == 2 and tuft.transmittance_records == ()
    np.testing.assert_array_equal(tuft.curves.points, make_curves().points)


def test_bounds_are_around_all_parts(tmp_path, path):
    manifest = Package.open(path).manifest
    box = manifest.parts[1].bounds.model_copy(update={"min": (-3.0, 0.0, 0.0)})
    moved = manifest.parts[1].model_copy(update={"bounds": box})
    asset = load(make_lantern(tmp_path / "x.rna", parts=(manifest.parts[0], moved)))
    assert asset.bounds.tolist() == [[-3, -1, -1], [1, 1, 1]]
    assert not asset.bounds.flags.writeable


def test_an_asset_of_one_part_is_its_part(tmp_path):
    asset = load(make_tiny_package(tmp_path / "x.rna"))
    assert asset.parts == (asset,) and not asset.emits
    assert asset.name == "tetrahedron" and asset.transmittance_records == ()
    points = random_points(20)
    dark = asset.emission(points.positions, points.normals, points.wo)
    assert dark.shape == (20, 3) and dark.dtype == np.float32 and not dark.any()


def test_each_part_answers_with_its_own_tier_part(path):
    small, hq = load(path, "small").parts, load(path, "hq").parts
    for points, (one, other) in zip(
        (random_points(50), random_fiber_points(50)), zip(small, hq, strict=True), strict=True
    ):
        answers = one.evaluate(*points), other.evaluate(*points)
        assert all(np.any(values) for pair in answers for values in pair)
        assert not np.array_equal(answers[0], answers[1])


def test_emission_is_that_of_the_package_evaluated_by_hand(path):
    points = random_points(3000)
    body = load(path, threads=2).parts[0]
    with Package.open(path) as package:
        record = package.tier("small").parts[0]
        assert record.emission is not None
        corners = package.manifest.parts[0].bounds.corners()
        at = points.positions, points.normals, points.wo
        wi = np.ones_like(points.wo)  # read by no block
        planes = package.planes("small")
        queries = queries_reference(planes, corners, record.emission.inputs, *at, wi)
        decoder = bytes(package.decoder("small", form="emission"))
        session = ort.InferenceSession(decoder, providers=["CPUExecutionProvider"])
    (expected,) = session.run(["emission"], {"queries": queries})
    actual = body.emission(*at)
    assert (expected > 0).mean() > 0.2
    np.testing.assert_allclose(actual, expected, rtol=1e-4, atol=1e-5)
    alone = np.concatenate([body.emission(*(a[k : k + 1] for a in at)) for k in range(0, 50)])
    np.testing.assert_array_equal(alone, actual[:50])


def test_emission_of_rows_that_are_no_points_is_0(path):
    body = load(path).parts[0]
    points = random_points(20)
    at = points.positions, points.normals, points.wo
    assert body.emission(*at)[[3, 7]].any(axis=1).all()
    for array in at:
        array[3, 1], array[7] = np.nan, 0
    actual = body.emission(*at)
    assert not actual[[3, 7]].any() and np.isfinite(actual).all()
    assert body.emission(*(a[:0] for a in at)).shape == (0, 3)


def test_a_wrong_argument_of_emission_is_named(path):
    body, tuft = load(path).parts
    points, strands = random_points(5), random_fiber_points(5)
    names = [field.name for field in fields(points)][:3]
    for place, name in enumerate(names):
        arguments = [points.positions, points.normals, points.wo]
        arguments[place] = arguments[place][:4]
        if place:
            with pytest.raises(QueryError, match=f"^{name}: expected"):
                body.emission(*arguments)
    with pytest.raises(QueryError, match=r"^h: expected"):
        tuft.emission(strands.positions, strands.tangents, strands.h[:4], strands.wo)


def test_cost_of_several_parts_is_their_mean(path, monkeypatch):
    asset = load(path)
    costs = dict(zip(asset.parts, (100.0, 300.0), strict=True))
    for cls in (SurfaceAsset, FiberAsset):
        monkeypatch.setattr(cls, "measured_part_ns", lambda part: costs[part])
    assert asset.measured_ns_per_query() == 200
    assert asset.parts[1].measured_ns_per_query() == 300
