"""The C host from Python: compiled with the machine's C compiler, called through ctypes."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from pathlib import Path

import numpy as np

SOURCES = Path(__file__).parents[2] / "examples" / "hosts" / "c"
_REPORT_BYTES = 2**15  # more than sizeof(RnaReport)


def compiler() -> str | None:
    """What `cc` is here; None where there is no C compiler, or no make."""
    return shutil.which("cc") if shutil.which("make") else None


def build(folder: Path, *targets: str, arch: str = "-march=x86-64-v3") -> list[Path]:
    """Make the files `targets` of the host's Makefile in `folder`."""
    paths = [folder / target for target in targets]
    command = ["make", "-s", "-j2", "-C", str(SOURCES), f"BUILD={folder}", f"ARCH={arch}"]
    subprocess.run([*command, *map(str, paths)], check=True)
    return paths


class CMesh(ctypes.Structure):
    """RnaMesh."""

    _fields_ = (
        ("vertex_count", ctypes.c_uint32),
        ("triangle_count", ctypes.c_uint32),
        ("positions", ctypes.POINTER(ctypes.c_float)),
        ("normals", ctypes.POINTER(ctypes.c_float)),
        ("uvs", ctypes.POINTER(ctypes.c_float)),
        ("triangles", ctypes.POINTER(ctypes.c_uint32)),
    )


class CCurves(ctypes.Structure):
    """RnaCurves."""

    _fields_ = (
        ("point_count", ctypes.c_uint32),
        ("strand_count", ctypes.c_uint32),
        ("points", ctypes.POINTER(ctypes.c_float)),
        ("radii", ctypes.POINTER(ctypes.c_float)),
        ("offsets", ctypes.POINTER(ctypes.c_uint32)),
    )


class CBaseColor(ctypes.Structure):
    """RnaBaseColor."""

    _fields_ = (
        ("first", ctypes.c_uint32),
        ("count", ctypes.c_uint32),
        ("file", ctypes.POINTER(ctypes.c_uint8)),
        ("file_size", ctypes.c_size_t),
        ("width", ctypes.c_uint32),
        ("height", ctypes.c_uint32),
        ("is_srgb", ctypes.c_bool),
        ("factor", ctypes.c_double * 3),
        ("wrap", ctypes.c_int * 2),
        ("transform", ctypes.c_double * 6),
    )


class CPart(ctypes.Structure):
    """RnaPart."""

    _fields_ = (
        ("name", ctypes.c_char_p),
        ("kind", ctypes.c_int),
        ("low", ctypes.c_float * 3),
        ("high", ctypes.c_float * 3),
        ("mesh", ctypes.POINTER(CMesh)),
        ("curves", ctypes.POINTER(CCurves)),
        ("emits", ctypes.c_bool),
        ("record_count", ctypes.c_int),
        ("records", ctypes.c_void_p),
        ("normal_map_count", ctypes.c_int),
        ("normal_maps", ctypes.c_void_p),
        ("base_color_count", ctypes.c_int),
        ("base_colors", ctypes.POINTER(CBaseColor)),
    )


class CAsset:
    """A part of a tier of a package, in the C host; evaluates as `rna_sdk.runtime` does.

    library: of `build(folder, "librna.so")`. record: what the host says of the part.
    """

    def __init__(self, library: Path, package: Path, tier: str, part: int = 0) -> None:
        self._rna = ctypes.CDLL(str(library))
        self._rna.rna_open.restype = ctypes.c_void_p
        self._rna.rna_part.restype = ctypes.POINTER(CPart)
        self._rna.rna_uses_base_color.restype = ctypes.c_bool
        self._rna.rna_texel_density.restype = ctypes.c_double
        report = ctypes.create_string_buffer(_REPORT_BYTES)
        address = self._rna.rna_open(str(package).encode(), report)
        if not address:
            raise ValueError(f"the C host refuses {package}")
        self._asset = ctypes.c_void_p(address)
        self._tier = self._rna.rna_tier_index(self._asset, tier.encode())
        self._part = part
        if self._tier < 0:
            raise ValueError(f"{package} has no tier {tier}")
        record = self._rna.rna_part(self._asset, part)
        if not record:
            raise ValueError(f"{package} has no part {part}")
        self.record: CPart = record.contents

    def close(self) -> None:
        self._rna.rna_close(self._asset)

    def evaluate(
        self, *arrays: np.ndarray, base_color: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """(visible, shadowed), (n, 3) float32 each, of positions, axes, [h,] wo, wi."""
        positions, axes, *h, wo, wi = arrays
        results = np.empty((2, len(positions), 3), np.float32)
        given = positions, axes, *(h or (None,)), wo, wi, base_color
        self._ask("rna_evaluate", *given, *results)
        visible, shadowed = results
        return visible, shadowed

    @property
    def uses_base_color(self) -> bool:
        return bool(self._rna.rna_uses_base_color(self._asset, self._tier, self._part))

    def set_image(self, record: int, pixels: np.ndarray) -> int:
        """The status for (H, W, 3) uint8 pixels of a record of base colour."""
        data = np.ascontiguousarray(pixels).ctypes.data_as(ctypes.c_void_p)
        return int(self._rna.rna_set_image(self._asset, self._part, record, data))

    def base_color(self, triangle: int, b1: float, b2: float, level: float) -> np.ndarray:
        """(3,) float32 at a hit."""
        color = np.empty(3, np.float32)
        numbers = (ctypes.c_double(number) for number in (b1, b2, level))
        place = ctypes.c_uint32(triangle), *numbers
        self._rna.rna_base_color(self._asset, self._part, *place, _address(color))
        return color

    def texel_density(self, triangle: int) -> float:
        return float(
            self._rna.rna_texel_density(self._asset, self._part, ctypes.c_uint32(triangle))
        )

    def emission(self, *arrays: np.ndarray) -> np.ndarray:
        """(n, 3) float32 of positions, axes, [h,] wo."""
        positions, axes, *h, wo = arrays
        colours = np.empty((len(positions), 3), np.float32)
        self._ask("rna_emission", positions, axes, *(h or (None,)), wo, colours)
        return colours

    def transmittance(
        self, triangle: int, b1: float, b2: float, direction: np.ndarray
    ) -> np.ndarray:
        """(3,) float32 for a ray of this direction."""
        tau = np.empty(3, np.float32)
        place = ctypes.c_uint32(triangle), ctypes.c_double(b1), ctypes.c_double(b2)
        vectors = _address(direction.astype(np.float32)), _address(tau)
        self._rna.rna_transmittance(self._asset, self._part, *place, *vectors)
        return tau

    def normal(self, triangle: int, b1: float, b2: float) -> np.ndarray:
        """(3,) float32 that a surface is asked with."""
        normal = np.empty(3, np.float32)
        place = ctypes.c_uint32(triangle), ctypes.c_double(b1), ctypes.c_double(b2)
        self._rna.rna_normal(self._asset, self._part, *place, _address(normal))
        return normal

    def _ask(self, function: str, *arrays: np.ndarray | None) -> None:
        rows = ctypes.c_size_t(0 if arrays[0] is None else len(arrays[0]))
        place = self._asset, self._tier, self._part, rows
        status = getattr(self._rna, function)(*place, *map(_address, arrays))
        if status:
            raise ValueError(f"{function}: status {status}")


def _address(array: np.ndarray | None) -> ctypes.c_void_p:
    if array is not None:
        assert array.dtype == np.float32 and array.flags.c_contiguous
    return ctypes.c_void_p(None if array is None else array.ctypes.data)
