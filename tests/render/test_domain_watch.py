"""A warning where an asset is asked for directions that it was not trained for."""

import warnings

import numpy as np
import pytest
from tqdm import tqdm

from rna_render.command.rna_run import main
from rna_render.world.domain_watch import (
    DomainWarning,
    WatchedAsset,
    warn_of_extrapolation,
    watched,
)
from rna_sdk.package import Cone, Domain
from rna_sdk.runtime import load
from tests.package.builders import make_tiny_package
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package

UP, DOWN, FRONT = (0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0)
SCENE = """\
assets: [{path: ball.rna}]
camera: {position: [0, 0, 4], look_at: [0, 0, 0], vertical_fov_deg: 5}
lights: [{type: directional, direction: DIRECTION, irradiance: [1, 1, 1]}]
resolution: [8, 8]
samples: 2
"""


def cone(axis: tuple[float, float, float]) -> tuple[Cone, ...]:
    return (Cone(axis=axis, half_angle=0.5),)


def rows(*directions: tuple[float, float, float]) -> np.ndarray:
    return np.array(directions, np.float32)


def test_queries_outside_are_counted_and_answered(tmp_path):
    domain = Domain(wo=cone(FRONT), wi="hemisphere")
    asset = load(make_tiny_package(tmp_path / "a.rna", domain=domain))
    watch = watched(asset, "a.rna")
    wo, wi = rows(FRONT, FRONT, UP, UP), rows(UP, DOWN, DOWN, UP)
    points = np.zeros((4, 3), np.float32), rows(UP, UP, UP, UP), wo, wi
    (part,) = watch.parts
    free = np.array([True, False, True, False])
    np.testing.assert_array_equal(part.transport(*points, free), asset.transport(*points, free))
    assert watch.complaint() == (
        "a.rna: 75.0% of the queries are outside the directions that it was trained for "
        "(views 50.0%, lights 50.0%)"
    )
    assert (watch.kind, watch.tier) == ("surface", asset.tier)


def test_an_asset_of_all_directions_is_not_watched(tmp_path):
    asset = load(make_tiny_package(tmp_path / "a.rna"))
    assert watched(asset, "a.rna") is asset


def test_a_warning_comes_once(tmp_path):
    asset = load(make_tiny_package(tmp_path / "a.rna", domain=Domain(wo=cone(UP), wi="sphere")))
    watch = WatchedAsset(asset, "a.rna")
    zero = np.zeros((1, 3), np.float32)
    warn_of_extrapolation([watch])  # nothing was asked: no warning, which would be an error
    watch.parts[0].transport(zero, rows(UP), rows(DOWN), rows(UP), np.ones(1, bool))
    with pytest.warns(DomainWarning) as caught:
        warn_of_extrapolation([watch, watch])
    assert len(caught) == 1
    with warnings.catch_warnings(action="error"):
        warn_of_extrapolation([watch])


@pytest.mark.filterwarnings("default::rna_render.world.domain_watch.DomainWarning")
@pytest.mark.parametrize(("direction", "warns"), [("[0, 0.1, 1]", False), ("[0, 1, 0]", True)])
def test_the_command_warns_of_lights_outside(direction, warns, tmp_path, capsys):
    domain = Domain(wo=cone(FRONT), wi=cone(FRONT))
    write_lambert_package(tmp_path / "ball.rna", sphere(3), domain=domain)
    (tmp_path / "scene.yaml").write_text(SCENE.replace("DIRECTION", direction))
    with tqdm(total=1):  # the bar of something else in this process
        assert main([str(tmp_path / "scene.yaml"), "--out", str(tmp_path / "out.exr")]) == 0
    warnings_said = [
        line for line in capsys.readouterr().err.splitlines() if line.startswith("warning")
    ]
    expected = [
        "warning: ball.rna: 100.0% of the queries are outside the directions that it was trained "
        "for (views 0.0%, lights 100.0%)"
    ]
    assert warnings_said == (expected if warns else [])
