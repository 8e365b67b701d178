"""Divides the rendered objects into the parts of the package."""

import re
from typing import TypedDict

from rna_geometry import curves_export, mesh_export

_MOST = 16  # parts of a package
_HAIR = "hair"
_ONLY = "asset"


class Part(TypedDict):
    """A part that a package will have; owner: the top object it is of, None for any."""

    name: str
    kind: str
    owner: str | None


def find_parts(how: str) -> list[Part]:
    """The parts to export; their kinds are "surface" and "fiber".

    how: "kinds": all surfaces are a part, and so is all hair; "objects": each top object is one.
    """
    if how == "objects":
        parts = _of_objects()
    else:
        hair, surface = curves_export.owners(), mesh_export.owners()
        names = (_HAIR, "surface") if hair and surface else (_ONLY, _ONLY)
        found = [("surface", names[1])] if surface or not hair else []
        found = [*found, *([("fiber", names[0])] if hair else [])]
        parts = [Part(name=name, kind=kind, owner=None) for kind, name in found]
    if len(parts) > _MOST:
        raise ValueError(
            f"found {len(parts)} parts, expected at most {_MOST}: join objects (Ctrl-J) or parent "
            "them to one another, or capture them as --parts kinds"
        )
    return parts


def is_empty() -> bool:
    """Whether there is nothing that a part could have."""
    return not (mesh_export.owners() or curves_export.owners())


def _of_objects() -> list[Part]:
    surfaces, hair = mesh_export.owners(), curves_export.owners()
    taken: set[str] = set()
    parts: list[Part] = []
    for owner in dict.fromkeys([*surfaces, *hair]):
        both = [("surface", owner in surfaces), ("fiber", owner in hair)]
        kinds = [kind for kind, there in both if there]
        for kind in kinds:
            mark = f"_{_HAIR}" if kind == "fiber" and len(kinds) > 1 else ""
            name = _free_name(owner, mark, taken)
            parts.append({"name": name, "kind": kind, "owner": owner})
    return parts or [{"name": _ONLY, "kind": "surface", "owner": None}]


def _free_name(name: str, mark: str, taken: set[str]) -> str:
    """An unused part name of letters, digits, dots and dashes, unique regardless of case."""
    plain = re.sub(r"[^A-Za-z0-9._-]+", "_", name).strip("._-")[:40] or "part"
    count, result = 1, plain + mark
    while result.lower() in taken:
        count += 1
        result = f"{plain}{mark}_{count}"
    taken.add(result.lower())
    return result
