"""Faults planted in copies of the readers, to prove that their fuzzers find such."""

import shutil
from dataclasses import dataclass
from pathlib import Path

from tests.conftest import REPOSITORY
from tests.fuzz.packages import WEB_READER, build
from tests.hosts.c_host import SOURCES


@dataclass(frozen=True)
class Bug:
    """`before` in the source `file` becomes `after`."""

    file: str
    before: str
    after: str

    def plant(self, folder: Path) -> None:
        text = (folder / self.file).read_text()
        assert text.count(self.before) == 1, (self.file, self.before)
        (folder / self.file).write_text(text.replace(self.before, self.after))


def _unless(bug: int, condition: str) -> str:
    return f"!planted({bug}) && ({condition})"


_END = "end > file.size - start"
_REST = "end != file.size - start"
_VERTEX = "largest >= vertices"
_VIEW = "start + stride * (elements - 1) + size > view_end || view_end > blob.size || start % 4"
_COLUMN = "(size_t)row * texture->width + (size_t)column"

C_BUGS = {
    "a texel beside the texture": [
        Bug("rna/textures.h", _COLUMN, f"{_COLUMN} + (size_t)planted(0)")
    ],
    "a tensor longer than its file": [
        Bug("rna/tensors.h", f"|| {_END}", f"|| ({_unless(1, _END)})"),
        Bug("rna/tensors.h", f"if ({_REST})", f"if ({_unless(1, _REST)})"),
    ],
    "a vertex that does not exist": [
        Bug("rna/mesh.h", f"if ({_VERTEX})", f"if ({_unless(2, _VERTEX)})")
    ],
    "an accessor past its view": [Bug("rna/mesh.h", f"if ({_VIEW})", f"if ({_unless(3, _VIEW)})")],
}
"""All are read past the end of an entry, which is inside the package."""

_SWITCH = """
static bool planted(int bug) {
    const char *wanted = getenv("PLANTED");
    return wanted && atoi(wanted) == bug;
}
"""

WEB_BUGS = {
    "a texture longer than its file": [
        Bug("tensors.js", " || data + last > bytes.length", ""),
        Bug("tensors.js", "if (data + next !== bytes.length)", "if (false)"),
    ],
    "a record past the mesh": [
        Bug("textures.js", "if (first + count > mesh.indices.length / 3)", "if (false)")
    ],
    "a vertex that does not exist": [Bug("mesh.js", "if (indices[k] >= count)", "if (false)")],
}


def build_planted(folder: Path) -> Path:
    """c_host.c with all C_BUGS, of which the number in PLANTED is switched on."""
    sources = shutil.copytree(SOURCES, folder / "c", ignore=shutil.ignore_patterns("build"))
    for bug in (bug for bugs in C_BUGS.values() for bug in bugs):
        bug.plant(sources)
    Bug("rna/base.h", "/* Limits of section 11. */", _SWITCH).plant(sources)
    return build(folder, sources)


def planted_web_reader(folder: Path, bugs: list[Bug]) -> Path:
    """The viewer's reader with these faults."""
    package = folder / "runtime" / "web" / "src" / "package"
    shutil.copytree(WEB_READER, package)
    shutil.copy(WEB_READER.parent / "steps.js", package.parent)
    for name in (
        *("spec/blocks.json", "spec/schema/manifest.schema.json"),
        *("runtime/web/src/decoder/records.js", "runtime/rna_gpu/wgsl/records.json"),
    ):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(REPOSITORY / name, folder / name)
    for bug in bugs:
        bug.plant(package)
    return package
