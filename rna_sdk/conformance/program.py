"""Reader programs: calls and valid results (spec/conformance/README.md)."""

import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from rna_sdk.conformance import lobe_queries
from rna_sdk.conformance.kit import LEVELS
from rna_sdk.errors import ConformanceError
from rna_sdk.package.decoder.decoder_form import TRANSPORT, DecoderForm
from rna_sdk.package.decoder.query_arrays import NEARBY, column_count


@dataclass(frozen=True)
class Answer:
    """Exit status and output of a program."""

    status: int
    stdout: str
    stderr: str


class Program(Protocol):
    """Something that runs with arguments."""

    def run(self, *arguments: str) -> Answer: ...


@dataclass(frozen=True)
class Command:
    """A program of the operating system; timeout: seconds that one run may take."""

    words: tuple[str, ...]
    timeout: float

    def run(self, *arguments: str) -> Answer:
        """Raises ConformanceError where it cannot start or takes too long."""
        shown = " ".join(self.words)
        try:
            done = subprocess.run(
                [*self.words, *arguments],
                stdin=subprocess.DEVNULL,
                capture_output=True,
                text=True,
                errors="replace",
                timeout=self.timeout,
            )
        except OSError as error:
            raise ConformanceError(f"cannot start {shown}: {error.strerror or error}") from None
        except subprocess.TimeoutExpired:
            what = " ".join(arguments[:1])
            raise ConformanceError(
                f"{shown} {what}: no answer after {self.timeout:g} s; see --timeout"
            ) from None
        return Answer(done.returncode, done.stdout, done.stderr)


def claimed_levels(program: Program) -> tuple[str, ...]:
    """The levels that the program says it has, in the order of LEVELS."""
    words = _checked(program.run("levels"), "levels").stdout.split()
    unknown = [word for word in words if word not in LEVELS]
    if unknown or not words:
        raise ConformanceError(
            f"levels: found {' '.join(unknown) or 'nothing'}, expected one or more lines of: "
            + ", ".join(LEVELS)
        )
    return tuple(level for level in LEVELS if level in words)


def evaluate(
    program: Program,
    form: DecoderForm,
    width: int,
    package: Path,
    tier: str,
    part: int,
    queries: Path,
    with_nearby: bool = False,
) -> NDArray[np.float64]:
    """(n, width) output of a part's decoder of this form for a file of n queries.

    with_nearby: whether the queries have nearby light in their last columns.
    """
    columns = column_count(form.arrays) + (NEARBY.columns if with_nearby else 0)
    command = NEARBY.name if with_nearby else command_of(form)
    rows = queries.stat().st_size // (4 * columns)
    return _results(program, rows, width, command, str(package), tier, str(part), str(queries))


def lobes(
    program: Program, width: int, package: Path, tier: str, part: int, queries: Path
) -> NDArray[np.float64]:
    """(n, width) amplitudes and axes of a part's lobes for a file of n LobeQueries."""
    rows = queries.stat().st_size // (4 * lobe_queries.COLUMNS)
    return _results(
        program, rows, width, lobe_queries.COMMAND, str(package), tier, str(part), str(queries)
    )


def command_of(form: DecoderForm) -> str:
    """The word of the protocol that requests a decoder's output."""
    return "evaluate" if form is TRANSPORT else form.name


def of_hits(program: Program, level: str, package: Path, hits: Path) -> NDArray[np.float64]:
    """(n, 3) visibility, mapped normals or base colours, by level, for a file of n hits."""
    rows = hits.stat().st_size // 32
    return _results(program, rows, 3, level, str(package), str(hits))


def geometry(
    program: Program, shape: tuple[int, int], package: Path, part: int
) -> NDArray[np.float64]:
    """(vertices or points, columns), the geometry that the program restores."""
    return _results(program, *shape, "geometry", str(package), str(part))


def deformed(
    program: Program, rows: int, package: Path, part: int, shape: Path, hits: Path
) -> NDArray[np.float64]:
    """(n, 15) rest position, normal or tangent, and rotation for a file of n hits."""
    return _results(program, rows, 15, "deformed", str(package), str(part), str(shape), str(hits))


def _results(program: Program, rows: int, columns: int, *call: str) -> NDArray[np.float64]:
    """Values that the program writes to a file, whose name is its last argument."""
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "results.f32"
        _checked(program.run(*call, str(results)), call[0])
        return _read(results, rows * columns).reshape(rows, columns).astype(np.float64)


def validate(program: Program, package: Path) -> tuple[bool, list[str]]:
    """Whether the program finds the package valid, and the codes it prints."""
    answer = program.run("validate", str(package))
    if answer.status not in (0, 1):
        _checked(answer, "validate")
    return answer.status == 0, answer.stdout.split()


def _checked(answer: Answer, what: str) -> Answer:
    if answer.status:
        lines = answer.stderr.strip().splitlines() or ["(it printed nothing on stderr)"]
        raise ConformanceError(f"{what}: exit status {answer.status}: {lines[-1]}")
    return answer


def _read(path: Path, count: int) -> NDArray[np.float32]:
    size = 4 * count
    actual = path.stat().st_size if path.is_file() else None
    if actual != size:
        wrote = "no file" if actual is None else f"{actual} bytes"
        raise ConformanceError(f"the reader wrote {wrote}, expected {size} bytes")
    return np.fromfile(path, "<f4")
