"""The goal of a fit, on a scale where training's power law is linear."""

from __future__ import annotations

from dataclasses import dataclass
from math import log10
from typing import Literal, Protocol


class Scored(Protocol):
    """The errors that goals use: PSNR in dB and mean FLIP of the validation images."""

    @property
    def psnr(self) -> float: ...

    @property
    def flip(self) -> float: ...


@dataclass(frozen=True)
class Goal:
    """A limit on the error, or on the cost.

    max_error: mean FLIP of the validation images, as a tier's `validation.flip` records it.
    min_psnr: dB, as `validation.psnr` records it. budget: nanoseconds per query on all threads.
    """

    metric: Literal["max_error", "min_psnr", "budget"]
    value: float

    @property
    def limits_cost(self) -> bool:
        """Whether the most accurate model within a cost is wanted, not the cheapest one."""
        return self.metric == "budget"

    def error_db(self, scores: Scored) -> float:
        """The error in decibels: a factor of the error is a difference here; less is better."""
        if self.metric == "max_error":
            return 10.0 * log10(max(scores.flip, 1e-9))
        return -scores.psnr

    @property
    def limit_db(self) -> float:
        """Largest allowed `error_db`; infinity if the cost is limited instead."""
        if self.metric == "max_error":
            return 10.0 * log10(self.value)
        return -self.value if self.metric == "min_psnr" else float("inf")

    def met_by(self, scores: Scored) -> bool:
        """Whether the error is within the limit."""
        return self.error_db(scores) <= self.limit_db

    def shown(self, error_db: float) -> str:
        """An `error_db` as people read it."""
        if self.metric == "max_error":
            return f"FLIP {10.0 ** (error_db / 10.0):.4f}"
        return f"{-error_db:.2f} dB"

    def __str__(self) -> str:
        return {
            "max_error": f"mean FLIP of at most {self.value:g}",
            "min_psnr": f"PSNR of at least {self.value:g} dB",
            "budget": f"cost of at most {self.value / 1e3:g} us per query",
        }[self.metric]
