"""Mutations of packages: of one entry, most with sizes and hashes that fit again, or of the ZIP."""

import hashlib
import json
import re
import struct
from functools import cache
from pathlib import Path

import numpy as np

from rna_sdk.package.container.zip_container import MANIFEST_NAME
from tests.fuzz.mutations import change_bytes, change_text, change_word
from tests.package.builders import pack, read_entries

_entries = cache(read_entries)

VARINTS = [0, 1, 2, 3, 6, 7, 10, 11, 13, 21, 127, 128, 8192]
VARINTS += [2**31 - 1, 2**31, 2**32 - 1, 2**63 - 1, 2**64 - 1]
_STRAY = 16  # one of so many keeps a length or a hash that is wrong


def mutation(packages: list[Path], number: int) -> bytes:
    """Mutation `number`, of package number % len(packages)."""
    rng = np.random.default_rng(number)
    entries = dict(_entries(packages[number % len(packages)]))
    kind = rng.integers(_STRAY)
    if kind == 0:
        return change_bytes(pack(entries.items()), rng)
    name = list(entries)[rng.integers(len(entries))] if rng.integers(4) else MANIFEST_NAME
    for _ in range(rng.geometric(0.7)):
        entries[name] = _change_entry(name, entries[name], rng)
    if name != MANIFEST_NAME and kind > 1:
        record = {"sha256": hashlib.sha256(entries[name]).hexdigest(), "size": len(entries[name])}
        manifest = json.loads(entries[MANIFEST_NAME])
        manifest["entries"][name] |= record
        entries[MANIFEST_NAME] = json.dumps(manifest).encode()
    return pack(entries.items())


def _change_entry(name: str, data: bytes, rng: np.random.Generator) -> bytes:
    if name.endswith(".json"):
        return change_text(data, rng)
    if name.endswith(".onnx"):
        return _change_message(data, rng)
    if name.endswith(".glb"):
        return _change_glb(data, rng)
    return _change_tensors(data, rng) if name.endswith(".safetensors") else change_bytes(data, rng)


def _change_glb(data: bytes, rng: np.random.Generator) -> bytes:
    length = int.from_bytes(data[12:16], "little")
    if rng.integers(_STRAY) == 0 or len(data) < length + 28:
        return change_bytes(data[:64], rng) + data[64:]
    text, blob = data[20 : 20 + length], data[length + 28 :]
    if rng.integers(3) == 0:
        text = change_text(text, rng)
        text += b" " * (-len(text) % 4)
    else:
        blob = _change_values(blob, rng)
    sizes = struct.pack("<I", len(blob)), struct.pack("<I", len(text))
    whole = struct.pack("<I", 28 + len(text) + len(blob))
    return data[:8] + whole + sizes[1] + b"JSON" + text + sizes[0] + b"BIN\0" + blob


def _change_tensors(data: bytes, rng: np.random.Generator) -> bytes:
    length = int.from_bytes(data[:8], "little")
    if rng.integers(_STRAY) == 0 or len(data) < 8 + length:
        return change_bytes(data[:64], rng) + data[64:]
    text, values = data[8 : 8 + length], data[8 + length :]
    if rng.integers(3):
        return data[: 8 + length] + _change_values(values, rng)
    text = change_text(text.rstrip(b" "), rng)
    text += b" " * (-(8 + len(text)) % 64)
    return struct.pack("<Q", len(text)) + text + values


def _change_values(data: bytes, rng: np.random.Generator) -> bytes:
    return change_word(data, rng) if rng.integers(3) else change_bytes(data, rng)


Field = tuple[int, bytes]
"""A field of a protobuf message: its tag, and the bytes of a varint or of a length."""


def _change_message(data: bytes, rng: np.random.Generator, depth: int = 0) -> bytes:
    """A protobuf message with one field, of it or of a message in it, changed."""
    fields = _fields(data)
    if not fields:
        return change_bytes(data, rng)
    sizes = np.array([8 + len(value) for _, value in fields])  # most of what is large
    at = int(rng.choice(len(fields), p=sizes / sizes.sum()))
    tag, value = fields[at]
    action = rng.integers(16)
    if action == 0:
        del fields[at]
    elif action == 1:
        fields.insert(at, fields[at])
    elif action == 2:
        fields[at] = tag ^ (8 << int(rng.integers(4))), value
    elif tag & 7 == 0:
        fields[at] = tag, _varint(VARINTS[rng.integers(len(VARINTS))])
    elif depth < 6 and _fields(value):
        fields[at] = tag, _change_message(value, rng, depth + 1)
    else:
        fields[at] = tag, change_bytes(value, rng)
    return b"".join(
        _varint(tag) + (value if tag & 7 == 0 else _varint(len(value)) + value)
        for tag, value in fields
    )


def _fields(data: bytes) -> list[Field]:
    """Fields of varints and lengths; none where the bytes are no such message."""
    fields, at = [], 0
    while at < len(data):
        tag, at = _read_varint(data, at)
        start = at
        value, at = _read_varint(data, at)
        if tag & 7 == 2:
            start, at = at, at + value
        if tag & 7 not in (0, 2) or tag < 8 or at > len(data):
            return []
        fields.append((tag, data[start:at]))
    return fields


_VARINT = re.compile(rb"[\x80-\xff]{0,9}[\x00-\x7f]")


def _read_varint(data: bytes, at: int) -> tuple[int, int]:
    """Its value and where it ends, which is past the data where there is none."""
    actual = _VARINT.match(data, at)
    if actual is None:
        return 0, len(data) + 1
    return sum((byte & 127) << (7 * k) for k, byte in enumerate(actual[0])), actual.end()


def _varint(value: int) -> bytes:
    out = bytearray()
    while value > 127:
        out.append(value & 127 | 128)
        value >>= 7
    return bytes([*out, value])
