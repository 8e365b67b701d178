"""The curves of a fiber asset, as a safetensors file: write them, read them from hostile bytes."""

from __future__ import annotations

import numpy as np

from rna_sdk.package.curves import Curves
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import MAX_CURVE_POINTS, MAX_STRANDS
from rna_sdk.package.tensor_file import (
    TensorCodes,
    TensorForm,
    tensors_from_bytes,
    tensors_to_bytes,
)

_POINTS = range(2, MAX_CURVE_POINTS + 1)
_FORMS = {
    "points": TensorForm("float32", (_POINTS, 3)),
    "radii": TensorForm("float32", (_POINTS,)),
    "offsets": TensorForm("uint32", (range(2, MAX_STRANDS + 2),)),
}
_CODES = TensorCodes(
    header=Code.GEOMETRY_CONTAINER,
    tensors=Code.GEOMETRY_PROFILE,
    dtype=Code.GEOMETRY_PROFILE,
    shape=Code.GEOMETRY_PROFILE,
    offsets=Code.GEOMETRY_RANGE,
    alignment=Code.GEOMETRY_PROFILE,
)


def curves_to_bytes(curves: Curves) -> bytes:
    """The safetensors file. The same arrays give the same bytes; values are not looked at."""
    return tensors_to_bytes({name: getattr(curves, name) for name in _FORMS})


def curves_from_bytes(data: memoryview, name: str) -> Curves:
    """The curves in the entry `data`; their arrays are read-only views of `data`.

    Args:
        data: the bytes of the entry.
        name: the entry's name, for issues.

    Raises:
        PackageError: with the first GEOMETRY_* or JSON_* issue found.
    """
    curves = Curves(**tensors_from_bytes(data, name, _FORMS, _CODES))
    for attribute, array in (("points", curves.points), ("radii", curves.radii)):
        if not np.isfinite(array).all():
            refuse(Code.GEOMETRY_NOT_FINITE, name, attribute, "finite values")
    thinnest = int(np.argmin(curves.radii))
    if curves.radii[thinnest] <= 0:
        found = f"{curves.radii[thinnest]:.6g} at point {thinnest}"
        refuse(Code.GEOMETRY_RADIUS, name, found, "greater than 0")
    return curves
