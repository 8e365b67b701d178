"""docs/scene.md says of every key what the models say."""

import re
from collections.abc import Iterator
from pathlib import Path
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

import pytest
from pydantic import BaseModel
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from rna_render.scene.scene_file import read_scene
from rna_render.scene.scene_model import Scene

DOCS = Path(__file__).parents[2] / "docs" / "scene.md"
RUNTIME = DOCS.parents[1] / "runtime"


def models(part: Any) -> Iterator[type[BaseModel]]:
    """The models of a part of a scene file, and of all below it."""
    if isinstance(part, type) and issubclass(part, BaseModel):
        yield part
        for field in part.model_fields.values():
            yield from models(field.annotation)
    for inner in get_args(part):
        yield from models(inner)


MODELS = list(dict.fromkeys(models(Scene)))


def row(name: str, field: FieldInfo) -> str:
    """The field's line of a table: key, type, default, meaning."""
    default = "required" if field.is_required() else _default(field)
    return f"| `{name}` | {_type(field.annotation)} | {default} | {field.description} |"


def _default(field: FieldInfo) -> str:
    value = field.default
    assert value is not PydanticUndefined
    if value in (None, (), {}, "") or isinstance(value, BaseModel):
        return "none"
    if isinstance(value, tuple):
        return f"`[{', '.join(f'{item:g}' for item in value)}]`"
    if isinstance(value, str):
        return f"`{value}`"
    return f"`{str(value).lower()}`" if isinstance(value, bool) else f"`{value:g}`"


def _type(annotation: Any) -> str:
    if get_origin(annotation) is Annotated:
        return _type(get_args(annotation)[0])
    if get_origin(annotation) in (Union, UnionType):
        return _type(next(kind for kind in get_args(annotation) if kind is not type(None)))
    if get_origin(annotation) is tuple:
        kinds = get_args(annotation)
        return "list" if kinds[-1] is ... else f"{len(kinds)} {_type(kinds[0])}s"
    if get_origin(annotation) is Literal or annotation in (str, Path):
        return "text"
    names = {float: "number", int: "whole number", bool: "true or false"}
    return names.get(annotation, "mapping")


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.__name__)
def test_every_key_is_described_as_in_the_model(model):
    text = DOCS.read_text(encoding="utf-8")
    for name, field in model.model_fields.items():
        assert row(name, field) in text, "docs/scene.md lacks:\n" + row(name, field)


def test_the_docs_describe_no_key_that_is_not_there():
    rows = [row(name, field) for model in MODELS for name, field in model.model_fields.items()]
    keys = DOCS.read_text("utf-8").split("## Light transport")[0]
    written = [line for line in keys.splitlines() if line.startswith("| `")]
    assert sorted(written) == sorted(rows)


def test_every_key_is_read_by_the_renderer():
    """By its name, beside the models; `up` of a camera or a light, for one, is read as `.up`."""
    files = [path for path in RUNTIME.rglob("*.py") if not path.name.endswith("_model.py")]
    text = "\n".join(path.read_text("utf-8") for path in files)
    keys = {name for model in MODELS for name in model.model_fields}
    assert {key for key in keys if not re.search(rf"\.{key}\b", text)} == set()


def test_models_of_every_light_and_material_are_among_them():
    names = {model.__name__ for model in MODELS}
    assert {"EnvironmentModel", "SphereModel", "ShadowCatcherModel", "QualityModel"} <= names


def test_the_example_in_the_docs_is_a_scene(tmp_path):
    example = DOCS.read_text("utf-8").split("```yaml\n")[1].split("```")[0]
    (tmp_path / "scene.yaml").write_text(example, encoding="utf-8")
    scene = read_scene(tmp_path / "scene.yaml").scene
    assert {light.type for light in scene.lights} == {"environment", "rectangle"}
