"""Errors of a scene file in plain words: pydantic's, described by the model's types."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic_core import ErrorDetails

Key = tuple[str | int, ...]

_BOUNDS = {
    "greater_than_equal": ("ge", "at least"),
    "less_than_equal": ("le", "at most"),
    "greater_than": ("gt", "more than"),
    "less_than": ("lt", "less than"),
}
_LIKENESS = 0.76  # at least, of a misspelt name to the right one: 1 is the same
_OTHER_NAMES = {
    "sun": "directional",
    "area": "rectangle",
    "quad": "rectangle",
    "hdri": "environment",
    "sky": "environment",
    "dome": "environment",
    "lambert": "diffuse",
    "metal": "conductor",
    "plastic": "coated",
}
"""Types of lights and materials, by the names that other programs have for them."""


@dataclass(frozen=True)
class Mistake:
    """A mistake: its key in the file, and its message."""

    key: Key
    message: str


def mistakes(model: type[BaseModel], details: Sequence[ErrorDetails]) -> list[Mistake]:
    """All that is wrong, each thing once, in pydantic's order.

    A misspelt key takes the place of the one that is missing for it.
    """
    unknown = [_place(model, d) for d in details if d["type"] == "extra_forbidden"]
    by_key: dict[Key, Mistake] = {}
    for detail in details:
        place = _place(model, detail)
        if detail["type"] == "missing" and _is_misspelt(place, unknown):
            continue
        mistake = _mistake(place, detail)
        by_key.setdefault(mistake.key, mistake)  # each choice of a union, or item, has its own
    return list(by_key.values())


@dataclass(frozen=True)
class _Place:
    """Where an error is: its key, without pydantic's tags of unions, and the types there.

    kind: what the value should be. around: the model that the key is in, if it is known.
    """

    key: Key
    kind: Any
    around: type[BaseModel] | None

    @property
    def keys_here(self) -> list[str]:
        return [] if self.around is None else list(self.around.model_fields)


def _place(model: type[BaseModel], detail: ErrorDetails) -> _Place:
    key: Key = ()
    kind: Any = model
    around: type[BaseModel] | None = None
    for part in detail["loc"]:
        first, *others = _choices(kind)
        if others:  # the part is the name of a choice, which the file does not have
            kind = next((one for one in (first, *others) if part in _tags(one)), kind)
        elif _is_model(first):
            around = first
            field = first.model_fields.get(str(part))
            key, kind = (*key, str(part)), None if field is None else field.annotation
        elif get_origin(first) is tuple:  # whose items are all of one type
            key, kind = (*key, part), get_args(first)[0]
    return _Place(key, kind, around)


def _mistake(place: _Place, detail: ErrorDetails) -> Mistake:
    key, value, context = place.key, detail["input"], detail.get("ctx", {})
    match detail["type"]:
        case "extra_forbidden":
            return Mistake(key, _unknown(str(key[-1]), place))
        case "missing" if isinstance(key[-1], int):  # an item of a list that is too short
            return Mistake(key[:-1], f"expected {_of(place, key)}, found {_shown(value)}")
        case "missing":
            return Mistake(key, f"is missing: expected {_expected(place.kind)}")
        case "union_tag_invalid":
            return Mistake((*key, "type"), _unknown_type(str(context["tag"]), place.kind))
        case "union_tag_not_found":
            return _untyped(place, value)
        case "value_error":
            return Mistake(key, detail["msg"].removeprefix("Value error, "))
        case "string_pattern_mismatch":
            return Mistake(key, f"expected letters, digits and '_', found {_shown(value)}")
        case "invalid_key":
            return Mistake(key, f"expected text as a key, found {_shown(value)}")
        case "finite_number":
            return Mistake(key, f"expected a finite number, found {_shown(value)}")
        case kind if kind in _BOUNDS:
            name, words = _BOUNDS[kind]
            bound = f"{words} {_number(context[name])}"
            return Mistake(key, f"expected {_expected(place.kind)}, {bound}, found {_shown(value)}")
        case "int_parsing_size":
            return Mistake(key, f"is too large: {_shown(value)}")
    return Mistake(key, f"expected {_expected(place.kind)}, found {_shown(value)}")


def _is_misspelt(missing: _Place, unknown: Iterable[_Place]) -> bool:
    """Whether a key that is missing is there in another spelling."""
    name = str(missing.key[-1])
    return any(
        place.key[:-1] == missing.key[:-1] and _close(str(place.key[-1]), place.keys_here) == name
        for place in unknown
    )


def _unknown(name: str, place: _Place) -> str:
    close = _close(name, place.keys_here)
    if close is not None:
        return f"is not a known key; did you mean {close}?"
    inner = [(outer, _close(name, keys)) for outer, keys in _models_below(place.around)]
    below = [f"{outer}.{key}" for outer, key in inner if key is not None]
    if below:
        return f"is not a known key here; did you mean {_or(below)}?"
    return f"is not a known key; known here: {', '.join(place.keys_here)}"


def _models_below(model: type[BaseModel] | None) -> Iterator[tuple[str, list[str]]]:
    """Keys of a model that are mappings themselves, and the keys in those."""
    for name, field in ({} if model is None else model.model_fields).items():
        (kind, *others) = _choices(field.annotation)
        if not others and _is_model(kind):
            yield name, list(kind.model_fields)


def _unknown_type(found: str, kind: Any) -> str:
    types = _types(kind)
    close = _OTHER_NAMES.get(found.lower()) or _close(found, types)
    hint = f"; did you mean {close}?" if close in types else ""
    return f"expected {_or(types)}, found {found!r}{hint}"


def _untyped(place: _Place, value: Any) -> Mistake:
    """A mapping without `type`: a key that is there for it, or that it is missing."""
    types = _types(place.kind)
    for name, member in value.items() if isinstance(value, dict) else ():
        if member in types or sorted(str(name)) == sorted("type"):
            return Mistake((*place.key, name), "is not a known key; did you mean type?")
    return Mistake((*place.key, "type"), f"is missing: expected {_or(types)}")


def _close(name: str, known: Sequence[str]) -> str | None:
    holding = [one for one in known if name in one.split("_")]  # fov in vertical_fov_deg
    if len(holding) == 1:
        return holding[0]
    plain = {one.replace("_", "").lower(): one for one in known}
    matches = get_close_matches(name.replace("_", "").lower(), plain, n=1, cutoff=_LIKENESS)
    return plain[matches[0]] if matches else None


def _of(place: _Place, key: Key) -> str:
    """The expected form of the list that an item lacks."""
    assert place.around is not None  # every list of the scene is the value of a key
    name = next(part for part in reversed(key) if isinstance(part, str))
    return _expected(place.around.model_fields[name].annotation)


def _expected(kind: Any) -> str:
    """A type in words: `a list of 3 numbers`."""
    first, *others = _choices(kind)
    if _types(kind):
        return f"a mapping with type: {_or(_types(kind))}"
    if others:
        return _or([_expected(one) for one in (first, *others)])
    if get_origin(first) is Literal:
        return _or([str(one) for one in get_args(first)])
    if get_origin(first) is tuple:
        item, *more = get_args(first)
        if more[-1] is ...:
            return "a list, each item after a '-'"
        return f"a list of {1 + len(more)} {_WORDS[_choices(item)[0]].removeprefix('a ')}s"
    if get_origin(first) is dict:
        return "a mapping"
    if _is_model(first):
        keys = [*first.model_fields]
        return f"a mapping of {', '.join(keys[:_KEYS])}{' ...' if len(keys) > _KEYS else ''}"
    return _WORDS[first]


_KEYS = 5  # that are named of a mapping
_WORDS = {
    float: "a number",
    int: "a whole number",
    str: "text",
    Path: "the name of a file",
    bool: "true or false",
}


def _shown(value: object) -> str:
    """A value that was found, short enough for a line."""
    try:
        return _short(value)
    except ValueError:  # YAML reads 1:1:1 in base 60, and Python writes no number of any length
        return "a number of thousands of digits"


def _short(value: object) -> str:
    match value:
        case None:
            return "nothing"
        case bool():
            return str(value).lower()
        case dict():
            return f"a mapping of {', '.join(map(str, value))}" if value else "an empty mapping"
        case list() if len(value) <= 4 and all(isinstance(v, str | int | float) for v in value):
            return f"[{', '.join(map(str, value))}]"
        case list():
            return f"a list of {len(value)}"
    shown = repr(value) if isinstance(value, str | int | float) else str(value)
    return shown if len(shown) <= 60 else f"{shown[:57]}..."


def _number(value: float) -> str:
    """1e+18 instead of all its zeros, and whole numbers that are shorter as they are."""
    return min(f"{value:g}", str(value), key=len) if isinstance(value, float) else str(value)


def _choices(kind: Any) -> tuple[Any, ...]:
    """The types of a union without None, or the type itself; without annotations."""
    if get_origin(kind) is Annotated:
        return _choices(get_args(kind)[0])
    if get_origin(kind) in (Union, UnionType):
        kinds = [one for one in get_args(kind) if one is not type(None)]
        return tuple(choice for one in kinds for choice in _choices(one))
    return (kind,)


def _is_model(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, BaseModel)


def _types(kind: Any) -> list[str]:
    """The values of `type` in a union of models."""
    first, *others = _choices(kind)
    return [tag for one in (first, *others) for tag in _tags(one)] if others else []


def _tags(kind: Any) -> tuple[str, ...]:
    """The values of a model's `type`; none for a model without such a field."""
    field = kind.model_fields.get("type") if _is_model(kind) else None
    return () if field is None else get_args(field.annotation)


def _or(words: Sequence[str]) -> str:
    """`a, b or c`."""
    *most, last = words
    return f"{', '.join(most)} or {last}" if most else last
