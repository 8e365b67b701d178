"""The visibility about the vertices of a geometry (RNA_environment), as a tensor file."""

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.container.tensor_file import (
    TensorCodes,
    TensorForm,
    tensors_from_bytes,
    tensors_to_bytes,
)
from rna_sdk.package.geometry.geometry_files import Geometry
from rna_sdk.package.geometry.mesh import Mesh
from rna_sdk.package.issues import Code
from rna_sdk.package.manifest.extensions import HARMONICS

STEPS = 127
"""Integer that stands for a coefficient of 1."""

_TENSOR = "harmonics"
_CODES = TensorCodes(*[Code.ENVIRONMENT_VISIBILITY] * 6)

Harmonics = NDArray[np.int8]
"""(vertices, HARMONICS) int8: STEPS times the coefficients."""


def quantised_harmonics(coefficients: NDArray[np.floating]) -> Harmonics:
    """As a package stores them; coefficients: (vertices, HARMONICS), from -1 to 1.

    Examples:
        >>> quantised_harmonics(np.float32([[1.0, -0.5]])).tolist()
        [[127, -64]]
    """
    steps = np.rint(STEPS * np.asarray(coefficients, np.float64))
    return np.clip(steps, -STEPS, STEPS).astype(np.int8)


def vertex_count(geometry: Geometry) -> int:
    """Vertices of a mesh, or points of curves: the rows of its visibility."""
    return len(geometry.positions if isinstance(geometry, Mesh) else geometry.points)


def visibility_to_bytes(harmonics: Harmonics) -> bytes:
    """The file of (vertices, HARMONICS) int8."""
    return tensors_to_bytes({_TENSOR: harmonics})


def visibility_from_bytes(data: memoryview, name: str, vertices: int) -> Harmonics:
    """The harmonics in the entry `name` of `data`, as a read-only view.

    vertices: of the mesh, or points of the curves.

    Raises:
        PackageError: ENVIRONMENT_VISIBILITY, or a JSON_* issue.
    """
    form = TensorForm("int8", (vertices, HARMONICS))
    harmonics: Harmonics = tensors_from_bytes(data, name, {_TENSOR: form}, _CODES)[_TENSOR]
    return harmonics
