"""Lobes of the kit (RNA_environment): their data, queries, and answers in float64."""

from dataclasses import replace

import numpy as np

from rna_sdk.package import Curves, Lobes, Mesh
from rna_sdk.package.decoder.query_arrays import arrays_of
from tests.conformance.kit import decoders
from tests.conformance.kit.answers import PART_OF_SCALE, SIGN_PATTERNS, Answers
from tests.conformance.kit.blocks import Points, decoder_inputs, dot, moved_blocks
from tests.conformance.kit.decoders import Decoder
from tests.conformance.kit.plans import LobesPlan, PartPlan
from tests.conformance.kit.queries import ALL, ORDINARY, WI, Maker, make_queries, valid_rows

_CALIBRATION_ROWS = 600
_OF_A_CLASS = {ORDINARY: 24, "NaN": 10}
_FEW = 6
"""Rows that are kept of each other class of queries."""


def make_lobes(
    rng: np.random.Generator, part: PartPlan, planes: np.ndarray
) -> tuple[Lobes, Answers]:
    """planes: (3, R, R, C) float64, those of the first tier."""
    plan = part.lobes
    assert plan is not None
    harmonics = None
    if plan.visibility:
        count = len(_vertices(part.geometry))
        harmonics = rng.integers(-127, 128, (count, 16)).astype(np.int8)
    rows, classes = _rows(int(rng.integers(2**32)), part)
    ordinary = Maker(rng, part.is_fiber, part.bounds).ordinary(_CALIBRATION_ROWS)
    blocks = _inputs(_points(ordinary, part), plan, planes)
    if harmonics is not None:
        blocks = np.hstack([blocks, rng.uniform(-1, 1, (len(blocks), 16))])
    width = 9 * plan.lobes
    decoder = decoders.make_decoder(rng, blocks, plan.widths, output="environment", colours=width)
    lobes = Lobes(part.tiers[0].name, plan.lobes, plan.inputs, decoder.file(), harmonics)
    return lobes, _answers(rng, part, planes, decoder, harmonics, rows, classes)


def _vertices(geometry: Mesh | Curves) -> np.ndarray:
    return geometry.positions if isinstance(geometry, Mesh) else geometry.points


def _rows(seed: int, part: PartPlan) -> tuple[np.ndarray, list[tuple[str, int, int]]]:
    """(n, 14) float32 of LobeQueries, and the classes."""
    queries, actual = make_queries(seed, part.is_fiber, part.bounds)
    valid_rows, classes, first = [], [], 0
    for name, start, count in actual:
        count = min(count, _OF_A_CLASS.get(name, _FEW))
        valid_rows.append(queries[start : start + count, : WI.start])
        classes.append((name, first, count))
        first += count
    valid_rows.append(valid_rows[0][:5])
    classes.append(("other visibility", first, 5))
    rows, rng = np.concatenate(valid_rows), np.random.default_rng(seed)
    free = rng.random(len(rows))
    free[-5:] = -0.5, 1.5, np.nan, np.inf, -np.inf
    geometry = part.geometry
    primitives = len(geometry.triangles if isinstance(geometry, Mesh) else geometry.segments())
    u, v, _ = rng.dirichlet((1, 1, 1), len(rows)).T
    place = rng.integers(primitives, size=len(rows)), u, v * (not part.is_fiber)
    return np.column_stack([rows, free, *place]).astype(np.float32), classes


def _points(rows: np.ndarray, part: PartPlan) -> Points:
    """With the mirror direction for wi; rows: (n, 10 or more), valid."""
    position, axis, h, wo = rows[:, :3], rows[:, 3:6], rows[:, 6], rows[:, 7:10]
    arrays = {"position": position, "axis": axis, "h": h, "wo": wo}
    return _mirrored(Points.of(arrays, part.bounds), part.is_fiber)


def _mirrored(points: Points, is_fiber: bool) -> Points:
    n, o = points.axis, points.wo
    turned = 2 * dot(n, o)[:, None] * n
    return replace(points, wi=o - turned if is_fiber else turned - o)


def _inputs(points: Points, plan: LobesPlan, planes: np.ndarray) -> np.ndarray:
    return decoder_inputs(points, plan.inputs, planes, of_lobes=True)


def _mixed(part: PartPlan, harmonics: np.ndarray | None, rows: np.ndarray) -> np.ndarray:
    """(n, 16 or 0): coefficients at the places of the rows, corner by corner."""
    if harmonics is None:
        return np.zeros((len(rows), 0))
    number, u, v = rows[:, 11].astype(int), *rows[:, 12:].T.astype(np.float64)
    if isinstance(part.geometry, Mesh):
        a, b, c = part.geometry.triangles[number].T
        corners = ((a, 1 - u - v), (b, u), (c, v))
    else:
        first = part.geometry.segments()[number]
        corners = ((first, 1 - u), (first + 1, u))
    return sum(weight[:, None] * harmonics[k].astype(np.float64) / 127 for k, weight in corners)


def _lobes(values: np.ndarray, points: Points, free: np.ndarray, is_fiber: bool) -> np.ndarray:
    """(n, 6 L) of the decoder's output (n, 9 L): spec/RNA.md, 12.1."""
    lobe = values.reshape(len(values), -1, 9)
    count, v = lobe.shape[1], np.clip(free, 0, 1)[:, None, None]
    axis = lobe[:, :, 6:] - 8
    axis[:, : count // 2] += (-2 * points.wo if is_fiber else 2 * points.axis)[:, None]
    axis[:, count // 2 :] += 10 * points.wi[:, None]
    amplitude = v * lobe[:, :, :3] + (1 - v) * lobe[:, :, 3:6]
    return np.concatenate([amplitude, axis], axis=2).reshape(len(values), -1)


def _answers(
    rng: np.random.Generator,
    part: PartPlan,
    planes: np.ndarray,
    decoder: Decoder,
    harmonics: np.ndarray | None,
    rows: np.ndarray,
    classes: list[tuple[str, int, int]],
) -> Answers:
    plan = part.lobes
    names = [name for name in ALL if name != "wi"]
    valid = valid_rows(arrays_of(rows[:, : WI.start], names)) & np.isfinite(rows[:, 10])
    points, free = _points(rows[valid], part), rows[valid, 10].astype(np.float64)
    mixed = _mixed(part, harmonics, rows[valid])

    def inputs_of(at: Points) -> np.ndarray:
        return np.hstack([_inputs(at, plan, planes), mixed])

    def answer_of(at: Points, inputs: np.ndarray) -> np.ndarray:
        return _lobes(decoder(inputs), at, free, part.is_fiber)

    inputs = inputs_of(points)
    answer = answer_of(points, inputs)
    change = np.zeros_like(answer)
    for _ in range(SIGN_PATTERNS):
        at = _mirrored(points.rounded(rng), part.is_fiber)
        moved = answer_of(at, moved_blocks(inputs_of(at), rng))
        change = np.maximum(change, np.abs(moved - answer))
    squares = (answer[: classes[0][2]] ** 2).reshape(-1, plan.lobes, 2, 3)
    scales = np.sqrt(squares.mean(axis=(0, 1, 3)))  # of amplitudes, of axes
    blocks = np.zeros((len(rows), inputs.shape[1]))
    expected, tolerance = np.zeros((2, len(rows), answer.shape[1]))
    blocks[valid], expected[valid] = inputs, answer
    tolerance[valid] = PART_OF_SCALE * np.tile(np.repeat(scales, 3), plan.lobes) + change
    return Answers(rows, blocks, expected, tolerance, classes, float(scales[0]), 0.0)
