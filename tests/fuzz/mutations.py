"""Mutations of files: of bytes, of numbers in text, of values in JSON, of floats in data."""

import base64
import json
import re
import struct
from collections.abc import Callable
from typing import Any

import numpy as np

PREFIX = "data:application/octet-stream;base64,"

# Numbers that break what trusts them: not finite, huge, tiny, and next to the ends of integers.
NUMBERS = [
    "NaN", "Infinity", "-Infinity", "1e30", "-1e30", "1e308", "1e-320", "0", "-0.0", "-1", "0.5",
    "255", "256", "65535", "65536", "2147483647", "-2147483648", "4294967295", "4294967296",
    "9223372036854775807", "1e18", "60000000", "3.5",
]  # fmt: skip
WORDS = ['""', "null", "true", "[]", "{}", '"a\\u0000b"', '"../../x"', "[[[[[[]]]]]]"]
STRICT = [  # of the texts of packages, whose JSON is strict
    "1e400", "1e-400", "64", "65", "4096", "4097", "9007199254740993", "18446744073709551616",
    "3.5e38", "1e-40", "01", "1.", ".5", "1e", "[0]", "[0,3]", "[1,1,3]", "[1.5,1.5]", '{"a":1}',
    '"\\ud800"', '"\\ud83d\\ude00"', '"\\q"', '"float16"', '"int8"', '"float32"', '"fiber"',
    '"surface"', '"1.0"', '"1.1"', '"01.0"', '"F32"', '"U32"', '"VEC3"', '"SCALAR"', '"U8"',
    '"U16"', '"I16"', '"I32"', "5122", "5123", "5125", '"KHR_mesh_quantization"', '"hemisphere"',
    '"features"', '"h"', '"learned_normal"', '[{"axis":[0,1,0],"halfAngle":0.5}]', 80 * "[",
]  # fmt: skip
FLOATS = np.array([np.nan, np.inf, -np.inf, 1e30, -1e30, 1e18, 3e38, 1e-45, 0, -1, 0.5], np.float32)


def mutate(data: bytes, suffix: str, rng: np.random.Generator) -> bytes:
    """The file with a change that suits its kind, or a few."""
    changes = _CHANGES.get(suffix, [change_bytes])
    for _ in range(rng.geometric(0.7)):
        change = changes[rng.integers(len(changes))]
        data = change(data, rng)
    return data


Change = Callable[[bytes, np.random.Generator], bytes]


def change_bytes(data: bytes, rng: np.random.Generator) -> bytes:
    """Bytes set, removed, repeated, or a word of 32 bits replaced; or the file is cut."""
    if not data:
        return b"\0"
    at = int(rng.integers(len(data)))
    length = int(min(rng.geometric(0.2), len(data) - at))
    match rng.integers(7):
        case 0:
            return data[:at]
        case 1:
            return data[:at] + data[at + length :]
        case 2:
            return data[:at] + data[at : at + length] * 2 + data[at + length :]
        case 3:
            word = struct.pack("<I", [0, 1, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF][rng.integers(5)])
            return data[:at] + word + data[at + 4 :]
        case 4:
            word = FLOATS[rng.integers(len(FLOATS))].tobytes()
            at -= at % 4
            return data[:at] + word + data[at + 4 :]
        case 5:
            return data[:at] + bytes([data[at] ^ (1 << rng.integers(8))]) + data[at + 1 :]
    return data[:at] + rng.bytes(length) + data[at + length :]


_TOKEN = re.compile(rb'"[^"]*"|-?[0-9][0-9.eE+-]*')
_VALUES = [text.encode() for text in (*NUMBERS, *WORDS, *STRICT)] + [
    b'"\xc3\x28"',
    b'"\xed\xa0\x80"',
]


def change_text(data: bytes, rng: np.random.Generator) -> bytes:
    """A string or number of a strict text becomes another one; or members and bytes change."""
    tokens = [actual.span() for actual in _TOKEN.finditer(data)]
    kind = rng.integers(16)
    if not tokens or kind < 1:
        return change_bytes(data, rng)
    if kind < 4:
        return _change_json(data, rng)
    start, end = tokens[rng.integers(len(tokens))]
    if kind < 7:
        other = slice(*tokens[rng.integers(len(tokens))])
        return data[:start] + data[other] + data[end:]
    if kind < 11 and data[start:end].isdigit():  # sizes that nearly fit
        number = int(data[start:end])
        near = [number + 1, max(number - 1, 0), 2 * number, 3 * number, 4 * number, number // 2]
        near += [number + 3, number + 4, number + 12, number + 64]
        return data[:start] + str(near[rng.integers(len(near))]).encode() + data[end:]
    return data[:start] + _VALUES[rng.integers(len(_VALUES))] + data[end:]


def _change_number(data: bytes, rng: np.random.Generator) -> bytes:
    """A number of a text is replaced."""
    starts = [
        k for k in range(len(data)) if data[k : k + 1].isdigit() and not data[k - 1 : k].isalnum()
    ]
    if not starts:
        return data
    at = starts[rng.integers(len(starts))]
    end = at
    while end < len(data) and data[end : end + 1] in b"0123456789.eE+-":
        end += 1
    return data[:at] + NUMBERS[rng.integers(len(NUMBERS))].encode() + data[end:]


def _change_line(data: bytes, rng: np.random.Generator) -> bytes:
    """A line of a text is removed, repeated, moved, or loses a word."""
    lines = data.split(b"\n")
    at, to = rng.integers(len(lines), size=2)
    match rng.integers(4):
        case 0:
            del lines[at]
        case 1:
            lines.insert(to, lines[at])
        case 2:
            lines.insert(to, lines.pop(at))
        case 3:
            words = lines[at].split(b" ")
            del words[rng.integers(len(words))]
            lines[at] = b" ".join(words)
    return b"\n".join(lines)


def change_word(data: bytes, rng: np.random.Generator) -> bytes:
    """A word of 32 bits becomes an odd float, or another word of the data."""
    if len(data) < 4:
        return change_bytes(data, rng)
    at = 4 * int(rng.integers(len(data) // 4))
    to = 4 * int(rng.integers(len(data) // 4))
    odd = FLOATS[rng.integers(len(FLOATS))].tobytes()
    return data[:at] + (odd if rng.integers(2) else data[to : to + 4]) + data[at + 4 :]


def _change_json(data: bytes, rng: np.random.Generator) -> bytes:
    """A value anywhere in a JSON document is replaced, removed or repeated."""
    try:
        document = json.loads(data)
    except ValueError:
        return change_bytes(data, rng)
    places = list(_places(document))
    if not places:
        return data
    parent, key = places[rng.integers(len(places))]
    match rng.integers(6):
        case 0:
            del parent[key]
        case 1:
            parent[key] = json.loads(WORDS[rng.integers(len(WORDS))])
        case 2:
            other, its_key = places[rng.integers(len(places))]
            value = other[its_key] if its_key in _keys(other) else None
            parent[key] = json.loads(json.dumps(value))
        case _:
            parent[key] = json.loads(NUMBERS[rng.integers(len(NUMBERS))])
    return json.dumps(document).encode()


def _places(value: Any) -> list[tuple[Any, Any]]:
    actual = []
    for key in _keys(value):
        actual += [(value, key), *_places(value[key])]
    return actual


def _keys(value: Any) -> list[Any]:
    if isinstance(value, dict):
        return list(value)
    return list(range(len(value))) if isinstance(value, list) else []


def _change_buffer(data: bytes, rng: np.random.Generator) -> bytes:
    """A float of a glTF's own buffer is replaced, or bytes of it are changed."""
    try:
        buffer = json.loads(data)["buffers"][0]
        blob = base64.b64decode(buffer["uri"].removeprefix(PREFIX))
    except (ValueError, LookupError, AttributeError, TypeError):
        return change_bytes(data, rng)
    changed = bytearray(blob)
    for _ in range(rng.integers(1, 4)):
        if len(changed) >= 4:
            at = 4 * int(rng.integers(len(changed) // 4))
            changed[at : at + 4] = FLOATS[rng.integers(len(FLOATS))].tobytes()
    old, new = buffer["uri"], PREFIX + base64.b64encode(changed).decode()
    return data.replace(old.encode(), new.encode())


_TEXT: list[Change] = [_change_number, _change_number, _change_line, change_bytes]
_CHANGES: dict[str, list[Change]] = {
    ".gltf": [_change_json, _change_json, _change_buffer, change_bytes],
    ".glb": [change_bytes, _change_number],
    ".rnam": [_change_number, change_word, change_bytes],
    ".json": [_change_json, _change_json, change_text],
    ".obj": _TEXT,
    ".ply": _TEXT,
    ".yaml": _TEXT,
    ".hdr": [change_bytes, change_bytes, _change_number],
}
