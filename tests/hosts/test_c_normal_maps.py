"""Normal maps in the C host: the normals of the numpy function."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from rna_sdk.package import Package, write_package
from rna_sdk.package.manifest import NormalMapRecord
from rna_sdk.runtime.normal_maps import mapped_normals
from tests.hosts.c_host import CAsset, build, compiler
from tests.package.builders import make_manifest, make_mesh, make_part, make_tier, make_tier_data

pytestmark = pytest.mark.skipif(compiler() is None, reason="needs cc and make")

BARK, DENT = "normals/bark.safetensors", "normals/dent.safetensors"


@pytest.fixture
def relief(tmp_path: Path) -> Path:
    """Of one part, with random coordinates; triangle 2 has no map."""
    records = (
        NormalMapRecord(triangles=(0, 2), texture=BARK),
        NormalMapRecord(triangles=(3, 1), texture=DENT),
    )
    rng = np.random.default_rng(7)
    bark = rng.integers(0, 256, (3, 4, 2)).astype(np.uint8)
    mesh = make_mesh()  # its own coordinates leave triangles without a direction
    mesh = replace(mesh, uvs=rng.uniform(-1, 2, (len(mesh.positions), 2)).astype(np.float32))
    maps = {BARK: bark, DENT: np.uint8([[[40, 160]]])}
    tier = make_tier("small")
    manifest = make_manifest(tier, parts=(make_part(normal_maps=records),))
    path = tmp_path / "relief.rna"
    write_package(path, manifest, [mesh], {"small": make_tier_data(tier)}, maps)
    return path


def test_normals_are_those_of_the_numpy_function(relief: Path, tmp_path: Path) -> None:
    library = build(tmp_path / "build", "librna.so", arch="")[0]
    rng = np.random.default_rng(3)
    triangle = rng.integers(0, 4, 400)
    b1, b2 = rng.dirichlet((1, 1, 1), 400)[:, 1:].T
    with Package.open(relief) as package:
        mesh = package.geometry()
        expected = mapped_normals(mesh, package.normal_maps(), triangle, b1, b2)
        plain = mapped_normals(mesh, [], triangle, b1, b2)
    with closing(CAsset(library, relief, "small")) as asset:
        assert asset.record.normal_map_count == 2
        found = np.stack([asset.normal(*hit) for hit in zip(triangle, b1, b2, strict=True)])
        assert not asset.normal(4, 0.2, 0.2).any()
    np.testing.assert_allclose(found, expected, atol=1e-6)
    is_bent = np.abs(found - plain).max(axis=1) > 1e-3
    assert is_bent[triangle != 2].mean() > 0.9 and not is_bent[triangle == 2].any()
