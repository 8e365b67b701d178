"""Decoder inputs of the minimal host, which is written by hand in float64: the oracle of all forms
that are generated from the formulas of the specification."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.conformance.conftest import host_module

_MINIMAL: Any = host_module("minimal")

Rows = NDArray[np.floating]

unit = _MINIMAL.unit


def queries_reference(
    planes: Rows,
    bounds: Rows,
    inputs: tuple[str, ...],
    positions: Rows,
    normals: Rows,
    wo: Rows,
    wi: Rows,
    of_lobes: bool = False,
) -> NDArray[np.float32]:
    """(n, K) float32: the blocks named in `inputs`, side by side, for points of a surface.

    planes: (3, R, R, C); bounds: (2, 3) lower and upper corner; positions, normals, wo, wi:
    (n, 3), finite, object space, directions of any length but zero. of_lobes: wi is the mirror
    direction of wo, and the half vector is n.
    """
    at, n, o, i = _place(bounds, positions), *(unit(np.float64(v)) for v in (normals, wo, wi))
    h = np.zeros(len(n))
    blocks = _blocks(planes, at, h, n, o, i)
    if of_lobes:
        along = _blocks(planes, at, h, n, n, n)
        cosines = [np.sum(n * v, axis=1, keepdims=True) for v in (i, o, i)]
        along["half_vector"] = np.hstack([along["half_vector"][:, :2], *cosines])
        blocks |= {name: along[name] for name in ("half_vector", "highlight", "learned_normal")}
    return np.hstack([blocks[name] for name in inputs]).astype(np.float32)


def fiber_queries_reference(
    planes: Rows,
    bounds: Rows,
    inputs: tuple[str, ...],
    positions: Rows,
    tangents: Rows,
    h: Rows,
    wo: Rows,
    wi: Rows,
) -> NDArray[np.float32]:
    """(n, K) float32: the blocks named in `inputs`, side by side, for points of fibers.

    h: (n,), finite; the others as in `queries_reference`.
    """
    at, t, o, i = _place(bounds, positions), *(unit(np.float64(v)) for v in (tangents, wo, wi))
    blocks = _blocks(planes, at, np.clip(np.float64(h), -1, 1), t, o, i)
    return np.hstack([blocks[name] for name in inputs]).astype(np.float32)


@np.errstate(all="ignore")  # blocks of the other kind of part
def _blocks(planes: Rows, *arguments: Rows) -> dict[str, NDArray[np.float64]]:
    blocks: dict[str, NDArray[np.float64]] = _MINIMAL.input_blocks(np.float64(planes), *arguments)
    return blocks


def triplane_features(planes: Rows, p: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, C): bilinear samples of the XY, YZ and ZX planes at p, (n, 3) in [0, 1], summed."""
    features: NDArray[np.float64] = _MINIMAL.triplane(np.float64(planes), p)
    return features


def _place(bounds: Rows, positions: Rows) -> NDArray[np.float64]:
    low, high = np.float64(bounds)
    return np.clip((np.float64(positions) - low) / (high - low), 0, 1)
