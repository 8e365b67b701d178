"""Packages whose record of nearby light is wrong, or not that of their decoder."""

from typing import Any

from tests.package.corpus.registry import Corpus, Entries, in_manifest, tier_part, with_manifest

CASES = Corpus("print")

GOOD = {"lengths": [0.01, 0.03, 0.1], "visible": [0.9, 0.8, 0.7], "shadowed": [0.1, 0.2, 0.3]}


def with_nearby(entries: Entries, **changes: Any) -> bytes:
    """The package with such a record, which its decoders do not know."""
    return with_manifest(entries, lambda m: tier_part(m).update(nearby={**GOOD, **changes}))


CASES.add("FIELD_UNKNOWN", nearby_light_of_a_name=lambda e: with_nearby(e, name="glow"))
CASES.add(
    "FIELD_MISSING",
    nearby_light_without_a_mean=in_manifest(
        lambda m: tier_part(m).update(nearby={k: v for k, v in GOOD.items() if k != "shadowed"})
    ),
)
CASES.add(
    "FIELD_VALUE",
    nearby_light_that_is_null=in_manifest(lambda m: tier_part(m).update(nearby=None)),
    nearby_light_of_two_lengths=lambda e: with_nearby(e, lengths=[0.01, 0.03]),
    nearby_light_of_equal_lengths=lambda e: with_nearby(e, lengths=[0.01, 0.03, 0.03]),
    nearby_light_of_no_length=lambda e: with_nearby(e, lengths=[0, 0.03, 0.1]),
    nearby_light_of_a_mean_above_1=lambda e: with_nearby(e, shadowed=[0.1, 0.2, 1.001]),
    nearby_light_of_a_mean_below_0=lambda e: with_nearby(e, visible=[-0.001, 0.2, 0.3]),
)
CASES.add("DECODER_PROFILE", nearby_light_of_a_decoder_without=with_nearby)
