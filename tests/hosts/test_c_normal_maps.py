"""Normal maps in the C host: the normal of a hit, what its renderer asks with."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from rna_sdk.package import Package
from rna_sdk.runtime import mapped_normals
from tests.hosts.c_host import CAsset, compiler
from tests.package.relief import make_relief

pytestmark = pytest.mark.skipif(compiler() is None, reason="needs cc and make")

BENT = 1  # 0 and 3 have no area in the texture, 2 has no record


def test_normals_have_the_relief(programs: dict[str, Path], tmp_path: Path) -> None:
    relief = make_relief(tmp_path / "relief.rna")
    with Package.open(relief) as package:
        mesh, records = package.mesh(), package.normal_maps()
        triangle = np.arange(80) % 4
        b1, b2 = np.random.default_rng(3).dirichlet((1, 1, 1), 80)[:, 1:].T
        expected = mapped_normals(mesh, records, triangle, b1, b2)
        plain = mapped_normals(mesh, [], triangle, b1, b2)
    with closing(CAsset(programs["librna.so"], relief, "small")) as asset:
        rows = zip(triangle.tolist(), b1, b2, strict=True)
        actual = np.array([asset.normal(*row) for row in rows])
        assert not asset.normal(99, 0.2, 0.3).any()
        assert asset.record.normal_map_count == 2
    np.testing.assert_allclose(actual, expected, atol=2e-6)
    bent = np.abs(expected - plain).max(axis=1) > 0.05
    assert bent[triangle == BENT].mean() > 0.9 and not bent[triangle != BENT].any()
