"""Scene files, good and bad."""

from __future__ import annotations

from pathlib import Path

import pytest

from rna_render.lights.models import DirectionalModel, EnvironmentModel
from rna_render.scene_file import read_scene
from rna_sdk.errors import SceneError

GOOD = """\
assets:
  - path: toy.rna
    transform:
      translation: [1, 2, 3]
      rotation_deg: [0, 90, 0]
      scale: 2
  - {path: sub/other.rna, tier: hq}
camera:
  position: [0, 1, 5]
  look_at: [0, 0, 0]
lights:
  - type: directional
    direction: [0, 1, 0]
    irradiance: [3, 2, 1e-2]
  - type: environment
    radiance: [1, 1, 1]
resolution: [320, 240]
"""


def scene(folder: Path, text: str):
    path = folder / "scene.yaml"
    path.write_text(text, encoding="utf-8")
    return read_scene(path)


def test_a_good_file_is_read(tmp_path):
    read = scene(tmp_path, GOOD)
    first, second = read.scene.assets
    assert first.transform.scale == 2 and first.tier is None and second.tier == "hq"
    sun, sky = read.scene.lights
    assert isinstance(sun, DirectionalModel) and sun.irradiance == (3, 2, 0.01)
    assert isinstance(sky, EnvironmentModel)
    assert read.scene.resolution == (320, 240) and read.scene.samples == 64
    assert read.resolve(second.path) == tmp_path / "sub" / "other.rna"


def test_changes_replace_keys_and_tiers(tmp_path):
    read = scene(tmp_path, GOOD).with_changes(samples=3, tier="small")
    assert read.scene.samples == 3 and read.scene.resolution == (320, 240)
    assert [asset.tier for asset in read.scene.assets] == ["small", "small"]


def test_errors_found_later_name_the_place_too(tmp_path):
    read = scene(tmp_path, GOOD)
    error = read.error(("assets", 1, "path"), "no such file")
    assert str(error) == f"{tmp_path / 'scene.yaml'}:7: assets[1].path: no such file"
    assert read.error(("assets", 0, "tier"), "unknown").line == 2


# What to change in GOOD, then the line and key reported, and a part of the message.
MISTAKES = [
    ("look_at: [0, 0, 0]", "lookat: [0, 0, 0]", 8, "camera.look_at", "missing"),
    ("resolution: [320, 240]", "resolutoin: 3", 17, "resolutoin", "not a known key"),
    ("resolution: [320, 240]", "resolution: [320, 0]", 17, "resolution[1]", "greater than or"),
    ("resolution: [320, 240]", "samples: many", 17, "samples", "found 'many'"),
    ("scale: 2", "scale: [1, 2, 1]", 6, "assets[0].transform.scale", "uniform"),
    ("scale: 2", "scale: -1", 6, "assets[0].transform.scale", "greater than or equal to 1e-18"),
    ("scale: 2", "scale: 1e-40", 6, "assets[0].transform.scale", "greater than or equal to 1e-18"),
    ("[1, 2, 3]", "[1, 1.0e+39, 3]", 4, "assets[0].transform.translation[1]", "found 1e+39"),
    (
        "[3, 2, 1e-2]",
        "[1.0e+39, 2, 1]",
        14,
        "lights[0].irradiance[0]",
        "1e+18, found 1e+39",
    ),
    ("[3, 2, 1e-2]", f"[{'9' * 400}, 2, 1]", 14, "lights[0].irradiance[0]", "found 999"),
    ("[3, 2, 1e-2]", "[.inf, 2, 1]", 14, "lights[0].irradiance[0]", "finite"),
    ("look_at: [0, 0, 0]", "look_at: [-1.0e+39, 0, 0]", 10, "camera.look_at[0]", "found -1e+39"),
    ("direction: [0, 1, 0]", "direction: [0, 1e-300, 0]", 13, "lights[0].direction", "zero"),
    ("scale: 2", "quaternion: [0, 0, 0, 1]", 3, "assets[0].transform", "give one of them"),
    ("[1, 2, 3]", "[1, 2]", 4, "assets[0].transform.translation[2]", "missing"),
    ("[1, 2, 3]", "[1, 2, .nan]", 4, "assets[0].transform.translation[2]", "finite"),
    ("type: directional", "type: laser", 12, "lights[0]", "'laser'"),
    ("type: directional", "kind: directional", 12, "lights[0]", "type"),
    ("[3, 2, 1e-2]", "[3, -2, 1]", 14, "lights[0].irradiance[1]", "found -2"),
    ("direction: [0, 1, 0]", "direction: [0, 0, 0]", 13, "lights[0].direction", "zero"),
    ("look_at: [0, 0, 0]", "look_at: [0, 1, 5]", 8, "camera", "same point"),
    ("look_at: [0, 0, 0]", "look_at: [0, 9, 5]", 8, "camera", "line of sight"),
    ("tier: hq", "path: again.rna", 7, "assets[1].path", "twice, first on line 7"),
    ("lights:", "camera: {}\nlights:", 11, "camera", "twice, first on line 8"),
    ("- path: toy.rna", "- tier: hq", 2, "assets[0].path", "missing"),
]


@pytest.mark.parametrize(("old", "new", "line", "key", "message"), MISTAKES)
def test_a_mistake_is_reported_with_file_line_and_key(tmp_path, old, new, line, key, message):
    assert GOOD.count(old) == 1
    with pytest.raises(SceneError) as caught:
        scene(tmp_path, GOOD.replace(old, new))
    error = caught.value
    assert (error.line, error.key) == (line, key), str(error)
    assert message in str(error)
    assert str(error).startswith(f"{tmp_path / 'scene.yaml'}:{line}: {key}: ")
    assert "\n" not in str(error)


def test_the_first_of_several_mistakes_is_reported(tmp_path):
    with pytest.raises(SceneError, match=r":6: assets\[0\].transform.scale: .* \(1 more after"):
        scene(tmp_path, GOOD.replace("scale: 2", "scale: 0").replace("[320, 240]", "[0, 240]"))


ALIASES = "a: &a [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n" + "".join(
    f"{new}: &{new} [{', '.join([f'*{old}'] * 10)}]\n"
    for old, new in zip("abcdefgh", "bcdefghi", strict=True)
)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "empty"),
        ("- 1\n", "must be a valid dictionary"),
        ("assets: [\n", "not YAML"),
        ("assets: 1\ncamera: }\n", ":2: not YAML"),
        ("? [1]\n: 2\n", "not YAML"),
        ("a: !!python/object:os.system x\n", "not YAML"),
        ("a: &a [*a]\n", "not YAML|too deep"),
        (ALIASES, "too deep or too long"),
        ("[" * 40 + "]" * 40, "too deep"),
        ("a: \x07\n", "not YAML"),
    ],
)
def test_what_is_no_scene_is_refused(tmp_path, text, message):
    with pytest.raises(SceneError, match=message) as caught:
        scene(tmp_path, text)
    assert "\n" not in str(caught.value)


def test_files_that_cannot_be_read_are_refused(tmp_path):
    with pytest.raises(SceneError, match=r"none\.yaml: No such file"):
        read_scene(tmp_path / "none.yaml")
    with pytest.raises(SceneError, match="directory"):
        read_scene(tmp_path)
    (tmp_path / "binary.yaml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(SceneError, match="UTF-8"):
        read_scene(tmp_path / "binary.yaml")
