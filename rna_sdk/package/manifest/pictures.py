"""Pictures in packages: the size in the header of a PNG (PNG specification, 11.2.2)."""

import struct

_START = b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR"
_SIZE = struct.Struct(">II")


def png_size(data: bytes | memoryview) -> tuple[int, int] | None:
    """Width and height of a PNG; None where the bytes are not one."""
    if bytes(data[: len(_START)]) != _START or len(data) < len(_START) + _SIZE.size:
        return None
    width, height = _SIZE.unpack_from(data, len(_START))
    return width, height
