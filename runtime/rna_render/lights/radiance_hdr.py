"""Reader of Radiance pictures (.hdr).

Format: G. Ward, The RADIANCE Picture File Format,
https://radsite.lbl.gov/radiance/refer/filefmts.pdf, and Real Pixels (Graphics Gems II, 1991).
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numba import prange

from rna_render.limits import MAX_PIXELS_A_SIDE
from rna_render.memory import signed
from rna_sdk.compiled import compiled
from rna_sdk.errors import SceneError

HDR_MAGIC = b"#?"
MAX_HEADER_BYTES = 1 << 16
# 16384 x 8192: a few bytes of old run-length code may stand for any number of pixels.
MAX_PIXELS = 1 << 27
# Widths that the newer code, one run-length code a component, can have.
NEW_CODE_WIDTHS = 8, 0x7FFF

_OK, _TRUNCATED, _OVERRUN, _EMPTY_RUN, _NOTHING_TO_REPEAT = range(5)
_MISTAKES = {
    _TRUNCATED: "the file ends there",
    _OVERRUN: "a run goes past the line's end",
    _EMPTY_RUN: "a run of no pixels",
    _NOTHING_TO_REPEAT: "a run repeats a pixel, but there is none before it",
}


def read_hdr(path: Path) -> np.ndarray:
    """The picture's values, (h, w, 3) float32, row 0 at the top.

    They are divided by the header's EXPOSURE, as the format asks. Raises SceneError for a file
    that cannot be read or is broken, for XYZE pictures and for those that start in another corner
    than the top left.
    """
    try:
        data = path.read_bytes()
    except OSError as error:
        raise SceneError(f"cannot read the image: {error.strerror}", file=path) from error
    start, width, height, exposure = _read_header(path, data)
    rgbe = np.empty((height, width, 4), np.uint8)
    mistake, row = _decode(np.frombuffer(data, np.uint8), start, rgbe)
    if mistake != _OK:
        raise SceneError(f"broken HDR image, line {row}: {_MISTAKES[mistake]}", file=path)
    texels = np.empty((height, width, 3), np.float32)
    _from_rgbe(rgbe, 1.0 / exposure, texels)
    return texels


def _read_header(path: Path, data: bytes) -> tuple[int, int, int, float]:
    """Offset of the pixels, width, height and exposure."""

    def error(message: str) -> SceneError:
        return SceneError(f"broken HDR image: {message}", file=path)

    end = data.find(b"\n\n", 0, MAX_HEADER_BYTES)
    size_end = data.find(b"\n", end + 2, MAX_HEADER_BYTES)
    if not data.startswith(HDR_MAGIC) or end < 0 or size_end < 0:
        raise error("it has no header")
    exposure = 1.0
    for line in data[:end].decode("latin-1").splitlines():
        name, _, value = line.partition("=")
        if name == "FORMAT" and value.strip() != "32-bit_rle_rgbe":
            raise error(f"format {value.strip()!r}, expected 32-bit_rle_rgbe")
        if name == "EXPOSURE":
            exposure *= _positive(value)
    if not 0.0 < exposure < np.inf:
        raise error("EXPOSURE is not a positive number")
    size = data[end + 2 : size_end].decode("latin-1")
    match = re.fullmatch(r"-Y (\d{1,9}) \+X (\d{1,9})", size.strip())
    if match is None:
        raise error(f"size {size[:40]!r}, expected '-Y height +X width'")
    height, width = int(match[1]), int(match[2])
    too_long = max(width, height) > MAX_PIXELS_A_SIDE or width * height > MAX_PIXELS
    if width * height == 0 or too_long:
        raise error(f"{width} x {height} pixels; at most {MAX_PIXELS_A_SIDE} a side, 2^27 in all")
    return size_end + 1, width, height, exposure


def _positive(text: str) -> float:
    """The number that the text is; 0 if it is none."""
    try:
        return float(text)
    except ValueError:
        return 0.0


@compiled(fastmath=())
def _decode(data: np.ndarray, at: int, rgbe: np.ndarray) -> tuple[int, int]:
    """Fill rgbe, (h, w, 4) uint8, from the bytes after the header; what is wrong, and its line."""
    height, width, _ = rgbe.shape
    for row in range(height):
        line = rgbe[row]
        new_code = (
            NEW_CODE_WIDTHS[0] <= width <= NEW_CODE_WIDTHS[1]
            and at + 4 <= len(data)
            and data[at] == 2
            and data[at + 1] == 2
            and data[at + 2] < 128
        )
        if new_code:
            if data[at + 2] * 256 + data[at + 3] != width:
                return _OVERRUN, row
            mistake, at = _decode_components(data, at + 4, line)
        else:
            mistake, at = _decode_pixels(data, at, line)
        if mistake != _OK:
            return mistake, row
    return _OK, height


@compiled(fastmath=())
def _decode_components(data: np.ndarray, at: int, line: np.ndarray) -> tuple[int, int]:
    """The newer code: the four components one after another, each in runs and dumps."""
    for component in range(4):
        x = 0
        while x < len(line):
            if at + 2 > len(data):
                return _TRUNCATED, at
            code = data[at]
            run = code > 128
            count = signed(code) - 128 if run else signed(code)
            if count == 0:
                return _EMPTY_RUN, at
            if x + count > len(line):
                return _OVERRUN, at
            if at + 1 + (1 if run else count) > len(data):
                return _TRUNCATED, at
            for k in range(count):
                line[x + k, component] = data[at + 1 + (0 if run else k)]
            x += count
            at += 2 if run else 1 + count
    return _OK, at


@compiled(fastmath=())
def _decode_pixels(data: np.ndarray, at: int, line: np.ndarray) -> tuple[int, int]:
    """Flat pixels and the older code: (1, 1, 1, n) repeats the pixel before n << shift times."""
    x, shift = 0, 0
    while x < len(line):
        if at + 4 > len(data):
            return _TRUNCATED, at
        if data[at] == 1 and data[at + 1] == 1 and data[at + 2] == 1:
            if x == 0:
                return _NOTHING_TO_REPEAT, at
            if shift > 16:
                return _OVERRUN, at
            count = signed(data[at + 3]) << shift
            if x + count > len(line):
                return _OVERRUN, at
            for k in range(count):
                line[x + k] = line[x - 1]
            x += count
            shift += 8
        else:
            for component in range(4):
                line[x, component] = data[at + component]
            x += 1
            shift = 0
        at += 4
    return _OK, at


@compiled(parallel=True, fastmath=())
def _from_rgbe(rgbe: np.ndarray, scale: float, texels: np.ndarray) -> None:
    """Mantissas m and exponent e: m 2^(e - 136), and 0 for e = 0.

    Without the half step that Real Pixels adds to m, as Blender and most readers have it.
    """
    height, width, _ = rgbe.shape
    for row in prange(height):
        for x in range(width):
            exponent = signed(rgbe[row, x, 3])
            step = scale * 2.0 ** (exponent - 136) if exponent > 0 else 0.0
            for channel in range(3):
                texels[row, x, channel] = rgbe[row, x, channel] * step
