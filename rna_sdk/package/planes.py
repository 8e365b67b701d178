"""The triplane of a tier, as a safetensors file of one tensor: write it, read it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.manifest import Tier
from rna_sdk.package.tensor_file import (
    TensorCodes,
    TensorForm,
    tensors_from_bytes,
    tensors_to_bytes,
)

Planes = NDArray[np.float16] | NDArray[np.float32]
"""(3, R, R, C): planes XY, YZ, ZX; row v, column u; channel last."""

TENSOR = "planes"
DTYPES = ("float16", "float32")
_CODES = TensorCodes(
    header=Code.PLANES_HEADER,
    tensors=Code.PLANES_TENSOR,
    dtype=Code.PLANES_DTYPE,
    shape=Code.PLANES_SHAPE,
    offsets=Code.PLANES_HEADER,
    alignment=Code.PLANES_ALIGNMENT,
)
_ROWS_AT_ONCE = 64


def planes_to_bytes(planes: Planes) -> bytes:
    """The safetensors file of a (3, R, R, C) float16 or float32 array."""
    return tensors_to_bytes({TENSOR: planes})


def planes_from_bytes(data: memoryview, tier: Tier) -> Planes:
    """The tier's planes, (3, R, R, C), as a read-only view of the entry `data`.

    Raises:
        PackageError: with the first PLANES_* or JSON_* issue found; values are not looked at.
    """
    shape = (3, tier.resolution, tier.resolution, tier.channels)
    forms = {TENSOR: TensorForm(tier.plane_precision, shape)}
    return tensors_from_bytes(data, tier.planes, forms, _CODES)[TENSOR]


def check_finite(planes: Planes, name: str) -> None:
    """Raises PackageError (PLANES_NOT_FINITE), in little memory beside the planes."""
    rows = planes.reshape(-1, *planes.shape[2:])
    for start in range(0, len(rows), _ROWS_AT_ONCE):
        finite = np.isfinite(rows[start : start + _ROWS_AT_ONCE])
        if not finite.all():
            at = start + int(np.argmin(finite.all(axis=(1, 2))))
            plane, row = divmod(at, planes.shape[1])
            refuse(Code.PLANES_NOT_FINITE, name, f"one in plane {plane}, row {row}", "none")
