"""Texture coordinates that a package stores for a material, so that one repeated texture fits.

A package's textures cover the unit square and repeat. A chart maps the UV coordinates that a
material's nodes read to coordinates in which that is so: those of a repeated image, two of a
mirrored one, or the box of all that the mesh uses.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from rna_materials.uv_dependence import IDENTITY, Dependence

_PROCEDURAL = 1024  # texels a side where no image says how fine the pattern is
SMALLEST, LARGEST = 4, 4096  # Blender renders no fewer than 4 pixels a side


@dataclass
class Chart:
    """layer: the UV map, "" for the one that renders use by default.

    matrix: (2, 3), from its (u, v, 1) to (s, t); the texture covers [0, 1] x [0, 1], t upwards.
    tiles: of UDIM, by which triangles are told apart (see `udim_tiles.numbers_of`).
    """

    layer: str
    matrix: np.ndarray
    tiles: dict[str, Any] | None = None

    @classmethod
    def of(cls, record: dict[str, Any]) -> "Chart":
        """The inverse of `record`."""
        return cls(record["layer"], np.array(record["matrix"]), record.get("tiles"))

    def record(self) -> dict[str, Any]:
        """As JSON holds it."""
        tiles = {} if self.tiles is None else {"tiles": self.tiles}
        return {"layer": self.layer, "matrix": self.matrix.tolist(), **tiles}

    def stored(self, uvs: np.ndarray) -> np.ndarray:
        """Texture coordinates of a package for (n, 2) UVs: glTF counts v from the top."""
        result = uvs.copy()
        if not np.array_equal(self.matrix, IDENTITY):
            result = (uvs @ self.matrix[:, :2].T + self.matrix[:, 2]).astype(np.float32)
        result[:, 1] = 1.0 - result[:, 1]
        return result

    def uvs(self, st: np.ndarray) -> np.ndarray:
        """The (n, 2) UVs of points (n, 2) of the texture's square."""
        return np.asarray((st - self.matrix[:, 2]) @ np.linalg.inv(self.matrix[:, :2]).T)

    @property
    def is_upright(self) -> bool:
        """Whether s grows with u alone, and t with v: tangents stay as they are."""
        across = np.abs(self.matrix[[0, 1], [1, 0]]).max()
        along = self.matrix[[0, 1], [0, 1]]
        return bool(along.min() > 0.0 and across < 1e-6 * along.max())

    def size(self, depends: Dependence, finer: int = 1, largest: int = LARGEST) -> tuple[int, int]:
        """(width, height) of a texture as fine as the images; `finer`: times as many texels."""
        inverse = np.linalg.inv(self.matrix[:, :2])
        sides = np.full(2, _PROCEDURAL if depends.patterns else SMALLEST, np.float64)
        if depends.images:
            # Of each image, the texels that are passed along s, and along t.
            passed = [
                np.linalg.norm((image.mapping[:, :2] @ inverse).T * image.size, axis=1)
                for image in depends.images
            ]
            sides = np.max(passed, axis=0)
        sides = np.ceil(np.round(finer * sides, 3))
        width, height = np.clip(sides, SMALLEST, largest).astype(int).tolist()
        return width, height


def charts(depends: Dependence, layer: str, uvs: np.ndarray) -> Iterator[Chart]:
    """Charts to try, the likeliest first. uvs: (n, 2), all that are used."""
    maps = [
        image.mapping
        for image in depends.images
        if abs(np.linalg.det(image.mapping[:, :2])) > 1e-12
    ]
    maps = _distinct(maps or [IDENTITY])
    extensions = {image.extension for image in depends.images}
    result: list[np.ndarray] = []
    if extensions <= {"REPEAT"}:
        result += maps
    if extensions == {"MIRROR"}:
        result += [0.5 * matrix for matrix in maps]
    result += [_boxed(matrix, depends, uvs) for matrix in maps[:1]]
    result += [IDENTITY, 0.5 * IDENTITY]
    for matrix in _distinct(result):
        yield Chart(layer, matrix)


def _distinct(maps: list[np.ndarray]) -> list[np.ndarray]:
    distinct: list[np.ndarray] = []
    for matrix in maps:
        if not any(np.allclose(matrix, other, atol=1e-7) for other in distinct):
            distinct.append(matrix)
    return distinct


def _boxed(matrix: np.ndarray, depends: Dependence, uvs: np.ndarray) -> np.ndarray:
    """The map whose unit square is all that is used, and a texel around it, on whole texels."""
    size = np.full(2, _PROCEDURAL)
    for image in depends.images:
        if np.allclose(image.mapping, matrix, atol=1e-7):
            size = np.array(image.size)
            break
    used = uvs @ matrix[:, :2].T + matrix[:, 2]
    low = (np.floor(used.min(axis=0) * size + 1e-4) - 1.0) / size
    high = (np.ceil(used.max(axis=0) * size - 1e-4) + 1.0) / size
    result = np.array(matrix, np.float64)
    result[:, 2] -= low
    return np.asarray(result / (high - low)[:, None])
