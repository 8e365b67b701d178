"""The curves of a fiber asset, as a safetensors file: write them, read them from hostile bytes."""

import numpy as np

from rna_sdk.package.container.tensor_file import (
    TensorCodes,
    TensorForm,
    tensor_names,
    tensors_from_bytes,
    tensors_to_bytes,
)
from rna_sdk.package.geometry.curves import Curves
from rna_sdk.package.geometry.quantised_curves import QuantisedCurves
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import MAX_CURVE_POINTS, MAX_STRANDS

_POINTS = range(2, MAX_CURVE_POINTS + 1)
_FORMS = {
    "points": TensorForm("float32", (_POINTS, 3)),
    "radii": TensorForm("float32", (_POINTS,)),
    "offsets": TensorForm("uint32", (range(2, MAX_STRANDS + 2),)),
}
_QUANTISED_FORMS = {
    "scales": TensorForm("float32", (2,)),
    "origins": TensorForm("float32", (range(1, MAX_STRANDS + 1), 3)),
    "offsets": _FORMS["offsets"],
    "steps": TensorForm(("int16", "int32"), (range(1, MAX_CURVE_POINTS), 3)),
    "radii": TensorForm(("uint8", "uint16"), (_POINTS,)),
}
GEOMETRY_CODES = TensorCodes(
    header=Code.GEOMETRY_CONTAINER,
    tensors=Code.GEOMETRY_PROFILE,
    dtype=Code.GEOMETRY_PROFILE,
    shape=Code.GEOMETRY_PROFILE,
    offsets=Code.GEOMETRY_RANGE,
    alignment=Code.GEOMETRY_PROFILE,
)


def curves_to_bytes(curves: Curves) -> bytes:
    """The safetensors file. The same arrays give the same bytes; values are not looked at."""
    stored = curves.quantised
    if stored is not None:
        return tensors_to_bytes({name: getattr(stored, name) for name in _QUANTISED_FORMS})
    return tensors_to_bytes({name: getattr(curves, name) for name in _FORMS})


def curves_from_bytes(data: memoryview, name: str) -> Curves:
    """The curves in the entry `data`.

    Their arrays are read-only views of `data`; those of quantised curves are restored.

    Args:
        data: the bytes of the entry.
        name: the entry's name, for issues.

    Raises:
        PackageError: with the first GEOMETRY_* or JSON_* issue found.
    """
    if "steps" in tensor_names(data, name, GEOMETRY_CODES):
        tensors = tensors_from_bytes(data, name, _QUANTISED_FORMS, GEOMETRY_CODES)
        curves = QuantisedCurves(**tensors).restored()
    else:
        curves = Curves(**tensors_from_bytes(data, name, _FORMS, GEOMETRY_CODES))
    check_curves(curves, name)
    return curves


def check_curves(curves: Curves, name: str) -> None:
    """Raises PackageError for values that the curves of a package have not.

    GEOMETRY_NOT_FINITE, GEOMETRY_RADIUS; name: of their file, for the issue.
    """
    for attribute, array in (("points", curves.points), ("radii", curves.radii)):
        if not np.isfinite(array).all():
            refuse(Code.GEOMETRY_NOT_FINITE, name, attribute, "finite values")
    thinnest = int(np.argmin(curves.radii))
    if curves.radii[thinnest] <= 0:
        found = f"{curves.radii[thinnest]:.6g} at point {thinnest}"
        refuse(Code.GEOMETRY_RADIUS, name, found, "greater than 0")
