"""The samples of an image, cut into bands of pixels, several of which are rendered at once.

Each band is rendered by one thread from its camera rays to its light. The loops within are long
enough to keep a thread busy, and what Python does between them for one band is done while the other
threads are in their loops. Threads that share each loop instead wait for one another at its end,
and for Python.
"""

import time
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice
from typing import Protocol

import numpy as np

from rna_render.image.film import Film, Layers
from rna_render.paths.sampling import Sampler
from rna_render.scene.scene_model import Scene
from rna_sdk.machine.kernel_threads import kernel_threads, limit_kernel_threads
from rna_work.pool import Pool
from rna_work.threads import Threads

# Rays in a band of the CPU: at most BAND, so that a stop is noticed soon. Of any renderer no fewer
# than SMALL_BAND if the image has them, so that each step has more to do than to start.
BAND = 1 << 16
SMALL_BAND = 1 << 13
_BANDS_A_THREAD = 8  # of all samples, from where the last ones leave few threads idle

_Band = tuple[np.ndarray, Sampler, bool]
"""Pixels, the sample's numbers, and whether it is the sample's last band."""


class BandRenderer(Protocol):
    """Renders samples of some pixels; rna_render.paths.integrator.Integrator does.

    groups: names of the groups of lights. at_once: so many bands at a time; None for any number.
    band: pixels of a band, at most. samples: of the same pixels that it takes at once, at most.
    """

    @property
    def groups(self) -> Sequence[str]: ...

    @property
    def at_once(self) -> int | None: ...

    @property
    def band(self) -> int: ...

    @property
    def samples(self) -> int: ...

    def render(self, pixels: np.ndarray, sampler: Sampler) -> Layers:
        """The sum of `sampler.count` samples."""


def render(
    scene: Scene,
    renderer: BandRenderer,
    stop: Callable[[], bool] = lambda: False,
    progress: Callable[[int], None] = lambda pixels: None,
    on_sample: Callable[[Film], None] = lambda film: None,
) -> Film:
    """Render `scene.samples` samples of every pixel, or fewer if `stop` or `quality` says so.

    stop: called after every band; the sample under way is then dropped. progress: called after
    every band with its number of pixels times its samples. on_sample: given the film after every
    sample but the last; where the renderer takes several at once, after these.
    """
    film = Film(scene.resolution, renderer.groups)
    samplers: Iterator[Sampler] = (Sampler(scene.seed, number) for number in range(scene.samples))
    if scene.quality is not None and scene.quality.seconds is not None:
        samplers = in_time(samplers, scene.quality.seconds, lambda: film.samples)
    sample: list[Layers] = []
    pixels = film.width * film.height
    with closing(rendered_bands(renderer, pixels, samplers, samples=scene.samples)) as bands:
        for band, samples, last in bands:
            sample.append(band)
            progress(len(band.hit) * samples)
            if last:
                film.add(sample, samples)
                sample.clear()
                if film.samples < scene.samples:
                    on_sample(film)
            if stop():
                break
    return film


def in_time(
    samplers: Iterable[Sampler], seconds: float, finished: Callable[[], int]
) -> Iterator[Sampler]:
    """The first of the samplers, and as many more as fit into `seconds` from the first on.

    One more fits if all given so far and it take as long each as the mean of those finished;
    before any is, if there is time left at all.

    finished: how many of the samples are done; it may lag behind those given.
    """
    start = time.perf_counter()
    for given, sampler in enumerate(samplers):
        elapsed, done = time.perf_counter() - start, finished()
        expected = elapsed * (given + 1) / done if done else elapsed
        if given and expected > seconds:
            return
        yield sampler


def rendered_bands(
    renderer: BandRenderer,
    count: int,
    samplers: Iterable[Sampler],
    most: int | None = None,
    samples: int = 1,
) -> Generator[tuple[Layers, int, bool], None, None]:
    """The bands of each sample in turn, of how many samples each is, and whether it is their last.

    count: pixels of the image. most: pixels of a band, the renderer's if None. samples: how many
    there will be, as far as is known: of many, each has no more bands than it needs. As many bands
    are under way as numba has threads for the caller, and as many wait, so that no thread idles
    while the caller takes what is finished; a caller that stops early waits for those under way,
    and the rest is not begun.
    """
    threads = min(kernel_threads(), renderer.at_once or kernel_threads())
    bands = _bands(count, threads, most or renderer.band, samples)
    work = (
        (band, sampler, band is bands[-1])
        for sampler in _together(renderer, iter(samplers))
        for band in bands
    )
    make = partial(_BandWorker, renderer)
    pool: Pool[_Band, Layers] = Pool(Threads(threads), make, ahead=1)
    with pool, closing(pool.run(work, ordered=True)) as outcomes:
        for outcome in outcomes:
            _, sampler, last = outcome.item
            yield outcome.value(), sampler.count, last


@dataclass(frozen=True)
class _BandWorker:
    """Renders bands in the thread that enters it."""

    renderer: BandRenderer
    name: str

    def __enter__(self) -> "_BandWorker":
        limit_kernel_threads(1)  # of calls of this thread
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def run(self, item: _Band) -> Layers:
        pixels, sampler, _ = item
        return self.renderer.render(pixels, sampler)

    def kill(self) -> None:
        """A band is rendered to its end, which is soon."""


def _together(renderer: BandRenderer, samplers: Iterator[Sampler]) -> Iterator[Sampler]:
    """The samplers, which are consecutive, several in one of them if the renderer takes several.

    There are ever more of them, so that the first samples are seen soon. How many does not depend
    on time, and neither do sums.
    """
    for first in samplers:
        most = min(max(3 * first.sample, 1), renderer.samples)
        others = sum(1 for _ in islice(samplers, most - 1))
        yield replace(first, count=1 + others)


def _bands(count: int, threads: int, most: int, samples: int = 1) -> list[np.ndarray]:
    """Places of pixels, (n,) uint32 each; bands of one size.

    Of few samples as many for each thread. Of many the fewest: threads go on to the next sample,
    and what Python does for a band, one thread at a time, is the less the larger bands are.
    """
    fewest = max(1, -(-count // most))
    if fewest * samples < _BANDS_A_THREAD * threads:
        shared = min(-(-fewest // threads) * threads, -(-count // SMALL_BAND))
        fewest = max(fewest, shared)
    return np.array_split(np.arange(count, dtype=np.uint32), fewest)
