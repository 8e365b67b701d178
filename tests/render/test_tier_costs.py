"""What rna-run says of its tiers' cost on the processor at hand."""

import pytest

from rna_render.command.terminal import cost_lines
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import read_scene
from rna_sdk.runtime import Asset
from tests.package.builders import make_measured_tier, make_tiny_package

SCENE = """\
assets:
  - {path: a.rna, tier: slow}
  - {path: a.rna, tier: slow, transform: {translation: [1, 0, 0]}}
camera: {position: [0, 4, 0], look_at: [0, 0, 0], up: [0, 0, -1], vertical_fov_deg: 5}
lights:
  - {type: directional, direction: [0, 1, 0], irradiance: [1, 2, 3]}
"""


@pytest.mark.parametrize(
    ("costs", "line"),
    [
        (
            {"slow": 300.0, "fast": 200.0},
            "a.rna: slow, 300 ns/query on this CPU; fast takes 200 and is no worse",
        ),
        ({"slow": 300.0, "fast": 290.0}, "a.rna: slow, 300 ns/query on this CPU"),
    ],
)
def test_a_line_a_tier_names_what_is_faster_and_no_worse(costs, line, tmp_path, monkeypatch):
    tiers = [make_measured_tier(name, 0.02, 90) for name in ("slow", "fast")]
    unmeasured = make_measured_tier("raw", None, 1)
    make_tiny_package(tmp_path / "a.rna", *tiers, unmeasured)
    (tmp_path / "scene.yaml").write_text(SCENE)
    monkeypatch.setattr(Asset, "measured_ns_per_query", lambda asset: costs[asset.tier.name])
    scene_file = read_scene(tmp_path / "scene.yaml")
    assert list(cost_lines([tmp_path / "a.rna"] * 2, load_world(scene_file))) == [line]
