"""Verdicts on materials: learnt well, roughly or not, with remedies."""

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import Literal, NamedTuple

from rna_export.blender.listing import listed
from rna_export.capture.capture_settings import LEAST_ROUGHNESS, DatasetModel
from rna_export.capture.preflight.material_record import Detail, Glass, MaterialFacts, Visible

Learnt = Literal["well", "roughly", "not", "left to the host"]
_WORSE: dict[Learnt, int] = {"well": 0, "left to the host": 0, "roughly": 1, "not": 2}
_PROMISES: dict[Learnt, str] = {
    "well": "learnt well",
    "roughly": "learnt roughly",
    "not": "not learnt",
    "left to the host": "left to the host",
}

_TEXELS = 2.0  # of a plane, from one detail to the next, at the least
_LOST = 0.5  # of that: relief of a plane's texel
_MIRROR = 0.05  # roughness that an artist calls a mirror's
_SOFTENED = 0.02  # roughness below which the floor of captures shows
_MIRRORING, _NARROW = 0.1, 0.25  # share that mirrors the asset, and roughness, where that shows
_OPTION = "--normal-texels"  # an obstacle that is the user's to raise
_SCATTERING = frozenset({"scattering", "thin", "refracting", "glass", "volume", "hair"})
_WORDS = {
    "coat": "clear coat",
    "thin": "thin, lit from behind",
    "scattering": "light scatters inside",
    "glass": "glass mixed with another shader",
    "refracting": "frosted glass",
    "see-through": "holes or thin panes",
    "volume": "a volume inside",
    "brushed": "brushed (anisotropic)",
    "varied": "each strand different",
}


class MaterialVerdict(DatasetModel):
    """How well a material is learnt.

    is_: what it is, in words. reasons: what is lost, and what to do; none if nothing is. share: of
    what is seen of the asset. full_name: in Blender, where libraries may have others of its name.
    loses: the only part of it that is not learnt; None where that is all of it, or nothing.
    scatters: whether light enters it, and leaves elsewhere.
    """

    name: str
    full_name: str = ""
    is_: str
    learnt: Learnt
    loses: Literal["relief"] | None = None
    reasons: tuple[str, ...] = ()
    share: float = 1.0
    scatters: bool = True

    @property
    def promise(self) -> str:
        """How well it is learnt, in words."""
        if self.learnt == "not" and self.loses is not None:
            return f"learnt without its {self.loses}"
        return _PROMISES[self.learnt]

    @property
    def lines(self) -> list[str]:
        """The verdict in the terminal and on the contact sheet."""
        seen = "" if self.share >= 1.0 else f" ({share_text(self.share)} of the visible surface)"
        first = f"  {self.name!r}: {self.is_}: {self.promise}{seen}"
        return [first, *(f"    {reason}" for reason in self.reasons)]


class _Reason(NamedTuple):
    """loses: the part that is not learnt, see `MaterialVerdict`."""

    learnt: Learnt
    text: str
    loses: Literal["relief"] | None = None


def verdicts(
    materials: Iterable[MaterialFacts],
    glass: Iterable[Glass],
    texel: float,
    mapped: Iterable[str],
    coloured: Iterable[str],
    obstacles: Mapping[str, Mapping[str, str]] | None = None,
    visible: Mapping[str, Visible] | None = None,
) -> tuple[MaterialVerdict, ...]:
    """One a material, the worst first.

    texel: side of a texel of the planes, m. mapped, coloured: full names of materials whose relief,
    and whose colour, are textures of the package. obstacles: of "relief" and "colour", by material,
    what keeps it from being one. visible: by material; None for a share of 1 each.
    """
    textures = {"relief": set(mapped), "colour": set(coloured)}
    result, obstacles = [], obstacles or {}
    for each in materials:
        why = {sort: of[each.full_name] for sort, of in obstacles.items() if each.full_name in of}
        stored = [s for s, names in textures.items() if each.full_name in names and s not in why]
        seen = Visible(1.0) if visible is None else visible.get(each.full_name, Visible(0.0))
        verdict = _verdict(each, texel, stored, why, seen.mirroring)
        result.append(verdict.model_copy(update={"share": seen.share}))
    result += [
        MaterialVerdict(
            name=each.name,
            is_=f"smooth glass (index {each.ior:.3g})",
            learnt="left to the host",
            reasons=("an ordinary mesh of glTF beside the package, which a scene places with it",),
        )
        for each in glass
    ]
    return tuple(sorted(result, key=lambda each: -_WORSE[each.learnt]))


def not_learnt(
    of: Iterable[MaterialVerdict], loses: Literal["relief"] | None = None
) -> tuple[str, float]:
    """Materials that are not learnt, or lose only `loses`, and their share of the visible area."""
    those = [each for each in of if each.learnt == "not" and each.loses == loses]
    share = sum(each.share for each in those)
    seen = f" ({share_text(share)} of the visible surface)" if share < 1.0 else ""
    return ", ".join(repr(each.name) for each in those) + seen, share


def share_text(share: float) -> str:
    """A share in words: "12%", "under 1%"."""
    return "under 1%" if share < 0.01 else f"{share:.0%}"


def preflight_lines(of: Iterable[MaterialVerdict]) -> list[str]:
    """Lines about all materials before the first ray; materials without a loss share a line."""
    of = list(of)
    lines = [line for each in of if each.reasons for line in each.lines]
    well: dict[str, list[str]] = {}
    for each in of:
        if not each.reasons:
            well.setdefault(each.is_, []).append(each.name)
    if well:
        named = (f"{listed([*map(repr, names)])} ({what})" for what, names in well.items())
        lines.append("  learnt well: " + "; ".join(named))
    return ["materials, and how well they will be learnt:", *lines] if lines else []


def length(metres: float) -> str:
    """A length in words: "0.4 mm", "12 mm", "1.3 m"."""
    return f"{metres:.2g} m" if metres >= 1.0 else f"{1000.0 * metres:.2g} mm"


def _verdict(
    facts: MaterialFacts,
    texel: float,
    stored: Collection[str],
    obstacles: Mapping[str, str],
    mirroring: float,
) -> MaterialVerdict:
    """stored: sorts of details that are textures of the package. obstacles: of others, by sort."""
    learnt_details = (detail for detail in facts.details if detail.of not in stored)
    of_details = [
        _of_detail(detail, _TEXELS * texel, obstacles.get(detail.of)) for detail in learnt_details
    ]
    reasons = [
        *_of_kinds(facts, mirroring),
        *(reason for reason in of_details if reason is not None),
    ]
    learnt = max((r.learnt for r in reasons), key=_WORSE.__getitem__, default="well")
    reasons.sort(key=lambda reason: -_WORSE[reason.learnt])
    texts = tuple(reason.text for reason in reasons)
    lost = {reason.loses for reason in reasons if reason.learnt == "not"}
    return MaterialVerdict(
        name=facts.name,
        full_name=facts.full_name,
        is_=_in_words(facts),
        learnt=learnt,
        loses=lost.pop() if len(lost) == 1 else None,
        reasons=texts,
        scatters=not _SCATTERING.isdisjoint(facts.kinds),
    )


def _in_words(facts: MaterialFacts) -> str:
    words = [_WORDS.get(kind, kind) for kind in facts.kinds]
    if facts.roughness is not None and facts.roughness < _MIRROR:
        words.append(f"mirror-like (roughness {facts.roughness:.2g})")
    words += [f"{d.of} by {d.node!r}" for d in facts.details if d.of in ("relief", "gloss")]
    return ", ".join(words)


def _of_kinds(facts: MaterialFacts, mirroring: float) -> Iterator[_Reason]:
    kinds = facts.kinds
    if mirroring >= _MIRRORING and _mirrors(facts):
        yield _Reason(
            "roughly",
            f"it mirrors the asset itself on {mirroring:.0%} of its surface, and such reflections "
            "come out blurred: make it rougher, or clear panes smooth glass, which is left to the "
            "host",
        )
    if "glass" in kinds:
        yield _Reason(
            "not",
            "the scene behind it is not seen through it: give the glass a material of its own, "
            "which is then left to the host",
        )
    if "refracting" in kinds:
        yield _Reason(
            "roughly",
            "it is learnt as a frosted surface: objects of a scene behind it are not seen "
            "through it",
        )
    if "varied" in kinds:
        yield _Reason(
            "roughly",
            "strands that lie together come out in their mean: let colour and roughness follow "
            "clumps or places instead of a random number a strand",
        )
    if "volume" in kinds:
        yield _Reason(
            "roughly",
            "the light that leaves its surface is learnt; objects of a scene behind it are not "
            "seen through it",
        )
    if facts.roughness is not None and facts.roughness < _SOFTENED and "glass" not in kinds:
        yield _Reason(
            "roughly",
            "reflections come out softer than in the original: smoother lobes are captured with a "
            f"roughness of {LEAST_ROUGHNESS:g}",
        )


def _mirrors(facts: MaterialFacts) -> bool:
    """Whether a narrow highlight, or one that a clear pane has alone, is most of its light."""
    kinds, rough = set(facts.kinds), facts.roughness
    is_narrow = "brushed" in kinds or (rough is not None and rough < _NARROW)
    return bool(kinds & {"metal", "glossy"}) and (is_narrow or {"glossy", "see-through"} <= kinds)


def _of_detail(detail: Detail, least: float, obstacle: str | None) -> _Reason | None:
    """least: metres from one detail to the next that planes can hold. obstacle: to a texture."""
    coarser = (
        f"make its details at least {length(least)} large, or train in pieces (rna-train --cut)"
    )
    if detail.size is None or detail.size >= least:
        return None
    finer = f"({length(detail.size)} from one detail to the next; the planes hold {length(least)})"
    if detail.of == "relief":
        is_lost = detail.size < _LOST * least
        becomes = "becomes an even sheen" if is_lost else "comes out softer"
        return _Reason(
            "not" if is_lost else "roughly",
            f"its relief by {detail.node!r} is finer than the planes {finer} and {becomes}: "
            f"{_remedy(obstacle, 'a normal map')}, {coarser}",
            "relief",
        )
    if detail.of == "gloss":
        return _Reason(
            "roughly",
            f"its shine varies by {detail.node!r} faster than the planes {finer} and becomes even: "
            f"{coarser}",
        )
    if detail.of == "emission":
        return _Reason(
            "roughly",
            f"its glow by {detail.node!r} is finer than the planes {finer} and blurred: {coarser}",
        )
    return _Reason(
        "roughly",
        f"its colour by {detail.node!r} is finer than the planes {finer} and blurred: "
        f"{_remedy(obstacle, 'an image')}, {coarser}",
    )


def _remedy(obstacle: str | None, texture: str) -> str:
    """The remedy for a texture of a detail; texture: "an image"."""
    if obstacle is None:
        return f"bake it into {texture} of its UVs"
    do = "raise it" if _OPTION in obstacle else f"bake it into {texture} of its UVs"
    return f"{obstacle} keeps it from being {texture}: {do}"
