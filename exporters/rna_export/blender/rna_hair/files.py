"""Groom files: Cem Yuksel's `.hair` (read, written) and TressFX's `.tfx`, versions 3 and 4 (read).

Every size is checked against the file's before it is used. A bad file raises `ValueError` with
one line: the file, where, what was found and what was expected.

Axes. `.hair` is right-handed with +Z up, as Yuksel's models are: (x, y, z) becomes (x, z, -y).
`.tfx` is left-handed with +Y up (Direct3D): (x, y, z) becomes (x, y, -z), which keeps up and turns
a head that looks along -z there to +z, where glTF has its front. Units stay the file's.
"""

import struct
import warnings
from pathlib import Path

import numpy as np

from .axes import y_up_to_z_up, z_up_to_y_up
from .strands import Strands, of_equal_length

_HAIR_HEADER = struct.Struct("<4sIIIIff3f88s")  # 128 bytes
_SEGMENTS, _POINTS, _THICKNESS, _TRANSPARENCY, _COLOUR = 1, 2, 4, 8, 16
_TFX_HEADER = struct.Struct("<fIII")  # version, strands, points a strand, offset of positions
_TFX_3_POSITIONS = 296  # TressFX 3.1: positions begin here, whatever else the header says
_TFX_4_HEADER_BYTES = 160


def _check(good: bool, path: Path, where: str, found: object, expected: object) -> None:
    if not good:
        raise ValueError(f"{path.name}: {where}: found {found}, expected {expected}")


def read_hair(path: Path | str) -> Strands:
    """Strands of a `.hair` file.

    The format does not say what its thickness is; readers take it as a width (Unreal's groom
    importer does), so the radius is half of it. Where there is no array, the default holds.
    Transparency and colours are skipped: they belong to a material. Strands of one point are left
    out, with a warning.
    """
    path = Path(path)
    data = path.read_bytes()
    _check(len(data) >= 128, path, "size", f"{len(data)} bytes", "a header of 128 bytes")
    magic, strands, points, bits, default_segments, thickness = _HAIR_HEADER.unpack(data[:128])[:6]
    _check(magic == b"HAIR", path, "byte 0", magic, b"HAIR")
    _check(bits < 32, path, "bit array", bits, "bits 0 to 4 only")
    _check(bool(bits & _POINTS), path, "bit array", bits, "a file with points (bit 1)")
    _check(strands > 0, path, "strand count", strands, "1 and more")
    size = 128 + sum(
        width
        for bit, width in (
            (_SEGMENTS, 2 * strands),
            (_POINTS, 12 * points),
            (_THICKNESS, 4 * points),
            (_TRANSPARENCY, 4 * points),
            (_COLOUR, 12 * points),
        )
        if bits & bit
    )
    counts = f"{strands} strands, {points} points and bits {bits}"
    _check(len(data) == size, path, "size", f"{len(data)} bytes", f"{size} for {counts}")
    at = 128
    if bits & _SEGMENTS:
        segments = np.frombuffer(data, "<u2", strands, at).astype(np.int64)
        at += 2 * strands
    else:
        _check(
            points == strands * (default_segments + 1),
            path,
            "default segments",
            f"{default_segments} for {points} points",
            f"{points / strands - 1:g} for {strands} strands",
        )
        segments = np.full(strands, default_segments, np.int64)
    total = int(segments.sum()) + strands
    _check(total == points, path, "segments", f"{total} points", f"{points} as in the header")
    _check(segments.max() >= 1, path, "segments", "strands of 0 only", "1 and more")
    xyz = np.frombuffer(data, "<f4", 3 * points, at).reshape(-1, 3)
    widths = np.full(points, thickness, np.float32)
    if bits & _THICKNESS:
        widths = np.frombuffer(data, "<f4", points, at + 12 * points).astype(np.float32)
    _check_finite(path, "points", xyz)
    good = bool(np.isfinite(widths).all() and widths.min() >= 0.0)
    _check(good, path, "thickness", "a negative or not finite one", "0 and more")
    return _without_lone_points(path, z_up_to_y_up(xyz), 0.5 * widths, segments + 1)


def _without_lone_points(
    path: Path, points: np.ndarray, radii: np.ndarray, counts: np.ndarray
) -> Strands:
    """Strands of the points, without those of one point: roots from which no hair grows."""
    valid = counts > 1
    if not valid.all():
        left_out = int((~valid).sum())
        warnings.warn(
            f"{path.name}: {left_out:,} of {len(counts):,} strands have one point and were left "
            "out",
            stacklevel=3,
        )
    rows = np.repeat(valid, counts)
    return Strands(points[rows], radii[rows], np.concatenate([[0], np.cumsum(counts[valid])]))


def write_hair(path: Path | str, strands: Strands) -> None:
    """Write the strands with segment, point and thickness arrays; `read_hair` gives them back."""
    segments = strands.counts - 1
    if segments.max() > 0xFFFF:
        raise ValueError(f"found a strand of {segments.max()} segments, expected 65535 at most")
    header = _HAIR_HEADER.pack(
        b"HAIR",
        len(strands),
        len(strands.points),
        _SEGMENTS | _POINTS | _THICKNESS,
        0,
        1.0,
        0.0,
        *(1.0, 1.0, 1.0),
        b"",
    )
    with Path(path).open("wb") as file:
        file.write(header)
        file.write(segments.astype("<u2").tobytes())
        file.write(y_up_to_z_up(strands.points).astype("<f4").tobytes())
        file.write((2.0 * strands.radii).astype("<f4").tobytes())


def read_tfx(path: Path | str, radius: float) -> Strands:
    """Strands of a TressFX 3 or 4 file; every radius is `radius`, in the file's unit.

    TressFX 3 has points of three numbers at a fixed place; TressFX 4 has four, of which the last is
    no coordinate but an inverse mass, where its header says.
    """
    path = Path(path)
    data = path.read_bytes()
    enough = len(data) >= _TFX_4_HEADER_BYTES
    _check(enough, path, "size", f"{len(data)} bytes", f"a header of {_TFX_4_HEADER_BYTES} bytes")
    version, strands, points, start = _TFX_HEADER.unpack(data[: _TFX_HEADER.size])
    _check(3.0 <= version < 5.0, path, "version", f"{version:g}", "3 or 4")
    _check(strands > 0, path, "strand count", strands, "1 and more")
    _check(points >= 2, path, "points a strand", points, "2 and more")
    start, numbers = (_TFX_3_POSITIONS, 3) if version < 4.0 else (start, 4)
    inside = start >= _TFX_4_HEADER_BYTES
    _check(inside, path, "offset of positions", start, f"{_TFX_4_HEADER_BYTES} and more")
    size = start + 4 * numbers * strands * points
    counts = f"{strands} strands of {points} points"
    _check(len(data) >= size, path, "size", f"{len(data)} bytes", f"{size} for {counts}")
    xyz = np.frombuffer(data, "<f4", numbers * strands * points, start).reshape(-1, numbers)[:, :3]
    _check_finite(path, "positions", xyz)
    mirrored = xyz.reshape(strands, points, 3) * np.array([1.0, 1.0, -1.0], np.float32)
    return of_equal_length(mirrored, np.array(radius, np.float32))


def _check_finite(path: Path, where: str, values: np.ndarray) -> None:
    bad = np.flatnonzero(~np.isfinite(values.reshape(-1)))
    if len(bad):
        number = bad[0] // 3
        _check(False, path, where, f"point {number} not finite", "finite coordinates")
