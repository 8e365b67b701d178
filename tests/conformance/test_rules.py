"""Rules that readers are known to get wrong: each is caught by a package that is made for it."""

import json

import pytest

from tests.conformance.level_mutants import (
    CAUGHT,
    MOST_MISSED,
    READERS,
    RECORD,
    Mutant,
    mutants,
    source_of,
    verdict,
)

_RECORD = json.loads(RECORD.read_text())
_KIT = "tests.conformance.kit"
_SMOOTH = "STEP, SMOOTH_BELOW = 2.0**-18, 0.1"
_TEXELS = "    texels = record.texture.astype(np.float64) / 255\n"
_WIDE = "(np.abs(g.points).max(axis=1) + g.radii).max()"

RULES: dict[str, tuple[str, str, str]] = {
    "visibility: a step twice as long": ("visibility", _SMOOTH, _SMOOTH.replace("18", "17")),
    "visibility: a step half as long": ("visibility", _SMOOTH, _SMOOTH.replace("18", "19")),
    "visibility: an eighth of the step": ("visibility", _SMOOTH, _SMOOTH.replace("18", "21")),
    "visibility: terminator of 0.08": ("visibility", _SMOOTH, _SMOOTH.replace("0.1", "0.08")),
    "visibility: size without radii": ("visibility", _WIDE, "np.abs(g.points).max()"),
    "visibility: size of the part alone": ("visibility", "extent(bodies)\n", "extent([mesh_of])\n"),
    "visibility: size is the extent": (
        *("visibility", "np.abs(g.positions).max()", "np.ptp(g.positions, axis=0).max()"),
    ),
    "visibility: strands of the same number in other parts are passed": (
        *("visibility", "rays.strand if part == rays.part else None", "rays.strand"),
    ),
    "visibility: texels are cut off before they are interpolated": (
        *("passing", _TEXELS, f"{_TEXELS}    texels = texels if record.cutoff is None else "),
    ),
    "base-color: alpha is multiplied": (
        *("png", "colors = samples[..., :3] if", "colors = samples[..., :3] * ALPHA if"),
    ),
    "base-color: alpha of grey is taken for a colour": ("png", "[0, 0, 0]]", "[0, -1, -1]]"),
    "base-color: palettes are not looked at": (
        *("png", "if color == PALETTE:\n        return np.frombuffer(ch", "if False:\n        (ch"),
    ),
    "base-color: ties of Paeth's filter": (*("png", "far[0] <= far[2]", "far[0] < far[2]"),),
    "base-color: averages round up": ("png", "(left + up) // 2", "(left + up + 1) // 2"),
    "base-color: sixteen bits are taken modulo 256": ("png", "colors >> 8 if", "colors & 255 if"),
    "deformed: flat triangles are judged deformed alone": (
        *("deformed", "        whole &= size >", "        whole = size >"),
    ),
    "deformed: flat triangles turn vertices": (
        *("deformed", "np.where(seen[number][:, None], sums[number], normals)", "sums[number]"),
    ),
    "deformed: the middle of a strand is (p - 1) / 2": (
        *("deformed", "- root) // 2, _FAR", "- root - 1) // 2, _FAR"),
    ),
    "deformed: not the smallest of several rotations": (
        *("deformed", "return _smallest(t[None], t1[None])[0]\n", "pass\n"),
    ),
    "deformed: a segment without length starts anew": (
        *("deformed", "        if (p1[k + 1] != p1[k]).any():", "        ANEW:"),
    ),
}
"""Level and rule -> module of the kit, its text, and another one."""

_WORDS = {
    "extent([mesh_of])": "extent([bodies[part]])",
    "texels = texels if record.cutoff is None else ": (
        "texels = texels if record.cutoff is None else 1.0 * (texels > record.cutoff)\n"
    ),
    "* ALPHA": "* samples[..., -1:] // (255 if color == RGBA else 1) ** (color == RGBA)",
    "ANEW:": ("if (p1[k + 1] == p1[k]).all():\n            rotation = np.eye(3)\n        else:"),
}


@pytest.mark.parametrize("rule", RULES)
def test_a_rule_that_is_broken_is_caught(rule, kit):
    module, old, new = RULES[rule]
    for short, text in _WORDS.items():
        new = new.replace(short, text)
    source = source_of(f"{_KIT}.{module}")
    assert source.count(old) == 1
    changed = source.replace(old, new)
    compile(changed, rule, "exec")  # a reader that does not start would be caught, too
    level = rule.partition(":")[0]
    assert verdict(level, Mutant(f"{_KIT}.{module}", rule, changed), kit) == CAUGHT


@pytest.mark.parametrize("level", READERS)
def test_a_reader_itself_passes(level, kit):
    host = next(iter(READERS[level].modules), "rna_sdk.package.validator")
    assert verdict(level, Mutant(host, "unchanged", source_of(host)), kit) == "passes"


@pytest.mark.parametrize("level", _RECORD)
def test_nearly_all_mutants_are_caught(level):
    """By the record. Stale after a change: run python -m tests.conformance.level_mutants."""
    of_level, every = _RECORD[level], mutants(level)
    assert of_level["mutants"] == len(every)
    assert of_level["passed"].keys() <= {mutant.name for mutant in every}
    missed = [name for name, why in of_level["passed"].items() if not why]
    assert len(missed) <= MOST_MISSED * len(every)
