"""Write the container: a ZIP of stored, aligned entries, with nothing that varies."""

import struct
import zlib
from collections.abc import Iterable
from typing import BinaryIO

from rna_sdk.package.container import zip_layout as z
from rna_sdk.package.limits import ALIGNMENT

_COMMON = struct.Struct("<HHHHHIIIH")
"""Fields that the local and the central record of an entry share, from the version needed on."""


def write_container(file: BinaryIO, entries: Iterable[tuple[str, bytes]]) -> None:
    """Write `entries`, (name, data) in this order, to a file that stands at offset 0.

    The same entries give the same bytes. Names and sizes are the caller's to check.
    """
    directory = b""
    offset = count = 0
    for name, data in entries:
        name_bytes = name.encode("ascii")
        extra = z.padding(offset, len(name_bytes), ALIGNMENT)
        both = _COMMON.pack(
            z.VERSION,
            0,
            z.STORED,
            z.DOS_TIME,
            z.DOS_DATE,
            zlib.crc32(data),
            len(data),
            len(data),
            len(name_bytes),
        )
        local = z.LOCAL_MAGIC.to_bytes(4, "little") + both + len(extra).to_bytes(2, "little")
        local += name_bytes + extra
        directory += struct.pack("<IH", z.CENTRAL_MAGIC, z.VERSION) + both
        directory += struct.pack("<HHHHII", 0, 0, 0, 0, 0, offset) + name_bytes
        file.write(local)
        file.write(data)
        offset += len(local) + len(data)
        count += 1
    file.write(directory)
    file.write(z.END.pack(z.END_MAGIC, 0, 0, count, count, len(directory), offset, 0))
