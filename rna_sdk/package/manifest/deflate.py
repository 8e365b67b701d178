"""RNA_deflate: the coded form of an entry's bytes (spec, "Extensions of this text").

Elements minus those some places before, lowest bytes first, then zlib.
"""

import hashlib
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.container.strict_json import pointer
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import DEFLATE_ALLOWANCE, MAX_DEFLATE_RATIO
from rna_sdk.package.manifest.extensions import Coding, Deflate

_LEVEL = 9


def encode(data: bytes | memoryview, element_size: int, distance: int) -> bytes:
    """The zlib stream of `data`, coded as elements of 1, 2 or 4 bytes; `distance` in elements."""
    elements, rest = _split(data, element_size)
    if 0 < distance < len(elements):
        elements = elements.copy()
        elements[distance:] -= elements[:-distance].copy()
    planes = elements.view(np.uint8).reshape(-1, element_size).T
    return zlib.compress(planes.tobytes() + rest, _LEVEL)


def decode(stream: bytes | memoryview, size: int, element_size: int, distance: int) -> bytes:
    """The inverse of `encode`: `size` bytes.

    Raises:
        ValueError: not a zlib stream, or it does not inflate to `size` bytes. No more than
            one byte beyond `size` is ever made.
    """
    coded = _inflated(stream, size)
    count = size // element_size
    planes = np.frombuffer(coded, np.uint8, count * element_size).reshape(element_size, count)
    elements = np.ascontiguousarray(planes.T).view(f"<u{element_size}").reshape(-1)
    if 0 < distance < count:
        elements = _summed(elements, distance)
    return elements.tobytes() + coded[count * element_size :]


def largest_decoded(stored: int) -> int:
    """Most bytes that an entry of `stored` bytes may inflate to, so that memory follows size."""
    return DEFLATE_ALLOWANCE + MAX_DEFLATE_RATIO * stored


def decoded_entry(stream: memoryview, name: str, coding: Coding) -> bytes:
    """The bytes of the coded entry `name`, of the declared size and hash.

    Raises:
        PackageError: DEFLATE_STREAM, ENTRY_HASH.
    """
    where = pointer("extensions", Deflate.NAME, "entries", name)
    try:
        data = decode(stream, coding.size, coding.element_size, coding.distance)
    except ValueError as error:
        refuse(Code.DEFLATE_STREAM, where, error, f"a zlib stream of {coding.size} bytes")
    digest = hashlib.sha256(data).hexdigest()
    if digest != coding.sha256:
        refuse(Code.ENTRY_HASH, f"{where}/sha256", digest, coding.sha256)
    return data


def _split(data: bytes | memoryview, element_size: int) -> tuple[NDArray[Any], bytes]:
    whole = len(data) // element_size * element_size
    elements = np.frombuffer(data, f"<u{element_size}", whole // element_size)
    return elements, bytes(data[whole:])


def _summed(differences: NDArray[Any], distance: int) -> NDArray[Any]:
    """Cumulative sums with a stride of `distance`, modulo the range of the dtype."""
    count = len(differences)
    padded = np.zeros(-(-count // distance) * distance, differences.dtype)
    padded[:count] = differences
    rows = padded.reshape(-1, distance)
    np.cumsum(rows, axis=0, dtype=rows.dtype, out=rows)
    return padded[:count]


def _inflated(stream: bytes | memoryview, size: int) -> bytes:
    inflater = zlib.decompressobj()
    try:
        data = inflater.decompress(stream, size + 1)
    except zlib.error as error:
        raise ValueError(str(error)) from None
    if len(data) != size or not inflater.eof or inflater.unused_data:
        more = "more than " if len(data) > size else ""
        raise ValueError(f"a stream of {more}{min(len(data), size)} bytes")
    return data
