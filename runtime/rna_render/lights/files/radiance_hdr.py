"""Reader of Radiance pictures (.hdr).

Format: G. Ward, The RADIANCE Picture File Format,
https://radsite.lbl.gov/radiance/refer/filefmts.pdf, and Real Pixels (Graphics Gems II, 1991).
"""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_render.scene.limits import check_image_size
from rna_sdk.errors import SceneError
from rna_sdk.files.regular_file import read_regular
from rna_sdk.machine.compiled import compiled
from rna_trace.memory import signed

HDR_MAGIC = b"#?"
MAX_HEADER_BYTES = 1 << 16
# Widths that the newer code, one run-length code a component, can have.
NEW_CODE_WIDTHS = 8, 0x7FFF
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", re.ASCII)
SIZE = re.compile(r"([-+])([XY]) +(\d{1,9}) +([-+])([XY]) +(\d{1,9})", re.ASCII)

_OK, _TRUNCATED, _OVERRUN, _EMPTY_RUN, _NOTHING_TO_REPEAT = range(5)
_MISTAKES = {
    _TRUNCATED: "the file ends there",
    _OVERRUN: "a run goes past the line's end",
    _EMPTY_RUN: "a run of no pixels",
    _NOTHING_TO_REPEAT: "a run repeats a pixel, but there is none before it",
}


@dataclass(frozen=True)
class _Header:
    """offset: of the pixels. lines, length: their number, and pixels of each. columns: whether
    lines are columns. flipped: whether the axes of the stored lines and of their pixels go up, or
    to the left. exposure: what values were multiplied by."""

    offset: int
    lines: int
    length: int
    columns: bool
    flipped: tuple[bool, bool]
    exposure: float


def read_hdr(path: Path) -> np.ndarray:
    """The picture's values, (h, w, 3) float32, row 0 at the top.

    They are divided by the header's EXPOSURE, as required; COLORCORR and PRIMARIES are left
    out. Raises SceneError for a file that cannot be read, is broken or too large, and for XYZE
    pictures.
    """
    try:
        data = read_regular(path)
    except OSError as error:
        raise SceneError(f"cannot read the image: {error.strerror}", file=path) from error
    header = _read_header(path, data)
    rgbe = _read_pixels(path, data, header)
    texels = np.empty((header.lines, header.length, 3), np.float32)
    _from_rgbe(rgbe, 1.0 / header.exposure, texels)
    steps = tuple(-1 if flip else 1 for flip in header.flipped)
    texels = texels[:: steps[0], :: steps[1]]
    return np.ascontiguousarray(texels.swapaxes(0, 1) if header.columns else texels)


def _read_header(path: Path, data: bytes) -> _Header:
    def error(message: str) -> SceneError:
        return SceneError(f"broken HDR image: {message}", file=path)

    lines = data[:MAX_HEADER_BYTES].split(b"\n")[:-1]
    end = next((k for k, line in enumerate(lines) if line.rstrip(b"\r") == b""), len(lines))
    if not data.startswith(HDR_MAGIC) or end + 1 >= len(lines):
        raise error("it has no header")
    exposure = 1.0
    for line in lines[1:end]:
        name, _, value = (part.strip() for part in line.decode("latin-1").partition("="))
        if name == "FORMAT" and value != "32-bit_rle_rgbe":
            raise error(f"format {value!r}, expected 32-bit_rle_rgbe")
        if name == "EXPOSURE":
            exposure *= _exposure(value)
    if not 0.0 < exposure < np.inf:
        raise error("EXPOSURE is not a positive number")
    size = lines[end + 1].decode("latin-1").strip()
    match = SIZE.fullmatch(size)
    if match is None or match[2] == match[5]:
        raise error(f"size {size[:40]!r}, expected such as '-Y height +X width'")
    first, second = (_goes_back(match[1] + match[2]), _goes_back(match[4] + match[5]))
    count, length = int(match[3]), int(match[6])
    columns = match[2] == "X"
    check_image_size(path, *((count, length) if columns else (length, count)))
    offset = sum(len(line) + 1 for line in lines[: end + 2])
    return _Header(offset, count, length, columns, (first, second), exposure)


def _goes_back(axis: str) -> bool:
    """Whether an axis goes up (`+Y`) or to the left (`-X`)."""
    return axis in ("+Y", "-X")


def _exposure(text: str) -> float:
    """A number of the header; 1 for the 0 that FreeImage writes, 0 if it is no number."""
    return (float(text) or 1.0) if NUMBER.fullmatch(text) else 0.0


def _read_pixels(path: Path, data: bytes, header: _Header) -> np.ndarray:
    """(lines, length, 4) uint8."""
    rgbe = np.empty((header.lines, header.length, 4), np.uint8)
    mistake, row = _decode(np.frombuffer(data, np.uint8), header.offset, rgbe)
    if mistake == _OK:
        return rgbe
    # Flat pixels may look like either code: a first one of 2, 2, less than 128.
    if len(data) - header.offset == rgbe.size:
        return np.frombuffer(data, np.uint8, rgbe.size, header.offset).reshape(rgbe.shape)
    raise SceneError(f"broken HDR image, line {row}: {_MISTAKES[mistake]}", file=path)


@compiled(fastmath=())
def _decode(data: np.ndarray, at: int, rgbe: np.ndarray) -> tuple[int, int]:
    """Fill rgbe, (h, w, 4) uint8, from the bytes after the header; returns a fault and its line."""
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


@compiled(rows="rgbe texels", step=16, fastmath=())
def _from_rgbe(rgbe: np.ndarray, scale: float, texels: np.ndarray) -> None:
    """Mantissas m and exponent e: m 2^(e - 136), and 0 for e = 0.

    Without the half step that Real Pixels adds to m, as Blender and most readers have it.
    """
    height, width, _ = rgbe.shape
    for row in range(height):
        for x in range(width):
            exponent = signed(rgbe[row, x, 3])
            step = scale * 2.0 ** (exponent - 136) if exponent > 0 else 0.0
            for channel in range(3):
                texels[row, x, channel] = rgbe[row, x, channel] * step
