"""The C host from Python: compiled with the machine's C compiler, called through ctypes."""

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


_SURFACE = 0  # of RnaKind


class CPart(ctypes.Structure):
    """RnaPart."""

    _fields_ = (
        ("name", ctypes.c_char_p),
        ("kind", ctypes.c_int),
        ("low", ctypes.c_float * 3),
        ("high", ctypes.c_float * 3),
        ("mesh", ctypes.c_void_p),
        ("curves", ctypes.c_void_p),
        ("emits", ctypes.c_bool),
        ("record_count", ctypes.c_int),
        ("records", ctypes.c_void_p),
        ("normal_map_count", ctypes.c_int),
        ("normal_maps", ctypes.c_void_p),
        ("base_color_count", ctypes.c_int),
        ("base_colors", ctypes.POINTER(CBaseColor)),
    )


class CAsset:
    """The first part of a tier of a package, in the C host; evaluates as `rna_sdk.runtime` does.

    library: of `build(folder, "librna.so")`. record: what the host says of the part.
    """

    def __init__(self, library: Path, package: Path, tier: str) -> None:
        self._rna = ctypes.CDLL(str(library))
        self._rna.rna_open.restype = ctypes.c_void_p
        self._rna.rna_part.restype = ctypes.POINTER(CPart)
        self._rna.rna_texel_density.restype = ctypes.c_double
        report = ctypes.create_string_buffer(_REPORT_BYTES)
        address = self._rna.rna_open(str(package).encode(), report)
        if not address:
            raise ValueError(f"the C host refuses {package}")
        self._asset = ctypes.c_void_p(address)
        self._tier = self._rna.rna_tier_index(self._asset, tier.encode())
        if self._tier < 0:
            raise ValueError(f"{package} has no tier {tier}")
        record = self._rna.rna_part(self._asset, 0)
        self.record: CPart = record.contents

    def close(self) -> None:
        self._rna.rna_close(self._asset)

    def evaluate(self, *arrays: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(visible, shadowed), (n, 3) float32 each.

        arrays: positions, normals, wo, wi and base colours of a surface; positions, tangents, h, wo
        and wi of fibers.
        """
        positions, axes, *rest = arrays
        in_order = [None, *rest] if self.record.kind == _SURFACE else [*rest, None]
        results = np.empty((2, len(positions), 3), np.float32)
        place = self._asset, self._tier, 0, ctypes.c_size_t(len(positions))
        given = positions, axes, *in_order, *results
        if status := self._rna.rna_evaluate(*place, *map(_address, given)):
            raise ValueError(f"rna_evaluate: status {status}")
        visible, shadowed = results
        return visible, shadowed

    def set_image(self, record: int, pixels: np.ndarray) -> int:
        """The status for (H, W, 3) uint8 pixels of a record of base colour."""
        data = np.ascontiguousarray(pixels).ctypes.data_as(ctypes.c_void_p)
        return int(self._rna.rna_set_image(self._asset, 0, record, data))

    def base_color(self, triangle: int, b1: float, b2: float, level: float) -> np.ndarray:
        """(3,) float32 at a hit."""
        color = np.empty(3, np.float32)
        numbers = (ctypes.c_double(number) for number in (b1, b2, level))
        place = ctypes.c_uint32(triangle), *numbers
        self._rna.rna_base_color(self._asset, 0, *place, _address(color))
        return color

    def texel_density(self, triangle: int) -> float:
        return float(self._rna.rna_texel_density(self._asset, 0, ctypes.c_uint32(triangle)))


def _address(array: np.ndarray | None) -> ctypes.c_void_p:
    if array is not None:
        assert array.dtype == np.float32 and array.flags.c_contiguous
    return ctypes.c_void_p(None if array is None else array.ctypes.data)
