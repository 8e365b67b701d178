"""A copy of onnxruntime that sees a CPU with AVX2 alone, for tests on newer machines.

onnxruntime has no setting that keeps it from AVX-512 and VNNI, and its kernels for int8 differ
there: without VNNI, products of uint8 and int8 are summed two by two in 16 bits, with saturation.
The copy's cpuid instructions trap into `cpuid.c`. All else runs at the machine's own speed.
"""

from __future__ import annotations

import platform
import re
import shutil
import subprocess
from importlib.util import find_spec
from pathlib import Path

_CPUID, _TRAP = b"\x0f\xa2", b"\x0f\x0b"
_LIBRARY = "onnxruntime_pybind11_state*.so"


def missing() -> str | None:
    """What this machine lacks to make such a copy; None if nothing."""
    if platform.machine().lower() not in ("x86_64", "amd64"):
        return "the CPU is not x86-64"
    tools = [tool for tool in ("cc", "objdump") if shutil.which(tool) is None]
    return f"{' and '.join(tools)} not found" if tools else None


def make_avx2_onnxruntime(folder: Path) -> Path:
    """Make the copy in `folder`, an empty one; returns what to put in front of PYTHONPATH."""
    spec = find_spec("onnxruntime")
    assert spec is not None and spec.origin is not None
    original, copy = Path(spec.origin).parent, folder / "onnxruntime"
    shutil.copytree(original, copy, copy_function=_link)
    (library,) = (copy / "capi").glob(_LIBRARY)
    source = library.resolve()
    library.unlink()
    library.write_bytes(_trapped(source))
    here = Path(__file__).with_name("cpuid.c")
    handler = folder / "cpuid.so"
    subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-o", handler, here], check=True)
    init = copy / "__init__.py"
    text = init.read_text()
    init.unlink()
    init.write_text(f"import ctypes\n\nctypes.CDLL({str(handler)!r})\n{text}")
    return folder


def _link(source: str, target: str) -> None:
    Path(target).symlink_to(source)


def _trapped(library: Path) -> bytes:
    """The library's bytes with every cpuid replaced."""
    data = bytearray(library.read_bytes())
    for start, size, offset in _code_segments(library):
        for address in _cpuid_addresses(library, start, start + size):
            at = address - start + offset
            assert data[at : at + 2] == _CPUID
            data[at : at + 2] = _TRAP
    return bytes(data)


def _code_segments(library: Path) -> list[tuple[int, int, int]]:
    """(address, bytes, offset in the file) of each section of code."""
    table = subprocess.run(["objdump", "-h", library], check=True, capture_output=True, text=True)
    lines = re.findall(
        r"^\s*\d+ \S+\s+(\w+)\s+(\w+)\s+\w+\s+(\w+).*\n.*CODE", table.stdout, re.MULTILINE
    )
    return [(int(address, 16), int(size, 16), int(at, 16)) for size, address, at in lines]


def _cpuid_addresses(library: Path, start: int, stop: int) -> list[int]:
    command = ["objdump", "-d", "--no-show-raw-insn"]
    command += [f"--start-address={start}", f"--stop-address={stop}", library]
    listing = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return [int(a, 16) for a in re.findall(r"^\s*(\w+):\s+cpuid\b", listing, re.MULTILINE)]
