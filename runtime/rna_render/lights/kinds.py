"""The kinds of lights, and what the row of each holds, declared once for compiled code and GPUs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

# Members of the rows behind their colour: radiance, irradiance, intensity, or a factor on what
# triangles send. frame: of a shape, rows of the matrix to the world; it faces +z.
_MEMBERS: dict[str, tuple[tuple[str, int | tuple[int, ...]], ...]] = {
    "directional": (("axis", 3),),
    "sun": (("axis", 3), ("one_minus_cosine", ())),
    "point": (("place", 3), ("axis", 3), ("cos_inner", ()), ("cos_outer", ())),
    "rectangle": (("frame", (3, 4)), ("half", 2)),
    "disk": (("frame", (3, 4)), ("radius", ())),
    "sphere": (("centre", 3), ("radius", ())),
    "uniform": (),
    "image": (
        *(("turn_cosine", ()), ("turn_sine", ()), ("total", ()), ("mean", ())),
        *(("rows", ()), ("columns", ())),
    ),
    "triangles": (("rotation", (3, 3)), ("place", 3), ("scale", ())),
}
LIGHT_ROWS = {
    kind: np.dtype([("colour", "<f8", 3), *((name, "<f8", shape) for name, shape in members)])
    for kind, members in _MEMBERS.items()
}
"""Kind -> its numbers; the kind's number is its place here."""

DIRECTIONAL, SUN, POINT, RECTANGLE, DISK, SPHERE, UNIFORM, IMAGE, TRIANGLES = range(len(LIGHT_ROWS))
ROW_NUMBERS, ROW_WORDS = 20, 8
OWN = 3  # numbers of the colour, before those of the kind

Numbers = Sequence[float] | np.ndarray


@dataclass(frozen=True, slots=True)
class LightRow:
    """A light as compiled code has it.

    kind: its number. numbers: (ROW_NUMBERS,) float64, a row of LIGHT_ROWS, filled up with 0.
    words: (ROW_WORDS,) uint64, as its kind has them; addresses among them are valid as long as the
    light.
    """

    kind: int
    numbers: np.ndarray
    words: np.ndarray


def light_row(kind: int, colour: Numbers, words: Numbers = (), **members: Any) -> LightRow:
    """colour: three numbers. members: those of the kind's row. words: addresses and sizes."""
    row = np.zeros((), list(LIGHT_ROWS.values())[kind])
    for name, value in {"colour": colour, **members}.items():
        row[name] = value
    numbers, padded = np.zeros(ROW_NUMBERS), np.zeros(ROW_WORDS, np.uint64)
    own = np.frombuffer(row.tobytes(), np.float64)
    numbers[: len(own)] = own
    padded[: len(words)] = words
    return LightRow(kind, numbers, padded)


def row_places(kind: str) -> dict[str, int]:
    """Where each member begins in a light's numbers."""
    row = LIGHT_ROWS[kind]
    return {name: row.fields[name][1] // 8 for name in row.names}  # type: ignore[index, union-attr]
