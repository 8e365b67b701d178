"""The packages of the kit as files, and what every tier of them answers in float64."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from rna_sdk.package import (
    BaseColor,
    BaseColorRecord,
    Bounds,
    Int8Planes,
    Lobes,
    NormalMapRecord,
    Part,
    Provenance,
    Tier,
    TierData,
    TierPart,
    TransmittanceRecord,
    Unpacked,
    write_package,
)
from rna_sdk.package.decoder.decoder_form import EMISSION, SHADOWED, TRANSPORT, VISIBLE
from rna_sdk.package.decoder.query_arrays import NEARBY, arrays_of
from tests.conformance.kit import decoders
from tests.conformance.kit.answers import PART_OF_SCALE, SIGN_PATTERNS, Answers
from tests.conformance.kit.base_color_queries import with_base_colors
from tests.conformance.kit.blocks import Points, decoder_inputs, moved_blocks
from tests.conformance.kit.decoders import Decoder, Int8Decoder, short
from tests.conformance.kit.lobes import make_lobes
from tests.conformance.kit.nearby import NEARBY_RECORD, with_nearby
from tests.conformance.kit.oddities import make_odd
from tests.conformance.kit.plans import DecoderPlan, PartPlan, Plan, TierPlan
from tests.conformance.kit.png import KINDS, Kind, png_bytes
from tests.conformance.kit.queries import ALL, ORDINARY, Maker, columns_of, make_queries, valid_rows
from tests.package.builders import make_manifest, make_part, make_tier_part

_CALIBRATION_ROWS = 600
_FORMS = {form.name: form for form in (TRANSPORT, VISIBLE, SHADOWED, EMISSION)}

Queried = tuple[Decoder | Int8Decoder, tuple[str, ...]]
"""A decoder and its input blocks."""


@dataclass(frozen=True)
class Query:
    """A query of a package."""

    tier: str
    part: int
    output: str  # name of the decoder's form


def write_asset(plan: Plan, folder: Path) -> dict[Query, Answers]:
    """Write NAME.rna below `folder`; the answers of its parts in its tiers."""
    made = [_Made(plan, number, part) for number, part in enumerate(plan.parts)]
    names = [tier.name for tier in plan.parts[0].tiers]
    manifest = make_manifest(
        *(Tier(name=n, parts=tuple(p.records[k] for p in made)) for k, n in enumerate(names)),
        parts=tuple(part.record for part in made),
        generator="rna conformance kit",
        name=plan.name,
        provenance=Provenance(source="tests/conformance/kit/assets.py", tool="numpy"),
    )
    path = folder / f"{plan.name}.rna"
    data = {name: [part.data[k] for part in made] for k, name in enumerate(names)}
    textures = {
        name: record.texture
        for part in plan.parts
        for name, record in (
            *((_texture(name), record) for name, record in part.records),
            *((_map(name), record) for name, record in part.maps),
        )
    }
    images = {
        _image(name): png_bytes(record.image, KINDS.get(name, Kind()))
        for part in plan.parts
        for name, record in part.colors
        if record.image is not None
    }
    files = {**textures, **images}
    write_package(path, manifest, [part.geometry for part in plan.parts], data, files)
    if any(part.lobes for part in made):
        Unpacked.read(path).with_environment([part.lobes for part in made]).write(path)
    if plan.name == "surface-odd":
        make_odd(path)
    return {query: answers for part in made for query, answers in part.answers.items()}


def _texture(name: str) -> str:
    return f"transmittance/{name}.safetensors"


def _map(name: str) -> str:
    return f"normals/{name}.safetensors"


def _image(name: str) -> str:
    return f"textures/{name}.png"


class _Made:
    """A part of a package, with the record, data and answers of each tier."""

    def __init__(self, plan: Plan, number: int, part: PartPlan) -> None:
        alone = len(plan.parts) == 1
        self._end = "" if alone else f"-{part.name}"
        self.record = _part(part, alone)
        self.records: list[TierPart] = []
        self.data: list[TierData] = []
        self.lobes: Lobes | None = None
        self.answers: dict[Query, Answers] = {}
        for k, tier in enumerate(part.tiers):
            seed = [len(plan.name), k + 100 * number, *plan.name.encode()]
            rng = np.random.default_rng(seed)
            if not tier.shares_planes:
                self._planes, self._values = _planes(rng, tier)
            self._add(rng, number, part, tier)
            if k == 0 and part.lobes:
                rng_of_part = np.random.default_rng([*seed, 1])
                self.lobes, answers = make_lobes(rng_of_part, part, self._values)
                self.answers[Query(tier.name, number, "environment")] = answers

    def _add(self, rng: np.random.Generator, number: int, part: PartPlan, tier: TierPlan) -> None:
        form = VISIBLE if SHADOWED.name in tier.others else TRANSPORT
        decoder = _decoder(rng, part, tier, self._values, form.name)
        shared = self.records[-1].planes if tier.shares_planes else None
        record = _record(tier, self._end, shared)
        queried: dict[str, list[Queried]] = {TRANSPORT.name: [(decoder, tier.inputs)]}
        seeds, files = [int(rng.integers(2**32))], {}
        for output, plan in tier.others.items():
            query = _as_tier(tier, plan)
            other = _decoder(rng, part, query, self._values, output)
            files[output] = other.file()
            tier_member = {_FORMS[output].member: _other(tier.name + self._end, output, plan)}
            record = TierPart.model_validate({**dict(record), **tier_member})
            name = TRANSPORT.name if output == SHADOWED.name else output
            queried.setdefault(name, []).append((other, query.inputs))
            seeds.append(int(rng.integers(2**32)))
        for (name, decoders_of), seed in zip(queried.items(), seeds, strict=False):
            answers = _answers(seed, part, tier, name, decoders_of, self._values)
            self.answers[Query(tier.name, number, name)] = answers
        self.records.append(record)
        self.data.append(TierData(self._planes, decoder.file(), files))


def _part(part: PartPlan, alone: bool) -> Part:
    ending = "safetensors" if part.is_fiber else "glb"
    geometry = {} if alone else {"geometry": f"geometry/{part.name}.{ending}"}
    return make_part(
        name=part.name,
        kind="fiber" if part.is_fiber else "surface",
        bounds=Bounds(min=part.low, max=part.high),
        transmittance=tuple(
            TransmittanceRecord(
                triangles=(record.first, record.count),
                texture=_texture(name),
                cutoff=record.cutoff,
                ior=record.ior,
            )
            for name, record in part.records
        ),
        normal_maps=tuple(
            NormalMapRecord(triangles=(record.first, record.count), texture=_map(name))
            for name, record in part.maps
        ),
        base_color=tuple(_color(name, record) for name, record in part.colors),
        **geometry,
    )


def _color(name: str, record: BaseColor) -> BaseColorRecord:
    """The record of the manifest without members that have their default."""
    plain = BaseColor(0, 1, None)
    names = [*("color_space", "factor", "wrap", "transform")]
    given = {n: getattr(record, n) for n in names if getattr(record, n) != getattr(plain, n)}
    image = None if record.image is None else _image(name)
    return BaseColorRecord(triangles=(record.first, record.count), image=image, **given)


def _as_tier(tier: TierPlan, other: DecoderPlan) -> TierPlan:
    """For the other decoder."""
    made = {name: getattr(other, name) for name in ("inputs", "int8", "widths", "mixing")}
    return replace(tier, **made)


def _record(tier: TierPlan, end: str, planes: str | None) -> TierPart:
    members = {"planes": planes} if planes else {}
    return make_tier_part(
        tier.name + end,
        inputs=tier.inputs,
        resolution=tier.resolution,
        channels=tier.channels,
        plane_precision=tier.planes,
        decoder_precision="int8" if tier.int8 else "float32",
        uses_base_color=tier.uses_base_color or None,
        nearby=NEARBY_RECORD if tier.nearby else None,
        **members,
    )


def _other(name: str, output: str, plan: DecoderPlan) -> dict[str, object]:
    return {
        "decoder": f"decoders/{name}-{output}.onnx",
        "inputs": plan.inputs,
        "decoder_precision": "int8" if plan.int8 else "float32",
    }


def _planes(rng: np.random.Generator, tier: TierPlan) -> tuple[np.ndarray | Int8Planes, np.ndarray]:
    """As stored, and their values (3, R, R, C) float64."""
    shape = 3, tier.resolution, tier.resolution, tier.channels
    if tier.planes == "int8":
        texels = rng.integers(-128, 128, shape).astype(np.int8)
        scales = short(rng.uniform(0.003, 0.009, (3, tier.channels)))
        wide = texels.astype(np.float64) * scales.astype(np.float64)[:, None, None, :]
        return Int8Planes(texels, scales), wide
    values = short(rng.uniform(-1, 1, shape)).astype(tier.planes)
    if tier.resolution == 1:  # features that sum to -10: q of (1, 0, 0) has no length
        values[:, 0, 0, 0] = -4, -3, -3
    if tier.faint:
        values[..., 1] *= values.dtype.type(2.0**-16)
    if tier.loud:
        values[0, 0, 0, 0], values[1, -1, -1, 1] = 1e6, -1e6
    return values, values.astype(np.float64)


def _decoder(
    rng: np.random.Generator, part: PartPlan, tier: TierPlan, planes: np.ndarray, output: str
) -> Decoder | Int8Decoder:
    rows = Maker(rng, part.is_fiber, part.bounds).ordinary(_CALIBRATION_ROWS)
    blocks = decoder_inputs(Points.of(arrays_of(rows, ALL), part.bounds), tier.inputs, planes)
    blocks = np.clip(blocks, -20, 20)  # except loud texels, which would drown the others
    first = None
    if tier.int8 == "saturating":
        first = decoders.saturating_weights(rng, blocks, tier.widths[0])
    colours = _FORMS[output].width(None, tier.uses_base_color, tier.nearby)
    sizes = tier.widths, tier.mixing
    decoder = decoders.make_decoder(rng, blocks, *sizes, first, output, colours)
    if not tier.int8:
        return decoder
    return decoders.make_int8_decoder(decoder, blocks, 127 if tier.int8 == "saturating" else 64)


def _answers(
    seed: int, part: PartPlan, tier: TierPlan, form: str, queried: list[Queried], planes: np.ndarray
) -> Answers:
    """form: queried form; queried: decoders whose results, side by side, are the answer."""
    queries, classes = make_queries(seed, part.is_fiber, part.bounds)
    if tier.resolution == 1 and not part.is_fiber:
        queries, classes = _with_cancelled_normals(queries, classes)
    if form == TRANSPORT.name and not part.is_fiber:
        queries, classes = with_base_colors(seed, queries, classes)
    names = _FORMS[form].arrays
    queries = queries[:, columns_of(names)]
    if tier.nearby:
        queries, classes = with_nearby(seed, queries, classes)
    arrays = arrays_of(queries, names)
    if not tier.uses_base_color:
        arrays.pop("base_color", None)
    if tier.nearby:
        arrays[NEARBY.name] = queries[:, -NEARBY.columns :]
    valid = valid_rows(arrays)
    points = Points.of({name: rows[valid] for name, rows in arrays.items()}, part.bounds)
    factors = _Factors(
        *(
            arrays[name][valid].astype(np.float64) if name in arrays else None
            for name in ("base_color", NEARBY.name)
        )
    )
    made = [decoder_inputs(points, inputs, planes) for _, inputs in queried]
    answer, rng = _light(queried, made, factors), np.random.default_rng(seed)
    change = np.zeros_like(answer)
    for _ in range(SIGN_PATTERNS):
        rounded = points.rounded(rng)
        moved = [moved_blocks(decoder_inputs(rounded, of, planes), rng) for _, of in queried]
        change = np.maximum(change, np.abs(_light(queried, moved, factors) - answer))
    name, first, count = classes[0]
    assert name == ORDINARY and first == 0
    scale = float(np.sqrt(np.mean(answer[:count] ** 2)))
    inputs = np.hstack(made)
    blocks = np.zeros((len(queries), inputs.shape[1]))
    expected, tolerance = np.zeros((2, len(queries), answer.shape[1]))
    blocks[valid], expected[valid] = inputs, answer
    tolerance[valid] = PART_OF_SCALE * scale + change
    step = _largest_step(queried, made, factors)
    return Answers(queries, blocks, expected, tolerance, classes, scale, step)


class _Factors(NamedTuple):
    """What multiplies outputs of the rows, (n, 3) each; None of a tier part without."""

    base_color: np.ndarray | None
    nearby: np.ndarray | None

    @property
    def shares(self) -> np.ndarray:
        assert self.nearby is not None
        return np.maximum(self.nearby, 0.0)


def _light(queried: list[Queried], blocks: list[np.ndarray], factors: _Factors) -> np.ndarray:
    """(n, width): results of the decoders side by side, summed up."""
    results = []
    for (decoder, _), inputs in zip(queried, blocks, strict=True):
        light = decoder(inputs)
        if factors.nearby is not None:
            own, *of_nearby = np.hsplit(light, 4)
            light = own + sum(
                s[:, None] * b for s, b in zip(factors.shares.T, of_nearby, strict=True)
            )
        if factors.base_color is not None:
            light, of_color = np.hsplit(light, 2)
            color = np.tile(factors.base_color, light.shape[1] // 3)
            light = np.maximum(light + color * of_color, 0)
        results.append(light)
    return np.hstack(results)


def _largest_step(queried: list[Queried], blocks: list[np.ndarray], factors: _Factors) -> float:
    """The most that one step of an int8 activation changes a result; 0 without int8."""
    color, terms = factors.base_color, np.float64(1.0)
    if color is not None:
        terms = 1.0 + np.abs(color).max(axis=1)
    if factors.nearby is not None:
        terms = terms * (1.0 + factors.shares.sum(axis=1))
    return max(
        float((decoder.largest_step(inputs) * terms).max())
        if isinstance(decoder, Int8Decoder)
        else 0.0
        for (decoder, _), inputs in zip(queried, blocks, strict=True)
    )


def _with_cancelled_normals(
    queries: np.ndarray, classes: list[tuple[str, int, int]]
) -> tuple[np.ndarray, list[tuple[str, int, int]]]:
    """With rows whose normal the features cancel, n + 0.1 f = 0 or 3e-7 long, at the end."""
    rows = queries[:6].copy()
    rows[:, 3:6] = (1, 0, 0)
    rows[3:, 4] = 3e-7
    return np.concatenate([queries, rows]), [*classes, ("cancelled normal", len(queries), 6)]
