"""The image of a base colour: the bytes of its file, or texels that Cycles shows.

Values in sRGB are interpolated, as Cycles does with images of 8 bits, and then made linear.
"""

from pathlib import Path

import bpy
import numpy as np
from rna_materials.texture_fit import Texture, best_fit, looked_up
from rna_materials.udim_tiles import path_of, size_of
from rna_materials.uv_charts import SMALLEST, Chart, charts
from rna_materials.uv_points import NotOfUv, UvPoints
from rna_materials.uv_render import ColourOfUv

LARGEST = 8192  # pixels a side that a package holds
_WRONG = 0.03  # mean error of a baked colour, linear
_CLOSEST = 4  # times the texels, where they are not interpolated
_FORMATS = (b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff", b"RIFF")
_SPACES = {"sRGB": "srgb", "Non-Color": "linear", "Linear Rec.709": "linear", "Raw": "linear"}
_WRAPS = {"REPEAT": "repeat", "EXTEND": "clamp", "CLIP": "clamp", "MIRROR": "mirror"}
_FLIP = np.array([(1.0, 0.0, 0.0), (0.0, -1.0, 1.0), (0.0, 0.0, 1.0)])  # of v, and back


def wrap_of(node: bpy.types.Node) -> str:
    """The extension of an image node beyond the image's edges, in a package's words."""
    return _WRAPS[node.extension]


def file_of(node: bpy.types.Node, tile: int = 0) -> tuple[bytes, str] | None:
    """The bytes of an image node's file and its colour space; None where they are not its colours.

    tile: the number of one of UDIM; 0 without tiles. A package reads 8 bits a channel, without
    alpha, interpolated.
    """
    image = node.image
    space = _SPACES.get(image.colorspace_settings.name)
    is_file = image.source in ("FILE", "TILED")
    is_plain = is_file and not image.is_float and not image.is_dirty
    is_read = is_plain and max(size_of(image, tile)) <= LARGEST and image.depth <= 32
    if space is None or not is_read or node.interpolation == "Closest":
        return None
    data = _bytes(image, tile)
    return (data, space) if data.startswith(_FORMATS) else None


def _bytes(image: bpy.types.Image, tile: int) -> bytes:
    """Bytes of the file of an image or a tile; b"" without a file."""
    packed = [each for each in image.packed_files if tile in (0, each.tile_number)]
    if packed:
        return bytes(packed[0].packed_file.data)
    path = path_of(image.filepath, tile) if tile else image.filepath
    file = Path(bpy.path.abspath(path, library=image.library))
    return file.read_bytes() if file.is_file() else b""


def texels_of(
    node: bpy.types.Node,
    tile: int,
    colour: ColourOfUv,
    layer: str,
    mapping: np.ndarray,
    uvs: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """(h, w, 3) uint8 sRGB, as Cycles shows an image node; and the map from UVs to the texels.

    mapping: (2, 3), from UVs to the image's coordinates. uvs: (n, 2), that are used. An image that
    ends at its edges gets a border where some of them lie beyond it. tile: see `file_of`.
    """
    finer = _CLOSEST if node.interpolation == "Closest" else 1
    width, height = (min(max(SMALLEST, finer * n), LARGEST) for n in size_of(node.image, tile))
    if is_cut_off(node, mapping, uvs):
        border = np.array([1.0 / width, 1.0 / height])
        grown = 1.0 + 2.0 * border
        mapping = mapping + np.column_stack([np.zeros((2, 2)), border])
        mapping = mapping / grown[:, None]
        width, height = min(width + 2, LARGEST), min(height + 2, LARGEST)
    shown = colour.texture(Chart(layer, mapping), (width, height))
    return texels_in_srgb(shown), mapping


def baked(colour: ColourOfUv, points: UvPoints, largest: int) -> tuple[np.ndarray, Chart]:
    """(h, w, 3) uint8 sRGB, repeated, over a chart that fits the nodes. Raises NotOfUv.

    largest: texels a side, at most.
    """
    tried = charts(colour.depends, points.layer, points.used)
    truth = np.clip(colour.values(points.uvs), 0.0, 1.0)

    def make(chart: Chart, size: tuple[int, int]) -> Texture:
        return texels_in_srgb(colour.texture(chart, size)), None

    def error(chart: Chart, made: Texture) -> float:
        shown = _linear(looked_up(made[0], chart, points.uvs) / 255.0)
        return float(np.abs(shown - truth).mean())

    fit = best_fit(colour, tried, make, error, largest)
    if fit is None or fit.error > _WRONG:
        raise NotOfUv("nodes whose values do not repeat")
    return fit.texture, fit.chart


def is_cut_off(node: bpy.types.Node, mapping: np.ndarray, uvs: np.ndarray) -> bool:
    """Whether some of the UVs (n, 2) lie beyond an image that ends at its edges."""
    places = uvs @ mapping[:, :2].T + mapping[:, 2]
    is_beyond = places.min() < -1e-4 or places.max() > 1.0 + 1e-4
    return bool(node.extension == "CLIP" and is_beyond)


def transform_of(mapping: np.ndarray, chart: Chart) -> list[float]:
    """A record's transform: from the chart's stored coordinates to the image's.

    mapping: (2, 3), from UVs to the image's coordinates, which both count v from the bottom.
    """
    image, stored = (np.vstack([m, (0.0, 0.0, 1.0)]) for m in (mapping, chart.matrix))
    matrix = _FLIP @ image @ np.linalg.inv(stored) @ _FLIP
    values: list[float] = np.round(matrix[:2], 12).ravel().tolist()
    return values


def texels_in_srgb(linear: np.ndarray) -> np.ndarray:
    """uint8 of linear colours, which are cut off at 1."""
    return np.round(255.0 * _srgb(np.clip(linear, 0.0, 1.0))).astype(np.uint8)


def _linear(value: np.ndarray) -> np.ndarray:
    """The inverse of `_srgb`."""
    power = ((np.maximum(value, 0.04045) + 0.055) / 1.055) ** 2.4
    return np.where(value <= 0.04045, value / 12.92, power)


def _srgb(linear: np.ndarray) -> np.ndarray:
    """IEC 61966-2-1."""
    power = 1.055 * np.maximum(linear, 0.0031308) ** (1.0 / 2.4) - 0.055
    return np.where(linear <= 0.0031308, 12.92 * linear, power)
