"""The interface between `rna-bench peers` and a method."""

from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

import numpy as np

from rna_bench.peers.views import PeerCamera, Views


@dataclass(frozen=True)
class Budget:
    """How long a training may be.

    until: seconds of processor time, all of the method's trainings in a folder together. planned:
    seconds for which rates and annealing are laid out; a training may stop before and go on later.
    steps: lay the schedule out in steps instead, and stop after these.
    """

    until: float
    planned: float
    steps: int | None = None


@dataclass(frozen=True)
class LossPoint:
    """A point of a training curve: the mean loss since the point before."""

    seconds: float
    steps: int
    samples: int
    loss: float


@dataclass(frozen=True)
class Training:
    """Steps, samples and time of a training so far.

    seconds: of processor time (of wall time on a GPU). samples: pixels seen, with repetition.
    """

    seconds: float = 0.0
    steps: int = 0
    samples: int = 0
    curve: tuple[LossPoint, ...] = ()


class Method(Protocol):
    """A relightable model of one asset."""

    @property
    def parameter_count(self) -> int:
        """Number of parameters that are trained."""

    def train(self, data: Views, budget: Budget, work: Path) -> Training:
        """Train on the images until the budget is used; resumes from the files in `work`."""

    def render(self, camera: PeerCamera, light: np.ndarray) -> np.ndarray:
        """Radiance (h, w, 3) float32, linear, over black, with a point light at `light`, (3,)."""
