"""JSON without the usual leniencies: UTF-8, unique keys, finite numbers, bounded depth.

Numbers are their values, however they are spelt: `8.0` and `8e0` are the integer 8.
"""

import json
import math
from collections import Counter
from typing import Any, TypeVar

from pydantic import BaseModel

from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import MAX_INTEGER, MAX_JSON_DEPTH

Model = TypeVar("Model", bound=BaseModel)


def parse_object(data: bytes, where: str, malformed: Code) -> dict[str, Any]:
    """The JSON object in `data`.

    Args:
        data: the bytes; the caller has bounded their number.
        where: place named in an issue.
        malformed: code for what is no JSON object at all.

    Raises:
        PackageError: `malformed`, JSON_DUPLICATE_KEY or JSON_NOT_FINITE.
    """

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        result = dict(pairs)
        if len(result) < len(pairs):
            counts = Counter(key for key, _ in pairs)
            twice = next(key for key, count in counts.items() if count > 1)
            refuse(Code.JSON_DUPLICATE_KEY, where, repr(twice), "each key once")
        return result

    def finite(text: str) -> float:
        value = float(text)
        if not math.isfinite(value):
            refuse(Code.JSON_NOT_FINITE, where, text, "a finite number")
        is_integer = value.is_integer() and abs(value) <= MAX_INTEGER
        return int(value) if is_integer else value

    def whole(text: str) -> int:
        finite(text)
        return int(text)

    try:
        value = json.loads(
            data.decode("utf-8"),
            object_pairs_hook=unique,
            parse_float=finite,
            parse_int=whole,
            parse_constant=finite,
        )
        depth = _depth(value)
        json.dumps(value, ensure_ascii=False).encode()  # fails for half a surrogate pair
    except (ValueError, RecursionError) as error:
        refuse(malformed, where, error, "a JSON object in UTF-8")
    if not isinstance(value, dict):
        refuse(malformed, where, type(value).__name__, "a JSON object")
    if depth > MAX_JSON_DEPTH:
        refuse(malformed, where, f"nesting {depth} deep", f"at most {MAX_JSON_DEPTH}")
    return value


def model_of(model: type[Model], value: Any) -> Model:
    """The model with the members of a JSON object of `parse_object`; no value is converted.

    Raises:
        pydantic.ValidationError: the object does not fit the model.
    """
    text = json.dumps(value)
    return model.model_validate_json(text, strict=True, by_alias=True, by_name=False)


def _depth(value: Any) -> int:
    if isinstance(value, dict):
        return 1 + max(map(_depth, value.values()), default=0)
    if isinstance(value, list):
        return 1 + max(map(_depth, value), default=0)
    return 0


def pointer(*path: str | int) -> str:
    """RFC 6901 JSON pointer, `pointer("a/b", 0)` -> `/a~1b/0`."""
    return "".join("/" + str(part).replace("~", "~0").replace("/", "~1") for part in path)
