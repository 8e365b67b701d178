"""The picture of a view before its samples: environments by lobes, which fades into them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rna_render.image.film import Film
from rna_render.paths.lobe_lighting import lobed_objects
from rna_render.preview.picture import rgba
from rna_render.world.world import World

FADED = 16
"""Samples from which on nothing is left of the first look."""


@dataclass(frozen=True)
class FirstLook:
    """A sample by lobes.

    rgba: (h, w, 4) float32. lobed: (h, w) bool, where an asset is seen that has lobes. samples: of
    the whole picture.
    """

    rgba: np.ndarray
    lobed: np.ndarray
    samples: int

    @classmethod
    def of(cls, film: Film, world: World, samples: int) -> FirstLook:
        """film: of the sample. samples: of the picture to come."""
        lobed = np.isin(film.channels()["assetId"], lobed_objects(world))
        return cls(rgba(film), lobed, samples)

    def share(self, samples: int) -> float:
        """Weight of this picture after `samples` samples, where lobes are seen."""
        return max(0.0, 1.0 - samples / min(FADED, self.samples))

    def blended(self, picture: np.ndarray, samples: int) -> np.ndarray:
        """The mean of so many samples, (h, w, 4) float32, and this; elsewhere it is one of them."""
        share = self.share(samples)
        weight = np.where(self.lobed, share, min(share, 1.0 / (samples + 1)))[..., None]
        return np.asarray(picture + weight.astype(np.float32) * (self.rgba - picture))
