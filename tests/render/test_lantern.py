"""A package of two parts with emission, holes and glass, from its file to the image."""

import warnings
from dataclasses import replace

import numpy as np
import pytest

from rna_render.command.terminal import cost_lines
from rna_render.lights import AssetLight
from rna_render.paths.bands import render
from rna_render.paths.integrator_factory import make_integrator
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import read_scene
from rna_render.world.domain_watch import DomainWarning, WatchedAsset, warn_of_extrapolation
from rna_sdk.package import Cone, Domain
from rna_sdk.runtime import load, transmittance
from rna_trace.asset_parts import mesh_transmittance
from rna_trace.parts_scene import PartsScene
from tests.package.lantern import make_lantern
from tests.render.packages import write_lamp_package
from tests.render.stage import rgb
from tests.runtime.points import unit_vectors

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
def scene_file(tmp_path):
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
    assert len(list(cost_lines([a.path for a in scene_file.resolved.assets], world))) == 2


LAMP = """
assets: [{path: lamp.rna, emission: 2}]
ground: {height: -0.5}
camera: {position: [0, 0.4, 4], look_at: [0, 0, 0], vertical_fov_deg: 26}
resolution: [60, 60]
samples: 64
max_depth: 2
"""


def test_a_lamp_shows_its_bulb_through_its_shade(tmp_path):
    """In the dark: the middle of the image is the bulb, times the factor, times the tint."""
    glow, tint = np.array([1.0, 2.0, 3.0]), np.uint8([51, 153, 204])
    write_lamp_package(tmp_path / "lamp.rna", tuple(glow), tint)
    (tmp_path / "scene.yaml").write_text(LAMP)
    scene_file = read_scene(tmp_path / "scene.yaml")
    world = load_world(scene_file)
    image = rgb(render(scene_file.scene, make_integrator(scene_file.scene, world)).channels())
    bulb = image[28:32, 28:32]
    np.testing.assert_allclose(bulb.mean(axis=(0, 1)), 2 * glow * tint / 255, rtol=0.05)
    below = image[54:, 20:40].mean(axis=(0, 1))
    assert (below > 1e-3).all()  # the ground before it is lit, in the colour of glow and tint
    np.testing.assert_allclose(below / below[2], glow * tint / (glow * tint)[2], rtol=0.1)


def test_parts_of_a_watched_asset_are_counted_together(tmp_path, scene_file):
    up = (Cone(axis=(0.0, 1.0, 0.0), half_angle=0.5),)
    make_lantern(tmp_path / "lantern.rna", domain=Domain(wo=up, wi="sphere"))
    world = load_world(scene_file)
    assert all(isinstance(scene_object, WatchedAsset) for scene_object in world.objects)
    render(scene_file.scene, make_integrator(scene_file.scene, world))
    with pytest.warns(DomainWarning, match="views"), warnings.catch_warnings():
        warn_of_extrapolation(world.objects[:1])


def test_lookups_are_those_of_the_sdk(tmp_path):
    """Records of a package: a cut-out, glass met from both sides, and opaque triangles."""
    part = load(make_lantern(tmp_path / "lantern.rna")).parts[0]
    records = [replace(r, ior=r.ior and (1.5, 1 / 1.5)) for r in part.transmittance_records]
    mesh = part.mesh
    scene = PartsScene([mesh], [mesh_transmittance(mesh, records)])
    rng = np.random.default_rng(1)
    inside = rng.random((20_000, 1)) < 0.5
    origins = np.where(inside, [[0, -0.2, 0]], 3 * unit_vectors(rng, 20_000)).astype(np.float32)
    d = np.where(inside, 1, 0.5 * unit_vectors(rng, 20_000) - origins)
    d = np.where(inside, unit_vectors(rng, 20_000), d).astype(np.float32)
    d /= np.linalg.norm(d, axis=1, keepdims=True)
    hits = scene.intersect(origins, d)
    row = np.flatnonzero(hits.geometry == 0)
    triangle, u, v = hits.primitive[row], hits.u[row], hits.v[row]
    expected = transmittance(mesh, records, triangle, u, v, d[row])
    actual = scene.hit_transmittance(hits, d)
    assert (actual[hits.geometry < 0] == 1).all()
    assert set(np.unique(expected[triangle < 2])) == {0, 1}
    for side in (True, False):  # of glass; beyond the critical angle it reflects all
        of_glass = expected[(triangle == 3) & (inside[row, 0] == side)]
        assert len(np.unique(of_glass)) > 100 and (of_glass == 0).any() == side
    assert np.mean(np.abs(actual[row] - expected).max(axis=1) < 1e-5) > 0.999  # cutoffs fall over
