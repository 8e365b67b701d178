"""Base colours of materials, as Blender exports them."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from rna_sdk.package.manifest.manifest_model import Affine, ColorSpace, Wrap

Rgb = tuple[float, float, float]
Piece = tuple[str, int]
"""A material's full name and a tile of its UDIM image: 0 without tiles, and beyond them all."""


@dataclass(frozen=True, eq=False)
class ColorImage:
    """The image of a base colour, and the colours that Cycles shows.

    data: (n,) uint8, the bytes of a file; or (h, w, 3) uint8, texels in sRGB. wrap: along u and v.
    transform: see rna_sdk.package.BaseColor. uvs: (p, 2) float32, texture coordinates of points of
    the surface. shown: (p, 3) float32, linear colours there, without the factor.
    """

    data: np.ndarray
    color_space: ColorSpace
    wrap: tuple[Wrap, Wrap]
    transform: Affine
    uvs: np.ndarray
    shown: np.ndarray


@dataclass(frozen=True, eq=False)
class MaterialColor:
    """The base colour of a piece: a linear factor from 0 to 1, times an image if it has any."""

    factor: Rgb
    image: ColorImage | None


@dataclass(frozen=True)
class MaterialColors:
    """Base colours by the piece of a material, of those that have one.

    charts: the texture coordinates of all textures (see `uv_charts.py`). others: by material,
    inputs of its shaders with other images -> texels in a unit square of texture coordinates.
    obstacles: by material, why its base colour is no image. notes: for the user.
    """

    of_piece: dict[Piece, MaterialColor]
    charts: dict[str, Any]
    others: dict[str, dict[str, float]]
    obstacles: dict[str, str]
    notes: list[str]

    @classmethod
    def of(cls, arrays: dict[str, np.ndarray], answer: dict[str, Any]) -> "MaterialColors":
        """The answer of `base_colors.py`."""
        colors = {}
        for record in answer["colors"]:
            image = None
            if (k := record.get("image")) is not None:
                image = ColorImage(
                    arrays[f"image{k}"],
                    record["colorSpace"],
                    (record["wrap"], record["wrap"]),
                    tuple(record["transform"]),
                    arrays[f"uvs{k}"],
                    arrays[f"shown{k}"],
                )
            piece = record["material"], record["tile"]
            colors[piece] = MaterialColor(tuple(record["factor"]), image)
        return cls(colors, answer["charts"], answer["others"], answer["obstacles"], answer["notes"])
