"""A copy of onnxruntime that sees a CPU with AVX2 alone, for tests on newer machines.

onnxruntime has no setting that keeps it from AVX-512 and VNNI, and its kernels for int8 differ
there: without VNNI, products of uint8 and int8 are summed two by two in 16 bits, with saturation.
The copy's cpuid instructions trap into `cpuid.c`. All else runs at the machine's own speed.
"""

import platform
import re
import shutil
import subprocess
from importlib.util import find_spec
from pathlib import Path

_CPUID, _TRAP = b"\x0f\xa2", b"\x0f\x0b"
_NOPS = b"\x90" * 16  # more than the longest instruction has
_BEFORE = 512
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
    library.write_bytes(_trapped(source, folder))
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


def _trapped(library: Path, folder: Path) -> bytes:
    """The library's bytes with every cpuid replaced."""
    data = bytearray(library.read_bytes())
    places = [
        found.start()
        for start, stop in _code_sections(library)
        for found in re.compile(_CPUID).finditer(data, start, stop)
    ]
    for at in _instructions(data, places, folder):
        data[at : at + 2] = _TRAP
    return bytes(data)


def _code_sections(library: Path) -> list[tuple[int, int]]:
    """First and last offset in the file of each section of code."""
    table = subprocess.run(["objdump", "-h", library], check=True, capture_output=True, text=True)
    lines = re.findall(
        r"^\s*\d+ \S+\s+(\w+)\s+\w+\s+\w+\s+(\w+).*\n.*CODE", table.stdout, re.MULTILINE
    )
    return [(int(at, 16), int(at, 16) + int(size, 16)) for size, at in lines]


def _instructions(data: bytes, places: list[int], folder: Path) -> list[int]:
    """The places where cpuid is an instruction, and not a part of one.

    Only the code before each place is disassembled: that of the whole library takes 10 s. The
    first instructions may be read wrongly, from their middle; soon they are read as they are.
    """
    pieces = folder / "pieces.bin"
    pieces.write_bytes(b"".join(data[at - _BEFORE : at + 2] + _NOPS for at in places))
    command = ["objdump", "-D", "-b", "binary", "-m", "i386:x86-64", pieces]
    listing = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    found = {int(a, 16) for a in re.findall(r"^\s*(\w+):.*\tcpuid\b", listing, re.MULTILINE)}
    size = _BEFORE + len(_CPUID + _NOPS)
    return [at for k, at in enumerate(places) if k * size + _BEFORE in found]
