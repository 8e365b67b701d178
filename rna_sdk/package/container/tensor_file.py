"""A safetensors file of a few known tensors: write one, read one from hostile bytes.

Layout: https://github.com/huggingface/safetensors#format. The tensors follow each other with no
gap, as that format asks, in the order of the caller; the first starts on a 64-byte boundary,
which the header's padding sees to.
"""

import json
import math
import struct
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.container.strict_json import parse_object
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import ALIGNMENT, MAX_TENSORS_HEADER_BYTES

_LENGTH = struct.Struct("<Q")
_DTYPES = {
    "int8": "I8",
    "uint8": "U8",
    "int16": "I16",
    "uint16": "U16",
    "int32": "I32",
    "uint32": "U32",
    "float16": "F16",
    "float32": "F32",
}
_NAMES = {written: name for name, written in _DTYPES.items()}


@dataclass(frozen=True)
class TensorForm:
    """Required form of a tensor: numpy's name of its dtype, or several, and its dimensions.

    A dimension is an int, or the range of those allowed.
    """

    dtype: str | tuple[str, ...]
    shape: tuple[int | range, ...]

    def fits(self, shape: list[int]) -> bool:
        """Whether a tensor may have this shape."""
        return len(shape) == len(self.shape) and all(
            n in allowed if isinstance(allowed, range) else n == allowed
            for n, allowed in zip(shape, self.shape, strict=True)
        )

    @property
    def written_dtypes(self) -> list[str]:
        """The names of the allowed dtypes in the file."""
        names = (self.dtype,) if isinstance(self.dtype, str) else self.dtype
        return [_DTYPES[name] for name in names]

    def __str__(self) -> str:
        texts = (f"{n[0]} to {n[-1]}" if isinstance(n, range) else f"{n}" for n in self.shape)
        return f"[{', '.join(texts)}]"


@dataclass(frozen=True)
class TensorCodes:
    """The issue codes of one sort of file.

    Attributes:
        header: no header in the file, or not JSON.
        tensors: other tensors than the known ones.
        dtype, shape: not the tensor's form.
        offsets: tensors that do not follow each other up to the end of the file.
        alignment: the first tensor is not on its boundary.
    """

    header: Code
    tensors: Code
    dtype: Code
    shape: Code
    offsets: Code
    alignment: Code


def tensors_to_bytes(tensors: Mapping[str, NDArray[Any]]) -> bytes:
    """The file of these arrays of _DTYPES. The same arrays give the same bytes."""
    forms = {name: (array.dtype.name, array.shape) for name, array in tensors.items()}
    data = (
        np.ascontiguousarray(array, array.dtype.newbyteorder("<")).tobytes()
        for array in tensors.values()
    )
    return b"".join((tensors_header(forms), *data))


def tensors_header(forms: Mapping[str, tuple[str, tuple[int, ...]]]) -> bytes:
    """The bytes before the data of tensors, by name: of these dtypes, of _DTYPES, and shapes."""
    header: dict[str, Any] = {}
    end = 0
    for name, (dtype, shape) in forms.items():
        start, end = end, end + math.prod(shape) * np.dtype(dtype).itemsize
        header[name] = {"dtype": _DTYPES[dtype], "shape": list(shape), "data_offsets": [start, end]}
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-(_LENGTH.size + len(text)) % ALIGNMENT)
    return _LENGTH.pack(len(text)) + text


def tensor_names(data: memoryview, name: str, codes: TensorCodes) -> set[str]:
    """The tensors that the file `data` names, whatever they are.

    Raises:
        PackageError: with the first issue of `codes` or JSON_* issue found in the header.
    """
    return set(_read_header(data, name, codes)[0]) - {"__metadata__"}


def tensors_from_bytes(
    data: memoryview, name: str, forms: Mapping[str, TensorForm], codes: TensorCodes
) -> dict[str, NDArray[Any]]:
    """The arrays of the file `data`, as read-only views of it; values are not looked at.

    Args:
        data: the bytes of the entry.
        name: the entry's name, for issues.
        forms: the tensors that the file must have, in the order of their data.
        codes: what to call what is wrong.

    Raises:
        PackageError: with the first issue of `codes` or JSON_* issue found.
    """
    header, start = _read_header(data, name, codes)
    if not isinstance(header.get("__metadata__", {}), dict):
        refuse(codes.tensors, f"{name}#/__metadata__", header["__metadata__"], "an object")
    if set(header) - {"__metadata__"} != set(forms):
        refuse(codes.tensors, name, sorted(header), sorted(forms))
    arrays: dict[str, NDArray[Any]] = {}
    end = 0
    for tensor, form in forms.items():
        where = f"{name}#/{tensor}"
        shape, written = _check_form(header[tensor], where, form, codes)
        dtype = np.dtype(_NAMES[written]).newbyteorder("<")
        begin, end = end, end + math.prod(shape) * dtype.itemsize
        offsets = header[tensor].get("data_offsets")
        if offsets != [begin, end] or not _is_integers(offsets) or start + end > len(data):
            found = f"{offsets} of {len(data) - start} bytes"
            refuse(codes.offsets, f"{where}/data_offsets", found, f"{[begin, end]}, in the file")
        flat = np.frombuffer(data[start + begin : start + end], dtype)
        arrays[tensor] = flat.reshape(shape)
    if start + end != len(data):
        refuse(codes.offsets, name, f"{len(data) - start} bytes of data", end)
    if start % ALIGNMENT:
        refuse(codes.alignment, name, f"byte {start}", f"a multiple of {ALIGNMENT}")
    return arrays


def _read_header(data: memoryview, name: str, codes: TensorCodes) -> tuple[dict[str, Any], int]:
    """The header's JSON object, and where the data behind it starts."""
    size = _LENGTH.unpack_from(data)[0] if len(data) >= _LENGTH.size else None
    if size is None or size > MAX_TENSORS_HEADER_BYTES or _LENGTH.size + size > len(data):
        expected = f"at most {MAX_TENSORS_HEADER_BYTES}, inside the file"
        refuse(codes.header, name, f"a header of {size} bytes", expected)
    start = _LENGTH.size + size
    if bytes(data[_LENGTH.size : _LENGTH.size + 1]) != b"{":
        refuse(codes.header, name, bytes(data[_LENGTH.size : start])[:1], "a header from { on")
    return parse_object(bytes(data[_LENGTH.size : start]), name, codes.header), start


def _check_form(
    tensor: object, where: str, form: TensorForm, codes: TensorCodes
) -> tuple[list[int], str]:
    """The tensor's shape and dtype, once the header's record of it is of the form."""
    if not isinstance(tensor, dict):
        refuse(codes.tensors, where, type(tensor).__name__, "an object")
    dtype = tensor.get("dtype")
    if dtype not in form.written_dtypes:
        refuse(codes.dtype, f"{where}/dtype", dtype, " or ".join(form.written_dtypes))
    shape = tensor.get("shape")
    if not _is_integers(shape) or not form.fits(shape):
        refuse(codes.shape, f"{where}/shape", shape, form)
    return shape, dtype


def _is_integers(value: object) -> TypeGuard[list[int]]:
    return isinstance(value, list) and all(type(item) is int for item in value)
