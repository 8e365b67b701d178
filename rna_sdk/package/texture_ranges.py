"""Ranges of a mesh's triangles that have a texture, and whether they fit the mesh."""

from __future__ import annotations

from collections.abc import Sequence

from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.mesh import Mesh


def check_last_range(ranges: Sequence[tuple[int, int]], mesh: Mesh, code: Code, where: str) -> None:
    """Whether ranges (first, count) that ascend end within the mesh.

    where: JSON pointer of the records.

    Raises:
        PackageError: `code`.
    """
    if ranges and sum(ranges[-1]) > len(mesh.triangles):
        found, expected = f"an end at {sum(ranges[-1])}", f"at most {len(mesh.triangles)} triangles"
        refuse(code, f"{where}/{len(ranges) - 1}/triangles", found, expected)
