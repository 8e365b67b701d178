"""The header and the chunks of a binary glTF (glTF 2.0, 4.4)."""

import struct

MAGIC = b"glTF"
CHUNK_JSON = b"JSON"
CHUNK_BIN = b"BIN\0"
HEADER = struct.Struct("<4sII")
CHUNK = struct.Struct("<I4s")


def pack_glb(document: bytes, blob: bytes) -> bytes:
    """A .glb of a JSON chunk and a binary chunk, each padded to 4 bytes (glTF 2.0, 4.4)."""
    document += b" " * (-len(document) % 4)
    blob += bytes(-len(blob) % 4)
    size = HEADER.size + 2 * CHUNK.size + len(document) + len(blob)
    return b"".join(
        (
            HEADER.pack(MAGIC, 2, size),
            CHUNK.pack(len(document), CHUNK_JSON),
            document,
            CHUNK.pack(len(blob), CHUNK_BIN),
            blob,
        )
    )
