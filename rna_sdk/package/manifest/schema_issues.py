"""Faults that a model of JSON finds, as issues."""

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from rna_sdk.package.container.strict_json import pointer
from rna_sdk.package.issues import Code, Issue

_SCHEMA_CODES = {"missing": Code.FIELD_MISSING, "extra_forbidden": Code.FIELD_UNKNOWN}


def schema_issues(error: ValidationError, *holder: str | int) -> list[Issue]:
    """The issues of an object of the manifest; `holder` is the path to it."""
    return [_schema_issue(detail, *holder) for detail in _root_causes(error.errors())]


def _root_causes(details: list[ErrorDetails]) -> list[ErrorDetails]:
    """Without a list's "too short" that only says that its items failed."""
    return [
        detail
        for detail in details
        if detail["type"] != "too_short"
        or not any(other["loc"][:-1][: len(detail["loc"])] == detail["loc"] for other in details)
    ]


def _schema_issue(detail: ErrorDetails, *holder: str | int) -> Issue:
    kind = detail["type"]
    if kind == "missing" and isinstance(detail["loc"][-1], int):
        kind = "too_short"  # what an array lacks is no member
    code = _SCHEMA_CODES.get(kind, Code.FIELD_VALUE)
    if kind in Code.__members__:
        code = Code[kind]
    # Pydantic's own parts, and the tags of unions, stand in brackets.
    members = (part for part in detail["loc"] if not str(part).startswith("["))
    where = pointer(*holder, *members)
    found = "nothing" if code is Code.FIELD_MISSING else repr(detail["input"])
    return Issue.of(code, where, found, detail["msg"])
