"""The tutorial on writing a host: its code runs, and shows what it says."""

import re
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from rna_sdk.package import Package, query_width
from rna_sdk.runtime import load
from rna_trace.parts_scene import PartsScene
from rna_trace.surface import SurfacePoints
from tests.conftest import REPOSITORY
from tests.package.builders import INPUTS
from tests.package.lobes import even_decoder, with_lobes

PAGE = REPOSITORY / "docs" / "your-own-host.md"


@pytest.fixture(scope="module")
def names():
    """What the page's code leaves behind."""
    result: dict = {}
    blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text(), re.DOTALL)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(REPOSITORY)
        exec("\n".join(blocks), result)
    return result


def mean(image) -> float:
    return float(np.asarray(image, float).mean())


def test_a_shadow_map_has_the_nearby_light_of_rays(names):
    by_rays, by_map = names["by_rays"], names["by_map"]
    assert by_rays == pytest.approx(by_map, abs=0.12) and by_map.std() > 0.1
    assert by_rays.mean(axis=0) == pytest.approx(by_map.mean(axis=0), abs=0.02)


def test_the_toy_is_in_the_picture(names):
    seen = np.asarray(names["right"]).any(axis=2)
    assert 0.15 < seen.mean() < 0.7


def test_breaking_the_rule_shows(names):
    """An asset that blocks its own light is dark from behind; without a ray light leaks."""
    right = mean(names["by_the_rule"])
    assert mean(names["asset_blocks_itself"]) < 0.6 * right
    assert mean(names["no_ray"]) > 1.1 * right


def test_its_visibility_is_the_renderers(names):
    mesh, b = names["mesh"], np.float32(names["b"][..., 0])
    points = SurfacePoints.of(mesh, np.uint32(names["triangle"]), b[:, 1], b[:, 2])
    wi = names["unit"](np.random.default_rng(1).normal(size=points.x.shape))
    free = PartsScene([mesh]).visible(0, points, wi)
    blocked = names["blocked"](*(names[k] for k in ("x", "n", "corners", "b")), wi)
    assert 0.2 < free.mean() < 0.6
    assert (free == blocked).mean() < 0.002  # edges and outlines, by rounding


def test_its_strands_are_the_renderers(names):
    """What rays hit, where, and what lies in shadow, against Embree; ties at joints differ."""
    scene, hits = PartsScene([names["curves"]]), len(names["k"])
    eye, views = names["eye"], names["views"]
    seen = scene.intersect(eye, views)
    assert hits > 20 and hits == np.count_nonzero(seen.geometry >= 0)
    seen = seen.take(np.flatnonzero(seen.geometry >= 0))
    points = scene.points(0, seen.primitive, seen.u, seen.v, seen.ng)
    same = points.segment == names["k"]
    assert same.mean() > 0.9
    np.testing.assert_allclose(points.x[same], names["hit"][same], atol=2e-6)
    np.testing.assert_allclose(points.n[same], names["normal"][same], atol=0.02)
    free = scene.visible(0, points, names["wi"])
    assert 0.1 < free.mean() < 0.9
    assert (free == names["in_shadow"]).mean() < 0.1


def test_lobes_are_looked_up_in_a_sky(names, tmp_path):
    """A sky of one colour is the sum of the amplitudes; another adds light where lobes look up."""
    with Package.open(REPOSITORY / "examples" / "quickstart" / "toy.rna") as package:
        part = package.manifest.tiers[0].parts[0]
    decoder = even_decoder(query_width(INPUTS, part.channels) + 16)
    toy = REPOSITORY / "examples" / "quickstart" / "toy.rna"
    asset = load(with_lobes(toy, tmp_path / "lobes.rna", decoder=decoder))
    seen = (names[k] for k in ("triangle", "b", "x", "n", "corners"))
    at = asset, *seen, -names["direction"][names["pixel"]]
    even = names["under_lobes"](*at, np.float32([0.5, 1, 2]), np.float32([0.5, 1, 2]))
    np.testing.assert_allclose(even, np.tile([0.25, 0.5, 1.0], (len(even), 1)), rtol=1e-5)
    above = names["under_lobes"](*at, np.float32(0), np.float32(1))[:, 0]
    up = names["n"][:, 1]
    assert 0.0 < above.min() < above.max() < 0.5
    assert np.corrcoef(up, above)[0, 1] > 0.5


def test_a_bent_asset_differs_a_little(names):
    at_rest, bent = names["again"][0], names["bent_visible"]
    assert bent.shape == at_rest.shape
    assert 0.01 < np.abs(bent - at_rest).mean() / at_rest.mean() < 0.5


def test_the_example_of_motion_makes_a_picture(tmp_path):
    """The toy hangs down on both sides, as the bend has it."""
    out = tmp_path / "bent.png"
    command = [sys.executable, "examples/hosts/motion.py", str(out)]
    subprocess.run(command, cwd=REPOSITORY, check=True)
    seen = np.asarray(Image.open(out)).any(axis=2)
    top = [int(np.argmax(column)) for column in seen.T if column.any()]
    assert 0.1 < seen.mean() < 0.6
    assert min(top) < top[0] - 10 and min(top) < top[-1] - 10
