"""Indices of triangles and segments are checked alike wherever hits are taken."""

from collections.abc import Callable

import numpy as np
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import Mesh
from rna_sdk.runtime import mapped_normals, transmittance
from rna_sdk.runtime.deformation import RestMesh

CORNERS = np.float32([[0, 0, 0], [1, 0, 0], [0, 0, -1]])
MESH = Mesh(CORNERS, np.tile(np.float32([0, 1, 0]), (3, 1)), None, np.uint32([[0, 1, 2]]))
DOWN = np.float32([[0, -1, 0]])

CALLS: dict[str, Callable[[np.ndarray, np.ndarray], object]] = {
    "rest points": lambda k, z: RestMesh(MESH).deformed(CORNERS).rest_points(k, z, z),
    "mapped normals": lambda k, z: mapped_normals(MESH, [], k, z, z),
    "transmittance": lambda k, z: transmittance(MESH, [], k, z, z, DOWN),
}


@pytest.mark.parametrize("name", CALLS)
@pytest.mark.parametrize(
    ("triangle", "message"),
    [
        (np.int64([2**32]), r"triangle: a number is outside \[0, 1\)"),
        (np.int32([-1]), r"triangle: a number is outside \[0, 1\)"),
        (np.float64([0.7]), r"triangle: expected an \(n,\) integer array, found \(1,\) float64"),
        (np.zeros((1, 1), np.int32), r"triangle: expected an \(n,\) integer .* found \(1, 1\)"),
        ([0], "triangle: expected an .* found list"),
    ],
)
def test_triangles_that_are_not_there(name, triangle, message):
    with pytest.raises(QueryError, match=message):
        CALLS[name](triangle, np.zeros(1, np.float32))
