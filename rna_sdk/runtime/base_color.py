"""Base colour of a part's surface, ready to be looked up at ray hits."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.arrays import indices, scalars
from rna_sdk.errors import QueryError
from rna_sdk.files.srgb import decode_srgb
from rna_sdk.package import BaseColor, Mesh
from rna_sdk.package.textures.texture_form import Texture
from rna_sdk.runtime.kernels.base_color_kernel import CLAMP, LEVELS, MIRROR, REPEAT, look_up

Rows = NDArray[np.float32]

_WRAPS = {"repeat": REPEAT, "clamp": CLAMP, "mirror": MIRROR}


class BaseColorMaps:
    """The base colour of a mesh; of one without records it is white."""

    def __init__(self, mesh: Mesh, records: Sequence[BaseColor]) -> None:
        self._mesh = mesh
        number = np.full(len(mesh.triangles), -1, np.int32)
        density = np.zeros(len(mesh.triangles), np.float32)
        for k, record in enumerate(records):
            of_record = slice(record.first, record.first + record.count)
            number[of_record] = k
            if record.image is not None:
                density[of_record] = _texel_density(mesh, record, of_record)
        uvs = np.zeros((len(mesh.positions), 2), np.float32) if mesh.uvs is None else mesh.uvs
        pyramids = [base_color_levels(one) if one.image is not None else [] for one in records]
        levels = np.zeros((max(len(records), 1), LEVELS, 3), np.int64)
        texels: list[Texture] = [np.zeros((1, 3), np.uint8)]
        first = 1
        for k, pyramid in enumerate(pyramids):
            for j, level in enumerate(pyramid):
                levels[k, j] = first, *level.shape[:2]
                texels.append(level.reshape(-1, 3))
                first += level.shape[0] * level.shape[1]
        self._density = density
        self._tables: tuple[Any, ...] = (
            *(np.ascontiguousarray(uvs, np.float32), mesh.triangles, number),
            np.array(
                [k if one.image is not None else -1 for k, one in enumerate(records)], np.int64
            ),
            np.array([one.factor for one in records], np.float32).reshape(-1, 3),
            np.array([[_WRAPS[w] for w in one.wrap] for one in records], np.int64).reshape(-1, 2),
            np.array([one.transform for one in records], np.float64).reshape(-1, 6),
            np.array([len(pyramid) for pyramid in pyramids], np.int64),
            levels,
            np.array([one.color_space == "srgb" for one in records], np.bool_),
            np.concatenate(texels),
        )

    def at(
        self, primitives: NDArray[np.integer], u: Rows, v: Rows, widths: Rows | float = 0.0
    ) -> Rows:
        """See `SurfaceAsset.base_color_at`."""
        return self._looked_up(primitives, u, v, widths, self._density)

    def at_levels(self, primitives: NDArray[np.integer], u: Rows, v: Rows, levels: Rows) -> Rows:
        """The like of `at` in these levels of the images, (n,) float32, 0 or more."""
        widths = np.exp2(np.minimum(levels, LEVELS))
        return self._looked_up(primitives, u, v, widths, np.ones_like(self._density))

    def _looked_up(
        self, primitives: NDArray[np.integer], u: Rows, v: Rows, widths: Rows | float, density: Rows
    ) -> Rows:
        number = indices("primitives", primitives, len(self._mesh.triangles))
        count = len(number)
        if not isinstance(widths, np.ndarray):
            widths = np.full(count, widths, np.float32)
        result = np.empty((count, 3), np.float32)
        look_up(
            number,
            scalars("u", u, count),
            scalars("v", v, count),
            scalars("widths", widths, count),
            density,
            result,
            *self._tables,
        )
        return result


def linear_of(color_space: str) -> Rows:
    """(256,): the linear value of each value of 8 bits."""
    value = np.arange(256, dtype=np.float32) / np.float32(255.0)
    if color_space == "srgb":
        return decode_srgb(value.astype(np.float64)).astype(np.float32)
    return value


def _texel_density(mesh: Mesh, record: BaseColor, of_record: slice) -> Rows:
    """Texels of the record's image a unit of length, on each of its triangles; 0 without area."""
    assert mesh.uvs is not None and record.image is not None
    corners = mesh.triangles[of_record]
    p = mesh.positions[corners].astype(np.float64)
    area = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1)
    uv = mesh.uvs[corners].astype(np.float64)
    a, b, _, c, d, _ = record.transform
    e1, e2 = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    of_uv = np.abs(e1[:, 0] * e2[:, 1] - e1[:, 1] * e2[:, 0]) * abs(a * d - b * c)
    of_texels = of_uv * record.image.shape[0] * record.image.shape[1]
    known = area > 0.0
    squared = np.divide(of_texels, area, out=np.zeros_like(area), where=known)
    density: Rows = np.sqrt(squared).astype(np.float32)
    return density


def base_color_levels(record: BaseColor) -> list[Texture]:
    """The image of a record and its smaller levels, for hosts that look it up themselves.

    Returns (H, W, 3) uint8 arrays in the colour space of the image, each half as high and wide as
    the one before, down to (1, 1, 3): spec/RNA.md, 4.6.

    Raises:
        QueryError: the record has no image, only a factor.

    Examples:
        >>> records = load("toy.rna").base_colors
        >>> [base_color_levels(record) for record in records if record.image is not None]
        []
    """
    if record.image is None:
        raise QueryError("base colour: the record has no image")
    linear = linear_of(record.color_space)
    edges = (linear[1:] + linear[:-1]) / 2.0  # between the values that 8 bits have
    levels = [record.image]
    exact = linear[record.image]
    while max(exact.shape[:2]) > 1:
        for axis in (0, 1):
            exact = _halved(exact, axis)
        levels.append(np.searchsorted(edges, exact).astype(np.uint8))
    return levels


def _halved(values: Rows, axis: int) -> Rows:
    """Means over equal intervals of max(1, floor(n / 2)) texels along an axis of n."""
    values = np.moveaxis(values, axis, 0)
    size = len(values)
    if size == 1:
        return np.moveaxis(values, 0, axis)
    half = size // 2
    if size % 2 == 0:
        result = 0.5 * (values[0::2] + values[1::2])
    else:  # an interval has two and a bit of texels: differences of the integral at its ends
        ends = np.arange(half + 1) * (size / half)
        integral = np.concatenate(
            [np.zeros_like(values[:1]), np.cumsum(values, axis=0, dtype=np.float64)]
        )
        whole = np.minimum(ends.astype(np.int64), size - 1)
        rest = (ends - whole).reshape(-1, *[1] * (values.ndim - 1))
        at_ends = integral[whole] + rest * values[whole]
        result = (np.diff(at_ends, axis=0) * (half / size)).astype(np.float32)
    return np.ascontiguousarray(np.moveaxis(result, 0, axis))
