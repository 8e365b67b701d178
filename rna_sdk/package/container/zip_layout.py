"""The ZIP records of the container, as fixed structs (PKWARE APPNOTE 6.3.10, section 4.3)."""

import struct
from typing import NamedTuple

LOCAL_MAGIC = 0x04034B50
CENTRAL_MAGIC = 0x02014B50
END_MAGIC = 0x06054B50

VERSION = 20
"""Version made by (high byte 0: MS-DOS) and version needed: 2.0."""

DOS_TIME = 0
DOS_DATE = 0x0021
"""1980-01-01, the first date that DOS can write."""

PADDING_ID = 0x4E52
"""Extra field of zeros that moves an entry's data to its boundary; bytes `R`, `N`."""

FLAG_ENCRYPTED = 0x0001
STORED = 0


class LocalHeader(NamedTuple):
    """Local file header; the name and the extra field follow, then the data."""

    magic: int
    version: int
    flags: int
    method: int
    time: int
    date: int
    crc: int
    stored_size: int
    size: int
    name_size: int
    extra_size: int


class CentralHeader(NamedTuple):
    """Central directory header; the name, the extra field and the comment follow."""

    magic: int
    made_by: int
    version: int
    flags: int
    method: int
    time: int
    date: int
    crc: int
    stored_size: int
    size: int
    name_size: int
    extra_size: int
    comment_size: int
    disk: int
    internal_attributes: int
    external_attributes: int
    offset: int


class EndRecord(NamedTuple):
    """End of central directory; the last bytes of the file, with no comment."""

    magic: int
    disk: int
    directory_disk: int
    entries_here: int
    entries: int
    directory_size: int
    directory_offset: int
    comment_size: int


def differing(
    found: LocalHeader | CentralHeader, expected: LocalHeader | CentralHeader
) -> tuple[str, str]:
    """The members in which two headers differ, in words, as found and as expected."""
    names = [name for name in found._fields if getattr(found, name) != getattr(expected, name)]
    texts = [
        ", ".join(f"{name.replace('_', ' ')} {getattr(header, name)}" for name in names)
        for header in (found, expected)
    ]
    return texts[0], texts[1]


FIXED_CENTRAL = {
    "made_by": VERSION,
    "version": VERSION,
    "flags": 0,
    "method": STORED,
    "time": DOS_TIME,
    "date": DOS_DATE,
    "disk": 0,
    "internal_attributes": 0,
    "external_attributes": 0,
}
"""Members of every CentralHeader that never vary."""

LOCAL = struct.Struct("<IHHHHHIIIHH")
CENTRAL = struct.Struct("<IHHHHHHIIIHHHHHII")
END = struct.Struct("<IHHHHIIH")
EXTRA = struct.Struct("<HH")


def padding(header_offset: int, name_size: int, alignment: int) -> bytes:
    """Extra field for a local header at `header_offset`, so that its data is aligned.

    Returns nothing where the data is aligned already.
    """
    missing = -(header_offset + LOCAL.size + name_size) % alignment
    if missing == 0:
        return b""
    if missing < EXTRA.size:
        missing += alignment
    return padding_field(missing)


def padding_field(size: int) -> bytes:
    """The padding extra field of `size` bytes in all, at least 4."""
    return EXTRA.pack(PADDING_ID, size - EXTRA.size) + bytes(size - EXTRA.size)
