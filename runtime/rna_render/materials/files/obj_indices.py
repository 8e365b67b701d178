"""Which corners the faces of a Wavefront OBJ file have.

trimesh takes 1 from each index and lets numpy count what is below 0 from the end of the file. So 0,
which some exporters count from, becomes the last vertex, and a relative index, which counts from
the face on, is right at the end of a file alone. It drops texture coordinates and normals where one
is not there.
"""

import re
import warnings
from pathlib import Path

import numpy as np

from rna_sdk.errors import SceneError

_KINDS = {"v": "vertex", "vt": "texture coordinate", "vn": "normal"}
_FACE = re.compile(r"^[ \t]*f[ \t]+([^#\r\n]*)", re.MULTILINE)
_SHOWN = 40  # characters of a corner
# Columns of a corner, by how many of its parts there are and how many slashes.
_FORMS = {(1, 0): ["v"], (2, 1): ["v", "vt"], (2, 2): ["v", "vn"], (3, 2): ["v", "vt", "vn"]}


def with_plain_indices(path: Path, text: str) -> str:
    """The text of an OBJ file, with all indices of its faces counted from the file's beginning on.

    Raises SceneError, with the line, for a face that names what is not in the file.
    """
    counts = {kind: len(re.findall(rf"^[ \t]*{kind}[ \t]", text, re.MULTILINE)) for kind in _KINDS}
    if _is_plain(" ".join(_FACE.findall(text)), counts):
        return text
    so_far, lines = dict.fromkeys(_KINDS, 0), text.split("\n")
    for number, line in enumerate(lines):
        key = (line.split(maxsplit=1) or [""])[0]
        if key in so_far:
            so_far[key] += 1
        elif (face := _FACE.match(line)) is not None:
            try:
                corners = [_plain(corner, counts, so_far) for corner in face[1].split()]
                _check_forms(corners)
            except ValueError as error:
                raise SceneError(str(error), file=path, line=number + 1) from error
            lines[number] = f"f {' '.join(corners)}"
    return "\n".join(lines)


def _is_plain(faces: str, counts: dict[str, int]) -> bool:
    """Whether all corners have one form and name existing items; false if not known."""
    first = (faces.split(maxsplit=1) or [""])[0]
    form, slashes = (len([*filter(None, first.split("/"))]), first.count("/")), faces.count("/")
    numbers = _integers(faces.replace("/", " "))
    if form not in _FORMS or not len(numbers) or len(numbers) * form[1] != slashes * form[0]:
        return False
    if form == (2, 2) and faces.count("//") * 2 != slashes:
        return False
    table, most = numbers.reshape(-1, form[0]), [counts[kind] for kind in _FORMS[form]]
    return bool(((table >= 1) & (table <= most)).all())


def _integers(text: str) -> np.ndarray:
    """The integers of a text, (n,) int64; none where something else is in it."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # numpy before 2.3 stops at what it cannot read, and warns
        try:
            return np.fromstring(text, np.int64, sep=" ")
        except (ValueError, DeprecationWarning):
            return np.zeros(0, np.int64)


def _check_forms(corners: list[str]) -> None:
    forms = {tuple(map(bool, corner.rstrip("/").split("/"))): corner for corner in corners}
    if len(forms) > 1:
        found = " and ".join(repr(corner) for corner in forms.values())
        raise ValueError(f"a face has the corners {found}; expected the same parts in each")


def _plain(corner: str, counts: dict[str, int], so_far: dict[str, int]) -> str:
    """A corner with all indices from 1 on. so_far: the counts before its face."""
    parts = corner.split("/")
    if len(parts) > len(_KINDS):
        raise ValueError(
            f"a face has the corner {corner[:_SHOWN]!r}; expected vertex/texture/normal"
        )
    plain: list[str] = []
    for part, (kind, name) in zip(parts, _KINDS.items(), strict=False):
        if not part and plain:
            plain.append("")
            continue
        if not re.fullmatch(r"[-+]?[0-9]{1,18}", part):
            raise ValueError(f"a face has the corner {corner[:_SHOWN]!r}; expected integers")
        index = int(part) + (so_far[kind] + 1 if part.startswith("-") else 0)
        if not 1 <= index <= counts[kind] or int(part) == 0:
            raise ValueError(
                f"a face names {name} {int(part)}; expected 1 to {counts[kind]}, or -1 to "
                f"-{so_far[kind]} counted back from the face"
            )
        plain.append(str(index))
    return "/".join(plain)
