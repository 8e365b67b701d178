"""The conformance kit on disk: `kit.json` and the files that it lists."""

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

from rna_sdk.errors import ConformanceError

INDEX = "kit.json"
VERSION = 8
LEVELS = (
    *("evaluate", "environment", "nearby", "visibility", "normals", "base-color"),
    *("geometry", "deformed", "validate"),
)
"""All but the second are of the format itself; that is of an extension that no reader must know."""


@dataclass(frozen=True)
class RowClass:
    """Class of rows `first` to `first + rows - 1`."""

    name: str
    first: int
    rows: int


@dataclass(frozen=True)
class EvaluateCase:
    """One part in one tier of a package.

    Attributes:
        package, queries: files.
        part: its number.
        output: name of the decoder's form.
        expected, tolerance: (n, width) of the decoder's output, float64.
        step: the most that one step of one int8 activation changes an output; 0 for float32.
    """

    level: ClassVar[str] = "evaluate"
    package: Path
    tier: str
    part: int
    output: str
    queries: Path
    expected: NDArray[np.float64]
    tolerance: NDArray[np.float64]
    step: float
    classes: tuple[RowClass, ...]


@dataclass(frozen=True)
class LobesCase(EvaluateCase):
    """Lobes of a part (RNA_environment).

    Attributes:
        queries: file of LobeQueries.
        expected, tolerance: (n, 6 L), amplitude and axis of each lobe.
    """

    level: ClassVar[str] = "environment"


@dataclass(frozen=True)
class NearbyCase(EvaluateCase):
    """A part that counts nearby light, which stands in three more columns of its queries."""

    level: ClassVar[str] = "nearby"


@dataclass(frozen=True)
class VisibilityCase:
    """Hits on the parts of a package; expected: (n, 3) float32, the visibility, RGB."""

    level: ClassVar[str] = "visibility"
    package: Path
    hits: Path
    expected: NDArray[np.float32]
    classes: tuple[RowClass, ...]


@dataclass(frozen=True)
class GeometryCase:
    """A part of a package, with integers for its geometry.

    Attributes:
        expected, tolerance: float64, a row for each vertex or point.
    """

    level: ClassVar[str] = "geometry"
    package: Path
    part: int
    expected: NDArray[np.float64]
    tolerance: NDArray[np.float64]
    classes: tuple[RowClass, ...]


@dataclass(frozen=True)
class NormalsCase(GeometryCase):
    """Hits on a part of a package; expected, tolerance: (n, 3) float64, the mapped normal."""

    level: ClassVar[str] = "normals"
    hits: Path


@dataclass(frozen=True)
class BaseColorCase(NormalsCase):
    """Hits on a part of a package; expected, tolerance: (n, 3) float64, the base colour."""

    level: ClassVar[str] = "base-color"


@dataclass(frozen=True)
class DeformedCase(NormalsCase):
    """Hits on a part with other positions, those in the file `shape`; expected, tolerance:
    (n, 15) float64, rest position, normal or tangent there, rotation to rest by rows."""

    level: ClassVar[str] = "deformed"
    shape: Path


@dataclass(frozen=True)
class ValidateCase:
    """A package, whether it is valid, and the code among its issues, if there is one.

    Attributes:
        extension: an optional one that the fault is in; a reader that does not know it says so.
    """

    level: ClassVar[str] = "validate"
    package: Path
    valid: bool
    code: str | None
    extension: str | None


Evaluated = TypeVar("Evaluated", bound=EvaluateCase)
OfPart = TypeVar("OfPart", bound=GeometryCase)


@dataclass(frozen=True)
class Kit:
    """All cases.

    Attributes:
        int8_share: part of the rows of an int8 decoder that may differ by a step.
        visibility_tolerance: how far a visibility may be off.
    """

    int8_share: float
    visibility_tolerance: float
    evaluate: tuple[EvaluateCase, ...]
    environment: tuple[LobesCase, ...]
    nearby: tuple[NearbyCase, ...]
    visibility: tuple[VisibilityCase, ...]
    normals: tuple[NormalsCase, ...]
    base_color: tuple[BaseColorCase, ...]
    geometry: tuple[GeometryCase, ...]
    deformed: tuple[DeformedCase, ...]
    validate: tuple[ValidateCase, ...]


def find_kit() -> Path:
    """The kit of the clone that this package is run from.

    Raises:
        ConformanceError: there is none; wheels come without it.
    """
    folder = Path(__file__).parents[2] / "spec" / "conformance"
    if not (folder / INDEX).is_file():
        raise ConformanceError(
            "the installed SDK does not contain the conformance kit; pass --kit PATH, the folder "
            "spec/conformance of a checkout"
        )
    return folder


def load_kit(folder: Path) -> Kit:
    """The kit in `folder`, every file compared with its hash.

    Raises:
        ConformanceError: there is no kit, or a file of it is missing or was changed.
    """
    try:
        index = json.loads((folder / INDEX).read_bytes())
    except (OSError, ValueError) as error:
        raise ConformanceError(
            f"{folder / INDEX}: not the index of a conformance kit: {error}"
        ) from None
    if not isinstance(index, dict) or index.get("version") != VERSION:
        raise ConformanceError(f"{folder / INDEX}: expected a kit of version {VERSION}")
    for name, record in index["files"].items():
        _check_file(folder / name, record)
    return Kit(
        index["int8Share"],
        index["visibilityTolerance"],
        tuple(_evaluate_case(EvaluateCase, folder, record) for record in index["evaluate"]),
        tuple(_evaluate_case(LobesCase, folder, record) for record in index["environment"]),
        tuple(_evaluate_case(NearbyCase, folder, record) for record in index["nearby"]),
        tuple(_visibility_case(folder, record) for record in index["visibility"]),
        tuple(_part_case(NormalsCase, folder, record) for record in index["normals"]),
        tuple(_part_case(BaseColorCase, folder, record) for record in index["base-color"]),
        tuple(_part_case(GeometryCase, folder, record) for record in index["geometry"]),
        tuple(_part_case(DeformedCase, folder, record) for record in index["deformed"]),
        tuple(
            ValidateCase(
                folder / record["package"], record["valid"], record["code"], record["extension"]
            )
            for record in index["validate"]
        ),
    )


def _check_file(path: Path, record: dict[str, Any]) -> None:
    try:
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError as error:
        raise ConformanceError(f"{path}: cannot read a file of the kit: {error}") from None
    if digest != record["sha256"]:
        raise ConformanceError(
            f"{path}: found SHA-256 {digest[:16]}..., expected {record['sha256'][:16]}...; the kit "
            "was modified or is incomplete"
        )


def _evaluate_case(case: type[Evaluated], folder: Path, record: dict[str, Any]) -> Evaluated:
    expected, tolerance = _expected(folder, record)
    return case(
        folder / record["package"],
        record["tier"],
        record["part"],
        record["output"],
        folder / record["queries"],
        expected,
        tolerance,
        record["step"],
        _classes(record),
    )


def _expected(
    folder: Path, record: dict[str, Any]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Expected values, and their tolerances."""
    both = np.fromfile(folder / record["expected"], "<f8").reshape(record["rows"], -1)
    expected, tolerance = np.hsplit(both.astype(np.float64), 2)
    return expected, tolerance


def _part_case(case: type[OfPart], folder: Path, record: dict[str, Any]) -> OfPart:
    files = {name: folder / record[name] for name in ("hits", "shape") if name in record}
    return case(
        folder / record["package"],
        record["part"],
        *_expected(folder, record),
        _classes(record),
        **files,
    )


def _visibility_case(folder: Path, record: dict[str, Any]) -> VisibilityCase:
    return VisibilityCase(
        folder / record["package"],
        folder / record["hits"],
        np.fromfile(folder / record["expected"], "<f4").reshape(-1, 3).astype(np.float32),
        _classes(record),
    )


def _classes(record: dict[str, Any]) -> tuple[RowClass, ...]:
    return tuple(RowClass(c["name"], c["first"], c["rows"]) for c in record["classes"])
