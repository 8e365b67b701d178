"""Choice in proportion to weights: intervals of their running sums.

Sums are (k + 1,) float64, from 0, rising. The interval that a number is in comes in the order of
the numbers: nearby ones stay neighbours, so that well spread ones stay so. An interval of no
length is never found, unless all that follow have none.
"""

import numpy as np

from rna_sdk.machine.compiled import compiled


@compiled(fastmath=())
def find_interval(cumulative: np.ndarray, value: float) -> int:
    """The interval that a value is in, by bisection."""
    low, high = 0, len(cumulative) - 1
    while high - low > 1:
        middle = (low + high) // 2
        if cumulative[middle] <= value:
            low = middle
        else:
            high = middle
    return low


@compiled(fastmath=())
def interval_near(cumulative: np.ndarray, near: int, value: float) -> int:
    """The interval that a value is in, in steps from one near it."""
    while near > 0 and cumulative[near] > value:
        near -= 1
    while near < len(cumulative) - 2 and cumulative[near + 1] <= value:
        near += 1
    return near


@compiled(fastmath=())
def place_within(cumulative: np.ndarray, interval: int, value: float) -> float:
    """Relative position of a value in its interval, in [0, 1)."""
    length = cumulative[interval + 1] - cumulative[interval]
    place = (value - cumulative[interval]) / length if length > 0.0 else 0.0
    return min(max(place, 0.0), 1.0 - 1e-16)


def guide_of(cumulative: np.ndarray, fineness: int) -> np.ndarray:
    """For each row of sums (r, k + 1) an interval near i / count of the last sum, for i < count.

    Returns (r, count) int32; count is `fineness` times k. From `guide_entry` of a u the interval of
    u is few steps away: Chen and Asau, On Generating Random Variates from an Empirical Distribution
    (AIIE Transactions 6, 1974).
    """
    guide = np.empty((len(cumulative), fineness * (cumulative.shape[1] - 1)), np.int32)
    _fill_guide(cumulative, guide)
    return guide


@compiled(rows="cumulative guide", step=16, fastmath=())
def _fill_guide(cumulative: np.ndarray, guide: np.ndarray) -> None:
    count = guide.shape[1]
    for row in range(len(guide)):
        interval = 0
        for i in range(count):
            value = i / count * cumulative[row, -1]
            interval = interval_near(cumulative[row], interval, value)
            guide[row, i] = interval


@compiled(fastmath=())
def guide_entry(u: float, count: int) -> int:
    """Place in a guide of `count` entries for a u in [0, 1)."""
    return min(int(u * count), count - 1)
