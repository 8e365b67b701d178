"""Assets with holes, glass and emission, and queries outside their domain."""

import re

import numpy as np
import pytest

from rna_render.world.domain_watch import DomainWarning, warn_of_extrapolation
from rna_sdk import runtime
from rna_sdk.package import Cone, Domain
from tests.conformance.conftest import KIT
from tests.conftest import REPOSITORY
from tests.gpu.scenes import assert_same_law, assert_same_numbers, on_cpu, on_gpu

LANTERN = KIT / "packages" / "parts-lantern.rna"
TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
GLOW = KIT / "packages" / "surface-glow.rna"

LANTERN_ON_A_FLOOR = f"""
assets:
  - path: {LANTERN}
    transform: {{rotation_deg: [0, 25, 0]}}
    emission: 3
  - path: {LANTERN}
    transform: {{translation: [1.6, 0, -0.9], scale: -1.2}}
ground:
  height: -1.1
  material: {{type: coated, color: [0.6, 0.5, 0.4], roughness: 0.3}}
camera: {{position: [1.4, 1.7, 4.6], look_at: [0.4, -0.2, 0], vertical_fov_deg: 40}}
lights:
  - {{type: directional, direction: [0.5, 0.9, 0.3], irradiance: [1.5, 1.4, 1.2]}}
  - {{type: environment, radiance: [0.3, 0.4, 0.6]}}
resolution: [48, 32]
samples: 16
max_depth: 3
"""

LANTERN_IN_THE_SUN = f"""
assets: [{{path: {LANTERN}, emission: 0}}]
ground: {{height: -0.6, material: {{type: diffuse}}}}
camera: {{position: [0.4, 2.2, 3], look_at: [0.2, -0.2, 0], vertical_fov_deg: 36}}
lights: [{{type: directional, direction: [-0.5, 0.9, 0.3], irradiance: [1.5, 1.4, 1.2]}}]
resolution: [32, 24]
samples: 16
max_depth: 1
"""

GLOW_ON_A_FLOOR = f"""
assets:
  - path: {GLOW}
    emission: 6
    transform: {{scale: 0.4}}
ground: {{height: -0.5, material: MATERIAL}}
camera: {{position: [1.4, 1.6, 2.6], look_at: [0, -0.2, 0], vertical_fov_deg: 50}}
lights: [{{type: point, position: [1, 2, 1], intensity: [0.3, 0.3, 0.3]}}]
resolution: [32, 24]
samples: 2
max_depth: 2
"""

WATCHED = f"""
assets: [{{path: {TOY}}}]
camera: {{position: [1, -0.2, 2], look_at: [0, 0.2, 0], vertical_fov_deg: 30}}
lights: [{{type: environment, radiance: [1, 1, 1]}}]
resolution: [24, 24]
samples: 2
max_depth: 2
"""


def test_holes_glass_and_light_of_assets(scene, device):
    """A lantern with strands, cut-outs, coloured glass and two parts that emit, twice."""
    actual = on_gpu(*scene(LANTERN_ON_A_FLOOR), lambda: device).channels()
    expected = on_cpu(*scene(LANTERN_ON_A_FLOOR, seed=7)).channels()
    assert_same_law(actual, expected)


def test_light_that_comes_through_an_asset(scene, device):
    """On the lantern's own floor and on the ground: the sun alone, so that little noise is left."""
    text = LANTERN_IN_THE_SUN
    actual = on_gpu(*scene(text), lambda: device).channels()
    assert_same_law(actual, on_cpu(*scene(text, seed=7)).channels())


@pytest.mark.parametrize(
    "material", ["{type: diffuse, color: [0.7, 0.7, 0.7]}", "{type: shadow_catcher}"]
)
def test_an_asset_that_emits_is_sampled(material, scene, device):
    text = GLOW_ON_A_FLOOR.replace("MATERIAL", material)
    actual = on_gpu(*scene(text), lambda: device).channels()
    assert_same_numbers(actual, on_cpu(*scene(text)).channels())


def test_queries_outside_the_domain_are_counted(scene, device, monkeypatch):
    cones = (Cone(axis=(0, 0, 1), half_angle=0.4), Cone(axis=(0, 1, 0), half_angle=0.7))

    def narrow(*arguments: object, **more: object) -> runtime.Asset:
        asset = load(*arguments, **more)
        asset.domain = Domain(wo="hemisphere", wi=cones)
        return asset

    load = runtime.load
    monkeypatch.setattr(runtime, "load", narrow)
    messages = []
    for render_it in (on_cpu, lambda *read: on_gpu(*read, lambda: device)):
        scene_file, world = scene(WATCHED)
        render_it(scene_file, world)
        with pytest.warns(DomainWarning) as caught:
            warn_of_extrapolation(world.objects)
        messages.append([float(x) for x in re.findall(r"[\d.]+(?=%)", str(caught[0].message))])
    assert len(messages[0]) == 3 and min(messages[0]) > 3
    np.testing.assert_allclose(messages[0], messages[1], atol=0.3)
