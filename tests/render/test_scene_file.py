"""Scene files, good and bad."""

import re
from datetime import date
from pathlib import Path
from typing import get_args, get_origin

import pytest
from pydantic import BaseModel, ValidationError

from rna_render.scene.light_models import DirectionalModel, EnvironmentModel
from rna_render.scene.scene_file import read_scene
from rna_render.scene.scene_messages import mistakes
from rna_render.scene.scene_model import Scene
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
    ("look_at: [0, 0, 0]", "lookat: [0, 0, 0]", 10, "camera.lookat", "did you mean look_at?"),
    ("resolution: [320, 240]", "resolutoin: 3", 17, "resolutoin", "did you mean resolution?"),
    (
        "resolution: [320, 240]",
        "resolution: [320, 0]",
        17,
        "resolution[1]",
        "whole number, at least 1",
    ),
    ("resolution: [320, 240]", "samples: many", 17, "samples", "found 'many'"),
    ("scale: 2", "scale: [1, 2, 1]", 6, "assets[0].transform.scale", "uniform"),
    ("scale: 2", "scale: -1e-9", 6, "assets[0].transform.scale", "at least 1e-06"),
    ("scale: 2", "scale: 1e-40", 6, "assets[0].transform.scale", "at least 1e-06"),
    ("[1, 2, 3]", "[1, 1.0e+39, 3]", 4, "assets[0].transform.translation[1]", "found 1e+39"),
    ("[3, 2, 1e-2]", "[1.0e+39, 2, 1]", 14, "lights[0].irradiance[0]", "1e+18, found 1e+39"),
    ("[3, 2, 1e-2]", f"[{'9' * 400}, 2, 1]", 14, "lights[0].irradiance[0]", "found 999"),
    ("[3, 2, 1e-2]", "[.inf, 2, 1]", 14, "lights[0].irradiance[0]", "finite"),
    ("look_at: [0, 0, 0]", "look_at: [-1.0e+39, 0, 0]", 10, "camera.look_at[0]", "found -1e+39"),
    ("direction: [0, 1, 0]", "direction: [0, 1e-300, 0]", 13, "lights[0].direction", "zero"),
    ("scale: 2", "quaternion: [0, 0, 0, 1]", 3, "assets[0].transform", "give one of them"),
    (
        "[1, 2, 3]",
        "[1, 2]",
        4,
        "assets[0].transform.translation",
        "list of 3 numbers, found [1, 2]",
    ),
    ("[1, 2, 3]", "[1, 2, .nan]", 4, "assets[0].transform.translation[2]", "finite"),
    ("type: directional", "type: laser", 12, "lights[0].type", "or environment, found 'laser'"),
    ("type: directional", "kind: directional", 12, "lights[0].kind", "did you mean type?"),
    ("[3, 2, 1e-2]", "[3, -2, 1]", 14, "lights[0].irradiance[1]", "found -2"),
    ("direction: [0, 1, 0]", "direction: [0, 0, 0]", 13, "lights[0].direction", "zero"),
    ("look_at: [0, 0, 0]", "look_at: [0, 1, 5]", 8, "camera", "same point"),
    ("look_at: [0, 0, 0]", "look_at: [0, 9, 5]", 8, "camera", "line of sight"),
    ("tier: hq", "path: again.rna", 7, "assets[1].path", "twice, first on line 7"),
    ("lights:", "camera: {}\nlights:", 11, "camera", "twice, first on line 8"),
    ("- path: toy.rna", "- tier: hq", 2, "assets[0].path", "missing: expected the name of a file"),
    ("[1, 2, 3]", "1 2 3", 4, "assets[0].transform.translation", "list of 3 numbers, found '1"),
    ("[1, 2, 3]", "[1, 2, 3, 4]", 4, "assets[0].transform.translation", "list of 3 numbers"),
    ("[3, 2, 1e-2]", "red", 14, "lights[0].irradiance", "a list of 3 numbers, found 'red'"),
    ("irradiance", "irradience", 14, "lights[0].irradience", "did you mean irradiance?"),
    ("type: directional", "type: SUN", 12, "lights[0].type", "did you mean directional?"),
    ("type: directional", "tpye: sun", 12, "lights[0].tpye", "did you mean type?"),
    ("rotation_deg", "rotation", 5, "assets[0].transform.rotation", "did you mean rotation_deg?"),
    ("resolution: [320, 240]", "fov: 40", 17, "fov", "did you mean camera.vertical_fov_deg?"),
    ("resolution: [320, 240]", "fog: 1", 17, "fog", "known here: assets, objects, ground"),
    ("resolution: [320, 240]", "resolution: 640x480", 17, "resolution", "list of 2 whole numbers"),
    ("resolution: [320, 240]", "view: agx", 17, "view", "expected srgb or filmic, found 'agx'"),
    ("resolution: [320, 240]", "clamp_indirect: -1", 17, "clamp_indirect", "more than 0, found -1"),
    ("resolution: [320, 240]", "samples:", 17, "samples", "a whole number, found nothing"),
    ("resolution: [320, 240]", "ground: true", 17, "ground", "mapping of height, size, material"),
    ("resolution: [320, 240]", "ground: {material: wood}", 17, "ground.material", "type: diffuse"),
    ("- {path: sub/other.rna, tier: hq}", "- toy.rna", 7, "assets[1]", "a mapping of path, tier"),
    ("resolution: [320, 240]", "7: x", 17, "7", "expected text as a key"),
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


def test_all_mistakes_are_reported_a_line_each_in_the_order_of_the_file(tmp_path):
    text = GOOD.replace("scale: 2", "scale: 0").replace("[320, 240]", "[0, 240]")
    text = text.replace("look_at", "lok_at")
    with pytest.raises(SceneError) as caught:
        scene(tmp_path, text)
    path = tmp_path / "scene.yaml"
    first, second, third = str(caught.value).splitlines()
    assert first.startswith(f"{path}:6: assets[0].transform.scale: ")
    assert second.startswith(f"{path}:10: camera.lok_at: is not a known key; did you mean look_at")
    assert third.startswith(f"{path}:17: resolution[0]: ")
    assert caught.value.line == 6


def test_a_file_full_of_mistakes_names_the_first_twenty_one(tmp_path):
    many = "".join(f"wrong{k}: 1\n" for k in range(30))
    with pytest.raises(SceneError, match=r"wrong20.*\nand 9 more$"):
        scene(tmp_path, GOOD + many)


def test_one_number_stands_for_equal_ones(tmp_path):
    light = "  - {type: rectangle, position: [1, 3, 0], look_at: [0, 0, 0], size: 0.5, radiance: 4}"
    text = GOOD.replace("radiance: [1, 1, 1]\n", f"radiance: 1\n{light}\n")
    _, sky, lamp = scene(tmp_path, text).scene.lights
    assert sky.radiance == (1, 1, 1) and lamp.size == (0.5, 0.5) and lamp.radiance == (4, 4, 4)
    with pytest.raises(
        SceneError, match=r"camera\.position: expected a list of 3 numbers, found 5"
    ):
        scene(tmp_path, GOOD.replace("position: [0, 1, 5]", "position: 5"))


def _everywhere(model, key=()):
    """All keys of the models below a model, lists with one item, unions with each type."""
    for name, field in model.model_fields.items():
        yield (*key, name)
        kind, within = field.annotation, (*key, name)
        if get_origin(kind) is tuple and get_args(kind)[-1] is ...:
            kind, within = get_args(kind)[0], (*within, 0)
            yield within
        for one in _models(kind):
            yield from _everywhere(one, (*within, one))


def _models(kind):
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        return [kind]
    return [one for part in get_args(kind) for one in _models(part)]


def _holding(key, value):
    """A scene with a value at a key and, of the mappings on the way, `type` alone."""
    for part in reversed(key):
        if isinstance(part, str):
            value = {part: value}
        elif isinstance(part, int):
            value = [value]
        elif "type" in part.model_fields:
            value = {"type": get_args(part.model_fields["type"].annotation)[0]} | value
    return value


VALUES = [None, True, 0, -1, 1.5, 10**30, 1e30, float("nan"), float("inf"), "x y", [], {}, [1], {}]
VALUES += [[1] * 5, ["a", None], {"type": "x"}, {"kind": "spot"}, {1: 2}, date(2020, 1, 1), b"x"]


@pytest.mark.parametrize("value", VALUES, ids=repr)
def test_no_value_of_any_key_is_reported_in_terms_of_the_program(value):
    count = 0
    for key in [*_everywhere(Scene), ()]:
        try:
            Scene.model_validate(_holding(key, value))
        except ValidationError as error:
            for mistake in mistakes(Scene, error.errors()):
                count += 1
                words = set(re.findall(r"[A-Za-z_]+", mistake.message.split("found ")[0]))
                terms = {"tuple", "valid", "dictionary", "Input", "parse", "instance", "None"}
                assert not words & terms, mistake
                assert not any(word.endswith("Model") for word in words), mistake
    assert count > 100


ALIASES = "a: &a [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n" + "".join(
    f"{new}: &{new} [{', '.join([f'*{old}'] * 10)}]\n"
    for old, new in zip("abcdefgh", "bcdefghi", strict=True)
)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "empty"),
        ("- 1\n", "expected a mapping of assets"),
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
