"""Nearby light in the last three columns of queries, and rows that are about it."""

import numpy as np

from rna_sdk.package.decoder.query_arrays import NEARBY
from rna_sdk.package.manifest.manifest_tiers import TierNearby

NEARBY_RECORD = TierNearby(
    lengths=(0.01, 0.03, 0.1), visible=(0.9, 0.75, 0.5), shadowed=(0.02, 0.1, 0.25)
)
_LIMITS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (3, 3, 3), (-1, 0.5, -0.0), (1e-42, 0, 1)]


def with_nearby(
    seed: int, rows: np.ndarray, classes: list[tuple[str, int, int]]
) -> tuple[np.ndarray, list[tuple[str, int, int]]]:
    """The rows with random nearby light behind them, and at the end a class of odd ones: ordinary
    rows with none, one length alone, the most an estimate has and less than 0, then with a share
    that is not finite."""
    rng, count = np.random.default_rng([seed, 2]), NEARBY.columns
    odd = rows[: len(_LIMITS) + 3 * count]
    shares = rng.random((len(rows) + len(odd), count)).astype(np.float32)
    shares[len(rows) : len(rows) + len(_LIMITS)] = _LIMITS
    for k, value in enumerate([np.nan, np.inf, -np.inf] * count):
        shares[len(rows) + len(_LIMITS) + k, k // 3] = value
    whole = np.hstack([np.concatenate([rows, odd]), shares])
    return whole, [*classes, ("nearby light", len(rows), len(odd))]
