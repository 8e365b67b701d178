"""Read the container: a hostile ZIP, checked record by record, in memory."""

import os
import re
import stat
import zlib
from dataclasses import dataclass
from os import PathLike

import numpy as np

from rna_sdk.errors import PackageError
from rna_sdk.package.container import zip_layout as z
from rna_sdk.package.container.zipped_again import explained
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import (
    ALIGNMENT,
    MAX_ENTRIES,
    MAX_FILE_BYTES,
    MAX_MANIFEST_BYTES,
    MAX_NAME_BYTES,
)

MANIFEST_NAME = "manifest.json"

NAME_PATTERN = r"[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*"
"""Relative ASCII paths; no part is empty or starts with a dot."""


@dataclass(frozen=True)
class Entry:
    """One stored entry: `size` bytes at byte `offset` of the file."""

    name: str
    header_offset: int
    offset: int
    size: int
    crc: int


class Container:
    """The entries of a `.rna` file.

    Attributes:
        data: the bytes of the file, read-only.
        entries: name -> Entry, in the order of their bytes in the file.
    """

    def __init__(self, data: memoryview, entries: dict[str, Entry]) -> None:
        self._decoded: dict[str, memoryview] = {}
        self.data, self.entries = data, entries

    @classmethod
    def of(cls, data: memoryview, path: str | PathLike[str]) -> "Container":
        """Check every ZIP record in the bytes of a `.rna`; the entries' data is not read.

        path: of the file that they are from.

        Raises:
            PackageError: with the first ZIP_* issue found.
        """
        try:
            entries = _read_entries(data)
        except PackageError as error:
            raise explained(error, path, MANIFEST_NAME) from None
        return cls(data, {entry.name: entry for entry in entries})

    def view(self, name: str) -> memoryview:
        """The read-only bytes of an entry: in place, or from `put_decoded`."""
        return self._decoded[name] if name in self._decoded else self.stored(name)

    def put_decoded(self, name: str, data: bytes) -> None:
        """Stores the decoded bytes of a coded entry, which `view` returns from now on."""
        self._decoded[name] = memoryview(data)

    def stored(self, name: str) -> memoryview:
        """The read-only bytes of an entry as they are in the file."""
        entry = self.entries[name]
        return self.data[entry.offset : entry.offset + entry.size]

    def place(self, name: str) -> int | None:
        """Where the bytes of `view` start in `data`; None for a coded entry."""
        return None if name in self._decoded else self.entries[name].offset

    def check_crc(self, name: str) -> None:
        """Raises PackageError (ZIP_CRC) where the data differs from its header."""
        entry = self.entries[name]
        crc = zlib.crc32(self.stored(name))
        if crc != entry.crc:
            refuse(Code.ZIP_CRC, entry.offset, f"{name}: {crc:08x}", f"{entry.crc:08x}")


def read_file(path: str | PathLike[str]) -> memoryview:
    """The bytes of a file, aligned as in it; mapped, they would change with it, or be gone.

    Raises:
        PackageError: with a FILE_* issue.
    """
    try:
        mode = os.stat(path).st_mode  # to open a pipe would wait for a writer
        if not stat.S_ISREG(mode):
            found = "a folder" if stat.S_ISDIR(mode) else "a pipe or a device"
            refuse(Code.FILE_UNREADABLE, 0, found, "a file")
        with open(path, "rb") as file:
            size = file.seek(0, 2)
            if size == 0:
                refuse(Code.FILE_EMPTY, 0, "0 bytes", "a ZIP archive")
            if size > MAX_FILE_BYTES:
                refuse(Code.FILE_TOO_LARGE, 0, f"{size} bytes", f"at most {MAX_FILE_BYTES}")
            file.seek(0)
            buffer = np.empty(size + ALIGNMENT, np.uint8)
            start = -buffer.ctypes.data % ALIGNMENT
            data = buffer[start : start + size].data
            return data[: file.readinto(data)].toreadonly()
    except OSError as error:
        refuse(Code.FILE_UNREADABLE, 0, error.strerror or error, "a readable file")
    except ValueError as error:  # of a NUL in the path
        refuse(Code.FILE_UNREADABLE, 0, error, "a path")


def _read_entries(data: memoryview) -> list[Entry]:
    """The entries in the order of their bytes, every ZIP record checked."""
    headers, directory_offset = _read_directory(data)
    entries = [_read_local(data, header, name, directory_offset) for header, name in headers]
    entries.sort(key=lambda entry: entry.header_offset)
    _check_layout(entries, directory_offset)
    return entries


def _read_directory(data: memoryview) -> tuple[list[tuple[z.CentralHeader, str]], int]:
    """The central headers with their names, and where the directory starts."""
    end_offset = len(data) - z.END.size
    if end_offset < 0 or bytes(data[end_offset : end_offset + 4]) != b"PK\x05\x06":
        starts_well = bytes(data[:4]) == b"PK\x03\x04"
        code = Code.ZIP_TRUNCATED if starts_well else Code.ZIP_NOT_ZIP
        refuse(code, max(end_offset, 0), "no end record", "an end record as the last 22 bytes")
    end = z.EndRecord(*z.END.unpack_from(data, end_offset))
    if 0xFFFF in (end.entries, end.disk) or end.disk or end.directory_disk:
        found = f"{end.entries} entries, disk {end.disk} and {end.directory_disk}"
        refuse(Code.ZIP_ZIP64, end_offset, found, "one disk, no ZIP64")
    if end.entries > MAX_ENTRIES:
        refuse(Code.ZIP_TOO_MANY, end_offset, end.entries, f"at most {MAX_ENTRIES}")
    whole = end.directory_offset + end.directory_size == end_offset
    if not whole or end.comment_size or end.entries_here != end.entries:
        found = (
            f"{end.directory_size} bytes at {end.directory_offset}, {end.entries_here} of "
            f"{end.entries} entries, a comment of {end.comment_size} bytes"
        )
        expected = f"a directory that ends at {end_offset}, with all entries and no comment"
        refuse(Code.ZIP_DIRECTORY, end_offset, found, expected)

    headers: list[tuple[z.CentralHeader, str]] = []
    seen: set[str] = set()
    offset = end.directory_offset
    for _ in range(end.entries):
        header, name, offset = _read_central(data, offset, end_offset)
        if name.lower() in seen:
            refuse(Code.ZIP_DUPLICATE, offset, name, "each name once")
        seen.add(name.lower())
        headers.append((header, name))
    if offset != end_offset:
        refuse(Code.ZIP_DIRECTORY, offset, f"{end_offset - offset} bytes more", "the end record")
    return headers, end.directory_offset


def _read_central(
    data: memoryview, offset: int, end_offset: int
) -> tuple[z.CentralHeader, str, int]:
    """The central header at `offset`, its name, and the offset behind it."""
    if offset + z.CENTRAL.size > end_offset:
        refuse(Code.ZIP_DIRECTORY, offset, "a header cut short", "a central header")
    header = z.CentralHeader(*z.CENTRAL.unpack_from(data, offset))
    if header.magic != z.CENTRAL_MAGIC or header.extra_size or header.comment_size:
        sizes = f"{header.extra_size} and {header.comment_size} bytes behind the name"
        found = f"signature {header.magic:#010x}, {sizes}"
        refuse(Code.ZIP_DIRECTORY, offset, found, "a central header, no extra field or comment")
    if 0xFFFFFFFF in (header.size, header.stored_size, header.offset):
        refuse(Code.ZIP_ZIP64, offset, "0xffffffff", "sizes and offsets below 4 GiB")
    if header.flags & z.FLAG_ENCRYPTED:
        refuse(Code.ZIP_ENCRYPTED, offset, f"flags {header.flags:#06x}", "flags 0")
    fixed = header._replace(**z.FIXED_CENTRAL)
    if header != fixed._replace(method=header.method):
        refuse(Code.ZIP_HEADER, offset, *z.differing(header, fixed))
    if header.method != z.STORED:
        refuse(Code.ZIP_COMPRESSED, offset, f"method {header.method}", "method 0 (stored)")
    if header.size != header.stored_size:
        refuse(Code.ZIP_SIZE, offset, f"{header.stored_size} and {header.size}", "equal sizes")

    name_offset = offset + z.CENTRAL.size
    behind = name_offset + header.name_size
    if behind > end_offset:
        refuse(Code.ZIP_DIRECTORY, offset, "a name cut short", "a name inside the directory")
    return header, _check_name(bytes(data[name_offset:behind]), name_offset), behind


def _check_name(raw: bytes, offset: int) -> str:
    name = raw.decode("ascii", errors="replace")
    if len(raw) > MAX_NAME_BYTES or not re.fullmatch(NAME_PATTERN, name):
        refuse(Code.ZIP_NAME, offset, repr(raw), f"a match of {NAME_PATTERN}")
    return name


def _read_local(
    data: memoryview, central: z.CentralHeader, name: str, directory_offset: int
) -> Entry:
    """The entry at a central header, after checking that the local header agrees."""
    start = central.offset
    if start + z.LOCAL.size > directory_offset:
        refuse(Code.ZIP_TRUNCATED, start, f"{name}: a header cut short", "a local header")
    local = z.LocalHeader(*z.LOCAL.unpack_from(data, start))
    name_offset = start + z.LOCAL.size
    extra_offset = name_offset + local.name_size
    data_offset = extra_offset + local.extra_size
    if data_offset + central.size > directory_offset:
        found = f"{name}: {central.size} bytes at {data_offset}"
        refuse(Code.ZIP_TRUNCATED, start, found, f"an end at or before {directory_offset}")

    wanted = z.LocalHeader(z.LOCAL_MAGIC, *central[2:11], local.extra_size)
    if local != wanted:
        refuse(Code.ZIP_LOCAL_HEADER, start, *z.differing(local, wanted))
    own_name = bytes(data[name_offset:extra_offset])
    if own_name != name.encode("ascii"):
        refuse(Code.ZIP_LOCAL_HEADER, start, repr(own_name[:80]), name)
    extra = bytes(data[extra_offset:data_offset])
    if extra and (len(extra) < z.EXTRA.size or extra != z.padding_field(len(extra))):
        refuse(Code.ZIP_EXTRA, extra_offset, extra[:16].hex(), f"zeros in field {z.PADDING_ID:#x}")
    if data_offset % ALIGNMENT:
        refuse(Code.ZIP_ALIGNMENT, data_offset, f"{name} at {data_offset}", "a multiple of 64")
    if name == MANIFEST_NAME and central.size > MAX_MANIFEST_BYTES:
        expected = f"at most {MAX_MANIFEST_BYTES}"
        refuse(Code.MANIFEST_TOO_LARGE, start, f"{central.size} bytes", expected)
    return Entry(name, start, data_offset, central.size, central.crc)


def _check_layout(entries: list[Entry], directory_offset: int) -> None:
    """Entries, sorted by offset, follow each other with no overlap and no gap."""
    behind = 0
    for entry in entries:
        _check_adjacent(behind, entry.header_offset, entry.name)
        behind = entry.offset + entry.size
    _check_adjacent(behind, directory_offset, "the central directory")
    if not entries or entries[0].name != MANIFEST_NAME:
        first = entries[0].name if entries else "no entry"
        refuse(Code.ZIP_ORDER, 0, first, MANIFEST_NAME)


def _check_adjacent(behind: int, start: int, what: str) -> None:
    if start < behind:
        refuse(Code.ZIP_OVERLAP, start, f"{what} at {start}", f"at {behind}")
    if start > behind:
        refuse(Code.ZIP_GAP, behind, f"{start - behind} bytes before {what}", "none")
