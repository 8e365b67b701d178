"""Scene files are YAML 1.2 of the core schema."""

import math

import pytest
import yaml

from rna_render.scene.core_yaml import CoreLoader, dump_yaml
from rna_render.scene.scene_file import read_scene
from rna_sdk.errors import SceneError

# YAML 1.2.2, section 10.3.2.
SCALARS: dict[str, object] = {
    "1e3": 1000.0,
    "-1.5E+3": -1500.0,
    ".5": 0.5,
    "1.": 1.0,
    "010": 10,
    "+7": 7,
    "0o17": 15,
    "0x1F": 31,
    "~": None,
    "": None,
    "Null": None,
    "TRUE": True,
    "false": False,
    "-.inf": -math.inf,
    "!!float 3": 3.0,
    "!!str 3": "3",
    **{
        text: text
        for text in ("1:30", "1_000", "0b11", "yes", "on", "2001-01-01", "=", "<<", "1e3x", "e3")
    },
    "'1e3'": "1e3",
}


def parsed(text: str) -> object:
    loader = CoreLoader(text)
    return loader.construct_document(loader.get_single_node())


@pytest.mark.parametrize("text", SCALARS)
def test_scalars_are_those_of_the_core_schema(text):
    actual = parsed(f"a: {text}")["a"]
    assert actual == SCALARS[text] and type(actual) is type(SCALARS[text])


@pytest.mark.parametrize(
    "text",
    [
        *("!!bool abc", '!!int ""', "!!int 1:30", "!!timestamp abc", "!!binary aa", "!!set {a}"),
        *("!!float 1:3", "!!int [1]", "!!seq abc", "!!map [1]", "!foo 1", "9" * 5000, "{[a]: 1}"),
    ],
)
def test_other_tags_are_errors_with_a_line(text, tmp_path):
    with pytest.raises(yaml.MarkedYAMLError):
        parsed(f"a: {text}")
    path = tmp_path / "scene.yaml"
    path.write_text(f"ground: {{}}\nexposure: {text}\n")
    with pytest.raises(SceneError, match=r"scene\.yaml:2: not YAML: ") as caught:
        read_scene(path)
    assert "\n" not in str(caught.value)


def test_what_is_written_is_read_again():
    data = {"group": "1e3", "other": ["0o17", "yes", "~", "", "a"], "numbers": [1e3, 8]}
    assert parsed(dump_yaml(data)) == data


CAMERA = "camera: {position: [1, 1, 1], look_at: [0, 0, 0]}\nground: {}\n"


@pytest.mark.parametrize(("number", "value"), [("1e3", 1000), ("1000", 1000), ("1e+3", 1000)])
def test_a_number_is_one_in_every_key(number, value, tmp_path):
    path = tmp_path / "scene.yaml"
    light = f"{{type: rectangle, position: [0, 9, 0], look_at: [0, 0, 0.1], radiance: {number}, "
    path.write_text(
        f"{CAMERA}max_depth: {number}\nresolution: [{number}, {number}]\n"
        f"lights: [{light}size: {number}}}]\n"
    )
    scene = read_scene(path).scene
    assert scene.max_depth == value and scene.resolution == (value, value)
    assert scene.lights[0].radiance == (value,) * 3 and scene.lights[0].size == (value,) * 2


@pytest.mark.parametrize("key", ["samples: true", "exposure: false", "resolution: [4, true]"])
def test_true_is_no_number(key, tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(f"{CAMERA}{key}\n")
    with pytest.raises(SceneError, match=r"yaml:3: .*: must be a number, not true or false$"):
        read_scene(path)


@pytest.mark.parametrize("value", ["bright", "1:30", "[]", "{a: 1}"])
def test_what_is_no_number_is_refused_in_one_line(value, tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(f"{CAMERA}lights: [{{type: environment, radiance: {value}}}]\n")
    with pytest.raises(SceneError, match=r"lights\[0\]\.radiance: expected") as caught:
        read_scene(path)
    assert "\n" not in str(caught.value)
