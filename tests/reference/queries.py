"""Decoder inputs of the minimal host, written by hand in float64: the oracle of generated formulas.

Arguments: planes, (3, R, R, C); bounds, (2, 3), corners of the box; names of blocks; positions,
normals or tangents, wo and wi, (n, 3), finite, in object space; h, (n,). Results: (n, K) float32.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.conformance.conftest import host_module

_MINIMAL: Any = host_module("minimal")

Rows = NDArray[np.floating]


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
    """Queries of surfaces. of_lobes: wi is the mirror direction of wo; the half vector is n."""
    h = np.zeros(len(normals))
    blocks = _blocks(planes, bounds, positions, h, normals, wo, wi)
    if of_lobes:
        along = _blocks(planes, bounds, positions, h, normals, normals, normals)
        n, o, i = (_MINIMAL.unit(np.float64(v)) for v in (normals, wo, wi))
        cosines = [np.sum(n * v, axis=1, keepdims=True) for v in (i, o, i)]
        along["half_vector"] = np.hstack([along["half_vector"][:, :2], *cosines])
        blocks |= {name: along[name] for name in ("half_vector", "highlight", "learned_normal")}
    return np.hstack([blocks[name] for name in inputs]).astype(np.float32)


def fiber_queries_reference(
    planes: Rows, bounds: Rows, inputs: tuple[str, ...], at: Rows, t: Rows, h: Rows, *wo_wi: Rows
) -> NDArray[np.float32]:
    """Queries of fibers."""
    blocks = _blocks(planes, bounds, at, np.clip(np.float64(h), -1, 1), t, *wo_wi)
    return np.hstack([blocks[name] for name in inputs]).astype(np.float32)


@np.errstate(all="ignore")  # blocks of the other kind of part
def _blocks(planes: Rows, bounds: Rows, at: Rows, h: Rows, *directions: Rows) -> dict[str, Rows]:
    low, high = np.float64(bounds)
    p = np.clip((np.float64(at) - low) / (high - low), 0, 1)
    axis, wo, wi = (_MINIMAL.unit(np.float64(v)) for v in directions)
    blocks: dict[str, Rows] = _MINIMAL.input_blocks(np.float64(planes), p, h, axis, wo, wi)
    return blocks


def triplane_features(planes: Rows, p: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, C): bilinear samples of the XY, YZ and ZX planes at p, (n, 3) in [0, 1], summed."""
    features: NDArray[np.float64] = _MINIMAL.triplane(np.float64(planes), p)
    return features
