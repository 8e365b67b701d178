"""Tiles of a UDIM image: which one a triangle lies in, their sizes and files."""

from typing import Any

import bpy
import numpy as np

_EDGE = 1e-4  # of a tile, by which a triangle that lies in it may pass its edges
_ACROSS = 10  # tiles in a row


def path_of(pattern: str, number: int) -> str:
    """The file of a tile: 1001, or u1_v1 as Mari names it."""
    v, u = divmod(number - 1001, _ACROSS)
    return pattern.replace("<UDIM>", str(number)).replace("<UVTILE>", f"u{u + 1}_v{v + 1}")


def is_tiled(node: bpy.types.Node) -> bool:
    """Whether the image of an image node has tiles."""
    return bool(node.image.source == "TILED")


def size_of(image: bpy.types.Image, number: int = 0) -> tuple[int, int]:
    """Texels of a tile; for 0, of an image without tiles, or the most of all its tiles."""
    sizes = [image.size]
    if image.source == "TILED":
        sizes = [tile.size for tile in image.tiles if number in (0, tile.number)]
    width, height = (max(1, *(size[k] for size in sizes)) for k in (0, 1))
    return width, height


def onto_tile(mapping: np.ndarray, number: int) -> np.ndarray:
    """The map (2, 3) onto the unit square of a tile; mapping: onto the square of tile 1001."""
    v, u = divmod(number - 1001, _ACROSS)
    return np.asarray(mapping - [(0.0, 0.0, u), (0.0, 0.0, v)])


def numbers_of(uvs: np.ndarray, tiles: dict[str, Any]) -> np.ndarray:
    """(t,) int32: the tile that each triangle of UVs (3t, 2) lies in, 0 for none or several.

    tiles: `numbers` of those that there are, and `matrix`, from UVs to coordinates of the image.
    """
    matrix = np.array(tiles["matrix"])
    places = (uvs.astype(np.float64) @ matrix[:, :2].T + matrix[:, 2]).reshape(-1, 3, 2)
    places = np.nan_to_num(places, nan=-1.0, posinf=-1.0, neginf=-1.0)
    first = np.floor(places.mean(axis=1))
    beyond = np.abs(places - first[:, None] - 0.5).max(axis=(1, 2)) > 0.5 + _EDGE
    u, v = first.T
    numbers = np.where(beyond | (u >= _ACROSS), 0, 1001 + u + _ACROSS * v)
    numbers[(u < 0.0) | ~np.isin(numbers, tiles["numbers"])] = 0
    return numbers.astype(np.int32)
