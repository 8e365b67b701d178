"""A texture over a mesh's triangles as an entry: a tensor file of one uint8 image."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.container.tensor_file import (
    TensorCodes,
    TensorForm,
    tensors_from_bytes,
    tensors_to_bytes,
)
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import MAX_TEXTURE_SIDE

Texture = NDArray[np.uint8]
"""(H, W, C) uint8; row 0 is v = 0."""

_SIDE = range(1, MAX_TEXTURE_SIDE + 1)


@dataclass(frozen=True)
class TextureForm:
    """One sort of textures.

    Attributes:
        tensor: its name in the file.
        channels: those that there may be.
        code: of a file that is another.
    """

    tensor: str
    channels: range
    code: Code

    @property
    def _form(self) -> TensorForm:
        return TensorForm("uint8", (_SIDE, _SIDE, self.channels))

    def to_bytes(self, texture: NDArray[Any], name: str) -> bytes:
        """The file of a texture, for the entry `name`.

        Raises:
            PackageError: `code`, where it is no such array.
        """
        if texture.dtype != np.uint8 or not self._form.fits(list(texture.shape)):
            found = f"{texture.dtype} {list(texture.shape)}"
            refuse(self.code, name, found, f"uint8 {self._form}")
        return tensors_to_bytes({self.tensor: texture})

    def from_bytes(self, data: memoryview, name: str) -> Texture:
        """The texture in the entry `name` of `data`, as a read-only view.

        Raises:
            PackageError: `code`, or a JSON_* issue.
        """
        codes = TensorCodes(*[self.code] * 6)
        texture: Texture = tensors_from_bytes(data, name, {self.tensor: self._form}, codes)[
            self.tensor
        ]
        return texture
