"""The protobuf wire format, just enough to look into a message without its schema.

https://protobuf.dev/programming-guides/encoding. Parsers merge a message field that comes
twice, so that two readers may see two different models; `Message.one` refuses it.
"""

from collections.abc import Iterator

MAX_ITEMS = 2**18
"""Fields and packed numbers in a model; a decoder has a few thousand."""

VARINT, FIXED64, BYTES, FIXED32 = 0, 1, 2, 5
_FIXED_SIZES = {FIXED64: 8, FIXED32: 4}


class WireError(ValueError):
    """The bytes are no message, or a field is not as its reader needs it."""


class Message:
    """The fields of one message: number -> values in order.

    A value is an int (varint), or a memoryview (bytes, strings, messages, fixed numbers).
    A message and those inside it draw on one budget of items, so that a file of tiny fields
    cannot fill the memory.
    """

    def __init__(self, data: memoryview, budget: Iterator[int] | None = None) -> None:
        self._budget = iter(range(MAX_ITEMS)) if budget is None else budget
        self.fields: dict[int, list[int | memoryview]] = {}
        for number, value in _read_fields(data):
            self._spend()
            self.fields.setdefault(number, []).append(value)

    def _spend(self) -> None:
        if next(self._budget, None) is None:
            raise WireError(f"more than {MAX_ITEMS} fields and numbers")

    def has(self, number: int) -> bool:
        return number in self.fields

    def one(self, number: int) -> int | memoryview | None:
        """The value of a field that comes at most once."""
        values = self.fields.get(number, [])
        if len(values) > 1:
            raise WireError(f"field {number} comes {len(values)} times")
        return values[0] if values else None

    def integer(self, number: int) -> int:
        """A varint field, 0 where it is absent (as protobuf has it)."""
        value = self.one(number)
        if isinstance(value, memoryview):
            raise WireError(f"field {number} is no varint")
        return value or 0

    def text(self, number: int) -> str:
        """A string field, "" where it is absent."""
        value = self.one(number)
        return "" if value is None else _text(value, number)

    def texts(self, number: int) -> list[str]:
        """A repeated string field."""
        return [_text(value, number) for value in self.fields.get(number, [])]

    def message(self, number: int) -> "Message":
        """A message field, empty where it is absent."""
        value = self.one(number)
        data = memoryview(b"") if value is None else _bytes(value, number)
        return Message(data, self._budget)

    def messages(self, number: int) -> list["Message"]:
        """A repeated message field."""
        values = self.fields.get(number, [])
        return [Message(_bytes(value, number), self._budget) for value in values]

    def integers(self, number: int) -> list[int]:
        """A repeated varint field, packed or not."""
        result: list[int] = []
        for value in self.fields.get(number, []):
            if isinstance(value, int):
                result.append(value)
                continue
            offset = 0
            while offset < len(value):
                self._spend()
                item, offset = _varint(value, offset)
                result.append(item)
        return result


def _read_fields(data: memoryview) -> Iterator[tuple[int, int | memoryview]]:
    offset = 0
    while offset < len(data):
        tag, offset = _varint(data, offset)
        number, wire = tag >> 3, tag & 7
        if wire == VARINT:
            value, offset = _varint(data, offset)
            yield number, value
            continue
        if wire == BYTES:
            size, offset = _varint(data, offset)
        elif wire in _FIXED_SIZES:
            size = _FIXED_SIZES[wire]
        else:
            raise WireError(f"wire type {wire}")
        if offset + size > len(data) or number == 0:
            raise WireError(f"field {number} of {size} bytes, {len(data) - offset} left")
        yield number, data[offset : offset + size]
        offset += size


def _varint(data: memoryview, offset: int) -> tuple[int, int]:
    """The varint at `offset`, unsigned 64-bit, and the offset behind it."""
    value = 0
    for shift in range(0, 70, 7):
        if offset >= len(data):
            break
        byte = data[offset]
        value |= (byte & 0x7F) << shift
        offset += 1
        if byte < 0x80:
            return value & (2**64 - 1), offset
    raise WireError("a varint cut short")


def _bytes(value: int | memoryview, number: int) -> memoryview:
    if isinstance(value, int):
        raise WireError(f"field {number} is a varint")
    return value


def _text(value: int | memoryview, number: int) -> str:
    try:
        return bytes(_bytes(value, number)).decode("utf-8")
    except UnicodeDecodeError:
        raise WireError(f"field {number} is no UTF-8") from None
