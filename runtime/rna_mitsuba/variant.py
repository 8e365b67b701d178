"""Which variants of Mitsuba assets work in."""

import mitsuba as mi

from rna_sdk.errors import QueryError


def check_variant() -> None:
    """Raises QueryError where no variant is set, or one without Dr.Jit arrays or in another colour.

    Transport is of three colours, so spectral and monochrome variants have no use for it.
    """
    name = mi.variant()
    if name is None or not name.endswith("_ad_rgb"):
        raise QueryError(
            f"rna_mitsuba: found the Mitsuba variant {name}, expected llvm_ad_rgb or cuda_ad_rgb; "
            'call mitsuba.set_variant("llvm_ad_rgb") before importing rna_mitsuba'
        )
