"""A part's geometry as file arrays: quantised integers or float32."""

from __future__ import annotations

from typing import Any

import numpy as np

from rna_sdk.package import Curves, Mesh
from rna_sdk.package.geometry.quantised_curves import QuantisedCurves
from rna_sdk.package.geometry.quantised_mesh import QuantisedMesh


def geometry_arrays(geometry: Mesh | Curves) -> dict[str, np.ndarray]:
    """Arrays of the geometry by name; quantised ones restore it and its package entry exactly."""
    stored = geometry if geometry.quantised is None else geometry.quantised
    return {k: v for k, v in vars(stored).items() if isinstance(v, np.ndarray)}


def geometry_from_arrays(arrays: dict[str, Any], kind: str) -> Mesh | Curves:
    """The inverse. Raises TypeError for other arrays, PackageError for impossible ones."""
    if kind == "fiber":
        return QuantisedCurves(**arrays).restored() if "steps" in arrays else Curves(**arrays)
    arrays = {"uvs": None, **arrays}
    return QuantisedMesh(**arrays).restored() if "scale" in arrays else Mesh(**arrays)
