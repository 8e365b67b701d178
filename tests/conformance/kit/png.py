"""PNG files of every kind that readers meet; bytes are stored, so no library changes them.

`png_bytes` writes them, `decoded` is a short reader of them.
"""

import struct
import zlib
from dataclasses import dataclass

import numpy as np

_MAGIC = b"\x89PNG\r\n\x1a\n"
GREY, RGB, PALETTE, GREY_ALPHA, RGBA = 0, 2, 3, 4, 6
SAMPLES = {GREY: 1, RGB: 3, PALETTE: 1, GREY_ALPHA: 2, RGBA: 4}
_PASSES = [(0, 0, 8, 8), (0, 4, 8, 8), (4, 0, 8, 4), (0, 2, 4, 4)]
_PASSES += [(2, 0, 4, 2), (0, 1, 2, 2), (1, 0, 2, 1)]
"""First row and column, and steps of either, of the passes of an interlaced image."""


@dataclass(frozen=True)
class Kind:
    """How a file is written: colour type, bits a sample, filter of rows (5: of each another)."""

    color: int = RGB
    depth: int = 8
    filter: int = 0
    interlaced: bool = False
    gamma: bool = False


KINDS = {
    "sub": Kind(filter=1),
    "up": Kind(filter=2),
    "average": Kind(filter=3),
    "paeth": Kind(filter=4),
    "alpha": Kind(RGBA, filter=5),
    "grey": Kind(GREY, filter=5),
    "grey-alpha": Kind(GREY_ALPHA),
    "palette": Kind(PALETTE),
    "palette-of-four": Kind(PALETTE, 2),
    "black-and-white": Kind(GREY, 1),
    "grey-of-sixteen": Kind(GREY, 4),
    "deep": Kind(RGB, 16, filter=5),
    "interlaced": Kind(RGB, filter=5, interlaced=True),
    "gamma": Kind(RGB, gamma=True),
}


def fitting(pixels: np.ndarray, kind: Kind) -> np.ndarray:
    """(H, W, 3) uint8: the pixels with colours that a file of this kind can have."""
    steps = 2**kind.depth - 1
    if kind.color in (GREY, GREY_ALPHA):
        value = pixels[..., :1]
        if kind.depth < 8:
            value = (value.astype(int) * steps // 255 * (255 // steps)).astype(np.uint8)
        return np.repeat(value, 3, axis=2)
    if kind.color == PALETTE:
        return _palette(kind)[pixels[..., 0].astype(int) % (steps + 1)]
    return pixels


def _palette(kind: Kind) -> np.ndarray:
    count = 2**kind.depth
    colors: np.ndarray = np.random.default_rng(count).permutation(count * 3) * 255 // (3 * count)
    return colors.reshape(count, 3).astype(np.uint8)


def png_bytes(pixels: np.ndarray, kind: Kind = Kind()) -> bytes:
    """The file of an image (H, W, 3) uint8 of less than 64 KiB, which `fitting` has made fit."""
    height, width, _ = pixels.shape
    samples = _samples(pixels, kind)
    passes = _PASSES if kind.interlaced else [(0, 0, 1, 1)]
    rows = b"".join(_filtered(samples[y::v, x::h], kind) for y, x, v, h in passes)
    block = struct.pack("<BHH", 1, len(rows), len(rows) ^ 0xFFFF) + rows
    stream = b"\x78\x01" + block + struct.pack(">I", zlib.adler32(rows))
    shape = width, height, kind.depth, kind.color, 0, 0, kind.interlaced
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", *shape))]
    if kind.gamma:
        chunks.append((b"gAMA", struct.pack(">I", 100_000)))
    if kind.color == PALETTE:
        clear = bytes(range(0, 256, 256 // 2**kind.depth))
        chunks += [(b"PLTE", _palette(kind).tobytes()), (b"tRNS", clear)]
    chunks += [(b"IDAT", stream), (b"IEND", b"")]
    return _MAGIC + b"".join(_chunk(*chunk) for chunk in chunks)


def _samples(pixels: np.ndarray, kind: Kind) -> np.ndarray:
    """(H, W, samples) uint16, as they are stored."""
    alpha = (np.arange(pixels[..., 0].size) * 37 % 256).reshape(*pixels.shape[:2], 1)
    values = pixels.astype(np.uint16)
    if kind.color == PALETTE:
        match = (pixels[:, :, None] == _palette(kind)).all(axis=3)
        return match.argmax(axis=2)[..., None].astype(np.uint16)
    if kind.color in (GREY, GREY_ALPHA):
        values = values[..., :1] // (255 // (2**kind.depth - 1) if kind.depth < 8 else 1)
    if kind.color in (GREY_ALPHA, RGBA):
        values = np.concatenate([values, alpha.astype(np.uint16)], axis=2)
    return values * 256 + 201 if kind.depth == 16 else values


def _filtered(samples: np.ndarray, kind: Kind) -> bytes:
    if not samples.size:
        return b""
    rows = [_packed(row.reshape(-1), kind.depth) for row in samples]
    distance = max(1, SAMPLES[kind.color] * kind.depth // 8)
    above, result = np.zeros_like(rows[0]), b""
    for y, row in enumerate(rows):
        way = y % 5 if kind.filter == 5 else kind.filter
        result += bytes([way]) + (row - _predicted(way, row, above, distance)).tobytes()
        above = row
    return result


def _packed(values: np.ndarray, depth: int) -> np.ndarray:
    """The bytes of a row."""
    if depth == 16:
        return np.frombuffer(values.astype(">u2").tobytes(), np.uint8)
    bits = np.unpackbits(values.astype(np.uint8)[:, None], axis=1)[:, 8 - depth :]
    return np.packbits(bits.reshape(-1))


def _predicted(way: int, row: np.ndarray, above: np.ndarray, distance: int) -> np.ndarray:
    """What a filter takes from each byte of a row, of bytes that are known already."""
    result = np.zeros_like(row)
    for i in range(len(row)):
        a = int(row[i - distance]) if i >= distance else 0
        c = int(above[i - distance]) if i >= distance else 0
        result[i] = _prediction(way, a, int(above[i]), c)
    return result


def _prediction(way: int, left: int, up: int, corner: int) -> int:
    if way == 4:
        p = left + up - corner
        far = abs(p - left), abs(p - up), abs(p - corner)
        if far[0] <= far[1] and far[0] <= far[2]:
            return left
        return up if far[1] <= far[2] else corner
    return (0, left, up, (left + up) // 2)[way]


def _chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def decoded(data: bytes) -> np.ndarray:
    """(H, W, 3) uint8: the colours of a file, as spec/RNA.md, 4.6, has them."""
    chunks, at, stream = {}, len(_MAGIC), b""
    while at < len(data):
        (size,), name = struct.unpack_from(">I", data, at), data[at + 4 : at + 8]
        chunks[name] = data[at + 8 : at + 8 + size]
        stream += chunks[name] if name == b"IDAT" else b""
        at += 12 + size
    width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", chunks[b"IHDR"])
    rows, count = np.frombuffer(zlib.decompress(stream), np.uint8), SAMPLES[color]
    samples = np.zeros((height, width, count), int)
    for y, x, v, h in _PASSES if interlaced else [(0, 0, 1, 1)]:
        part = samples[y::v, x::h]
        above = np.zeros(-(-part.shape[1] * count * depth // 8), np.uint8)
        for k in range(len(part) if part.size else 0):
            way, row = int(rows[0]), rows[1 : 1 + len(above)].copy()
            rows, above = rows[1 + len(above) :], _restored(way, row, above, count * depth)
            part[k] = _unpacked(above, depth)[: part[k].size].reshape(part[k].shape)
    if color == PALETTE:
        return np.frombuffer(chunks[b"PLTE"], np.uint8).reshape(-1, 3)[samples[..., 0]]
    colors = samples[..., :3] if color in (RGB, RGBA) else samples[..., [0, 0, 0]]
    scaled = colors >> 8 if depth == 16 else colors * (255 // (2**depth - 1))
    return scaled.astype(np.uint8)


def _restored(way: int, row: np.ndarray, above: np.ndarray, bits: int) -> np.ndarray:
    distance = max(1, bits // 8)
    for i in range(len(row)):
        a = int(row[i - distance]) if i >= distance else 0
        c = int(above[i - distance]) if i >= distance else 0
        row[i] = (int(row[i]) + _prediction(way, a, int(above[i]), c)) % 256
    return row


def _unpacked(row: np.ndarray, depth: int) -> np.ndarray:
    if depth == 16:
        return row.view(">u2").astype(int)
    bits = np.unpackbits(row).reshape(-1, depth)
    return bits @ (1 << np.arange(depth)[::-1])
