"""The triplane of a tier, as a safetensors file of one tensor: write it, read it.

Layout: https://github.com/huggingface/safetensors#format. The tensor starts on a 64-byte
boundary, which the header's padding sees to.
"""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import ALIGNMENT, MAX_PLANES_HEADER_BYTES
from rna_sdk.package.manifest import Tier
from rna_sdk.package.strict_json import parse_object

Planes = NDArray[np.float16] | NDArray[np.float32]
"""(3, R, R, C): planes XY, YZ, ZX; row v, column u; channel last."""

TENSOR = "planes"
DTYPES = {"float16": "F16", "float32": "F32"}
_LENGTH = struct.Struct("<Q")
_ROWS_AT_ONCE = 64


def planes_to_bytes(planes: Planes) -> bytes:
    """The safetensors file of a (3, R, R, C) float16 or float32 array."""
    little = np.ascontiguousarray(planes, planes.dtype.newbyteorder("<"))
    tensor = {
        "dtype": DTYPES[planes.dtype.name],
        "shape": list(planes.shape),
        "data_offsets": [0, little.nbytes],
    }
    header = json.dumps({TENSOR: tensor}, separators=(",", ":")).encode()
    header += b" " * (-(_LENGTH.size + len(header)) % ALIGNMENT)
    return _LENGTH.pack(len(header)) + header + little.tobytes()


def planes_from_bytes(data: memoryview, tier: Tier) -> Planes:
    """The tier's planes, (3, R, R, C), as a read-only view of the entry `data`.

    Raises:
        PackageError: with the first PLANES_* or JSON_* issue found; values are not looked at.
    """
    name = tier.planes
    size = _LENGTH.unpack_from(data)[0] if len(data) >= _LENGTH.size else None
    if size is None or size > MAX_PLANES_HEADER_BYTES or _LENGTH.size + size > len(data):
        expected = f"at most {MAX_PLANES_HEADER_BYTES}, inside the file"
        refuse(Code.PLANES_HEADER, name, f"a header of {size} bytes", expected)
    start = _LENGTH.size + size
    header = parse_object(bytes(data[_LENGTH.size : start]), name, Code.PLANES_HEADER)
    tensor = header.get(TENSOR)
    if not isinstance(tensor, dict) or set(header) - {"__metadata__"} != {TENSOR}:
        refuse(Code.PLANES_TENSOR, name, sorted(header), [TENSOR])
    _check_tensor(tensor, len(data) - start, tier)
    if start % ALIGNMENT:
        refuse(Code.PLANES_ALIGNMENT, name, f"byte {start}", f"a multiple of {ALIGNMENT}")
    flat = np.frombuffer(data[start:], np.dtype(tier.plane_precision).newbyteorder("<"))
    return flat.reshape(3, tier.resolution, tier.resolution, tier.channels)


def check_finite(planes: Planes, name: str) -> None:
    """Raises PackageError (PLANES_NOT_FINITE), in little memory beside the planes."""
    rows = planes.reshape(-1, *planes.shape[2:])
    for start in range(0, len(rows), _ROWS_AT_ONCE):
        finite = np.isfinite(rows[start : start + _ROWS_AT_ONCE])
        if not finite.all():
            at = start + int(np.argmin(finite.all(axis=(1, 2))))
            plane, row = divmod(at, planes.shape[1])
            refuse(Code.PLANES_NOT_FINITE, name, f"one in plane {plane}, row {row}", "none")


def _check_tensor(tensor: dict[str, Any], available: int, tier: Tier) -> None:
    """The header's tensor is the one the tier describes, and fills the file."""
    name = f"{tier.planes}#/{TENSOR}"
    dtype = DTYPES[tier.plane_precision]
    if tensor.get("dtype") != dtype:
        refuse(Code.PLANES_DTYPE, f"{name}/dtype", tensor.get("dtype"), dtype)
    shape = [3, tier.resolution, tier.resolution, tier.channels]
    if tensor.get("shape") != shape:
        refuse(Code.PLANES_SHAPE, f"{name}/shape", tensor.get("shape"), shape)
    size = int(np.prod(shape)) * np.dtype(tier.plane_precision).itemsize
    if tensor.get("data_offsets") != [0, size] or available != size:
        found = f"{tensor.get('data_offsets')} of {available} bytes"
        refuse(Code.PLANES_HEADER, f"{name}/data_offsets", found, f"[0, {size}] of {size}")
