"""Base colour of a part: its images, and records with them (spec/RNA.md, 4.6)."""

from __future__ import annotations

import io
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import TYPE_CHECKING

import numpy as np

from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import MAX_TEXTURE_SIDE
from rna_sdk.package.manifest.manifest_model import (
    Affine,
    BaseColorFields,
    BaseColorRecord,
    ColorSpace,
    Wrap,
)
from rna_sdk.package.textures.texture_form import Texture

if TYPE_CHECKING:
    from PIL.Image import Image

IMAGE_FORMATS = ("PNG", "JPEG", "WEBP")

WHITE = (1.0, 1.0, 1.0)
IDENTITY: Affine = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0)


@dataclass(frozen=True, eq=False)
class BaseColor:
    """Base colour of a range of a mesh's triangles.

    Attributes:
        first, count: the range of triangles.
        image: (H, W, 3) uint8, read-only; row 0 is v = 0; None for white.
        color_space: of the image.
        factor: linear RGB.
        wrap: what lies beyond the image's edges along u, and along v.
        transform: (a, b, c, d, e, f): the image is looked up at (a u + b v + c, d u + e v + f).
        label: what the image is called: its entry's name without folder and suffix.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     [round(channel, 2) for channel in package.base_color()[0].factor]  # blue bricks
        [0.03, 0.16, 0.65]
    """

    first: int
    count: int
    image: Texture | None
    color_space: ColorSpace = "srgb"
    factor: tuple[float, float, float] = WHITE
    wrap: tuple[Wrap, Wrap] = ("repeat", "repeat")
    transform: Affine = IDENTITY
    label: str = ""

    @classmethod
    def of(
        cls, record: BaseColorRecord, image: Texture | None, label: str | None = None
    ) -> BaseColor:
        """A record of the manifest with its image. label: None for its entry's."""
        return cls(
            *record.triangles,
            image,
            record.color_space or "srgb",
            record.factor or WHITE,
            record.wrap or ("repeat", "repeat"),
            record.transform or IDENTITY,
            label_of(record) if label is None else label,
        )


def label_of(record: BaseColorFields) -> str:
    """Label of a record's image: its entry's name without folder and suffix."""
    return PurePosixPath(record.image or "").stem


def image_from_bytes(data: bytes | memoryview, name: str) -> Texture:
    """The pixels of the image in the entry `name`: (H, W, 3) uint8, read-only, alpha dropped.

    Raises:
        PackageError: BASE_COLOR_IMAGE.
    """
    from PIL import UnidentifiedImageError  # loads with the first image
    from PIL.Image import DecompressionBombError
    from PIL.Image import open as open_image

    expected = f"a PNG, JPEG or WebP of 1 to {MAX_TEXTURE_SIDE} pixels a side"
    try:
        with open_image(io.BytesIO(data), formats=IMAGE_FORMATS) as image:
            if max(image.size) > MAX_TEXTURE_SIDE:
                found = f"{image.width} x {image.height} pixels"
                refuse(Code.BASE_COLOR_IMAGE, name, found, expected)
            if image.mode == "CMYK":  # whose colours decoders do not agree on
                refuse(Code.BASE_COLOR_IMAGE, name, "a JPEG in CMYK", expected + ", grey or RGB")
            pixels = _rgb(image)
    except UnidentifiedImageError:
        refuse(Code.BASE_COLOR_IMAGE, name, "another file", expected)
    except (OSError, ValueError, SyntaxError, DecompressionBombError) as error:
        refuse(Code.BASE_COLOR_IMAGE, name, f"what cannot be decoded: {error}", expected)
    pixels.flags.writeable = False
    return pixels


def _rgb(image: Image) -> Texture:
    if image.mode.startswith("I"):  # grey of 16 bits, which Pillow would clip to 255
        high = (np.asarray(image) >> 8).astype(np.uint8)
        return np.repeat(high[:, :, None], 3, axis=2)
    return np.array(image.convert("RGBA").convert("RGB"))
