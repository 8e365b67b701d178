"""Which triangles of a mesh have a mixture of lobes of their own.

Meshes hold one material after the other, so places are runs of triangles: points in the order of
their triangles take one of a few mixtures each, and a change of the mixture between two of them has
its price (Viterbi's algorithm). The mixtures are those that the points of each then fit best, in
turns, as with k-means.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rna_export.export.sampling_shares import STEPS, Array, fitted_shares
from rna_sdk.package.limits import MAX_MIXTURES

_ROUNDS = 3
_PRICE = 0.01  # of a change, in the variance of all points with one mixture
_QUICK = STEPS // 4
_FEWEST = 12  # points of a mixture
_NEAR = 1024  # triangles of a mesh, among which each has a neighbour


class Weighted(NamedTuple):
    """The data of a fit of mixtures: k directions at n points.

    row: (k,) int64, the points. weight, densities: of `fitted_shares`. points: n.
    """

    row: NDArray[np.int64]
    weight: Array
    densities: Array
    points: int

    def costs(self, shares: Array) -> Array:
        """Sum of weight / density by point: (n,)."""
        costs = self.weight / (self.densities @ shares)
        return np.bincount(self.row, costs, self.points).astype(np.float64)

    def fitted(self, chosen: NDArray[np.bool_], steps: int) -> Array:
        """Shares for the points that are chosen, (n,)."""
        mine = chosen[self.row]
        return fitted_shares("surface", self.weight[mine], self.densities[mine], steps)


def segments_of(
    data: Weighted, triangle: np.ndarray, triangles: np.ndarray
) -> list[tuple[int, Array]]:
    """First triangle and shares of each run of triangles, in order; the first one begins at 0.

    triangle: (n,), of the points. triangles: (t, 3), of the mesh.
    """
    order = np.argsort(triangle, kind="stable")
    whole = data.fitted(np.ones(data.points, bool), STEPS)
    price = _PRICE * float(data.costs(whole).sum())
    label = _best_lobes(data, whole)
    for _ in range(_ROUNDS):
        known = [k for k in np.unique(label).tolist() if (label == k).sum() >= _FEWEST]
        mixtures = [whole, *(data.fitted(label == k, _QUICK) for k in known)]
        costs = np.stack([data.costs(shares) for shares in mixtures], axis=1)[order]
        label[order] = _labels(costs, price)
    changes = np.flatnonzero(np.diff(label[order])) + 1
    starts = [0, *changes.tolist()]
    final = {k: data.fitted(label == k, STEPS) for k in np.unique(label).tolist()}
    ascending, of_point = triangle[order].tolist(), label[order].tolist()
    firsts = [0, *(_border(triangles, *ascending[k - 1 : k + 1]) for k in changes.tolist())]
    ends = [*firsts[1:], len(triangles)]
    runs = zip(firsts, ends, starts, strict=True)
    return [(first, final[of_point[start]]) for first, end, start in runs if first < end]


def _border(triangles: np.ndarray, before: int, after: int) -> int:
    """Where triangles of another mixture begin: above `before`, up to `after`.

    The first one that shares no corner with those just before it, as at the next of several
    meshes; else the middle.
    """
    for k in range(before + 1, after + 1):
        if not np.isin(triangles[k], triangles[max(k - _NEAR, 0) : k]).any():
            return k
    return (before + after + 1) // 2


def _best_lobes(data: Weighted, shares: Array) -> NDArray[np.int64]:
    """The lobe of which more would help each point most: (n,)."""
    gain = data.weight / np.square(data.densities @ shares)
    lobes = range(data.densities.shape[1])
    by_lobe = [np.bincount(data.row, gain * data.densities[:, k], data.points) for k in lobes]
    best: NDArray[np.int64] = np.argmax(by_lobe, axis=0)
    return best


def _labels(costs: Array, price: float) -> NDArray[np.int64]:
    """Which mixture each point in order takes, with at most MAX_MIXTURES runs: (n,).

    costs: (n, mixtures).
    """
    while True:
        total, came = costs[0].copy(), np.empty(costs.shape, np.int64)
        for k, cost in enumerate(costs):
            least = int(np.argmin(total))
            changed = total[least] + price < total
            came[k] = np.where(changed, least, np.arange(len(total)))
            total = np.where(changed, total[least] + price, total) + (cost if k else 0.0)
        label = np.empty(len(costs), np.int64)
        at = int(np.argmin(total))
        for k in range(len(costs) - 1, -1, -1):
            label[k] = at
            at = int(came[k, at])
        if np.count_nonzero(np.diff(label)) < MAX_MIXTURES:
            return label
        price *= 2.0
