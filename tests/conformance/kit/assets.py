"""The packages of the kit, and what every tier of them answers in float64."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_sdk.package import Bounds, Curves, Int8Planes, Mesh, Provenance, Tier, TierData
from rna_sdk.package.writer import write_package
from tests.conformance.kit import decoders, shapes
from tests.conformance.kit.blocks import Points, decoder_inputs, moved_blocks
from tests.conformance.kit.decoders import Decoder, Int8Decoder, short
from tests.conformance.kit.oddities import make_odd
from tests.conformance.kit.queries import ORDINARY, Maker, make_queries, valid_rows
from tests.package.builders import make_manifest, make_tier

PART_OF_SCALE = 1e-4  # tolerance of a well-conditioned row
SIGN_PATTERNS = 32
_CALIBRATION_ROWS = 600

SURFACE = ("features", "position", "normal", "wo", "wi", "half_vector")
SURFACE_ALL = (
    *("wi", "learned_normal", "highlight", "position"),
    *("half_vector", "normal", "features", "wo"),
)
FIBER = ("features", "tangent", "h", "wo", "wi", "fiber_angles", "fiber_lobes")
FIBER_ALL = ("fiber_lobes", "h", "fiber_angles", "position", "wi", "features", "tangent", "wo")


@dataclass(frozen=True)
class TierPlan:
    """What a tier is made of; `int8`: "" for a float32 decoder, else how its weights are."""

    name: str
    inputs: tuple[str, ...]
    resolution: int
    channels: int
    planes: str = "float16"
    int8: str = ""
    widths: tuple[int, ...] = (16, 16)
    mixing: int = 0  # outputs that a matrix makes colours of; 0: a factor does
    loud: bool = False  # texels beyond the Clip of the decoder's inputs
    faint: bool = False  # a channel of texels that float16 holds as subnormal numbers
    shares_planes: bool = False  # with the tier before


@dataclass(frozen=True)
class Plan:
    name: str
    what: str
    geometry: Mesh | Curves
    low: tuple[float, float, float]
    high: tuple[float, float, float]
    tiers: tuple[TierPlan, ...]
    warning: str | None = None  # the code that the validator gives it

    @property
    def is_fiber(self) -> bool:
        return isinstance(self.geometry, Curves)

    @property
    def bounds(self) -> np.ndarray:
        """(2, 3) float64, rounded to float32 as readers have them."""
        return np.array([self.low, self.high], np.float32).astype(np.float64)


ONE = (-1.0,) * 3, (1.0,) * 3
HERE = (3.0, -0.7, 0.5), 0.002

PLANS = (
    Plan(
        *("surface-float32", "float32 planes, two float32 tiers"),
        *(shapes.ball(), *ONE),
        (
            TierPlan("small", SURFACE, 6, 4, "float32"),
            TierPlan("hq", SURFACE_ALL, 9, 5, "float32", widths=(24, 16, 16), mixing=6),
        ),
    ),
    Plan(
        *("surface-clip", "features beyond the decoder's first Clip, colours beyond its second"),
        *(shapes.steps(), *ONE),
        (TierPlan("loud", SURFACE, 16, 2, "float32", widths=(), loud=True),),
    ),
    Plan(
        *("surface-float16", "float16 planes, every block of surfaces, self-shadowing"),
        *(shapes.bowl(), *ONE),
        (TierPlan("all", SURFACE_ALL, 12, 3),),
    ),
    Plan(
        *("surface-int8", "int8 planes, one tier in int8 and one in float32; sheets"),
        *(shapes.steps(), *ONE),
        (
            TierPlan("small-int8", SURFACE, 8, 4, "int8", "plain"),
            TierPlan("small", SURFACE, 8, 4, "int8", shares_planes=True),
        ),
    ),
    Plan(
        *("surface-int8-saturating", "int8 weights that 16-bit sums of pairs cannot hold"),
        *(shapes.steps(), *ONE),
        (TierPlan("small-int8", SURFACE, 8, 4, "float16", "saturating"),),
        "DECODER_SATURATION",
    ),
    Plan(
        *("surface-one-texel", "R = 1, one channel, wound clockwise, narrow and long bounds"),
        *(shapes.backwards(shapes.bowl()), (-1.0, -1.5, -40.0), (1.0, 1.0, 1.0)),
        (TierPlan("one", ("learned_normal", *SURFACE), 1, 1),),
    ),
    Plan(
        *("surface-tiny", "bounds of 2 mm far from the origin, two channels, four layers"),
        shapes.placed(shapes.ball(5, 8), HERE[1] / 2, HERE[0]),
        *(tuple(c + s * HERE[1] / 2 for c in HERE[0]) for s in (-1, 1)),
        (TierPlan("two", SURFACE_ALL, 7, 2, "float16", widths=(16, 12, 8)),),
    ),
    Plan(
        *("surface-odd", "a manifest, planes and container as no exporter writes them; subnormals"),
        *(shapes.with_uvs(shapes.ball(4, 7)), *ONE),
        (TierPlan("odd", SURFACE, 5, 3, "float16", faint=True),),
        "EXTENSION_UNKNOWN",
    ),
    Plan(
        *("fiber-float16", "float16 planes, every block of fibers, two tiers"),
        *(shapes.curls(7, 3), *ONE),
        (
            TierPlan("small", FIBER, 8, 4),
            TierPlan("hq", FIBER_ALL, 12, 6, widths=(24, 15), mixing=9),
        ),
    ),
    Plan(
        *("fiber-int8", "int8 planes and decoder; strands that touch, cross and double back"),
        *(shapes.crossings(), *ONE),
        (TierPlan("small-int8", FIBER, 8, 4, "int8", "plain", (13, 10), mixing=6),),
    ),
    Plan(
        *("fiber-one-channel", "float32 planes, R = 1, one channel, no features among the inputs"),
        *(shapes.curls(2, 5), *ONE),
        (TierPlan("one", ("h", "fiber_lobes", "fiber_angles"), 1, 1, "float32", widths=(13, 7)),),
    ),
)


@dataclass(frozen=True)
class Answers:
    """Of one tier: queries (n, 13) float32; blocks (n, K), expected and tolerance (n, 6) float64.

    classes: name, first row, rows. scale: root mean square of the expected of ordinary rows.
    step: the most that a step of one int8 activation changes an output; 0 for float32.
    """

    queries: np.ndarray
    blocks: np.ndarray
    expected: np.ndarray
    tolerance: np.ndarray
    classes: list[tuple[str, int, int]]
    scale: float
    step: float


def write_asset(plan: Plan, folder: Path) -> dict[str, Answers]:
    """Write NAME.rna below `folder`; the answers of its tiers."""
    records: list[Tier] = []
    data: dict[str, list[TierData]] = {}
    answers: dict[str, Answers] = {}
    for number, tier in enumerate(plan.tiers):
        rng = np.random.default_rng([len(plan.name), number, *plan.name.encode()])
        if not tier.shares_planes:
            planes, values = _planes(rng, tier)
        decoder = _decoder(rng, plan, tier, values)
        data[tier.name] = [TierData(planes, decoder.file())]
        shared = records[-1].parts[0].planes if tier.shares_planes else None
        records.append(_record(tier, shared or f"features/{tier.name}.safetensors"))
        seed = int(rng.integers(2**32))
        answers[tier.name] = _answers(seed, plan, tier, values, decoder)
    manifest = make_manifest(
        *records,
        kind="fiber" if plan.is_fiber else "surface",
        geometry="geometry/curves.safetensors" if plan.is_fiber else "geometry/mesh.glb",
        generator="rna conformance kit",
        name=plan.name,
        bounds=Bounds(min=plan.low, max=plan.high),
        provenance=Provenance(source="tests/conformance/kit/assets.py", tool="numpy"),
    )
    path = folder / f"{plan.name}.rna"
    write_package(path, manifest, [plan.geometry], data)
    if plan.name == "surface-odd":
        make_odd(path)
    return answers


def _record(tier: TierPlan, planes: str) -> Tier:
    return make_tier(
        tier.name,
        planes=planes,
        inputs=tier.inputs,
        resolution=tier.resolution,
        channels=tier.channels,
        plane_precision=tier.planes,
        decoder_precision="int8" if tier.int8 else "float32",
    )


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
    rng: np.random.Generator, plan: Plan, tier: TierPlan, planes: np.ndarray
) -> Decoder | Int8Decoder:
    rows = Maker(rng, plan.is_fiber, plan.bounds).ordinary(_CALIBRATION_ROWS)
    blocks = decoder_inputs(Points.of(rows, plan.bounds), tier.inputs, planes)
    blocks = np.clip(blocks, -20, 20)  # but for loud texels, which would drown the others
    first = None
    if tier.int8 == "saturating":
        first = decoders.saturating_weights(rng, blocks, tier.widths[0])
    decoder = decoders.make_decoder(rng, blocks, tier.widths, tier.mixing, first)
    if not tier.int8:
        return decoder
    return decoders.make_int8_decoder(decoder, blocks, 127 if tier.int8 == "saturating" else 64)


def _answers(
    seed: int, plan: Plan, tier: TierPlan, planes: np.ndarray, decoder: Decoder | Int8Decoder
) -> Answers:
    queries, classes = make_queries(seed, plan.is_fiber, plan.bounds)
    if tier.resolution == 1 and not plan.is_fiber:
        queries, classes = _with_cancelled_normals(queries, classes)
    valid = valid_rows(queries)
    points = Points.of(queries[valid], plan.bounds)
    inputs = decoder_inputs(points, tier.inputs, planes)
    answer, rng = decoder(inputs), np.random.default_rng(seed)
    change = np.zeros_like(answer)
    for _ in range(SIGN_PATTERNS):
        moved = decoder_inputs(points.rounded(rng), tier.inputs, planes)
        change = np.maximum(change, np.abs(decoder(moved_blocks(moved, rng)) - answer))
    name, first, count = classes[0]
    assert name == ORDINARY and first == 0
    scale = float(np.sqrt(np.mean(answer[:count] ** 2)))
    blocks = np.zeros((len(queries), inputs.shape[1]))
    expected, tolerance = np.zeros((2, len(queries), 6))
    blocks[valid], expected[valid] = inputs, answer
    tolerance[valid] = PART_OF_SCALE * scale + change
    step = 0.0
    if isinstance(decoder, Int8Decoder):
        step = float(decoder.largest_step(inputs).max())
    return Answers(queries, blocks, expected, tolerance, classes, scale, step)


def _with_cancelled_normals(
    queries: np.ndarray, classes: list[tuple[str, int, int]]
) -> tuple[np.ndarray, list[tuple[str, int, int]]]:
    """With rows whose normal the features cancel, n + 0.1 f = 0, at the end."""
    rows = queries[:6].copy()
    rows[:, 3:6] = (1, 0, 0)
    return np.concatenate([queries, rows]), [*classes, ("cancelled normal", len(queries), 6)]
