"""Base colour: what `evaluate` makes of it, and its lookup at hits against the reference."""

import math
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import BaseColor, Mesh, Package, decoder_from_bytes
from rna_sdk.runtime import SurfaceAsset, load
from rna_sdk.runtime.base_color import BaseColorMaps, base_color_levels
from tests.package.builders import make_mesh
from tests.package.lobes import with_lobes
from tests.package.prints import make_print, tiers
from tests.reference.base_color import base_color_reference
from tests.reference.queries import queries_reference
from tests.runtime.points import Points, random_points

PRECISIONS = ("float32", "int8")
STORED = 0.004
"""A step of 8 bits at the bright end, to which levels above 0 are rounded."""


@pytest.fixture(scope="session", params=product(PRECISIONS, ("small", "hq")), ids="-".join)
def printed(request, tmp_path_factory):
    """A package with factors in a tier of one decoder, or of two; and the tier."""
    precision, tier = request.param
    folder = tmp_path_factory.mktemp("print")
    return make_print(folder / "print.rna", tiers=tiers(True, precision)), tier


def opened(printed: tuple[Path, str], threads: int = 1) -> SurfaceAsset:
    asset = load(*printed, threads=threads)
    assert isinstance(asset, SurfaceAsset)
    return asset


def colours(count: int) -> np.ndarray:
    return np.random.default_rng(5).uniform(size=(count, 3)).astype(np.float32)


def by_hand(printed: tuple[Path, str], points: Points, base_color: np.ndarray) -> list[np.ndarray]:
    """Visible and shadowed: the decoders run one by one in numpy."""
    path, name = printed
    results = []
    with Package.open(path) as package:
        planes, bounds = package.planes(name), package.manifest.parts[0].bounds.corners()
        for decoder in package.tier(name).parts[0].decoders:
            queries = queries_reference(planes, bounds, decoder.inputs, *points)
            model = package.decoder(name, 0, decoder.form.name)
            output = decoder_from_bytes(model, decoder.entry).run(queries)
            light, factors = np.hsplit(output, 2)
            results.append(light + np.tile(base_color, light.shape[1] // 3) * factors)
    visible, shadowed = np.hsplit(np.hstack(results), 2)
    return [visible, shadowed]


def test_light_is_a_sum_of_which_one_term_has_the_base_colour(printed):
    points, base_color = random_points(3000), colours(3000)
    actual = opened(printed).evaluate(*points, base_color=base_color)
    share = 0.02 if "int8" in load(*printed).tier.parts[0].decoder_precision else 0
    for result, expected in zip(actual, by_hand(printed, points, base_color), strict=True):
        assert (expected > 0).mean() > 0.2
        off = ~np.isclose(result, expected, rtol=1e-4, atol=1e-5)
        assert off.any(axis=1).mean() <= share
    black = opened(printed).evaluate(*points, base_color=0 * base_color)
    assert all((a >= b).all() and (a > b).any() for a, b in zip(actual, black, strict=True))


def test_a_row_depends_on_its_base_colour_alone(printed):
    points, base_color = random_points(5003), colours(5003)
    expected = np.hstack(opened(printed).evaluate(*points, base_color=base_color))
    for threads, size in ((3, 5003), (2, 7), (1, 2049)):
        asset = opened(printed, threads)
        parts = [
            np.hstack(asset.evaluate(*points[i : i + size], base_color=base_color[i : i + size]))
            for i in range(0, 5003, size)
        ]
        np.testing.assert_array_equal(np.concatenate(parts), expected)
    out = np.empty((5003, 3), np.float32), np.empty((5003, 3), np.float32)
    assert opened(printed).evaluate(*points, base_color, out)[0] is out[0]
    np.testing.assert_array_equal(np.hstack(out), expected)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_a_base_colour_that_is_not_finite_gives_black(printed, value):
    asset, points, base_color = opened(printed), random_points(30), colours(30)
    expected = np.hstack(asset.evaluate(*points, base_color=base_color))
    for k in range(3):
        base_color[k, k] = value
    actual = np.hstack(asset.evaluate(*points, base_color=base_color))
    assert not actual[:3].any() and expected[:3].any(axis=1).all()
    np.testing.assert_array_equal(actual[3:], expected[3:])


def test_base_colours_out_of_range_give_light_that_is_finite_and_not_negative(
    printed,
):
    asset, points = opened(printed), random_points(6)
    base_color = np.float32([[-1, -1e30, 3e38], [2, 0, -0.0], [1e-45, 1, 1]] * 2)
    for light in asset.evaluate(*points, base_color=base_color):
        assert np.isfinite(light).all() and (light >= 0).all() and light.any()


def test_a_missing_base_colour_is_an_error(printed):
    asset, points = opened(printed), random_points(5)
    assert asset.uses_base_color
    with pytest.raises(
        QueryError, match=r"^base_color: print needs it; base_color_at looks it up$"
    ):
        asset.evaluate(*points)
    for wrong in (np.ones((5, 3)), np.ones((4, 3), np.float32), np.ones((5, 4), np.float32)):
        with pytest.raises(QueryError, match=r"^base_color: expected a"):
            asset.evaluate(*points, base_color=wrong)


def test_an_asset_that_does_not_use_it_does_not_look_at_it(tmp_path):
    path = make_print(tmp_path / "print.rna", tiers=tiers(None))
    points = random_points(50)
    for tier in ("small", "hq"):
        asset = opened((path, tier))
        assert not asset.uses_base_color
        expected = asset.evaluate(*points)
        ignored = asset.evaluate(*points, base_color=np.full((50, 3), np.nan, np.float32))
        np.testing.assert_array_equal(np.hstack(ignored), np.hstack(expected))
        assert np.hstack(expected).any()
        np.testing.assert_allclose(asset.base_color_at(*hits(50, 4))[:, 0].max(), 0.8, atol=0.2)


def test_an_asset_has_the_base_colour_of_its_package(printed):
    asset = opened(printed)
    with Package.open(printed[0]) as package:
        records = package.base_color()
    at = hits(500, 4)
    expected = base_color_reference(asset.mesh, records, *at, np.zeros(500))
    np.testing.assert_allclose(asset.base_color_at(*at), expected, atol=1e-5)


def hits(count: int, triangles: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Triangles, and u and v on them, some at corners and edges."""
    rng = np.random.default_rng(count)
    u, v = rng.dirichlet((1, 1, 1), count)[:, 1:].astype(np.float32).T.copy()
    u[::7], v[::11] = 0, 0
    return rng.integers(0, triangles, count), u, v


def sheet(seed: int) -> Mesh:
    rng = np.random.default_rng(seed)
    positions = rng.normal(size=(30, 3)).astype(np.float32)
    uvs = rng.uniform(-1, 2, (30, 2)).astype(np.float32)
    normals = np.tile(np.float32([0, 0, 1]), (30, 1))
    return Mesh(positions, normals, uvs, rng.integers(0, 30, (20, 3)).astype(np.uint32))


IDENTITY, SKEWED = (1, 0, 0, 0, 1, 0), (2, 0.3, 0.1, -0.2, 3, 0.4)
IMAGES = {
    "even": ((8, 16), ("repeat", "repeat"), IDENTITY, "srgb"),
    "odd": ((7, 13), ("mirror", "clamp"), SKEWED, "linear"),
    "one texel": ((1, 1), ("clamp", "mirror"), IDENTITY, "srgb"),
    "narrow": ((300, 5), ("repeat", "mirror"), (1, 0, 0, 0, -1, 1), "srgb"),
    "one row": ((1, 9), ("mirror", "mirror"), SKEWED, "srgb"),
    "one column": ((6, 1), ("clamp", "clamp"), SKEWED, "linear"),
    "far": ((5, 4), ("repeat", "mirror"), (1, 0, -40000, 0, 1, 30001), "srgb"),
}


@pytest.mark.parametrize("name", IMAGES)
def test_the_lookup_is_that_of_the_reference(name):
    size, wrap, transform, color_space = IMAGES[name]
    image = np.random.default_rng(1).integers(0, 256, (*size, 3), dtype=np.uint8)
    image.flags.writeable = False
    mesh = sheet(2)
    records = [
        BaseColor(2, 7, None, factor=(0.2, 0.3, 0.4)),
        BaseColor(9, 8, image, color_space, (0.5, 1.0, 0.7), wrap, transform),
    ]
    maps, at = BaseColorMaps(mesh, records), hits(600, 20)
    density = densities(mesh, records[1])[at[0]]
    widths = np.exp2(np.random.default_rng(4).uniform(-3, 12, 600)) / density
    widths = np.where(np.isfinite(widths), widths, 0).astype(np.float32)
    level = np.log2(np.maximum(widths * density, 1.0))
    actual = maps.at(*at, widths)
    expected = base_color_reference(mesh, records, *at, level)
    np.testing.assert_allclose(actual, expected, atol=STORED)
    np.testing.assert_allclose(actual[level == 0], expected[level == 0], atol=1e-4)
    np.testing.assert_allclose(
        maps.at(*at), base_color_reference(mesh, records, *at, 0 * level), atol=1e-4
    )
    free = ~np.isin(at[0], range(2, 17))
    assert free.any() and (actual[free] == 1).all()
    assert (level > 0).sum() > 100 and (level == 0).sum() > 100 and actual.dtype == np.float32


def densities(mesh: Mesh, record: BaseColor) -> np.ndarray:
    """Texels of the image a metre on each triangle: square roots of ratios of areas."""
    corners = mesh.triangles
    a, b, c = (mesh.positions[corners[:, k]].astype(np.float64) for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    matrix = np.reshape(record.transform, (2, 3))[:, :2]
    p, q, r = (mesh.uvs[corners[:, k]].astype(np.float64) @ matrix.T for k in range(3))
    (x1, y1), (x2, y2) = (q - p).T, (r - p).T
    texels = np.abs(x1 * y2 - x2 * y1) / 2 * record.image.shape[0] * record.image.shape[1]
    return np.sqrt(np.divide(texels, area, out=np.zeros_like(area), where=area > 0))


def test_the_last_level_is_the_mean_of_the_image():
    image = np.random.default_rng(1).integers(0, 256, (37, 22, 3), dtype=np.uint8)
    maps, at = BaseColorMaps(sheet(2), [BaseColor(0, 20, image, "linear")]), hits(40, 20)
    mean = np.broadcast_to((image / 255).mean(axis=(0, 1)), (40, 3))
    far = maps.at(*at, 1e6)
    np.testing.assert_allclose(far, mean, atol=0.01)
    np.testing.assert_array_equal(maps.at(*at, math.inf), far)


def test_a_record_without_an_image_has_no_levels():
    with pytest.raises(QueryError, match="the record has no image"):
        base_color_levels(BaseColor(0, 20, None, factor=(0.2, 0.3, 0.4)))


def test_encoded_colours_are_mixed_as_the_teacher_does():
    """Halfway between black and white is the linear value of the middle, 0.21."""
    image = np.uint8([[[0, 0, 0], [255, 255, 255]]])
    uvs = np.float32([[0.5, 0.5], [0.5, 0.5], [0.5, 0.5]])
    mesh = make_mesh()
    mesh = Mesh(mesh.positions[:3], mesh.normals[:3], uvs, mesh.triangles[:1])
    first, third = np.zeros(1, np.int64), np.full(1, 1 / 3, np.float32)
    maps = BaseColorMaps(mesh, [BaseColor(0, 1, image)])
    np.testing.assert_allclose(maps.at(first, third, third), 0.21404, atol=1e-5)
    wide = BaseColorMaps(mesh, [BaseColor(0, 1, image, "linear", (0.5, 1, 0))])
    np.testing.assert_allclose(wide.at(first, third, third), [[0.25, 0.5, 0]], atol=1e-6)


def test_hits_that_are_not_there_are_refused(printed):
    asset = opened(printed)
    zero = np.zeros(2, np.float32)
    with pytest.raises(QueryError, match="primitives"):
        asset.base_color_at(np.int64([0, 4]), zero, zero)
    with pytest.raises(QueryError, match="u: "):
        asset.base_color_at(np.int64([0, 1]), zero[:1], zero)
    with pytest.raises(QueryError, match="widths: "):
        asset.base_color_at(np.int64([0, 1]), zero, zero, np.zeros(3, np.float32))
    assert asset.base_color_at(np.empty(0, np.int64), zero[:0], zero[:0]).shape == (0, 3)


def test_print_beyond_the_planes_of_lobes(tmp_path):
    """Its ratio; 1 of pixels that are wider than their texels, and of a part without lobes."""
    plain = make_print(tmp_path / "print.rna")
    asset = load(with_lobes(plain, tmp_path / "lobes.rna"))
    rng = np.random.default_rng(2)
    number, (u, v) = rng.integers(0, 4, 50).astype(np.uint32), rng.random((2, 50), np.float32) / 2
    texel = float(np.ptp(asset.bounds, axis=0).max() / asset.environment_form.resolution)
    narrow, wide = (np.full(50, width, np.float32) for width in (1e-3, 2.0 * texel))
    sharp, blurred = (asset.base_color_at(number, u, v, width) for width in (1e-3, texel))
    expected = (sharp + 0.02) / (blurred + 0.02)
    detail = asset.print_detail_at(number, u, v, narrow, sharp)
    np.testing.assert_allclose(detail, expected, rtol=1e-5)
    assert np.ptp(expected) > 0.5
    coarse = asset.base_color_at(number, u, v, wide)
    assert (asset.print_detail_at(number, u, v, wide, coarse) == 1.0).all()
    assert (load(plain).print_detail_at(number, u, v, narrow, sharp) == 1.0).all()
