"""A package with all that is new in 1.1, from its file to the image."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import pytest

from rna_render.asset_parts import part_transmittance
from rna_render.domain_watch import DomainWarning, WatchedAsset, warn_of_extrapolation
from rna_render.lights import AssetLight
from rna_render.render import load_world, make_integrator, render
from rna_render.scene_file import read_scene
from rna_render.tier_costs import cost_lines
from rna_sdk.package import Cone, Domain
from rna_sdk.runtime import load, transmittance
from tests.package.lantern import make_lantern
from tests.render.assets import unit_vectors
from tests.render.stage import rgb

SCENE = """
assets:
  - {path: lantern.rna}
  - {path: lantern.rna, tier: hq, emission: 0, transform: {translation: [2, 0, 0]}}
camera: {position: [0.5, 1, 6], look_at: [1, 0, 0], vertical_fov_deg: 40}
lights: [{type: environment, radiance: [1, 1, 1]}]
resolution: [64, 48]
samples: 4
"""


@pytest.fixture
def scene_file(tmp_path: Path):
    make_lantern(tmp_path / "lantern.rna")
    (tmp_path / "scene.yaml").write_text(SCENE)
    return read_scene(tmp_path / "scene.yaml")


def test_a_lantern_is_rendered(scene_file):
    world = load_world(scene_file)
    assert world.scene.transmits
    assert [type(light) for light in world.lights] == [AssetLight]  # the other one's factor is 0
    channels = render(scene_file.scene, make_integrator(scene_file.scene, world)).channels()
    assert np.isfinite(rgb(channels)).all() and rgb(channels).max() > 0
    assert set(np.unique(channels["assetId"])) == {0, 1, 2}
    assert len(list(cost_lines(scene_file, world))) == 2


def test_parts_of_a_watched_asset_are_counted_together(tmp_path, scene_file):
    up = (Cone(axis=(0.0, 1.0, 0.0), half_angle=0.5),)
    make_lantern(tmp_path / "lantern.rna", domain=Domain(wo=up, wi="sphere"))
    world = load_world(scene_file)
    assert all(isinstance(thing, WatchedAsset) for thing in world.things)
    render(scene_file.scene, make_integrator(scene_file.scene, world))
    with pytest.warns(DomainWarning, match="views"), warnings.catch_warnings():
        warn_of_extrapolation(world.things[:1])


def test_lookups_are_those_of_the_sdk(tmp_path):
    """Of the records of a package: a cut-out, a pane with Fresnel, and opaque triangles."""
    part = load(make_lantern(tmp_path / "lantern.rna")).parts[0]
    table, mesh = part_transmittance(part), part.mesh
    rng = np.random.default_rng(1)
    n = 5000
    triangle = rng.integers(0, len(mesh.triangles), n).astype(np.int32)
    u, v = rng.random((2, n), np.float32)
    u, v = np.where(u + v > 1, (1 - u, 1 - v), (u, v)).astype(np.float32)
    d = unit_vectors(rng, n)
    expected = transmittance(mesh, part.transmittance_records, triangle, u, v, d)
    p = mesh.positions[mesh.triangles[triangle]].astype(np.float64)
    facing = np.sum(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]) * d, axis=1) < 0
    found = table.at(triangle, u, v, d, facing)
    assert set(np.unique(expected[triangle < 2])) == {0, 1}
    assert len(np.unique(expected[triangle == 3])) > 100
    assert np.mean(np.abs(found - expected).max(axis=1) < 1e-5) > 0.999  # cutoffs may fall over
