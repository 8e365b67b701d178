"""A part's geometry as file arrays: quantised integers or float32."""

from typing import Any

import numpy as np

from rna_sdk.package import Curves, Mesh, SourceVertices
from rna_sdk.package.geometry.quantised_curves import QuantisedCurves
from rna_sdk.package.geometry.quantised_mesh import QuantisedMesh

_NUMBERS, _COUNT = "source.numbers", "source.count"
_POSITIONS, _NORMALS = "exact.positions", "exact.normals"
_BESIDE = (_NUMBERS, _COUNT, _POSITIONS, _NORMALS)


def geometry_arrays(
    geometry: Mesh | Curves, source: SourceVertices | None = None, exact: Mesh | None = None
) -> dict[str, np.ndarray]:
    """Arrays of the geometry by name; quantised ones restore it and its package entry exactly.

    source, exact: see `Dataset.create`.
    """
    stored = geometry if geometry.quantised is None else geometry.quantised
    arrays = {k: v for k, v in vars(stored).items() if isinstance(v, np.ndarray)}
    if source is not None:
        arrays |= {_NUMBERS: source.numbers, _COUNT: np.array([source.count], np.uint32)}
    if exact is not None:
        arrays |= {_POSITIONS: exact.positions, _NORMALS: exact.normals}
    return arrays


def exact_from_arrays(arrays: dict[str, Any]) -> Mesh | None:
    """The mesh before it was quantised, which rays of a capture meet; None for none."""
    if _POSITIONS not in arrays:
        return None
    stored = geometry_from_arrays(arrays, "surface")
    assert isinstance(stored, Mesh)
    return Mesh(arrays[_POSITIONS], arrays[_NORMALS], stored.uvs, stored.triangles)


def source_from_arrays(arrays: dict[str, Any]) -> SourceVertices | None:
    """The source's vertices that were stored with a geometry; None for none."""
    if _NUMBERS not in arrays:
        return None
    return SourceVertices(arrays[_NUMBERS], int(arrays[_COUNT][0]))


def geometry_from_arrays(arrays: dict[str, Any], kind: str) -> Mesh | Curves:
    """The inverse. Raises TypeError for other arrays, PackageError for impossible ones."""
    arrays = {k: v for k, v in arrays.items() if k not in _BESIDE}
    if kind == "fiber":
        return QuantisedCurves(**arrays).restored() if "steps" in arrays else Curves(**arrays)
    arrays = {"uvs": None, **arrays}
    return QuantisedMesh(**arrays).restored() if "scale" in arrays else Mesh(**arrays)
