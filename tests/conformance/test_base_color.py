"""Readers that get base colour, or a decoder of shadowed light, wrong do not pass the kit."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from rna_sdk.conformance import reader
from rna_sdk.conformance.reader_program import BASE_COLOR_HIT
from rna_sdk.package import BaseColor, Package
from tests.conformance import twin_reader
from tests.conformance.conftest import InProcess
from tests.conformance.test_readers import failures
from tests.reference import base_color as reference

Arrays = dict[str, np.ndarray]


def test_hits_are_of_every_sort(kit):
    (case,) = (case for case in kit.base_color if case.package.stem == "surface-print")
    rows = {c.name: c.rows for c in case.classes}
    assert sum(rows.values()) == len(case.expected) and min(rows.values()) >= 12
    hits = np.fromfile(case.hits, BASE_COLOR_HIT)
    with Package.open(case.package) as package:
        records = package.base_color()
    wraps = {wrap for record in records if record.image is not None for wrap in record.wrap}
    assert wraps == {"repeat", "clamp", "mirror"}
    assert {record.color_space for record in records} == {"srgb", "linear"}
    assert any(record.image is None for record in records)
    by_level = case.tolerance.max(axis=1)
    assert by_level[hits["level"] == 0].max() < 5e-4 and by_level.max() < 6e-3


def with_records(change: Callable[[BaseColor], BaseColor | None]) -> InProcess:
    """Records of base colour are read wrong, or not at all."""
    base_color = Package.base_color

    def changed(package: Package, part: int = 0) -> list[BaseColor]:
        return [new for old in base_color(package, part) if (new := change(old))]

    def answer(package: str, records: bytes) -> np.ndarray:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Package, "base_color", changed)
            return reader.base_color(package, records)

    return InProcess(base_color=answer)


def image_of(change: Callable[[np.ndarray], np.ndarray]) -> Callable[[BaseColor], BaseColor]:
    def changed(record: BaseColor) -> BaseColor:
        if record.image is None:
            return record
        return replace(record, image=np.ascontiguousarray(change(record.image)))

    return changed


@pytest.mark.parametrize(
    "change",
    [
        lambda record: None,
        lambda record: replace(record, color_space="linear"),
        lambda record: replace(record, color_space="srgb"),
        lambda record: replace(record, factor=(1, 1, 1)),
        lambda record: replace(record, wrap=("repeat", "repeat")),
        lambda record: replace(record, wrap=("clamp", "clamp")),
        lambda record: replace(record, wrap=record.wrap[::-1]),
        lambda record: replace(record, transform=(1, 0, 0, 0, 1, 0)),
        lambda record: replace(
            record, transform=tuple(np.reshape(record.transform, (2, 3))[::-1, [1, 0, 2]].flat)
        ),
        lambda record: replace(record, first=record.first + 1, count=record.count - 1),
        image_of(lambda image: image[::-1]),
        image_of(lambda image: image[:, ::-1]),
        image_of(lambda image: image[:, :, ::-1]),
    ],
    ids=[
        *("white", "all linear", "all srgb", "no factor", "repeat", "clamp", "wrap of v"),
        *("no transform", "transform of v", "triangles", "upside down", "mirrored", "BGR"),
    ],
)
def test_readers_that_get_records_wrong_fail(change, kit):
    notes = {one.package: one.note for one in failures(with_records(change), kit, "base-color")}
    assert "expected" in notes["surface-print"]


def with_levels(change: Callable[[np.ndarray], np.ndarray]) -> InProcess:
    """Hits are asked in other levels."""

    def answer(package: str, records: bytes) -> np.ndarray:
        hits = np.frombuffer(records, BASE_COLOR_HIT).copy()
        hits["level"] = change(hits["level"])
        return reader.base_color(package, hits.tobytes())

    return InProcess(base_color=answer)


@pytest.mark.parametrize(
    "change", [np.zeros_like, np.floor, np.rint], ids=["level 0", "level below", "nearest level"]
)
def test_readers_that_do_not_filter_between_levels_fail(change, kit):
    assert failures(with_levels(change), kit, "base-color")


def with_reference(name: str, function: Callable[..., object]) -> InProcess:
    """The reference with another function in the place of one of its own."""

    def answer(package: str, records: bytes) -> np.ndarray:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(reference, name, function)
            return twin_reader.base_color(package, records)

    return InProcess(base_color=answer)


def linear_last(record: BaseColor) -> list[np.ndarray]:
    """Levels whose values of sRGB are averaged as they are."""
    return LEVELS(replace(record, color_space="linear"))


LEVELS, LOOKED_UP = reference._levels, reference._looked_up


@pytest.mark.parametrize(
    ("name", "function"),
    [
        ("_levels", linear_last),
        ("_means", lambda n: np.eye(n)[:: 2 if n > 1 else 1][: max(1, n // 2)]),
        (
            "_looked_up",
            lambda level, at, wrap: LOOKED_UP(
                level, (np.floor(at * level.shape[1::-1]) + 0.5) / level.shape[1::-1], wrap
            ),
        ),
        ("_looked_up", lambda level, at, wrap: LOOKED_UP(level, at + 0.5 / 16, wrap)),
    ],
    ids=["means before linear", "every second texel", "nearest texel", "half a texel"],
)
def test_readers_that_filter_wrong_fail(name, function, kit):
    assert failures(with_reference(name, function), kit, "base-color")


def test_interpolation_of_linear_colours_fails(kit):
    def looked_up(level: np.ndarray, at: np.ndarray, wrap: tuple[str, str]) -> np.ndarray:
        return LOOKED_UP(level**2.4, at, wrap) ** (1 / 2.4)

    assert failures(with_reference("_looked_up", looked_up), kit, "base-color")


def with_arrays(change: Callable[[Arrays], Arrays]) -> InProcess:
    """Queries are changed before they are asked."""

    def evaluate(form: str, package: str, tier: str, part: int, arrays: Arrays) -> np.ndarray:
        return reader.evaluate(form, package, tier, part, change(arrays))

    return InProcess(evaluate)


def colored(change: Callable[[np.ndarray], np.ndarray]) -> InProcess:
    def changed(arrays: Arrays) -> Arrays:
        if "base_color" not in arrays:
            return arrays
        return {**arrays, "base_color": np.ascontiguousarray(change(arrays["base_color"]))}

    return with_arrays(changed)


@pytest.mark.parametrize(
    "change",
    [np.ones_like, np.zeros_like, lambda a: a[:, ::-1], lambda a: np.minimum(a, 1), np.nan_to_num],
    ids=["white", "black", "BGR", "up to 1", "NaN"],
)
def test_readers_that_take_another_base_colour_fail(change, kit):
    failed = failures(colored(change), kit, "evaluate")
    assert {(score.package, score.tier) for score in failed} == {
        *(("surface-print", "small 0"), ("surface-print", "int8 0")),
        ("surface-shadowed", "print 0"),
    }


def test_a_reader_that_refuses_rows_for_a_base_colour_it_does_not_use_fails(kit):
    def evaluate(form: str, package: str, tier: str, part: int, arrays: Arrays) -> np.ndarray:
        answer = reader.evaluate(form, package, tier, part, arrays)
        known = np.isfinite(arrays.get("base_color", np.zeros((1, 1)))).all(axis=1)
        return np.where(known[:, None], answer, 0)

    failed = {score.package for score in failures(InProcess(evaluate), kit, "evaluate")}
    assert "surface-float32" in failed and "surface-print" not in failed


@pytest.mark.parametrize(
    "swap", [lambda v, s: (s, v), lambda v, s: (v, v)], ids=["swapped", "visible alone"]
)
def test_readers_without_the_decoder_of_shadowed_light_fail(swap, kit):
    def evaluate(form: str, package: str, tier: str, part: int, arrays: Arrays) -> np.ndarray:
        answer = reader.evaluate(form, package, tier, part, arrays)
        apart = form == "transport" and "shadowed" in package
        return np.hstack(swap(*np.hsplit(answer, 2))) if apart else answer

    failed = {score.package for score in failures(InProcess(evaluate), kit, "evaluate")}
    assert failed == {"surface-shadowed", "fiber-shadowed"}
