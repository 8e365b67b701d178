"""Motion blur: samples of an image at several times while the shutter is open."""

from collections.abc import Sequence

import numpy as np

from rna_render.image.film import Layers
from rna_render.paths.bands import BandRenderer
from rna_render.paths.sampling import Sampler


class ShutterRenderer:
    """Renders sample s with the renderer of time s modulo their number, so each has its share."""

    def __init__(self, renderers: Sequence[BandRenderer]) -> None:
        self._renderers = renderers
        first = renderers[0]
        self.groups, self.at_once, self.band = first.groups, first.at_once, first.band
        self.samples = 1

    def render(self, pixels: np.ndarray, sampler: Sampler) -> Layers:
        """One sample of the given pixels, (n,) uint32."""
        return self._renderers[sampler.sample % len(self._renderers)].render(pixels, sampler)


def shutter_times(number: int, shutter: float, subframes: int) -> list[float]:
    """The times of a frame's samples, in frames: the middles of equal parts of the open shutter.

    It opens at the frame, for `shutter` of the time to the next one.
    """
    if shutter == 0.0:
        return [float(number)]
    return [number + shutter * (k + 0.5) / subframes for k in range(subframes)]
