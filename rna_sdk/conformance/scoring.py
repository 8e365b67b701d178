"""Scores of a reader: each case of the kit against its expected values."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from rna_sdk.conformance import program as reader
from rna_sdk.conformance.kit import (
    DeformedCase,
    EvaluateCase,
    GeometryCase,
    Kit,
    LobesCase,
    NearbyCase,
    NormalsCase,
    RowClass,
    ValidateCase,
    VisibilityCase,
)
from rna_sdk.conformance.program import Program
from rna_sdk.errors import ConformanceError
from rna_sdk.package.decoder.decoder_form import TRANSPORT, allowed, form_named


@dataclass(frozen=True)
class Score:
    """Score of a case.

    Attributes:
        level, package, tier: which case; tier is "" where there is none, and has the part, and
            the decoder's form except for transport, behind it where there are any.
        rows, right: how many rows there are, and how many are within their tolerance.
        passed: the verdict.
        in_tolerances, absolute: the largest difference over all rows but those that a step of
            int8 excuses; infinite where an answer is not finite or negative, 0 where the level
            has no differences.
        note: what is wrong or excused, one line; "" if nothing is.
    """

    level: str
    package: str
    tier: str
    rows: int
    right: int
    passed: bool
    in_tolerances: float = 0.0
    absolute: float = 0.0
    note: str = ""


Case = EvaluateCase | VisibilityCase | GeometryCase | ValidateCase


def cases(kit: Kit, level: str) -> list[Case]:
    """The cases of the level."""
    return list(getattr(kit, level.replace("-", "_")))


def score(program: Program, kit: Kit, case: Case) -> Score:
    """Score of the reader; if it fails or its output cannot be read, no row is right."""
    try:
        if isinstance(case, LobesCase):
            return _lobes(program, case)
        if isinstance(case, EvaluateCase):
            return _evaluate(program, case, kit.int8_share)
        if isinstance(case, VisibilityCase):
            return _visibility(program, case, kit.visibility_tolerance)
        if isinstance(case, GeometryCase):
            return _of_part(program, case)
        return _validate(program, case)
    except ConformanceError as error:
        return replace(_nothing(case), note=str(error))


def _nothing(case: Case) -> Score:
    rows = 1 if isinstance(case, ValidateCase) else len(case.expected)
    return Score(case.level, case.package.stem, _tier(case), rows, 0, False)


def _evaluate(program: Program, case: EvaluateCase, int8_share: float) -> Score:
    form = form_named(case.output)
    with_nearby = isinstance(case, NearbyCase)
    actual = reader.evaluate(
        program,
        form,
        case.expected.shape[1],
        case.package,
        case.tier,
        case.part,
        case.queries,
        with_nearby,
    )
    return _compared(case, actual, allowed(actual), case.step, int8_share)


def _lobes(program: Program, case: LobesCase) -> Score:
    actual = reader.lobes(
        program, case.expected.shape[1], case.package, case.tier, case.part, case.queries
    )
    is_axis = np.arange(actual.shape[1]) % 6 >= 3
    return _compared(case, actual, allowed(actual) | (np.isfinite(actual) & is_axis))


def _of_part(program: Program, case: GeometryCase) -> Score:
    if isinstance(case, DeformedCase):
        actual = reader.deformed(
            program, len(case.expected), case.package, case.part, case.shape, case.hits
        )
    elif isinstance(case, NormalsCase):
        actual = reader.of_hits(program, case.level, case.package, case.hits)
    else:
        rows, columns = case.expected.shape
        actual = reader.geometry(program, (rows, columns), case.package, case.part)
    return _compared(case, actual, np.isfinite(actual))


def _compared(
    case: EvaluateCase | GeometryCase,
    actual: NDArray[np.float64],
    good: NDArray[np.bool_],
    step: float = 0.0,
    int8_share: float = 0.0,
) -> Score:
    """Each value against its tolerance; `int8_share` of the rows may be off by a step of int8."""
    difference = np.where(good, np.abs(actual - case.expected), np.inf)
    units = _units(difference, case.tolerance)
    wrong = units.max(axis=1) > 1
    by_a_step = np.all(difference <= case.tolerance + step, axis=1)
    few = step > 0 and int(np.sum(wrong)) <= int8_share * len(actual)
    within = not wrong.any() or (few and bool(by_a_step[wrong].all()))
    counted = ~wrong if within else np.ones_like(wrong)
    steps = f"{int(wrong.sum())} rows by one step of int8" if within and wrong.any() else ""
    return Score(
        case.level,
        case.package.stem,
        _tier(case),
        len(actual),
        int(np.sum(~wrong)),
        within,
        float(units[counted].max()),
        float(difference[counted].max()),
        steps if within else _worst(case, actual, int(units.max(axis=1).argmax())),
    )


def _tier(case: Case) -> str:
    if not isinstance(case, EvaluateCase):
        return ""
    return f"{case.tier} {case.part}" + f" {case.output}" * (case.output != TRANSPORT.name)


def _units(difference: NDArray[np.float64], tolerance: NDArray[np.float64]) -> NDArray[np.float64]:
    """Differences in tolerances; where that is 0 none is 0, and any is infinite."""
    exact = np.where(difference > 0, np.inf, 0.0)
    return np.divide(difference, tolerance, out=exact, where=tolerance > 0)


def _worst(
    case: EvaluateCase | VisibilityCase | GeometryCase, actual: NDArray[np.float64], row: int
) -> str:
    return (
        f"row {row} ({_class_of(case.classes, row)}): found {_shown(actual[row])}, "
        f"expected {_shown(case.expected[row])}"
    )


def _shown(values: NDArray[np.floating]) -> str:
    return " ".join(f"{value:.6g}" for value in values)


def _visibility(program: Program, case: VisibilityCase, tolerance: float) -> Score:
    actual = reader.of_hits(program, case.level, case.package, case.hits)
    difference = np.where(np.isfinite(actual), np.abs(actual - case.expected), np.inf).max(axis=1)
    wrong, note = np.flatnonzero(difference > tolerance), ""
    if len(wrong):
        where = ", ".join(sorted({_class_of(case.classes, int(k)) for k in wrong}))
        note = f"{_worst(case, actual, int(wrong[0]))}; wrong in: {where}"
    rows = len(actual)
    return Score(case.level, case.package.stem, "", rows, rows - len(wrong), not note, note=note)


def _validate(program: Program, case: ValidateCase) -> Score:
    valid, codes = reader.validate(program, case.package)
    passed = valid == case.valid and (case.code is None or case.code in codes)
    if case.extension and not passed:
        passed = "EXTENSION_UNKNOWN" in codes or (not valid and "EXTENSION_REQUIRED" in codes)
    note = ""
    if not passed:
        names = {True: "valid", False: "invalid"}
        expected = " ".join(filter(None, (names[case.valid], case.code)))
        note = f"found {' '.join((names[valid], *codes[:4]))}, expected {expected}"
    return Score(case.level, case.package.stem, "", 1, int(passed), passed, note=note)


def _class_of(classes: tuple[RowClass, ...], row: int) -> str:
    return next(c.name for c in classes if c.first <= row < c.first + c.rows)
