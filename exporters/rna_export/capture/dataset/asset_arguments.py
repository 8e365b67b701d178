"""Captured samples as the positional arguments of the runtime's `evaluate` and `emission`."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np


class SurfaceArguments(NamedTuple):
    """Arguments of `SurfaceAsset.evaluate`: (n, 3) float32 each, object space.

    base_color: None of a part without.
    """

    position: np.ndarray
    normal: np.ndarray
    wo: np.ndarray
    wi: np.ndarray
    base_color: np.ndarray | None = None


class FiberArguments(NamedTuple):
    """Arguments of `FiberAsset.evaluate`: h (n,), the others (n, 3), float32, object space."""

    position: np.ndarray
    tangent: np.ndarray
    h: np.ndarray
    wo: np.ndarray
    wi: np.ndarray


class SurfaceEmissionArguments(NamedTuple):
    """Arguments of `SurfaceAsset.emission`."""

    position: np.ndarray
    normal: np.ndarray
    wo: np.ndarray


class FiberEmissionArguments(NamedTuple):
    """Arguments of `FiberAsset.emission`."""

    position: np.ndarray
    tangent: np.ndarray
    h: np.ndarray
    wo: np.ndarray


Arguments = SurfaceArguments | FiberArguments


def evaluate_arguments(fields: Mapping[str, np.ndarray]) -> Arguments:
    """Arguments of `evaluate` from a part's samples by name; other fields are ignored."""
    form = FiberArguments if "tangent" in fields else SurfaceArguments
    return form(**{name: fields[name] for name in form._fields if name in fields})


def rows_of(arguments: Arguments, rows: np.ndarray) -> Arguments:
    """These rows of each."""
    given = {name: v for name, v in arguments._asdict().items() if v is not None}
    return evaluate_arguments({name: v[rows] for name, v in given.items()})


def emission_arguments(
    fields: Mapping[str, np.ndarray],
) -> SurfaceEmissionArguments | FiberEmissionArguments:
    """Arguments of `emission`, from samples without a light direction."""
    form = FiberEmissionArguments if "tangent" in fields else SurfaceEmissionArguments
    return form(**{name: fields[name] for name in form._fields})
