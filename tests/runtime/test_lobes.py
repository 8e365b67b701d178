"""Lobes of a whole environment: as by hand, and safe for any input."""

import numpy as np
import onnxruntime as ort
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import Package, Unpacked, float_planes
from rna_sdk.runtime import FiberAsset, SurfaceAsset, load
from tests.package.lantern import make_lantern
from tests.package.lobes import with_lobes
from tests.reference.lobes import (
    lobes_reference,
    log_normalisation,
    mirror_reference,
    radiance_reference,
    visibility_reference,
)
from tests.reference.queries import fiber_queries_reference, queries_reference
from tests.runtime.points import random_fiber_points, random_points

Part = SurfaceAsset | FiberAsset


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    """A surface and fibers, both with lobes and visibility."""
    folder = tmp_path_factory.mktemp("lobes")
    return with_lobes(make_lantern(folder / "lantern.rna"), folder / "lobes.rna", 0, 1)


@pytest.fixture(scope="module", params=[0, 1], ids=["surface", "fiber"])
def part(path, request):
    return load(path, threads=2).parts[request.param]


def arguments(part: Part, n: int) -> tuple[np.ndarray, ...]:
    """Those of `lobes`."""
    points = random_points(n) if part.kind == "surface" else random_fiber_points(n)
    *at, _ = points
    u, v = np.random.default_rng(8).uniform(0.0, 0.5, (2, n)).astype(np.float32)
    primitives = np.arange(n) % 4
    free = np.linspace(0.0, 1.0, n, dtype=np.float32)
    return *at, free, part.visibility_at(primitives, u, v)


def test_lobes_are_those_of_the_package_evaluated_by_hand(part, path):
    *at, free, visibility = arguments(part, 3000)
    amplitudes, axes = part.lobes(*at, free, visibility)
    assert amplitudes.shape == axes.shape == (3000, 4, 3) and axes.dtype == np.float32
    number = 0 if part.kind == "surface" else 1
    with Package.open(path) as package:
        lobes = package.environment(number)
        box = package.manifest.parts[number].bounds.corners()
    place = float_planes(lobes.planes), box, lobes.record.inputs
    mirror = mirror_reference(part.kind, at[1], at[-1])
    if part.kind == "surface":
        blocks = queries_reference(*place, *at, mirror, of_lobes=True)
    else:
        blocks = fiber_queries_reference(*place, *at, mirror)
    session = ort.InferenceSession(bytes(lobes.decoder), providers=["CPUExecutionProvider"])
    queries = np.hstack([blocks, visibility])
    (output,) = session.run(["environment"], {"queries": queries})
    assert (output > 0).mean() > 0.2
    expected = lobes_reference(part.kind, output, at[1], at[-1], free)
    for actual, right in zip((amplitudes, axes), expected, strict=True):
        np.testing.assert_allclose(actual, right, rtol=2e-4, atol=2e-4)


def test_a_row_does_not_depend_on_the_batch(part):
    at = arguments(part, 600)
    together = part.lobes(*at)
    for k in (0, 17, 599):
        alone = part.lobes(*(array[k : k + 1] for array in at))
        for one, all_rows in zip(alone, together, strict=True):
            np.testing.assert_array_equal(one[0], all_rows[k])
    assert part.lobes(*(array[:0] for array in at))[0].shape == (0, 4, 3)


def test_rows_that_are_no_points_have_no_light(part):
    at = arguments(part, 40)
    bad = {0: np.nan, 1: 0.0, len(at) - 3: 0.0, len(at) - 2: np.inf, len(at) - 1: np.nan}
    for row, (place, value) in enumerate(bad.items()):
        at[place][row] = value
    amplitudes, axes = part.lobes(*at)
    assert np.isfinite(amplitudes).all() and np.isfinite(axes).all() and (amplitudes >= 0).all()
    assert not amplitudes[: len(bad)].any() and not axes[: len(bad)].any()
    assert amplitudes[len(bad) :].any(axis=(1, 2)).mean() > 0.5


def test_free_light_mixes_the_two_colours(part):
    *at, free, visibility = arguments(part, 100)
    low, middle, high = (
        part.lobes(*at, np.full_like(free, v), visibility)[0] for v in (0.0, 0.25, 1.0)
    )
    np.testing.assert_allclose(middle, 0.75 * low + 0.25 * high, rtol=1e-5, atol=1e-6)
    beyond = part.lobes(*at, np.full_like(free, 1.5), visibility)[0]
    np.testing.assert_array_equal(beyond, high)


def test_mirror_directions(part):
    points = random_points(200)
    actual = part.mirror(points.normals, 3 * points.wo)
    np.testing.assert_allclose(
        actual, mirror_reference(part.kind, points.normals, points.wo), atol=1e-6
    )
    along = np.sum(points.normals * points.wo, axis=1)
    sign = 1 if part.kind == "surface" else -1
    np.testing.assert_allclose(np.sum(points.normals * actual, axis=1), sign * along, atol=1e-6)
    points.wo[0], points.wo[1] = 0, np.nan
    assert not part.mirror(points.normals, points.wo)[:2].any()


def test_visibility_is_interpolated_between_vertices(part, path):
    with Package.open(path) as package:
        harmonics = package.environment(0 if part.kind == "surface" else 1).harmonics
    u, v = np.float32([0.25, 0.5, 0.0]), np.float32([0.5, 0.25, 0.0])
    primitives = np.array([3, 0, 2])
    if part.kind == "surface":
        corners, weights = part.mesh.triangles[primitives], np.stack([1 - u - v, u, v], axis=1)
    else:
        first = part.curves.segments()[primitives]
        corners, weights = np.stack([first, first + 1], axis=1), np.stack([1 - u, u], axis=1)
    actual = part.visibility_at(primitives, u, v)
    np.testing.assert_allclose(actual, visibility_reference(harmonics, corners, weights), atol=1e-6)
    with pytest.raises(QueryError, match="primitives: a number is outside"):
        part.visibility_at(primitives + 97, u, v)
    with pytest.raises(QueryError, match=r"^u: expected"):
        part.visibility_at(primitives, u[:2], v)


def test_a_part_without_lobes(path, tmp_path):
    lantern = make_lantern(tmp_path / "plain.rna")
    body, tuft = load(with_lobes(lantern, tmp_path / "x.rna", 1, visibility=False)).parts
    assert body.environment_form is None and tuft.environment_form.lobes == 4
    none = np.zeros(3, np.float32)
    for part in (body, tuft):
        assert part.visibility_at(np.zeros(3, np.int64), none, none).shape == (3, 0)
    *at, _ = random_fiber_points(3)
    assert tuft.lobes(*at, none, np.empty((3, 0), np.float32))[0].any()
    *at, _ = random_points(3)
    with pytest.raises(QueryError, match="no lobes here"):
        body.lobes(*at, none, np.empty((3, 0), np.float32))


def test_a_wrong_argument_is_named(part):
    at = arguments(part, 5)
    names = ["positions", part._labels["axis"], "h", "wo", "free", "visibility"]
    names.remove("h") if part.kind == "surface" else None
    for place, name in enumerate(names):
        if place:
            changed = [a[:4] if k == place else a for k, a in enumerate(at)]
            with pytest.raises(QueryError, match=f"^{name}: expected"):
                part.lobes(*changed)


def test_lobes_are_for_the_full_geometry(path, tmp_path):
    unpacked, out = Unpacked.read(path), tmp_path / "x.rna"
    with Package.open(path) as package:
        curves = package.curves(1)
    unpacked.with_proxies([[], [(curves, 64)]]).write(out)
    assert load(out).parts[1].environment_form is not None
    near, far = load(out, pixels=65).parts[1], load(out, pixels=64).parts[1]
    assert near.environment_form is not None and far.environment_form is None


def test_radiance_under_a_wide_light_is_the_integral():
    """The closed form of the specification, against a sum over directions."""
    rng = np.random.default_rng(1)
    amplitudes, axes = rng.uniform(0, 1, (5, 4, 3)), rng.normal(0, 4, (5, 4, 3))
    light, flux = np.array([3.0, -2.0, 5.0]), np.array([1.0, 2.0, 0.5])
    n = 200_000
    z = 1 - (2 * np.arange(n) + 1) / n
    turn, r = np.pi * (1 + 5**0.5) * np.arange(n), np.sqrt(1 - z * z)
    d = np.stack([r * np.cos(turn), r * np.sin(turn), z], axis=1)

    def density(a: np.ndarray) -> np.ndarray:
        kappa = np.linalg.norm(a, axis=-1)
        return np.exp(log_normalisation(kappa)[..., None] + a @ d.T)

    weight = 4 * np.pi / n
    np.testing.assert_allclose(density(axes).sum(axis=-1) * weight, 1, rtol=1e-3)
    shares = density(axes) @ density(light) * weight
    expected = np.einsum("nlc,nl->nc", amplitudes, shares) * flux
    actual = radiance_reference(amplitudes, axes, light, flux)
    np.testing.assert_allclose(actual, expected, rtol=1e-3)
