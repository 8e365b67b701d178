"""The motion file: a cache of positions by frame, as a safetensors file.

Its tensors: `rate` [1] float32, frames a second; `topology` [parts, 32] uint8, a SHA-256 a part, of
the triangles of a mesh as they are stored, or of the offsets of curves; `part.K` [frames, vertices,
3] float32, object space of the package, metres.
"""

import hashlib
import mmap
import os
from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.arrays import first_not_finite
from rna_sdk.errors import MotionError, PackageError
from rna_sdk.files.atomic_file import atomic_file
from rna_sdk.files.regular_file import check_regular
from rna_sdk.package import Code, Curves, Mesh
from rna_sdk.package.container.tensor_file import (
    TensorCodes,
    TensorForm,
    tensor_names,
    tensors_from_bytes,
    tensors_header,
)

Float32 = NDArray[np.float32]

MAX_FRAMES = 1 << 20

_CODES = TensorCodes(
    Code.PLANES_HEADER,
    Code.PLANES_TENSOR,
    Code.PLANES_DTYPE,
    Code.PLANES_SHAPE,
    Code.PLANES_SHAPE,
    Code.PLANES_ALIGNMENT,
)
"""Never seen: every issue becomes a MotionError with the found and the expected value."""

_MOST_READ = 1 << 26
"""Bytes of a file that is read at once: later changes of the file do not matter."""

_MOST_SCALE = 8.0
"""How many times as long, or as short, the edges of a first frame may be on average."""


class Motion(ABC):
    """Positions of a package's parts, frame by frame.

    Attributes:
        path: the file that it is of.
        frames: how many there are, numbered from 0.
        rate: frames a second.

    Examples:
        >>> mesh = load("toy.rna").mesh
        >>> write_motion("still.rnam", [mesh], [[mesh.positions]], count=1, rate=24.0)
        >>> isinstance(open_motion("still.rnam", [mesh]), Motion)
        True
    """

    def __init__(self, path: Path, frames: int, rate: float) -> None:
        self.path, self.frames, self.rate = path, frames, rate

    def check_frame(self, frame: float) -> None:
        """Raises MotionError where there is no such frame."""
        last = self.frames - 1
        if not 0 <= frame <= last:
            raise MotionError(f"{self.path}: has frames 0 to {last}, and no frame {frame:g}")

    @abstractmethod
    def positions(self, frame: float) -> list[Float32]:
        """Positions of each part at a frame, which may be between two: (v, 3) float32.

        Raises:
            MotionError: there is no such frame, or it has numbers that are not finite.
        """


class MotionFile(Motion):
    """A motion file, mapped if it is large. Made by `open_motion`.

    It may be replaced by another file; a large one that is written in place is a MotionError at the
    next frame, and may end the process within one.

    Examples:
        >>> mesh = load("toy.rna").mesh
        >>> low, high = mesh.positions, mesh.positions + np.float32([0, 1, 0])
        >>> write_motion("rise.rnam", [mesh], [[low], [high]], count=2, rate=24.0)
        >>> (between,) = open_motion("rise.rnam", [mesh]).positions(0.5)
        >>> bool(np.allclose(between - low, [0, 0.5, 0], atol=1e-6))
        True
    """

    def __init__(
        self, path: Path, rate: float, parts: Sequence[Float32], mapped: os.stat_result | None
    ) -> None:
        super().__init__(path, len(parts[0]), rate)
        self._parts, self._mapped = tuple(parts), mapped

    def positions(self, frame: float) -> list[Float32]:
        """See `Motion`; between two frames, linear."""
        self.check_frame(frame)
        before = int(frame)
        share = np.float32(frame - before)
        result = self._frame(before)
        if share:
            after = self._frame(before + 1)
            result = [(1 - share) * a + share * b for a, b in zip(result, after, strict=True)]
        return result

    def _frame(self, number: int) -> list[Float32]:
        if self._mapped is not None and _is_changed(self.path, self._mapped):
            raise MotionError(f"{self.path}: was written to while it was in use")
        result = [np.array(part[number]) for part in self._parts]
        for part, positions in enumerate(result):
            check_finite(f"{self.path}: frame {number}, part {part}", positions)
        return result


def open_motion(
    path: str | PathLike[str], geometries: Sequence[Mesh | Curves], package: str = "the package"
) -> MotionFile:
    """Open a motion file for the parts of a package.

    geometries: of the parts, in order. package: what to call it in errors.

    Raises:
        MotionError: the file cannot be read, is no motion, or not one of this geometry: other
            parts, vertices or triangles, or positions of another scale.

    Examples:
        >>> mesh = load("toy.rna").mesh
        >>> write_motion("still.rnam", [mesh], [[mesh.positions]], count=1, rate=24.0)
        >>> open_motion("still.rnam", [mesh], "toy.rna").frames
        1
    """
    file = Path(path)
    try:
        state = check_regular(file)
        with file.open("rb") as opened:
            data = memoryview(
                opened.read()
                if state.st_size <= _MOST_READ
                else mmap.mmap(opened.fileno(), 0, access=mmap.ACCESS_READ)
            )
    except OSError as error:
        raise MotionError(f"{file}: {error.strerror}") from error
    if not data:
        raise MotionError(f"{file}: is empty")
    try:
        arrays = _arrays(data, file, geometries, package)
    except PackageError as error:
        issue = error.issues[0]
        place = str(issue.pointer_or_offset).replace(f"{file.name}#/", "")
        where = "" if place == file.name else f"{place}: "
        message = f"{file}: {where}found {issue.found}, expected {issue.expected}"
        raise MotionError(f"{message}: no motion file of {package}") from error
    rate = float(arrays["rate"][0])
    if not 0.0 < rate < np.inf:
        raise MotionError(f"{file}: rate: found {rate:g}, expected frames a second, more than 0")
    parts = [arrays[_name(k)] for k in range(len(geometries))]
    for number, (geometry, positions) in enumerate(zip(geometries, parts, strict=True)):
        if len(positions) != len(parts[0]):
            found = f"{len(positions)} frames of part {number}, but {len(parts[0])} of part 0"
            raise MotionError(f"{file}: {found}")
        if arrays["topology"][number].tobytes() != topology(geometry):
            what = "strands" if isinstance(geometry, Curves) else "triangles"
            raise MotionError(f"{file}: part {number} has other {what} than {package}")
        _check_scale(file, number, geometry, positions[0], package)
    return MotionFile(file, rate, parts, state if state.st_size > _MOST_READ else None)


def _is_changed(file: Path, state: os.stat_result) -> bool:
    """Whether a file was written in place; another one of its name does not count."""
    try:
        now = file.stat()
    except OSError:
        return False
    changed = (now.st_size, now.st_mtime_ns) != (state.st_size, state.st_mtime_ns)
    return changed and os.path.samestat(now, state)


def write_motion(
    path: str | PathLike[str],
    geometries: Sequence[Mesh | Curves],
    frames: Iterable[Sequence[Float32]],
    *,
    count: int,
    rate: float,
) -> None:
    """Write a motion file, frame by frame; `path` is there when all of it is written.

    geometries: of the package's parts, in order. frames: `count` of them, each the positions of
    every part, (v, 3) float32. rate: frames a second.

    Raises:
        MotionError: positions of another shape or not finite, or another number of frames.
        OSError: the file cannot be written.

    Examples:
        >>> mesh = load("toy.rna").mesh
        >>> write_motion("still.rnam", [mesh], [[mesh.positions]], count=1, rate=24.0)
    """
    if not (1 <= count <= MAX_FRAMES and 0.0 < rate < np.inf):
        raise MotionError(f"{count} frames at {rate:g} a second; expected 1 and more of both")
    sizes = [len(rest_positions(geometry)) for geometry in geometries]
    forms: dict[str, tuple[str, tuple[int, ...]]] = {
        "rate": ("float32", (1,)),
        "topology": ("uint8", (len(geometries), 32)),
        **{_name(k): ("float32", (count, size, 3)) for k, size in enumerate(sizes)},
    }
    start = tensors_header(forms) + np.array([rate], "<f4").tobytes()
    start += b"".join(map(topology, geometries))
    starts = len(start) + 12 * count * np.cumsum([0, *sizes[:-1]])
    written = 0
    with atomic_file(Path(path)) as temporary, temporary.open("wb") as file:
        file.write(start)
        for number, frame in enumerate(frames):
            for part, (size, positions) in enumerate(zip(sizes, frame, strict=True)):
                where = f"{path}: frame {number}, part {part}"
                if positions.shape != (size, 3):
                    raise MotionError(f"{where}: found {positions.shape}, expected ({size}, 3)")
                check_finite(where, positions)
                if number < count:
                    file.seek(int(starts[part]) + 12 * size * number)
                    file.write(np.ascontiguousarray(positions, "<f4").tobytes())
            written = number + 1
        if written != count:
            raise MotionError(f"{path}: found {written} frames, expected {count}")


def check_finite(where: str, positions: NDArray[np.floating]) -> None:
    """Raises MotionError, which starts with `where`, for positions that are not finite."""
    if (at := first_not_finite(positions)) is not None:
        raise MotionError(f"{where}: vertex {at} is at {positions[at].tolist()}")


def rest_positions(geometry: Mesh | Curves) -> Float32:
    """Positions of a mesh, or points of curves, at rest."""
    return geometry.points if isinstance(geometry, Curves) else geometry.positions


def topology(geometry: Mesh | Curves) -> bytes:
    """SHA-256 of the connections between a geometry's positions."""
    links = geometry.offsets if isinstance(geometry, Curves) else geometry.triangles
    return hashlib.sha256(np.ascontiguousarray(links, "<u4").tobytes()).digest()


def _name(part: int) -> str:
    return f"part.{part}"


def _arrays(
    data: memoryview, file: Path, geometries: Sequence[Mesh | Curves], package: str
) -> dict[str, NDArray[Any]]:
    names = tensor_names(data, file.name, _CODES)
    parts = sum(name.startswith("part.") for name in names)
    if {"rate", "topology"} <= names and parts != len(geometries):
        count = len(geometries)
        raise MotionError(f"{file}: has {parts} parts, but {package} has {count}")
    frames = range(1, MAX_FRAMES + 1)
    forms = {
        "rate": TensorForm("float32", (1,)),
        "topology": TensorForm("uint8", (len(geometries), 32)),
    }
    for k, geometry in enumerate(geometries):
        forms[_name(k)] = TensorForm("float32", (frames, len(rest_positions(geometry)), 3))
    return tensors_from_bytes(data, file.name, forms, _CODES)


def _check_scale(
    file: Path, part: int, geometry: Mesh | Curves, positions: Float32, package: str
) -> None:
    """Refuses a first frame whose edges are many times as long, or short, as at rest."""
    check_finite(f"{file}: frame 0, part {part}", positions)
    ratio = _mean_edge(geometry, positions) / _mean_edge(geometry, rest_positions(geometry))
    if not 1 / _MOST_SCALE < ratio < _MOST_SCALE:
        raise MotionError(
            f"{file}: part {part} is {ratio:.3g} times as large as in {package}: it is in another "
            "unit, expected metres"
        )


def _mean_edge(geometry: Mesh | Curves, positions: Float32) -> float:
    if isinstance(geometry, Curves):
        first = geometry.segments()
        second = first + np.uint32(1)
    else:
        first, second = geometry.triangles[:, 0], geometry.triangles[:, 1]
    edges = (positions[second] - positions[first]).astype(np.float64)
    return float(np.linalg.norm(edges, axis=1).mean())
