"""The triplane of a tier part, as a safetensors file: write it, read it."""

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
from rna_sdk.package.limits import MAX_TEXEL
from rna_sdk.package.manifest.manifest_tiers import TierPartFields


@dataclass(frozen=True, eq=False)
class Int8Planes:
    """Quantised planes.

    Attributes:
        texels: (3, R, R, C) int8.
        scales: (3, C) float32, per plane and channel; a feature is texel times scale.
    """

    texels: NDArray[np.int8]
    scales: NDArray[np.float32]

    @property
    def dtype(self) -> np.dtype[Any]:
        """dtype of the texels."""
        return self.texels.dtype

    def decoded(self) -> NDArray[np.float32]:
        """The features, (3, R, R, C) float32."""
        return self.texels * self.scales[:, None, None, :]


Planes = NDArray[np.float16] | NDArray[np.float32] | Int8Planes
"""(3, R, R, C): planes XY, YZ, ZX; row v, column u; channel last."""

TENSOR, SCALES = "planes", "scales"
DTYPES = ("int8", "float16", "float32")
_CODES = TensorCodes(
    header=Code.PLANES_HEADER,
    tensors=Code.PLANES_TENSOR,
    dtype=Code.PLANES_DTYPE,
    shape=Code.PLANES_SHAPE,
    offsets=Code.PLANES_HEADER,
    alignment=Code.PLANES_ALIGNMENT,
)
_ROWS_AT_ONCE = 64


def float_planes(planes: Planes) -> NDArray[np.float32]:
    """Planes of any precision as features, (3, R, R, C) float32.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     planes = float_planes(package.planes("small"))
        >>> planes.shape, planes.dtype
        ((3, 256, 256, 8), dtype('float32'))
    """
    return planes.decoded() if isinstance(planes, Int8Planes) else planes.astype(np.float32)


def planes_to_bytes(planes: Planes) -> bytes:
    """The safetensors file of (3, R, R, C) planes."""
    if isinstance(planes, Int8Planes):
        return tensors_to_bytes({SCALES: planes.scales, TENSOR: planes.texels})
    return tensors_to_bytes({TENSOR: planes})


def planes_from_bytes(data: memoryview, part: TierPartFields) -> Planes:
    """The part's planes, (3, R, R, C), as read-only views of the entry `data`.

    Raises:
        PackageError: with the first PLANES_* or JSON_* issue found; values are not looked at.
    """
    shape = (3, part.resolution, part.resolution, part.channels)
    forms = {TENSOR: TensorForm(part.plane_precision, shape)}
    if part.plane_precision == "int8":
        forms = {SCALES: TensorForm("float32", (3, part.channels)), **forms}
        tensors = tensors_from_bytes(data, part.planes, forms, _CODES)
        return Int8Planes(tensors[TENSOR], tensors[SCALES])
    return tensors_from_bytes(data, part.planes, forms, _CODES)[TENSOR]


def check_finite(planes: Planes, name: str) -> None:
    """Raises PackageError (PLANES_NOT_FINITE), in little memory beside the planes."""
    expected = f"numbers within {MAX_TEXEL:g}"
    if isinstance(planes, Int8Planes):
        if not (np.abs(planes.scales) <= MAX_TEXEL / 128).all():
            refuse(Code.PLANES_NOT_FINITE, f"{name}#/{SCALES}", planes.scales.tolist(), expected)
        return
    rows = planes.reshape(-1, *planes.shape[2:])
    for start in range(0, len(rows), _ROWS_AT_ONCE):
        good = np.abs(rows[start : start + _ROWS_AT_ONCE]) <= MAX_TEXEL
        if not good.all():
            at = start + int(np.argmin(good.all(axis=(1, 2))))
            plane, row = divmod(at, planes.shape[1])
            refuse(Code.PLANES_NOT_FINITE, name, f"one in plane {plane}, row {row}", expected)
