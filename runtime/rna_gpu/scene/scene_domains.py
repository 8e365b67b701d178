"""The directions that assets were trained for, as wgsl/render/domains.wgsl has them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

_SPHERE, _HEMISPHERE = 0xFFFFFFFF, 0xFFFFFFFE
_ROUNDING = 1e-6  # as of rna_sdk.runtime.in_region


def domain_rows(domains: Sequence[Any]) -> NDArray[np.float32]:
    """(n, 4) float32: a row a part, whose words are numbers and places of cones; then the cones.

    domains: `Asset.domain` of the parts' assets.
    """
    cones: list[list[float]] = []
    heads = np.zeros((len(domains), 4), np.uint32)
    for head, domain in zip(heads, domains, strict=True):
        for column, region in ((0, domain.wo), (2, domain.wi)):
            head[column : column + 2] = _words(region, cones, len(domains))
    rows = [heads.view(np.float32), np.array(cones, np.float32).reshape(-1, 4)]
    return np.concatenate([*rows, np.zeros((1, 4), np.float32)])


def _words(region: Any, cones: list[list[float]], heads: int) -> tuple[int, int]:
    if region == "sphere":
        return _SPHERE, 0
    if region == "hemisphere":
        return _HEMISPHERE, 0
    first = heads + len(cones)
    for cone in region:
        cones.append(_cone(cone))
    return len(region), first


def _cone(cone: Any) -> list[float]:
    axis = np.asarray(cone.axis, np.float64)
    return [*(axis / np.linalg.norm(axis)), float(np.cos(cone.half_angle)) - _ROUNDING]
