"""Glass of an asset in the C host."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from rna_sdk.package import Package
from tests.hosts.c_host import CAsset, compiler
from tests.package.lantern import make_lantern

pytestmark = pytest.mark.skipif(compiler() is None, reason="needs cc and make")


def test_pane_reflects_by_the_law_of_fresnel(library: Path, tmp_path: Path) -> None:
    """Triangle 3 is glass of index 1.5: 4% head-on, all of it where light grazes."""
    lantern = make_lantern(tmp_path / "lantern.rna")
    with Package.open(lantern) as package:
        mesh = package.mesh()
    normal = mesh.normals[mesh.triangles[3]].astype(np.float64).mean(axis=0)
    normal /= np.linalg.norm(normal)
    across = np.cross(normal, [0.0, 0.6, 0.8])
    across /= np.linalg.norm(across)
    colour = np.float64([200, 150, 100]) / 255
    with closing(CAsset(library, lantern, "small", 0)) as body:
        for sine, reflected in ((0.0, 0.04), (np.sin(np.radians(60)), 0.0891867), (1.0, 1.0)):
            for side in (-1, 1):
                direction = side * np.sqrt(1 - sine**2) * normal + sine * across
                tau = body.transmittance(3, 1 / 3, 1 / 3, direction)
                np.testing.assert_allclose(tau, (1 - reflected) * colour, atol=1e-5)
        assert not body.transmittance(2, 1 / 3, 1 / 3, normal).any()
        assert not body.transmittance(99, 1 / 3, 1 / 3, normal).any()
