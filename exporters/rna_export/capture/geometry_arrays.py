"""The geometry of a part as named arrays: float32, or the integers of a quantised one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from rna_sdk.package import Curves, Mesh
from rna_sdk.package.quantised_curves import QuantisedCurves
from rna_sdk.package.quantised_mesh import QuantisedMesh


def geometry_arrays(geometry: Mesh | Curves) -> dict[str, np.ndarray]:
    """What `geometry_of` makes the very same geometry of."""
    holder: Any = geometry if geometry.quantised is None else geometry.quantised
    return {name: array for name, array in vars(holder).items() if array is not None}


def geometry_of(arrays: Mapping[str, np.ndarray], kind: str) -> Mesh | Curves:
    """The inverse. Raises TypeError for other arrays, PackageError for wrong ones."""
    if kind == "fiber":
        return QuantisedCurves(**arrays).restored() if "steps" in arrays else Curves(**arrays)
    whole: dict[str, Any] = {"uvs": None, **arrays}
    return QuantisedMesh(**whole).restored() if "scale" in arrays else Mesh(**whole)
