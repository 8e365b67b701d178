"""Brightness of a model relative to Cycles, in lit and shadowed regions."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from rna_export.capture.dataset.validation_view import is_lit

LIT, SHADOWED = 0.02, 0.05
"""Shares of the light by which a channel may be off, where light is visible and in shadow."""

_LEAST_SHARE = 0.01  # of an asset's light; a channel with less in shadow is not judged there


@dataclass(frozen=True)
class Brightness:
    """Sums of radiance over the references' sums, (3,) float64 each; NaN without light."""

    lit: np.ndarray
    shadowed: np.ndarray
    shadow_share: np.ndarray  # (3,): of the references' light, what is in shadow

    def __str__(self) -> str:
        lit, shadowed = (
            " ".join(f"{x:.3f}" for x in values) for values in (self.lit, self.shadowed)
        )
        return f"brightness over Cycles', red green blue: lit {lit}, in shadow {shadowed}"

    @property
    def faults(self) -> list[str]:
        """Channels whose brightness is off by more than `LIT` or `SHADOWED`, one line each."""
        lines = []
        counts = self.shadow_share > _LEAST_SHARE
        for where, ratio, most, judged in (
            ("lit", self.lit, LIT, np.isfinite(self.lit)),
            ("in shadow", self.shadowed, SHADOWED, counts & np.isfinite(self.shadowed)),
        ):
            off = np.abs(ratio - 1.0)[judged]
            if off.size and off.max() > most:
                lines.append(
                    f"{where} the brightness is off by {off.max():.1%} in a channel, expected at "
                    f"most {most:.0%}"
                )
        return lines


def brightness(rows: Iterable[tuple[np.ndarray, np.ndarray, np.ndarray]]) -> Brightness:
    """Brightness over images of (radiance (n, 3), reference (n, 3), visible (n,) or (n, 3)).

    What counts as lit: see `is_lit`.
    """
    sums = np.zeros((2, 2, 3))  # in shadow and lit; ours and the reference
    for radiance, reference, visible in rows:
        of_lit = is_lit(visible)
        for lit in (False, True):
            for k, values in enumerate((radiance, reference)):
                sums[int(lit), k] += values[of_lit == lit].sum(axis=0, dtype=np.float64)
    with np.errstate(divide="ignore", invalid="ignore"):
        shadowed, lit = sums[:, 0] / sums[:, 1]
        share = sums[0, 1] / sums[:, 1].sum(axis=0)
    return Brightness(lit, shadowed, share)
