"""The packages of the kit: what each is made of."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from rna_sdk.package import BaseColor, Curves, Mesh, NormalMap, Transmittance, quantise
from tests.conformance.kit import shapes
from tests.conformance.kit.restored import with_extremes
from tests.conformance.kit.visibility import Body

SURFACE = ("features", "position", "normal", "wo", "wi", "half_vector")
SURFACE_ALL = (
    *("wi", "learned_normal", "highlight", "position"),
    *("half_vector", "normal", "features", "wo"),
)
FIBER = ("features", "tangent", "h", "wo", "wi", "fiber_angles", "fiber_lobes")
FIBER_ALL = ("fiber_lobes", "h", "fiber_angles", "position", "wi", "features", "tangent", "wo")


GLOW = ("features", "position", "normal", "wo")
GLOW_OF_FIBERS = ("wo", "h", "features", "tangent", "position")
LIT, SHADED = ("features", "normal", "wo", "wi"), ("wi", "features", "position", "normal")
LIT_FIBERS, SHADED_FIBERS = (
    ("features", "tangent", "h", "wo", "wi"),
    ("fiber_lobes", "wi", "features"),
)


@dataclass(frozen=True)
class DecoderPlan:
    """A decoder of another form than transport; `int8` and `mixing` as those of TierPlan."""

    inputs: tuple[str, ...]
    int8: str = ""
    widths: tuple[int, ...] = (16, 16)
    mixing: int = 0


@dataclass(frozen=True)
class TierPlan:
    """What a part is in a tier; `int8`: "" for a float32 decoder, else how its weights are."""

    name: str  # of the tier
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
    uses_base_color: bool = False
    nearby: bool = False
    others: Mapping[str, DecoderPlan] = field(default_factory=dict)  # by form


@dataclass(frozen=True)
class LobesPlan:
    """Lobes of a part, on the planes of the first tier."""

    inputs: tuple[str, ...]
    lobes: int
    visibility: bool
    widths: tuple[int, ...] = (12,)


@dataclass(frozen=True)
class PartPlan:
    """A part; records, maps, colors: with the names of their textures, if they have any."""

    name: str
    geometry: Mesh | Curves
    low: tuple[float, float, float]
    high: tuple[float, float, float]
    tiers: tuple[TierPlan, ...]
    records: tuple[tuple[str, Transmittance], ...] = ()
    maps: tuple[tuple[str, NormalMap], ...] = ()
    colors: tuple[tuple[str, BaseColor], ...] = ()
    lobes: LobesPlan | None = None

    @property
    def is_fiber(self) -> bool:
        return isinstance(self.geometry, Curves)

    @property
    def bounds(self) -> np.ndarray:
        """(2, 3) float64, rounded to float32 as readers have them."""
        return np.array([self.low, self.high], np.float32).astype(np.float64)

    def body(self) -> Body:
        return Body(self.geometry, tuple(record for _, record in self.records))


@dataclass(frozen=True)
class Plan:
    """A package: its parts have the same tiers."""

    name: str
    what: str
    parts: tuple[PartPlan, ...]
    warning: str | None = None  # the code that the validator gives it

    @property
    def counts_nearby(self) -> bool:
        return any(tier.nearby for part in self.parts for tier in part.tiers)


def one_part(
    name: str,
    what: str,
    geometry: Mesh | Curves,
    low: tuple[float, float, float],
    high: tuple[float, float, float],
    tiers: tuple[TierPlan, ...],
    warning: str | None = None,
    lobes: LobesPlan | None = None,
) -> Plan:
    return Plan(name, what, (PartPlan("asset", geometry, low, high, tiers, lobes=lobes),), warning)


ONE = (-1.0,) * 3, (1.0,) * 3
HERE = (3.0, -0.7, 0.5), 0.002

LEAST = TierPlan("least", ("normal", "wi"), 1, 1, widths=(4,))
LEAST_OF_FIBERS = TierPlan("least", ("tangent", "wi"), 1, 1, widths=(4,))

PLANS = (
    one_part(
        *("surface-float32", "float32 planes, two float32 tiers; a ball under a shell"),
        *(shapes.capped_ball(), *ONE),
        (
            TierPlan("small", SURFACE, 6, 4, "float32"),
            TierPlan("hq", SURFACE_ALL, 9, 5, "float32", widths=(24, 16, 16), mixing=6),
        ),
    ),
    one_part(
        *("surface-clip", "features beyond the decoder's first Clip, colours beyond its second"),
        *(shapes.steps(), *ONE),
        (TierPlan("loud", SURFACE, 16, 2, "float32", widths=(), loud=True),),
    ),
    one_part(
        *("surface-float16", "float16 planes, every block of surfaces, self-shadowing"),
        *(shapes.bowl(), *ONE),
        (TierPlan("all", SURFACE_ALL, 12, 3),),
    ),
    one_part(
        *("surface-int8", "int8 planes, one tier in int8 and one in float32; sheets"),
        *(shapes.steps(), *ONE),
        (
            TierPlan("small-int8", SURFACE, 8, 4, "int8", "plain"),
            TierPlan("small", SURFACE, 8, 4, "int8", shares_planes=True),
        ),
    ),
    one_part(
        *("surface-int8-saturating", "int8 weights that 16-bit sums of pairs cannot hold"),
        *(shapes.steps(), *ONE),
        (TierPlan("small-int8", SURFACE, 8, 4, "float16", "saturating"),),
        "DECODER_SATURATION",
    ),
    one_part(
        *("surface-one-texel", "R = 1, one channel, wound clockwise, narrow and long bounds"),
        *(shapes.backwards(shapes.bowl()), (-1.0, -1.5, -40.0), (1.0, 1.0, 1.0)),
        (TierPlan("one", ("learned_normal", *SURFACE), 1, 1),),
    ),
    one_part(
        *("surface-tiny", "bounds of 2 mm far from the origin, two channels, four layers"),
        shapes.placed(shapes.ball(5, 8), HERE[1] / 2, HERE[0]),
        *(tuple(c + s * HERE[1] / 2 for c in HERE[0]) for s in (-1, 1)),
        (TierPlan("two", SURFACE_ALL, 7, 2, "float16", widths=(16, 12, 8)),),
    ),
    one_part(
        *("surface-odd", "a manifest, planes and container as no exporter writes them; subnormals"),
        *(shapes.with_uvs(shapes.ball(4, 7)), *ONE),
        (TierPlan("odd", SURFACE, 5, 3, "float16", faint=True),),
        "EXTENSION_UNKNOWN",
    ),
    one_part(
        *("fiber-float16", "float16 planes, every block of fibers, two tiers"),
        *(shapes.curls(7, 3), *ONE),
        (
            TierPlan("small", FIBER, 8, 4),
            TierPlan("hq", FIBER_ALL, 12, 6, widths=(24, 15), mixing=9),
        ),
    ),
    one_part(
        *("fiber-int8", "int8 planes and decoder; strands that touch, cross and double back"),
        *(shapes.crossings(), *ONE),
        (TierPlan("small-int8", FIBER, 8, 4, "int8", "plain", (13, 10), mixing=6),),
    ),
    one_part(
        *("fiber-one-channel", "float32 planes, R = 1, one channel, no features among the inputs"),
        *(shapes.curls(2, 5), *ONE),
        (TierPlan("one", ("h", "fiber_lobes", "fiber_angles"), 1, 1, "float32", widths=(13, 7)),),
    ),
    one_part(
        *("surface-quantised", "a mesh in 16 bits, with texture coordinates; lobes"),
        *(with_extremes(shapes.with_uvs(shapes.bowl())), *ONE),
        (TierPlan("small", SURFACE, 6, 4, widths=(12,)),),
        lobes=LobesPlan(SURFACE, 4, visibility=True),
    ),
    one_part(
        *("fiber-quantised", "strands in steps; lobes without visibility"),
        *(quantise(shapes.curls(7, 3)), *ONE),
        (TierPlan("small", FIBER, 6, 4, widths=(12,)),),
        lobes=LobesPlan(FIBER, 2, visibility=False),
    ),
    one_part(
        *("surface-glow", "one part that emits, float32"),
        *(shapes.steps(), *ONE),
        (TierPlan("small", SURFACE, 6, 4, widths=(12,), others={"emission": DecoderPlan(GLOW)}),),
    ),
    Plan(
        *("parts-head", "a mesh and strands that shadow each other, two tiers"),
        (
            PartPlan(
                *("skin", shapes.backwards(shapes.bowl()), *ONE),
                (
                    TierPlan("small", SURFACE, 6, 4),
                    TierPlan("hq", SURFACE_ALL, 9, 3, widths=(24, 16), mixing=6),
                ),
            ),
            PartPlan(
                *("hair", shapes.curls(7, 3), (-1.0, -0.9, -1.1), (1.1, 1.0, 1.0)),
                (TierPlan("small", FIBER, 8, 4), TierPlan("hq", FIBER_ALL, 10, 5)),
            ),
        ),
    ),
    Plan(
        *("parts-lantern", "strands and two meshes behind glass and cut-outs; two parts emit"),
        (
            PartPlan(
                *("wick", shapes.wick(), *ONE),
                (
                    TierPlan(
                        *("small", FIBER, 6, 4),
                        others={"emission": DecoderPlan(GLOW_OF_FIBERS, widths=(13, 10), mixing=5)},
                    ),
                ),
            ),
            PartPlan(
                *("panes", shapes.panes(), (-1.0, -1.0, -1.2), (1.0, 1.0, 1.2)),
                (
                    TierPlan(
                        *("small", SURFACE, 6, 4, "int8"),
                        others={"emission": DecoderPlan(GLOW, int8="plain", mixing=3)},
                    ),
                ),
                shapes.pane_records(),
            ),
            PartPlan(*("floor", shapes.floor(), *ONE), (TierPlan("small", SURFACE, 5, 3),)),
        ),
    ),
    Plan(
        *("surface-relief", "normal maps: mirrored, repeated, on triangles without texture area"),
        (
            PartPlan(
                *("asset", shapes.relief(), *ONE),
                (TierPlan("small", SURFACE, 6, 4, widths=(12,)),),
                maps=shapes.relief_maps(),
            ),
        ),
    ),
    Plan(
        *("surface-print", "base colour as a factor, in float32 and in int8; images"),
        (
            PartPlan(
                *("asset", shapes.printed(), *ONE),
                (
                    TierPlan("small", SURFACE, 6, 4, uses_base_color=True, mixing=7),
                    TierPlan("int8", SURFACE, 6, 4, int8="plain", uses_base_color=True),
                ),
                colors=shapes.prints(),
            ),
        ),
    ),
    Plan(
        *("surface-shadowed", "a decoder for visible and one for shadowed light, with base colour"),
        (
            PartPlan(
                *("asset", shapes.bowl(), *ONE),
                (
                    TierPlan("plain", LIT, 6, 3, others={"shadowed": DecoderPlan(SHADED)}),
                    TierPlan(
                        *("print", LIT, 6, 3),
                        uses_base_color=True,
                        others={"shadowed": DecoderPlan(SHADED, int8="plain", mixing=5)},
                    ),
                ),
                colors=(("", BaseColor(0, 7, None, factor=(0.3, 0.6, 1.0))),),
            ),
        ),
    ),
    Plan(
        *("surface-nearby", "nearby light: of one decoder, of two with base colour, one in int8"),
        (
            PartPlan(
                *("asset", shapes.bowl(), *ONE),
                (
                    TierPlan("one", LIT, 6, 3, nearby=True),
                    TierPlan(
                        *("print", LIT, 6, 3),
                        uses_base_color=True,
                        nearby=True,
                        others={"shadowed": DecoderPlan(SHADED, int8="plain", mixing=5)},
                    ),
                ),
                colors=(("", BaseColor(0, 7, None, factor=(0.3, 0.6, 1.0))),),
            ),
        ),
    ),
    one_part(
        *("fiber-nearby", "fibers with nearby light"),
        *(shapes.curls(7, 3), *ONE),
        (TierPlan("small", LIT_FIBERS, 6, 4, mixing=9, nearby=True),),
    ),
    one_part(
        *("fiber-shadowed", "fibers with a decoder for shadowed light, of other inputs"),
        *(shapes.curls(7, 3), *ONE),
        (
            TierPlan(
                *("small", LIT_FIBERS, 6, 4),
                int8="plain",
                others={"shadowed": DecoderPlan(SHADED_FIBERS, widths=(12,))},
            ),
        ),
    ),
    one_part(
        *("surface-room", "a floor shaded as a dome, between walls: how far rays are lifted"),
        *(shapes.room(), *ONE),
        (LEAST,),
    ),
    one_part(
        *(
            "surface-sheets",
            "sheets closer to each other than the step of rays",
        ),
        *(shapes.close_sheets(4.2, (3.4, 0.3, -0.6)), (2.0, -1.0, -2.0), (4.5, 1.0, 1.0)),
        (LEAST,),
    ),
    Plan(
        *("parts-pairs", "two parts of strands side by side, one of them as thick as the asset"),
        (
            PartPlan(*("sheets", shapes.close_sheets(4.2), *ONE), (LEAST,)),
            PartPlan(*("left", shapes.pairs_of_strands(0.0), *ONE), (LEAST_OF_FIBERS,)),
            PartPlan(
                *("right", shapes.pairs_of_strands(0.15, thick=True), (-1, -4, -2), (3, 1, 2)),
                (LEAST_OF_FIBERS,),
            ),
        ),
    ),
    Plan(
        *("surface-screens", "holes in greys, and coated panes under a normal map"),
        (
            PartPlan(
                *("asset", shapes.panes(), (-1.0, -1.0, -1.2), (1.0, 1.0, 1.2)),
                *((LEAST,), shapes.screens(), shapes.screen_maps()),
            ),
        ),
    ),
    Plan(
        *("surface-pictures", "images in every kind of PNG"),
        (
            PartPlan(
                *("asset", shapes.printed(), *ONE),
                (replace(LEAST, uses_base_color=True),),
                colors=shapes.pictures(),
            ),
        ),
    ),
    one_part(
        *("surface-folds", "triangles that are flat at rest, not when deformed"),
        *(shapes.folds(), *ONE),
        (LEAST,),
    ),
    one_part(
        *("fiber-lone", "one curved strand of an even number of points"),
        *(shapes.lone(6, 0.3), *ONE),
        (LEAST_OF_FIBERS,),
    ),
    one_part(
        *("fiber-straight", "one straight strand"),
        *(shapes.lone(2, 0.0), *ONE),
        (LEAST_OF_FIBERS,),
    ),
)
