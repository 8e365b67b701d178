"""The last three columns of queries of surfaces, the base colour, and rows that are about it."""

import numpy as np

from rna_sdk.package.decoder.query_arrays import column_count
from tests.conformance.kit.queries import COLUMNS, INPUTS

FIRST = column_count(INPUTS)
NAME = "base colour"
_LIMITS = [
    *((0, 0, 0), (1, 1, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1)),
    *((-0.0, 1e-42, 2.5), (-2, -2.5, 0.5)),
]


def with_base_colors(
    seed: int, rows: np.ndarray, classes: list[tuple[str, int, int]]
) -> tuple[np.ndarray, list[tuple[str, int, int]]]:
    """The rows with random base colours, and at the end a class of odd ones: ordinary rows with
    black, white and pure colours, with components below 0, then with one that is not finite."""
    rng = np.random.default_rng([seed, 1])
    odd = rows[: len(_LIMITS) + 9].copy()
    for of in (rows, odd):
        of[:, FIRST:COLUMNS] = rng.random((len(of), 3))
    odd[: len(_LIMITS), FIRST:] = _LIMITS
    for k, value in enumerate([np.nan, np.inf, -np.inf] * 3):
        odd[len(_LIMITS) + k, FIRST + k // 3] = value
    return np.concatenate([rows, odd]), [*classes, (NAME, len(rows), len(odd))]
