"""Which light a sample goes to."""

from collections.abc import Sequence

import numpy as np

from rna_render.lights.base import Light

# Part of the samples that go to all lights that shine alike. By power alone, a lamp near an
# object would get next to nothing under a sky that lights a wide ground.
EVEN_SHARE = 0.5


class LightSelection:
    """Chooses among lights: EVEN_SHARE of the samples evenly, the rest by power.

    scene_radius: of a sphere around the scene, metres. Lights without power are never chosen,
    unless no light has any: then all are alike, and what they are chosen for is black.

    probability: (k,) float64 of each light, its sum 1; (0,) if there are no lights.
    """

    def __init__(self, lights: Sequence[Light], scene_radius: float) -> None:
        power = np.array([light.power(scene_radius) for light in lights], np.float64)
        shines = power > 0.0
        if not shines.any():
            shines = np.ones(len(power), bool)
            power = shines.astype(np.float64)
        # In two steps, because a sum of great powers may be infinite.
        power = power / max(float(power.max(initial=0.0)), 1e-300)
        even = shines / max(int(np.count_nonzero(shines)), 1)
        by_power = power / max(float(power.sum()), 1e-300)
        self.probability = EVEN_SHARE * even + (1.0 - EVEN_SHARE) * by_power
        self._inner_edges = np.cumsum(self.probability)[:-1]
        self._last = int(np.flatnonzero(shines)[-1]) if len(power) else -1

    def choose(self, u: np.ndarray) -> np.ndarray:
        """Places of lights in the list: (n,) int32; -1 if there are none.

        u: (n,) in [0, 1).
        """
        chosen = np.searchsorted(self._inner_edges, u, side="right")
        # The sum of the probabilities may miss 1 by a rounding error.
        return np.minimum(chosen, self._last).astype(np.int32)
