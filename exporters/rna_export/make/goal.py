"""The error that a package is to have, on a scale where training's power law is linear."""

from dataclasses import dataclass
from math import log10
from typing import Literal, Protocol


class Scored(Protocol):
    """The errors that goals use: PSNR in dB and mean FLIP of the asset's pixels."""

    @property
    def psnr(self) -> float: ...

    @property
    def flip(self) -> float: ...


@dataclass(frozen=True)
class Goal:
    """A limit on the error.

    max_error: mean FLIP of the asset's pixels in the validation images, `validation.flip`.
    min_psnr: dB, `validation.psnr`.
    """

    metric: Literal["max_error", "min_psnr"]
    value: float

    def error_db(self, scores: Scored) -> float:
        """The error in decibels: a factor of the error is a difference here; less is better."""
        if self.metric == "max_error":
            return 10.0 * log10(max(scores.flip, 1e-9))
        return -scores.psnr

    @property
    def limit_db(self) -> float:
        """Largest allowed `error_db`."""
        return 10.0 * log10(self.value) if self.metric == "max_error" else -self.value

    def met_by(self, scores: Scored) -> bool:
        """Whether the error is within the limit."""
        return self.error_db(scores) <= self.limit_db

    def __str__(self) -> str:
        if self.metric == "max_error":
            return f"mean FLIP of at most {self.value:g}"
        return f"PSNR of at least {self.value:g} dB"
