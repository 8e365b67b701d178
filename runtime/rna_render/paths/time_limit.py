"""How long a sample of an image takes, measured on some of its pixels."""

import time
from contextlib import closing

import numpy as np

from rna_render.image.film import Layers
from rna_render.paths.bands import BandRenderer, rendered_bands
from rna_render.paths.sampling import Sampler

# Below this many samples a pixel noise is worse than what a cheaper tier costs.
ENOUGH_SAMPLES = 16


def seconds_a_sample(renderer: BandRenderer, count: int) -> float:
    """Time of one sample per pixel of an image of `count` pixels, measured on some of them.

    Half a band, if the image has as many: enough to keep all threads busy.
    """
    chosen = np.linspace(0, count - 1, min(count, renderer.band // 2)).astype(np.uint32)
    sparse = SomePixels(renderer, chosen)
    _seconds(sparse, min(len(chosen), 256))  # compiles, and warms caches
    return _seconds(sparse, len(chosen)) * count / len(chosen)


class SomePixels:
    """A renderer of chosen pixels alone, (n,) uint32."""

    def __init__(self, renderer: BandRenderer, chosen: np.ndarray) -> None:
        self._renderer, self._chosen = renderer, chosen
        self.groups, self.at_once = renderer.groups, renderer.at_once
        self.band, self.samples = renderer.band, renderer.samples

    def render(self, pixels: np.ndarray, sampler: Sampler) -> Layers:
        return self._renderer.render(self._chosen[pixels], sampler)


def _seconds(renderer: BandRenderer, count: int) -> float:
    start = time.perf_counter()
    with closing(rendered_bands(renderer, count, [Sampler(0, 0)])) as bands:
        for _ in bands:
            pass
    return time.perf_counter() - start
