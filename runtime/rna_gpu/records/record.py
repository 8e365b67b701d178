"""A record of a buffer: a numpy dtype, laid out as WGSL has it, that can say itself in WGSL."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

_SCALARS = {"<f4": "f32", "<u4": "u32"}
_VECTORS = {"<f4": "vec{}f", "<u4": "vec{}<u32>"}


@dataclass(frozen=True)
class Field:
    """A member of a record.

    form: "<f4", "<u4", or a record. shape: () for a scalar, (2,) to (4,) for a vector, (..., 4) for
    an array of vectors; of records () or (n,). meaning: a comment, maybe "".
    """

    name: str
    form: "str | Record"
    shape: tuple[int, ...] = ()
    meaning: str = ""

    @property
    def wgsl(self) -> str:
        """Type of the member in WGSL."""
        if isinstance(self.form, Record):
            return f"array<{self.form.name}, {self.shape[0]}>" if self.shape else self.form.name
        if not self.shape:
            return _SCALARS[self.form]
        vector = _VECTORS[self.form].format(self.shape[-1])
        return f"array<{vector}, {prod(self.shape[:-1])}>" if self.shape[1:] else vector

    @property
    def alignment(self) -> int:
        """Bytes: WGSL, section 14.4.1."""
        if isinstance(self.form, Record):
            return self.form.alignment
        return {(): 4, (2,): 8}.get(self.shape, 16)


class Record:
    """Members one behind the other, where WGSL aligns them.

    Attributes:
        name: in WGSL and JavaScript.
        dtype: in numpy; what it leaves free between members is 0 in `np.zeros`.
        alignment: bytes.
    """

    def __init__(self, name: str, *fields: Field) -> None:
        self.name, self.fields = name, fields
        self.alignment = max(field.alignment for field in fields)
        offsets, end = [], 0
        for field in fields:
            offsets.append(_rounded(end, field.alignment))
            end = offsets[-1] + _numpy_form(field).itemsize
        self.dtype = np.dtype(
            {
                "names": [field.name for field in fields],
                "formats": [_numpy_form(field) for field in fields],
                "offsets": offsets,
                "itemsize": _rounded(end, self.alignment),
            }
        )
        self.offsets = dict(zip((field.name for field in fields), offsets, strict=True))
        for field in fields:  # uniform buffers want it: WGSL, section 14.4.2
            if isinstance(field.form, Record) and self.offsets[field.name] % 16:
                raise ValueError(f"{name}.{field.name} is not at a multiple of 16 bytes")

    def stacked(self, rows: Sequence[NDArray[Any]]) -> NDArray[Any]:
        """(n,) of dtype, of records () each."""
        result = np.zeros(len(rows), self.dtype)
        for k, row in enumerate(rows):
            result[k] = row
        return result

    def wgsl(self) -> str:
        """The struct's declaration; each member's byte offset is in its comment."""
        lines = []
        for field in self.fields:
            comment = "; ".join(filter(None, [str(self.offsets[field.name]), field.meaning]))
            lines.append(f"    {field.name}: {field.wgsl}, // {comment}\n")
        return f"struct {self.name} {{ // {self.dtype.itemsize} bytes\n{''.join(lines)}}}\n"

    def accessors(self, section: str) -> str:
        """Functions of WGSL that read a member of a record in `table`, by the record's number.

        section: of the frame, where the first record begins. Arrays are read an element at a time.
        """
        start = f"table[frame.{section} + {self.dtype.itemsize // 16}u * k + "
        return "".join(
            _accessor(field, self.name.lower(), start, self.offsets[field.name] // 4)
            for field in self.fields
        )

    def layout(self) -> dict[str, Any]:
        """For JavaScript, in words of 4 bytes: where members begin, and how many words they have.

        A member that is a record, or an array of records, names it.
        """
        members = {}
        for field in self.fields:
            member: dict[str, Any] = {"at": self.offsets[field.name] // 4}
            if isinstance(field.form, Record):
                member |= {"record": field.form.name, "count": prod(field.shape)}
            else:
                member |= {"type": _SCALARS[field.form], "count": prod(field.shape)}
            members[field.name] = member
        return {"words": self.dtype.itemsize // 4, "members": members}


def constants(values: Mapping[str, int | float | tuple[float, ...]]) -> str:
    """Declarations of u32, f32 and vec3f by their names."""
    return "".join(f"const {name}{_literal(value)};\n" for name, value in values.items())


def _literal(value: int | float | tuple[float, ...]) -> str:
    if isinstance(value, tuple):
        return f" = vec3f{value}"
    if isinstance(value, int):
        return f": u32 = {value if value < 1 << 16 else hex(value)}u"
    return f": f32 = {value}"


def _accessor(field: Field, prefix: str, start: str, word: int) -> str:
    scalar = _SCALARS[str(field.form)]
    width = field.shape[-1] if field.shape else 1
    argument, row, column = "", f"{word // 4}u]", f".{'xyzw'[word % 4 :][:width]}"
    kind = field.wgsl
    if field.shape[1:]:
        argument, row, column = ", i: u32", f"{word // 4}u + i / 4u]", "[i % 4u]"
        kind = scalar
    value = f"{start}{row}{column}"
    if scalar == "u32":
        value = f"bitcast<{kind}>({value})"
    return f"fn {prefix}_{field.name}(k: u32{argument}) -> {kind} {{\n    return {value};\n}}\n"


def _numpy_form(field: Field) -> np.dtype[Any]:
    form = field.form.dtype if isinstance(field.form, Record) else field.form
    return np.dtype((form, field.shape))


def _rounded(size: int, step: int) -> int:
    return -(-size // step) * step
