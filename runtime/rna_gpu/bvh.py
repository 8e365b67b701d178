"""Bounding volume hierarchies for the shaders, built with binned surface-area heuristics.

Wald, On fast Construction of SAH-based Bounding Volume Hierarchies (2007).
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.records.geometry import NODE
from rna_sdk.machine.compiled import compiled

BINS = 16
LEAF = 4  # primitives
MAX_DEPTH = 46  # below RNA_STACK of wgsl/geometry.wgsl
# Levels; from here on sets are halved, which ends within MAX_DEPTH for 2^22 x LEAF.
HALVED_FROM = 24

Box = NDArray[np.float32] | NDArray[np.float64]
"""Corners, (2, 3)."""
Centres = NDArray[np.float32]
"""Centres of the primitives' boxes, (n, 3)."""
Order = NDArray[np.int64]
"""Numbers of the primitives, (n,); a set is a range of it."""


def build_tree(boxes: NDArray[np.float32]) -> tuple[NDArray[Any], NDArray[np.int64]]:
    """A tree over n boxes: nodes of dtype NODE.dtype, root first, and the order of the primitives.

    boxes: (n, 2, 3) float32, corners; n at least 1.
    """
    count = len(boxes)
    order = np.arange(count)
    corners = np.empty((2 * count, 2, 3), np.float32)
    links = np.zeros((2 * count, 2), np.uint32)
    centres = (0.5 * (boxes[:, 0].astype(np.float64) + boxes[:, 1])).astype(np.float32)
    used = _build(np.ascontiguousarray(boxes, np.float32), centres, order, corners, links)
    nodes = np.empty(used, NODE.dtype)
    nodes["low"], nodes["high"] = corners[:used, 0], corners[:used, 1]
    nodes["child"], nodes["count"] = links[:used, 0], links[:used, 1]
    return nodes, order


@compiled(fastmath=())
def _build(
    boxes: NDArray[np.float32],
    centres: Centres,
    order: Order,
    corners: NDArray[np.float32],
    links: NDArray[np.uint32],
) -> int:
    """Fills the nodes in depth-first order; returns how many there are."""
    stack = np.empty((2 * MAX_DEPTH + 4, 4), np.int64)  # first, end, level, parent of a right child
    stack[0] = 0, len(order), 0, -1
    top, used = 1, 0
    while top:
        top -= 1
        first, end, level, parent = stack[top]
        node = used
        used += 1
        if parent >= 0:
            links[parent, 0] = node
        _bound(boxes, order, first, end, corners[node])
        if end - first <= LEAF:
            links[node] = first, end - first
            continue
        middle = first
        if level < HALVED_FROM:
            middle = _split(boxes, centres, order, first, end)
        if not first < middle < end:
            middle = _halve(centres, order, first, end)
        stack[top] = middle, end, level + 1, node
        stack[top + 1] = first, middle, level + 1, -1
        top += 2
    return used


@compiled(fastmath=())
def _bound(boxes: NDArray[np.float32], order: Order, first: int, end: int, corner: Box) -> None:
    for axis in range(3):
        low, high = boxes[order[first], 0, axis], boxes[order[first], 1, axis]
        for k in range(first + 1, end):
            low = min(low, boxes[order[k], 0, axis])
            high = max(high, boxes[order[k], 1, axis])
        corner[0, axis], corner[1, axis] = low, high


@compiled(fastmath=())
def _half_area(box: Box) -> float:
    x, y, z = box[1, 0] - box[0, 0], box[1, 1] - box[0, 1], box[1, 2] - box[0, 2]
    area: float = x * y + y * z + z * x
    return area


@compiled(fastmath=())
def _grow(box: Box, other: Box) -> None:
    for axis in range(3):
        box[0, axis] = min(box[0, axis], other[0, axis])
        box[1, axis] = max(box[1, axis], other[1, axis])


@compiled(fastmath=())
def _span(centres: Centres, order: Order, first: int, end: int, axis: int) -> tuple[float, float]:
    low = high = np.float64(centres[order[first], axis])
    for k in range(first + 1, end):
        low = min(low, np.float64(centres[order[k], axis]))
        high = max(high, np.float64(centres[order[k], axis]))
    return low, high


@compiled(fastmath=())
def _bin(value: float, low: float, high: float) -> int:
    return min(int((value - low) / (high - low) * BINS), BINS - 1)


@compiled(fastmath=())
def _empty() -> Box:
    box = np.empty((2, 3))
    box[0], box[1] = np.inf, -np.inf
    return box


@compiled(fastmath=())
def _best_cut(
    boxes: NDArray[np.float32],
    centres: Centres,
    order: Order,
    first: int,
    end: int,
    axis: int,
    low: float,
    high: float,
) -> tuple[float, int]:
    """The cheapest cut between bins along an axis: its cost and the first bin behind it."""
    counts, bins = np.zeros(BINS, np.int64), np.empty((BINS, 2, 3))
    bins[:, 0], bins[:, 1] = np.inf, -np.inf
    for k in range(first, end):
        b = _bin(np.float64(centres[order[k], axis]), low, high)
        counts[b] += 1
        _grow(bins[b], boxes[order[k]])
    right_cost = np.full(BINS + 1, np.inf)
    box, count = _empty(), 0
    for b in range(BINS - 1, 0, -1):
        _grow(box, bins[b])
        count += counts[b]
        right_cost[b] = _half_area(box) * count if count else np.inf
    box, count = _empty(), 0
    best, cut = np.inf, 0
    for b in range(1, BINS):
        _grow(box, bins[b - 1])
        count += counts[b - 1]
        cost = _half_area(box) * count + right_cost[b] if count else np.inf
        if cost < best:
            best, cut = cost, b
    return best, cut


@compiled(fastmath=())
def _split(boxes: NDArray[np.float32], centres: Centres, order: Order, first: int, end: int) -> int:
    """Sorts the set by the best cut of all axes; the first of the right half, `first` for none."""
    best, best_axis, best_cut = np.inf, -1, 0
    for axis in range(3):
        low, high = _span(centres, order, first, end, axis)
        if high > low:
            cost, cut = _best_cut(boxes, centres, order, first, end, axis, low, high)
            if cost < best:
                best, best_axis, best_cut = cost, axis, cut
    if best_axis < 0:
        return first
    low, high = _span(centres, order, first, end, best_axis)
    left, right = first, end - 1
    while left <= right:
        if _bin(np.float64(centres[order[left], best_axis]), low, high) < best_cut:
            left += 1
        else:
            order[left], order[right] = order[right], order[left]
            right -= 1
    return left


@compiled(fastmath=())
def _halve(centres: Centres, order: Order, first: int, end: int) -> int:
    """Halves the set at the median of its widest axis."""
    widest, axis = -1.0, 0
    for k in range(3):
        low, high = _span(centres, order, first, end, k)
        if high - low > widest:
            widest, axis = high - low, k
    keys = np.empty(end - first, np.float64)
    for k in range(first, end):
        keys[k - first] = centres[order[k], axis]
    ranks = np.argsort(keys)
    order[first:end] = order[first:end][ranks]
    return (first + end) // 2
