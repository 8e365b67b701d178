"""Shared by reader programs in Python: command line, input and output files.

spec/conformance/README.md defines the protocol.
"""

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rna_sdk.conformance.kit import LEVELS
from rna_sdk.conformance.lobe_queries import COLUMNS, COMMAND, LobeQueries
from rna_sdk.conformance.program import command_of
from rna_sdk.errors import ConformanceError, RnaError
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.package.decoder.decoder_form import FORMS, TRANSPORT, DecoderForm
from rna_sdk.package.decoder.query_arrays import NEARBY, arrays_of, column_count

Evaluate = Callable[[str, str, str, int, dict[str, NDArray[np.float32]]], NDArray[np.float32]]
"""(name of a decoder form, package, tier, part, query arrays by name) -> its output (n, width).

A part without such a decoder answers 0.
"""
Environment = Callable[[str, str, int, LobeQueries], NDArray[np.float32]]
"""(package, tier, part, queries) -> (n, 6 L), amplitude and axis of each lobe."""
OfHits = Callable[[str, bytes], NDArray[np.float32]]
"""(package, hit records) -> (n, 3): visibility, RGB, or mapped normals, or base colours."""
Geometry = Callable[[str, int], NDArray[np.float32]]
"""(package, part) -> (v, 8) vertices or (p, 4) points."""
Deformed = Callable[[str, int, NDArray[np.float32], bytes], NDArray[np.float32]]
"""(package, part, shape (p, 3), hit records) -> (n, 15)."""
Validate = Callable[[str], tuple[bool, list[str]]]
"""package -> whether it is valid, and the codes of its issues."""


BASE_COLOR_HIT = np.dtype(
    {
        "names": ["primitive", "u", "v", "level", "part"],
        "formats": ["<u4", "<f4", "<f4", "<f4", "<u4"],
        "offsets": [0, 4, 8, 12, 28],
        "itemsize": 32,
    }
)
"""A hit record of the level `base-color`."""


def run_reader(
    arguments: Sequence[str] | None = None,
    *,
    evaluate: Evaluate | None = None,
    environment: Environment | None = None,
    nearby: Evaluate | None = None,
    visibility: OfHits | None = None,
    normals: OfHits | None = None,
    base_color: OfHits | None = None,
    geometry: Geometry | None = None,
    deformed: Deformed | None = None,
    validate: Validate | None = None,
) -> int:
    """The exit status of the program; a level is had if its function is given."""
    forms = {command_of(form): form for form in FORMS}
    of_hits = {"visibility": visibility, "normals": normals, "base-color": base_color}
    level, *rest = list(sys.argv[1:] if arguments is None else arguments) or [""]
    try:
        if level == "levels" and not rest:
            asked = evaluate, environment, nearby, *of_hits.values()
            had = (*asked, geometry, deformed, validate)
            print("\n".join(name for name, function in zip(LEVELS, had, strict=True) if function))
        elif level in forms and evaluate and len(rest) == 5:
            _answer(evaluate, forms[level], *rest)
        elif level == NEARBY.name and nearby and len(rest) == 5:
            _answer_nearby(nearby, *rest)
        elif level == COMMAND and environment and len(rest) == 5:
            package, tier, part, queries, results = rest
            rows = np.fromfile(queries, "<f4").reshape(-1, COLUMNS).astype(np.float32)
            _write(results, environment(package, tier, int(part), LobeQueries.of(rows)))
        elif (of_level := of_hits.get(level)) and len(rest) == 3:
            package, hits, results = rest
            _write(results, of_level(package, Path(hits).read_bytes()))
        elif level == "geometry" and geometry and len(rest) == 3:
            package, part, results = rest
            _write(results, geometry(package, int(part)))
        elif level == "deformed" and deformed and len(rest) == 5:
            package, part, shape, hits, results = rest
            positions = np.fromfile(shape, "<f4").reshape(-1, 3).astype(np.float32)
            _write(results, deformed(package, int(part), positions, Path(hits).read_bytes()))
        elif level == "validate" and validate and len(rest) == 1:
            valid, codes = validate(rest[0])
            print("\n".join(codes))
            return 0 if valid else 1
        else:
            raise ConformanceError(f"unknown call of a reader: {' '.join([level, *rest])}")
    except (RnaError, OSError, ValueError) as error:
        print("error: " + "; ".join(str(error).splitlines()), file=sys.stderr)
        return 2
    return 0


def _answer(
    function: Evaluate,
    form: DecoderForm,
    package: str,
    tier: str,
    part: str,
    queries: str,
    results: str,
) -> None:
    columns = column_count(form.arrays)
    rows = np.fromfile(queries, "<f4").reshape(-1, columns).astype(np.float32)
    _write(results, function(form.name, package, tier, int(part), arrays_of(rows, form.arrays)))


def _answer_nearby(
    function: Evaluate, package: str, tier: str, part: str, queries: str, results: str
) -> None:
    columns = column_count(TRANSPORT.arrays)
    rows = np.fromfile(queries, "<f4").reshape(-1, columns + NEARBY.columns).astype(np.float32)
    arrays = arrays_of(rows[:, :columns], TRANSPORT.arrays)
    arrays[NEARBY.name] = np.ascontiguousarray(rows[:, columns:])
    _write(results, function(TRANSPORT.name, package, tier, int(part), arrays))


def _write(path: str, values: NDArray[np.float32]) -> None:
    write_atomically(Path(path), values.astype("<f4").tobytes())
