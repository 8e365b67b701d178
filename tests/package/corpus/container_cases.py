"""Files whose ZIP container is wrong."""

from __future__ import annotations

from typing import Any
from unittest import mock

from rna_sdk.package.container import zip_layout as z
from tests.package.builders import pack
from tests.package.corpus.registry import DECODER, MESH, PLANES, Entries, case

HIDDEN = bytes(range(64))


def read_end(data: bytes) -> z.EndRecord:
    return z.EndRecord(*z.END.unpack_from(data, len(data) - z.END.size))


def patch_end(data: bytes, **changes: int) -> bytes:
    return data[: -z.END.size] + z.END.pack(*read_end(data)._replace(**changes))


def patch_entry(data: bytes, name: str, where: str, **changes: Any) -> bytes:
    """Change members of an entry's headers; `where`: "local", "central" or "both"."""
    result = bytearray(data)
    offset = read_end(data).directory_offset
    while True:
        central = z.CentralHeader(*z.CENTRAL.unpack_from(data, offset))
        start = offset + z.CENTRAL.size
        if data[start : start + central.name_size] == name.encode():
            break
        offset = start + central.name_size
    if where in ("central", "both"):
        z.CENTRAL.pack_into(result, offset, *central._replace(**changes))
    if where in ("local", "both"):
        local = z.LocalHeader(*z.LOCAL.unpack_from(data, central.offset))
        z.LOCAL.pack_into(result, central.offset, *local._replace(**changes))
    return bytes(result)


def with_extra_entry(entries: Entries, name: str) -> bytes:
    return pack([*entries.items(), (name, b"data")])


@case("FILE_EMPTY")
def empty_file(entries: Entries) -> bytes:
    return b""


@case("ZIP_NOT_ZIP")
def not_a_zip(entries: Entries) -> bytes:
    return b"\x93NUMPY" + bytes(500)


@case("ZIP_NOT_ZIP")
def shorter_than_an_end_record(entries: Entries) -> bytes:
    return b"PK"


@case("ZIP_TRUNCATED")
def truncated(entries: Entries) -> bytes:
    return pack(entries.items())[:-100]


@case("ZIP_TRUNCATED")
def bytes_behind_the_end(entries: Entries) -> bytes:
    return pack(entries.items()) + bytes(10)


@case("ZIP_TRUNCATED")
def declared_size_of_gigabytes(entries: Entries) -> bytes:
    size = 3 * 2**30
    return patch_entry(pack(entries.items()), MESH, "both", size=size, stored_size=size)


@case("ZIP_TRUNCATED")
def header_offset_past_the_end(entries: Entries) -> bytes:
    return patch_entry(pack(entries.items()), MESH, "central", offset=2**31)


@case("ZIP_DIRECTORY")
def bytes_cut_from_the_middle(entries: Entries) -> bytes:
    data = pack(entries.items())
    return data[:3000] + data[3064:]


@case("ZIP_DIRECTORY")
def directory_longer_than_its_count(entries: Entries) -> bytes:
    data = pack(entries.items())
    count = read_end(data).entries - 1
    return patch_end(data, entries=count, entries_here=count)


@case("ZIP_DIRECTORY")
def directory_shorter_than_its_count(entries: Entries) -> bytes:
    data = pack(entries.items())
    count = read_end(data).entries + 1
    return patch_end(data, entries=count, entries_here=count)


@case("ZIP_DIRECTORY")
def archive_comment(entries: Entries) -> bytes:
    return patch_end(pack(entries.items()), comment_size=22)


@case("ZIP_DIRECTORY")
def name_past_the_directory(entries: Entries) -> bytes:
    return patch_entry(pack(entries.items()), DECODER, "central", name_size=60000)


@case("ZIP_ZIP64")
def zip64_count(entries: Entries) -> bytes:
    return patch_end(pack(entries.items()), entries=0xFFFF, entries_here=0xFFFF)


@case("ZIP_ZIP64")
def zip64_size(entries: Entries) -> bytes:
    size = 0xFFFFFFFF
    return patch_entry(pack(entries.items()), MESH, "both", size=size, stored_size=size)


@case("ZIP_TOO_MANY")
def too_many_entries(entries: Entries) -> bytes:
    return pack([*entries.items(), *((f"more/{i}", b"") for i in range(300))])


@case("ZIP_ENCRYPTED")
def encrypted_entry(entries: Entries) -> bytes:
    return patch_entry(pack(entries.items()), MESH, "both", flags=1)


@case("ZIP_HEADER")
def data_descriptor(entries: Entries) -> bytes:
    return patch_entry(pack(entries.items()), MESH, "both", flags=8)


@case("ZIP_HEADER")
def symbolic_link(entries: Entries) -> bytes:
    attributes = 0o120777 << 16
    return patch_entry(pack(entries.items()), MESH, "central", external_attributes=attributes)


@case("ZIP_COMPRESSED")
def compressed_entry(entries: Entries) -> bytes:
    return patch_entry(pack(entries.items()), MESH, "both", method=8)


@case("ZIP_SIZE")
def bomb_like_size(entries: Entries) -> bytes:
    return patch_entry(pack(entries.items()), MESH, "both", size=2**31)


@case("ZIP_NAME")
def parent_folder(entries: Entries) -> bytes:
    return with_extra_entry(entries, "features/../../evil")


@case("ZIP_NAME")
def absolute_path(entries: Entries) -> bytes:
    return with_extra_entry(entries, "/etc/evil")


@case("ZIP_NAME")
def backslash_path(entries: Entries) -> bytes:
    return with_extra_entry(entries, "features\\evil")


@case("ZIP_NAME")
def drive_path(entries: Entries) -> bytes:
    return with_extra_entry(entries, "C:/evil")


@case("ZIP_NAME")
def folder_entry(entries: Entries) -> bytes:
    return with_extra_entry(entries, "features/")


@case("ZIP_NAME")
def name_with_newline(entries: Entries) -> bytes:
    return with_extra_entry(entries, "evil\n")


@case("ZIP_NAME")
def name_too_long(entries: Entries) -> bytes:
    return with_extra_entry(entries, "x" * 201)


@case("ZIP_DUPLICATE")
def duplicate_name(entries: Entries) -> bytes:
    return with_extra_entry(entries, MESH)


@case("ZIP_DUPLICATE")
def duplicate_but_for_case(entries: Entries) -> bytes:
    return with_extra_entry(entries, MESH.upper())


@case("ZIP_LOCAL_HEADER")
def local_size_differs(entries: Entries) -> bytes:
    return patch_entry(pack(entries.items()), MESH, "local", size=10)


@case("ZIP_LOCAL_HEADER")
def local_name_differs(entries: Entries) -> bytes:
    data = pack(entries.items())
    start = data.rindex(MESH.encode(), 0, read_end(data).directory_offset)
    return data[:start] + b"X" + data[start + 1 :]


@case("ZIP_EXTRA")
def bytes_hidden_in_the_padding(entries: Entries) -> bytes:
    data = bytearray(pack(entries.items()))
    data[data.index(b"manifest.json") + len("manifest.json") + z.EXTRA.size] = 1
    return bytes(data)


@case("ZIP_OVERLAP")
def entry_inside_another(entries: Entries) -> bytes:
    """The decoder's header and data lie within the data of the planes' neighbour."""
    inner = pack([("x", entries[DECODER])])
    inner_local = inner[: read_end(inner).directory_offset]
    data = pack([*entries.items(), ("outer", inner_local)])
    end = read_end(data)
    start = data.rindex(inner_local)
    central = z.CentralHeader(*z.CENTRAL.unpack_from(inner, len(inner_local)))
    record = z.CENTRAL.pack(*central._replace(offset=start)) + b"x"
    return patch_end(
        data[: -z.END.size] + record + data[-z.END.size :],
        entries=end.entries + 1,
        entries_here=end.entries + 1,
        directory_size=end.directory_size + len(record),
    )


@case("ZIP_GAP")
def bytes_between_the_entries_and_the_directory(entries: Entries) -> bytes:
    data = pack(entries.items())
    offset = read_end(data).directory_offset
    return patch_end(data[:offset] + HIDDEN + data[offset:], directory_offset=offset + len(HIDDEN))


@case("ZIP_ALIGNMENT")
def unaligned_entry(entries: Entries) -> bytes:
    with mock.patch("rna_sdk.package.container.zip_writer.ALIGNMENT", 4):
        return pack(entries.items())


@case("ZIP_ORDER")
def manifest_not_first(entries: Entries) -> bytes:
    return pack(reversed(entries.items()))


@case("ZIP_ORDER")
def no_manifest(entries: Entries) -> bytes:
    return pack([(MESH, entries[MESH])])


@case("ZIP_ORDER")
def no_entries(entries: Entries) -> bytes:
    return pack([])


@case("ZIP_CRC")
def wrong_crc(entries: Entries) -> bytes:
    return patch_entry(pack(entries.items()), MESH, "both", crc=0x12345678)


@case("ZIP_CRC")
def one_damaged_byte(entries: Entries) -> bytes:
    """Neither CRC-32 nor SHA-256 is that of the data."""
    data, planes = pack(entries.items()), entries[PLANES]
    at = data.index(planes) + len(planes) - 5
    return data[:at] + bytes([data[at] ^ 1]) + data[at + 1 :]


@case("ZIP_CRC")
def one_damaged_byte_of_the_manifest(entries: Entries) -> bytes:
    """It is no JSON either."""
    return pack(entries.items()).replace(b'"format"', b'"for\x00at"', 1)


@case("ZIP_CRC")
def wrong_crc_of_the_manifest(entries: Entries) -> bytes:
    return patch_entry(pack(entries.items()), "manifest.json", "both", crc=0x12345678)
