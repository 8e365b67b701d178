"""Tiers of a scene's assets: by size in the image, and what happens when none is good enough."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from rna_render.paths.world_in_time import QualityWarning, load_world
from rna_render.scene.animation import frame_scene
from rna_render.scene.scene_file import SceneFile, read_scene
from rna_render.world.tier_choice import TierChoice, Tiers
from rna_sdk.errors import SceneError
from rna_sdk.package import Package
from rna_sdk.package.packing import Unpacked
from tests.package.builders import make_measured_tier
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package

# The sphere about the package's box, [-1, 1] on every axis, has radius sqrt(3).
RADIUS = np.sqrt(3.0)
SCENE = """\
assets:
  - path: ball.rna
  - {path: ball.rna, transform: {translation: [0, 0, -30]}}
  - {path: ball.rna, transform: {translation: [0, 0, 60]}}
  - {path: ball.rna, tier: hq, transform: {translation: [3, 0, -90]}}
camera: {position: [0, 0, 10], look_at: [0, 0, 0], vertical_fov_deg: 40}
resolution: [100, 100]
QUALITY
"""


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    tiers = (
        make_measured_tier("hq", 0.02, 9000, (100, 0.02), (25, 0.01)),
        make_measured_tier("small", 0.04, 900, (100, 0.04), (25, 0.02)),
        make_measured_tier("tiny", 0.08, 90, (100, 0.08), (25, 0.06)),
    )
    path = tmp_path_factory.mktemp("tiers") / "ball.rna"
    return write_lambert_package(path, sphere(2), tiers)


def scene(package: Path, quality: str = "", text: str = SCENE) -> SceneFile:
    path = package.parent / "scene.yaml"
    path.write_text(text.replace("QUALITY", quality))
    return read_scene(path)


def names(file: SceneFile) -> list[str]:
    return [asset.tier.name for asset in load_world(file).objects]


def tier_names(choices: Tiers) -> tuple[str | None, ...]:
    return tuple(choice.tier for choice in choices)


def test_near_assets_get_finer_tiers_and_unseen_ones_the_cheapest(package):
    # Heights: 48, 11 and 0 (behind the camera) pixels; the last one names its tier.
    assert names(scene(package, "quality: {max_error: 0.025}")) == ["hq", "small", "small", "hq"]
    assert names(scene(package, "quality: {max_error: 0.06}")) == ["small", "tiny", "tiny", "hq"]


def test_without_quality_it_is_the_first_tier(package):
    assert names(scene(package)) == ["hq", "hq", "hq", "hq"]


def test_instances_of_a_tier_share_it(package):
    objects = load_world(scene(package, "quality: {max_error: 0.025}")).objects
    assert objects[1] is objects[2] and objects[0] is objects[3]


def test_an_error_that_no_tier_meets_is_a_warning_with_the_best(package):
    file = scene(package, "quality: {max_error: 0.001}")
    with pytest.warns(QualityWarning) as caught:
        world = load_world(file)
    assert [asset.tier.name for asset in world.objects] == ["hq"] * 4
    (message,) = (str(warning.message) for warning in caught)
    assert message.startswith("ball.rna: no tier has an error of at most 0.001 at 48 pixels; ")
    assert "hq with 0.0148" in message


def test_a_package_without_errors_is_told_of(tmp_path):
    write_lambert_package(tmp_path / "ball.rna", sphere(2), ("only",))
    file = scene(tmp_path / "ball.rna", "quality: {max_error: 0.1}", SCENE.replace("hq", "only"))
    with pytest.warns(QualityWarning, match="only, unmeasured"):
        assert names(file) == ["only"] * 4


def test_indirect_radiance_has_a_cheaper_tier(package):
    """Four times the error; an asset whose tier is named has no other, nor one of the cheapest."""
    file = scene(package, "quality: {max_error: 0.015}")
    choices = TierChoice(file, [file.scene]).within(0.015)
    assert tier_names(choices) == ("hq", "hq", "hq", "hq")
    assert [choice.indirect for choice in choices] == ["small", "tiny", "tiny", None]
    world = load_world(file)
    assert [asset.tier.name for asset in world.indirect] == ["small", "tiny", "tiny"]
    coarse = TierChoice(file, [file.scene]).within(0.1)
    assert [choice.indirect for choice in coarse] == [None] * 4


def test_coarser_choices_end_with_the_cheapest_tiers(package):
    file = scene(package, "quality: {seconds: 1}")
    choices = list(TierChoice(file, [file.scene]).coarser(0.0))
    assert tier_names(choices[0]) == ("hq", "hq", "hq", "hq")
    assert tier_names(choices[-1]) == ("tiny", "tiny", "tiny", "hq")
    assert len(set(choices)) == len(choices) > 2


def test_a_sequence_has_one_tier_for_its_largest_frame(package):
    turning = SCENE.replace("look_at: [0, 0, 0]", "look_at: [0, 0, -15]")
    file = scene(package, "animation: {frames: 2, turntable: {}}", turning)
    views = [frame_scene(file.scene, number) for number in range(2)]
    alone = [tier_names(TierChoice(file, [view]).within(0.025))[:2] for view in views]
    assert alone == [("hq", "small"), ("small", "hq")]  # from the front, from behind
    assert tier_names(TierChoice(file, views).within(0.025))[:2] == ("hq", "hq")


def test_a_missing_package_is_reported_with_its_line(package):
    text = SCENE.replace("ball.rna", "other.rna", 1)
    with pytest.raises(SceneError, match=r"scene.yaml:2: assets\[0\].path: no such file"):
        load_world(scene(package, "quality: {max_error: 0.1}", text))


def test_a_quality_that_asks_for_nothing_is_refused(package):
    with pytest.raises(SceneError, match=r"quality: .* give max_error, seconds or both"):
        scene(package, "quality: {}")


def test_small_assets_get_the_proxy_of_their_size(package, tmp_path):
    path = tmp_path / "ball.rna"
    whole = Package.open(package).mesh()
    of_size = {pixels: replace(whole, triangles=whole.triangles[:pixels]) for pixels in (60, 20)}
    Unpacked.read(package).with_proxies([[(mesh, h) for h, mesh in of_size.items()]]).write(path)

    def triangles(quality: str) -> list[int]:
        return [len(asset.mesh.triangles) for asset in load_world(scene(path, quality)).objects]

    assert triangles("quality: {max_error: 0.025}") == [60, 20, 20, 20]
    assert triangles("") == [len(whole.triangles)] * 4
