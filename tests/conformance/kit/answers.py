"""The answers to one question of the kit, and what their tolerances are made of."""

from dataclasses import dataclass

import numpy as np

PART_OF_SCALE = 1e-4  # tolerance of a well-conditioned row
SIGN_PATTERNS = 32


@dataclass(frozen=True)
class Answers:
    """To one question: queries (n, columns) float32; blocks (n, K), expected and tolerance
    (n, width) float64.

    blocks: of two decoders those of the second behind those of the first.

    classes: name, first row, rows. scale: root mean square of the expected of ordinary rows.
    step: the most that a step of one int8 activation changes an output; 0 for float32.
    """

    queries: np.ndarray
    blocks: np.ndarray
    expected: np.ndarray
    tolerance: np.ndarray
    classes: list[tuple[str, int, int]]
    scale: float
    step: float
