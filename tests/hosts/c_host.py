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


class CAsset:
    """A tier of a package, in the C host; evaluates as `rna_sdk.runtime` does.

    library: of `build(folder, "librna.so")`.
    """

    def __init__(self, library: Path, package: Path, tier: str) -> None:
        self._rna = ctypes.CDLL(str(library))
        self._rna.rna_open.restype = ctypes.c_void_p
        report = ctypes.create_string_buffer(_REPORT_BYTES)
        address = self._rna.rna_open(str(package).encode(), report)
        if not address:
            raise ValueError(f"the C host refuses {package}")
        self._asset = ctypes.c_void_p(address)
        self._tier = self._rna.rna_tier_index(self._asset, tier.encode())
        if self._tier < 0:
            raise ValueError(f"{package} has no tier {tier}")

    def close(self) -> None:
        self._rna.rna_close(self._asset)

    def evaluate(self, *arrays: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(visible, shadowed), (n, 3) float32 each, of positions, axes, [h,] wo, wi."""
        positions, axes, *h, wo, wi = arrays
        visible, shadowed = np.empty((2, len(positions), 3), np.float32)
        pointers = (_address(a) for a in (positions, axes, *(h or (None,)), wo, wi))
        status = self._rna.rna_evaluate(
            self._asset,
            self._tier,
            0,
            ctypes.c_size_t(len(positions)),
            *pointers,
            _address(visible),
            _address(shadowed),
        )
        if status:
            raise ValueError(f"rna_evaluate: status {status}")
        return visible, shadowed


def _address(array: np.ndarray | None) -> ctypes.c_void_p:
    if array is not None:
        assert array.dtype == np.float32 and array.flags.c_contiguous
    return ctypes.c_void_p(None if array is None else array.ctypes.data)
