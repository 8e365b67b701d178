"""RNA_source: which vertex of its source each vertex of a mesh came from."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.container.tensor_file import TensorForm, tensors_from_bytes, tensors_to_bytes
from rna_sdk.package.geometry.curves_file import GEOMETRY_CODES
from rna_sdk.package.issues import Code, refuse

_NAME = "vertices"


@dataclass(frozen=True, slots=True, eq=False)
class SourceVertices:
    """Where a part's vertices are in the source that it was made from.

    numbers: (v,) uint32, of each vertex of the mesh. count: vertices that the source has, more than
    every number.

    Examples:
        >>> corners_of_a_box = np.arange(24, dtype=np.uint32) // 3
        >>> SourceVertices(corners_of_a_box, count=8).numbers[3:6].tolist()
        [1, 1, 1]
    """

    numbers: NDArray[np.uint32]
    count: int

    def to_bytes(self) -> bytes:
        """The safetensors file of the numbers."""
        return tensors_to_bytes({_NAME: self.numbers})


def source_vertices_from_bytes(
    data: memoryview, name: str, vertices: int, count: int
) -> SourceVertices:
    """The numbers in an entry, for a mesh of so many vertices and a source of `count`.

    name: of the entry, for issues.

    Raises:
        PackageError: with the first GEOMETRY_* or JSON_* issue found.
    """
    form = {_NAME: TensorForm("uint32", (vertices,))}
    numbers = tensors_from_bytes(data, name, form, GEOMETRY_CODES)[_NAME]
    largest = int(numbers.max(initial=0))
    if largest >= count:
        refuse(Code.GEOMETRY_INDEX, name, f"vertex {largest}", f"less than {count}")
    return SourceVertices(numbers, count)
