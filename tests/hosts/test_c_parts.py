"""Assets of several parts in the C host: parts, emission, transmittance, quantised geometry."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from rna_sdk.package import Package
from rna_sdk.runtime import load
from tests.hosts.c_host import CAsset, compiler, values
from tests.hosts.packages import write_quantised
from tests.hosts.test_c_host import TOLERANCE, random_rows
from tests.package.lantern import make_lantern

pytestmark = pytest.mark.skipif(compiler() is None, reason="needs cc and make")

BODY, TUFT = 0, 1


@pytest.fixture(scope="module")
def lantern(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_lantern(tmp_path_factory.mktemp("lantern") / "lantern.rna")


@pytest.fixture
def body(library: Path, lantern: Path) -> Iterator[CAsset]:
    with closing(CAsset(library, lantern, "small", BODY)) as asset:
        yield asset


@pytest.mark.parametrize("part", [BODY, TUFT])
@pytest.mark.parametrize("tier", ["small", "hq"])
def test_every_part_means_the_same(tier: str, part: int, library: Path, lantern: Path) -> None:
    expected = load(lantern, tier, threads=1).parts[part]
    rows = random_rows(expected.kind, expected.bounds, 500)
    with closing(CAsset(library, lantern, tier, part)) as asset:
        transport = np.hstack(expected.evaluate(*rows)), np.hstack(asset.evaluate(*rows))
        emission = expected.emission(*rows[:-1]), asset.emission(*rows[:-1])
        assert (asset.record.name.decode(), asset.record.emits) == (expected.name, expected.emits)
        assert asset.record.emits == (part == BODY)
    for theirs, ours in (transport, emission):
        scale = np.sqrt(np.mean(theirs.astype(np.float64) ** 2))
        assert np.abs(ours - theirs).max() <= TOLERANCE * scale
    assert emission[0].any() == (part == BODY)


def test_quantised_geometry_is_restored_to_the_bit(library: Path, tmp_path: Path) -> None:
    path = write_quantised(tmp_path / "quantised.rna")
    with Package.open(path) as package:
        expected_mesh, expected_curves = package.geometry(BODY), package.geometry(TUFT)
    with closing(CAsset(library, path, "small", BODY)) as asset:
        mesh = asset.record.mesh.contents
        for name, width in (("positions", 3), ("normals", 3), ("uvs", 2)):
            actual = values(getattr(mesh, name), mesh.vertex_count, width)
            np.testing.assert_array_equal(actual, getattr(expected_mesh, name), name)
        actual = values(mesh.triangles, mesh.triangle_count, 3)
        np.testing.assert_array_equal(actual, expected_mesh.triangles)
    with closing(CAsset(library, path, "small", TUFT)) as asset:
        curves = asset.record.curves.contents
        actual = values(curves.points, curves.point_count, 3)
        np.testing.assert_array_equal(actual, expected_curves.points)
        actual = values(curves.radii, curves.point_count)
        np.testing.assert_array_equal(actual, expected_curves.radii)


def test_cut_out_is_open_or_closed(body: CAsset, lantern: Path) -> None:
    """Triangles 0 and 1 have holes where the texture, bilinear, is above a half."""
    with Package.open(lantern) as package:
        mesh = package.geometry(BODY)
    texture = np.float64([[0, 255, 255, 0], [0, 0, 255, 255], [128, 0, 0, 255]]) / 255
    rng = np.random.default_rng(4)
    seen = set()
    for b1, b2 in rng.dirichlet((1, 1, 1), 200)[:, 1:]:
        u, v = np.float64([1 - b1 - b2, b1, b2]) @ mesh.uvs[mesh.triangles[1]]
        s, t = u * 4 - 0.5, v * 3 - 0.5
        i, j = int(np.floor(s)), int(np.floor(t))
        rows, columns = texture[[j % 3, (j + 1) % 3]], [i % 4, (i + 1) % 4]
        value = [1 - (t - j), t - j] @ rows[:, columns] @ [1 - (s - i), s - i]
        tau = body.transmittance(1, b1, b2, np.float32([0.3, -0.8, 0.2]))
        np.testing.assert_array_equal(tau, np.float32([value > 0.5] * 3))
        seen.add(value > 0.5)
    assert seen == {False, True}


def test_pane_reflects_by_the_law_of_fresnel(body: CAsset, lantern: Path) -> None:
    """Triangle 3 is glass of index 1.5: 4% head-on, all of it where light grazes."""
    with Package.open(lantern) as package:
        mesh = package.geometry(BODY)
    normal = mesh.normals[mesh.triangles[3]].astype(np.float64).mean(axis=0)
    normal /= np.linalg.norm(normal)
    across = np.cross(normal, [0.0, 0.6, 0.8])
    across /= np.linalg.norm(across)
    colour = np.float64([200, 150, 100]) / 255
    for sine, reflected in ((0.0, 0.04), (np.sin(np.radians(60)), 0.0891867), (1.0, 1.0)):
        for side in (-1, 1):
            direction = side * np.sqrt(1 - sine**2) * normal + sine * across
            tau = body.transmittance(3, 1 / 3, 1 / 3, direction)
            np.testing.assert_allclose(tau, (1 - reflected) * colour, atol=1e-5)
    assert not body.transmittance(2, 1 / 3, 1 / 3, normal).any()
    assert not body.transmittance(99, 1 / 3, 1 / 3, normal).any()
