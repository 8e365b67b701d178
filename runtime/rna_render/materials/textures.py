"""Textures: images on a mesh, as linear colours between their texels.

A texture coordinate (0, 0) is the upper left corner of the image and (1, 1) the lower right one,
as in glTF 2.0, section 3.8.4.
"""

from __future__ import annotations

import io
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from rna_render.scene.limits import MAX_IMAGE_PIXELS
from rna_sdk.errors import SceneError
from rna_sdk.files.regular_file import check_regular
from rna_sdk.files.srgb import decode_srgb
from rna_sdk.machine.compiled import compiled
from rna_trace.bilinear import REPEAT, texels_around
from rna_trace.vectors import Vector

if TYPE_CHECKING:
    from PIL.ImageFile import ImageFile

# Formats that are read, by PIL's names: pictures alone, no decoder that starts another program.
FORMATS = ("PNG", "JPEG", "WEBP", "TIFF", "BMP", "TGA", "GIF", "PPM", "DDS", "JPEG2000")

_LEVELS = np.arange(256) / 255.0
LINEAR = _LEVELS.astype(np.float32)
SRGB = decode_srgb(_LEVELS).astype(np.float32)
IDENTITY = np.eye(2, 3)


@dataclass(frozen=True, slots=True, eq=False)
class Texture:
    """An image, looked up bilinearly; filtering happens after decoding to linear values.

    texels: (height, width, 3) uint8, the upper row first.
    decode: (256,) float32, linear value of each level: SRGB or LINEAR.
    wrap: what is outside [0, 1] in u and in v: REPEAT, CLAMP or MIRROR.
    transform: (2, 3) float64, from the mesh's coordinates (u, v, 1) to the image's.
    uv_set: which of the mesh's coordinates.
    """

    texels: np.ndarray
    decode: np.ndarray
    wrap: tuple[int, int] = (REPEAT, REPEAT)
    transform: np.ndarray = field(default_factory=lambda: IDENTITY)
    uv_set: int = 0

    def lookup(self, uv: np.ndarray) -> np.ndarray:
        """Linear colours at texture coordinates (n, 2) float32: (n, 3) float32."""
        result = np.empty((len(uv), 3), np.float32)
        _lookup(self.texels, self.decode, *self.wrap, self.transform, uv, result)
        return result

    def mean(self) -> np.ndarray:
        """The mean linear colour: (3,) float64."""
        levels = [np.bincount(self.texels[..., c].ravel(), minlength=256) for c in range(3)]
        return np.array(levels) @ self.decode.astype(np.float64) / self.texels[..., 0].size


def read_texels(source: Path | bytes, name: object) -> np.ndarray:
    """An image file as (height, width, 3) uint8; its alpha is left out.

    source: the file, or what is in it. name: for errors. Raises SceneError if it is not there or
    is no image.
    """
    with _opened(source, name) as image:
        if image.mode.startswith("I"):  # 16 bits of grey, which PIL would clip to 8
            grey = np.clip(np.asarray(image, np.float64) / 257.0, 0, 255)
            return np.repeat(np.rint(grey).astype(np.uint8)[..., None], 3, axis=2)
        if image.mode == "F":
            raise SceneError("images of floating point numbers are no textures", file=name)
        return np.array(image.convert("RGB"))


def read_alpha(source: Path | bytes, name: object) -> np.ndarray | None:
    """The alpha of an image file in all three channels, (height, width, 3) uint8; None if it has
    none. Arguments and errors are those of `read_texels`."""
    with _opened(source, name) as image:
        if "A" not in image.getbands() and "transparency" not in image.info:
            return None
        return np.repeat(np.array(image.convert("RGBA"))[..., 3:], 3, axis=2)


@contextmanager
def _opened(source: Path | bytes, name: object) -> Iterator[ImageFile]:
    from PIL import Image

    try:
        if isinstance(source, Path):
            check_regular(source)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            opened = Image.open(
                source if isinstance(source, Path) else io.BytesIO(source), formats=FORMATS
            )
        with opened as image:
            if image.width * image.height > MAX_IMAGE_PIXELS:
                size = f"{image.width} x {image.height} pixels; at most 2^27 in all"
                raise SceneError(f"cannot read the image: {size}", file=name)
            yield image
    except FileNotFoundError as error:
        raise SceneError("no such file", file=name) from error
    except SceneError:
        raise
    except Exception as error:  # whatever a broken image makes a decoder raise
        reason = getattr(error, "strerror", None) or "it is broken, or of a kind that PIL lacks"
        raise SceneError(f"cannot read the image: {reason}", file=name) from error


@compiled(fastmath=())
def texture_value(
    texels: np.ndarray,
    decode: np.ndarray,
    wrap_u: int,
    wrap_v: int,
    transform: np.ndarray,
    a: float,
    b: float,
) -> Vector:
    """Linear colour at the mesh's coordinates (a, b): red, green, blue."""
    height, width = texels.shape[0], texels.shape[1]
    u = transform[0, 0] * a + transform[0, 1] * b + transform[0, 2]
    v = transform[1, 0] * a + transform[1, 1] * b + transform[1, 2]
    left, right, s = texels_around(u, width, wrap_u)
    top, bottom, t = texels_around(v, height, wrap_v)
    return (
        _mixed(texels, decode, left, right, top, bottom, s, t, 0),
        _mixed(texels, decode, left, right, top, bottom, s, t, 1),
        _mixed(texels, decode, left, right, top, bottom, s, t, 2),
    )


@compiled(fastmath=())
def _mixed(
    texels: np.ndarray,
    decode: np.ndarray,
    left: int,
    right: int,
    top: int,
    bottom: int,
    s: float,
    t: float,
    c: int,
) -> float:
    upper = (1.0 - s) * decode[texels[top, left, c]] + s * decode[texels[top, right, c]]
    lower = (1.0 - s) * decode[texels[bottom, left, c]] + s * decode[texels[bottom, right, c]]
    return float((1.0 - t) * upper + t * lower)


@compiled(rows="uv result", fastmath=())
def _lookup(
    texels: np.ndarray,
    decode: np.ndarray,
    wrap_u: int,
    wrap_v: int,
    transform: np.ndarray,
    uv: np.ndarray,
    result: np.ndarray,
) -> None:
    for i in range(len(uv)):
        a, b = np.float64(uv[i, 0]), np.float64(uv[i, 1])
        value = texture_value(texels, decode, wrap_u, wrap_v, transform, a, b)
        result[i, 0], result[i, 1], result[i, 2] = value
