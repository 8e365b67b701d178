"""Numbers that shaders look up: skies, textures, attributes of points, one behind the other."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.records.tables import TEXTURE
from rna_render.materials import IDENTITY, SRGB, Texture
from rna_sdk.errors import GpuError
from rna_sdk.package import BaseColor
from rna_sdk.runtime.base_color import base_color_levels
from rna_sdk.runtime.kernels.base_color_kernel import CLAMP, MIRROR, REPEAT

NONE = np.uint32(0xFFFFFFFF)
_SIDE = (1 << 16) - 1
_WRAPS = {"repeat": REPEAT, "clamp": CLAMP, "mirror": MIRROR}


class Images:
    """Contents of the binding `images`, and records of its textures.

    Attributes:
        textures: () each, of dtype TEXTURE.
    """

    def __init__(self) -> None:
        self._arrays: list[NDArray[np.uint32]] = [np.zeros(4, np.uint32)]
        self._length = 4
        self._offsets: dict[int, tuple[int, object]] = {}
        self._levels: dict[tuple[int, str], tuple[int, object]] = {}
        self.textures: list[NDArray[Any]] = []

    def add(self, values: NDArray[Any]) -> int:
        """Place of the values, 4 bytes each."""
        place = self._length
        self._arrays.append(np.ascontiguousarray(values).reshape(-1).view(np.uint32))
        self._length += len(self._arrays[-1])
        return place

    def add_texture(self, texture: Texture) -> int:
        """Number of a texture."""
        srgb = int(texture.decode is SRGB)
        wrap_u, wrap_v = texture.wrap
        form = wrap_u | wrap_v << 2 | srgb << 4 | texture.uv_set << 5
        return self.add_texels(texture.texels, form, texture.transform)

    def add_texels(
        self,
        texels: NDArray[np.uint8],
        form: int = REPEAT,
        transform: NDArray[np.float64] = IDENTITY,
    ) -> int:
        """Number of a texture of (h, w, 1, 2 or 3) texels; form: as of TEXTURE.

        Raises:
            GpuError: it is too large.
        """
        height, width = texels.shape[:2]
        if max(height, width) > _SIDE:
            raise GpuError(f"a texture of {width} x {height} texels; a GPU takes {_SIDE} a side")
        return self._add_record(self._place(texels), texels.shape, form, transform)

    def _add_record(
        self, place: int, shape: tuple[int, ...], form: int, transform: NDArray[np.float64]
    ) -> int:
        record = np.zeros((), TEXTURE.dtype)
        record["place"], record["size"] = place, shape[0] << 16 | shape[1]
        record["form"] = form
        record["row_u"], record["row_v"] = transform
        self.textures.append(record)
        return len(self.textures) - 1

    def add_base_color(self, record: BaseColor) -> int:
        """Number of the texture of a record's image, its levels one behind the other."""
        assert record.image is not None  # the caller has checked
        key = id(record.image), record.color_space
        if key not in self._levels:
            levels = [_words(level) for level in base_color_levels(record)]
            self._levels[key] = self.add(np.concatenate(levels)), record.image
        wrap_u, wrap_v = (_WRAPS[way] for way in record.wrap)
        form = wrap_u | wrap_v << 2 | int(record.color_space == "srgb") << 8
        place = self._levels[key][0]
        transform = np.reshape(record.transform, (2, 3))
        return self._add_record(place, record.image.shape, form, transform)

    def _place(self, texels: NDArray[np.uint8]) -> int:
        """Offset of the texels, which are stored once; a single channel represents grey."""
        if id(texels) not in self._offsets:
            self._offsets[id(texels)] = self.add(_words(texels)), texels
        return self._offsets[id(texels)][0]

    def texture_rows(self) -> NDArray[np.float32]:
        """(n, 4): the textures' records, one behind the other."""
        return TEXTURE.stacked(self.textures).view(np.float32).reshape(-1, 4)

    def whole(self) -> NDArray[np.uint32]:
        """All images in one array."""
        return np.concatenate(self._arrays)


def _words(texels: NDArray[np.uint8]) -> NDArray[np.uint32]:
    """(h * w,): a word a texel; a single channel represents grey."""
    channels = texels.shape[2]
    words = np.zeros((*texels.shape[:2], 4), np.uint8)
    words[..., : 3 if channels == 1 else channels] = texels
    return words.reshape(-1).view(np.uint32)
