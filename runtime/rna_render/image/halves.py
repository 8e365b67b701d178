"""Noise of an image, from how far the two halves of its samples are apart."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

_OF_HALVES = 0.65
"""Variance of the mean of Sobol' samples over the variance of independent halves.

Each half is spread evenly, and both together more evenly still. Measured 0.5 to 0.87 on 2 to 64
samples (docs/decisions/renderer.md).
"""


@dataclass
class Halves:
    """The samples up to the last time that their number had doubled, and those before.

    first: (n, 3) float64, sum of the samples at that time. variance: (n, 3) float64, of the mean
    of these. samples: their number.
    """

    first: np.ndarray
    variance: np.ndarray
    samples: int = 0

    @classmethod
    def empty(cls, count: int) -> Halves:
        """Halves without samples for `count` pixels."""
        return cls(np.zeros((count, 3)), np.zeros((count, 3)))

    @property
    def nbytes(self) -> int:
        """Memory of the arrays."""
        return self.first.nbytes + self.variance.nbytes

    def follow(self, total: np.ndarray, samples: int) -> None:
        """Take note of the sum (n, 3) of so many samples."""
        if samples < 2 * self.samples:
            return
        if self.samples > 0:
            later = samples - self.samples
            difference = self.first / self.samples - (total - self.first) / later
            share = _OF_HALVES * self.samples * later / samples**2
            self.variance = share * np.square(difference)
        self.first, self.samples = total.copy(), samples

    def put(self, pixels: slice, part: Halves) -> None:
        """Take over some pixels."""
        self.first[pixels], self.variance[pixels] = part.first, part.variance
        self.samples = part.samples

    def arrays(self) -> dict[str, np.ndarray]:
        """State from which `of_arrays` restores it."""
        counted = np.array([self.samples])
        return {"first_half": self.first, "variance": self.variance, "half_samples": counted}

    @classmethod
    def of_arrays(cls, arrays: dict[str, np.ndarray]) -> Halves:
        """From its `arrays`."""
        return cls(arrays["first_half"], arrays["variance"], int(arrays["half_samples"][0]))
