"""Files whose ZIP container is wrong."""

from typing import Any
from unittest import mock

from rna_sdk.package.container import zip_layout as z
from tests.package.builders import pack
from tests.package.corpus.registry import DECODER, MESH, PLANES, Corpus, Entries

CASES = Corpus("surface")


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


CASES.add("FILE_EMPTY", empty_file=lambda _: b"")
CASES.add(
    "ZIP_NOT_ZIP",
    not_a_zip=lambda _: b"\x93NUMPY" + bytes(500),
    shorter_than_an_end_record=lambda _: b"PK",
)
CASES.add(
    "ZIP_TRUNCATED",
    truncated=lambda e: pack(e.items())[:-100],
    bytes_behind_the_end=lambda e: pack(e.items()) + bytes(10),
    declared_size_of_gigabytes=lambda e: patch_entry(
        pack(e.items()), MESH, "both", size=3 * 2**30, stored_size=3 * 2**30
    ),
    header_offset_past_the_end=lambda e: patch_entry(
        pack(e.items()), MESH, "central", offset=2**31
    ),
)


@CASES.case("ZIP_DIRECTORY")
def bytes_cut_from_the_middle(entries: Entries) -> bytes:
    data = pack(entries.items())
    return data[:3000] + data[3064:]


@CASES.case("ZIP_DIRECTORY")
def directory_longer_than_its_count(entries: Entries) -> bytes:
    data = pack(entries.items())
    count = read_end(data).entries - 1
    return patch_end(data, entries=count, entries_here=count)


@CASES.case("ZIP_DIRECTORY")
def directory_shorter_than_its_count(entries: Entries) -> bytes:
    data = pack(entries.items())
    count = read_end(data).entries + 1
    return patch_end(data, entries=count, entries_here=count)


CASES.add(
    "ZIP_DIRECTORY",
    archive_comment=lambda e: patch_end(pack(e.items()), comment_size=22),
    central_header_of_another_signature=lambda e: patch_entry(
        pack(e.items()), MESH, "central", magic=z.CENTRAL_MAGIC + 1
    ),
    name_past_the_directory=lambda e: patch_entry(
        pack(e.items()), DECODER, "central", name_size=60000
    ),
)
CASES.add(
    "ZIP_ZIP64",
    zip64_count=lambda e: patch_end(pack(e.items()), entries=0xFFFF, entries_here=0xFFFF),
    zip64_size=lambda e: patch_entry(
        pack(e.items()), MESH, "both", size=0xFFFFFFFF, stored_size=0xFFFFFFFF
    ),
)
CASES.add(
    "ZIP_TOO_MANY",
    too_many_entries=lambda e: pack([*e.items(), *((f"more/{i}", b"") for i in range(300))]),
)
CASES.add(
    "ZIP_ENCRYPTED", encrypted_entry=lambda e: patch_entry(pack(e.items()), MESH, "both", flags=1)
)
CASES.add(
    "ZIP_HEADER", data_descriptor=lambda e: patch_entry(pack(e.items()), MESH, "both", flags=8)
)


@CASES.case("ZIP_HEADER")
def symbolic_link(entries: Entries) -> bytes:
    attributes = 0o120777 << 16
    return patch_entry(pack(entries.items()), MESH, "central", external_attributes=attributes)


CASES.add(
    "ZIP_COMPRESSED",
    compressed_entry=lambda e: patch_entry(pack(e.items()), MESH, "both", method=8),
)
CASES.add(
    "ZIP_SIZE", bomb_like_size=lambda e: patch_entry(pack(e.items()), MESH, "both", size=2**31)
)
CASES.add(
    "ZIP_NAME",
    parent_folder=lambda e: with_extra_entry(e, "features/../../evil"),
    absolute_path=lambda e: with_extra_entry(e, "/etc/evil"),
    backslash_path=lambda e: with_extra_entry(e, "features\\evil"),
    drive_path=lambda e: with_extra_entry(e, "C:/evil"),
    folder_entry=lambda e: with_extra_entry(e, "features/"),
    name_with_newline=lambda e: with_extra_entry(e, "evil\n"),
    name_too_long=lambda e: with_extra_entry(e, "x" * 201),
)
CASES.add(
    "ZIP_DUPLICATE",
    duplicate_name=lambda e: with_extra_entry(e, MESH),
    duplicate_but_for_case=lambda e: with_extra_entry(e, MESH.upper()),
)
CASES.add(
    "ZIP_LOCAL_HEADER",
    local_size_differs=lambda e: patch_entry(pack(e.items()), MESH, "local", size=10),
)


@CASES.case("ZIP_LOCAL_HEADER")
def local_name_differs(entries: Entries) -> bytes:
    data = pack(entries.items())
    start = data.rindex(MESH.encode(), 0, read_end(data).directory_offset)
    return data[:start] + b"X" + data[start + 1 :]


@CASES.case("ZIP_EXTRA")
def bytes_hidden_in_the_padding(entries: Entries) -> bytes:
    data = bytearray(pack(entries.items()))
    data[data.index(b"manifest.json") + len("manifest.json") + z.EXTRA.size] = 1
    return bytes(data)


@CASES.case("ZIP_OVERLAP")
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


@CASES.case("ZIP_GAP")
def bytes_between_the_entries_and_the_directory(entries: Entries) -> bytes:
    data = pack(entries.items())
    offset = read_end(data).directory_offset
    return patch_end(data[:offset] + HIDDEN + data[offset:], directory_offset=offset + len(HIDDEN))


@CASES.case("ZIP_ALIGNMENT")
def unaligned_entry(entries: Entries) -> bytes:
    with mock.patch("rna_sdk.package.container.zip_writer.ALIGNMENT", 4):
        return pack(entries.items())


CASES.add(
    "ZIP_ORDER",
    manifest_not_first=lambda e: pack(reversed(e.items())),
    no_manifest=lambda e: pack([(MESH, e[MESH])]),
    no_entries=lambda _: pack([]),
)


@CASES.case("ZIP_CRC")
def wrong_crc(entries: Entries) -> bytes:
    return patch_entry(pack(entries.items()), MESH, "both", crc=0x12345678)


@CASES.case("ZIP_CRC")
def one_damaged_byte(entries: Entries) -> bytes:
    """Neither CRC-32 nor SHA-256 is that of the data."""
    data, planes = pack(entries.items()), entries[PLANES]
    at = data.index(planes) + len(planes) - 5
    return data[:at] + bytes([data[at] ^ 1]) + data[at + 1 :]


@CASES.case("ZIP_CRC")
def one_damaged_byte_of_the_manifest(entries: Entries) -> bytes:
    """It is no JSON either."""
    return pack(entries.items()).replace(b'"format"', b'"for\x00at"', 1)


CASES.add(
    "ZIP_CRC",
    wrong_crc_of_the_manifest=lambda e: patch_entry(
        pack(e.items()), "manifest.json", "both", crc=0x12345678
    ),
)
