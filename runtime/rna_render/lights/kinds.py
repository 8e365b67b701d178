"""Numbers of the kinds of lights, and the layout of a light's row; `table` says what they mean."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from rna_render.lights.base import LightRow

DIRECTIONAL, SUN, POINT, RECTANGLE, DISK, SPHERE, UNIFORM, IMAGE, TRIANGLES = range(9)

# Every kind's first three numbers are a colour: radiance, irradiance, intensity, or a factor.
COLOUR, OWN = 0, 3
ROW_NUMBERS, ROW_WORDS = 20, 8


Numbers = Sequence[float] | np.ndarray


def light_row(kind: int, colour: Numbers, own: Numbers = (), words: Numbers = ()) -> LightRow:
    """colour: three numbers. own: those of the kind. words: addresses and sizes."""
    numbers = np.zeros(ROW_NUMBERS)
    numbers[COLOUR:OWN] = colour
    flat = np.ravel(np.asarray(own, np.float64))
    numbers[OWN : OWN + len(flat)] = flat
    padded = np.zeros(ROW_WORDS, np.uint64)
    padded[: len(words)] = words
    return LightRow(kind, numbers, padded)
