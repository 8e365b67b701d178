"""The loop over an image's samples."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing

from rna_render.image.film import Film, Layers
from rna_render.paths.bands import BandRenderer, rendered_bands
from rna_render.paths.sampling import Sampler
from rna_render.paths.time_limit import in_time
from rna_render.scene.scene_model import Scene


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
