"""An image in pieces of pixels, each with all samples, rendered by workers wherever they are.

A pixel's samples are added in the order in which one machine adds them, so the image is the same
to the bit.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from math import prod

import numpy as np

from rna_render.bands import SMALL_BAND, rendered_bands
from rna_render.film import Film, Layers
from rna_render.frame_worker import SceneWorker
from rna_render.integrator import Integrator
from rna_render.render import make_integrator
from rna_render.sampling import Sampler
from rna_render.scene_file import SceneFile
from rna_render.scene_sources import carried_scene
from rna_render.time_limit import SomePixels
from rna_sdk.errors import SceneError
from rna_work.places import Place
from rna_work.pool import Pool
from rna_work.progress import Progress
from rna_work.sources import Carried

_PIECES_A_WORKER = 4  # so that none waits long for the last one
_MOST = 1 << 18  # pixels: of more, what comes back would be hundreds of megabytes


@dataclass(frozen=True)
class Piece:
    """Pixels of an image in row-major order, from `start` to before `stop`."""

    start: int
    stop: int

    @property
    def pixels(self) -> int:
        """How many."""
        return self.stop - self.start

    def __str__(self) -> str:
        return f"piece of pixels {self.start} to {self.stop - 1}"


def render_pieces(scene_file: SceneFile, where: Place, threads: int | None) -> Film:
    """The finished image. Raises SceneError for a scene that limits the time of its image."""
    scene = scene_file.scene
    if scene.quality is not None and scene.quality.seconds is not None:
        raise scene_file.error(
            ("quality", "seconds"), "limits the time of one machine, expected none with --cluster"
        )
    backend, threads = where.whole_machines(threads)
    make = partial(PieceWorker, scene_file, carried_scene(scene_file, where), threads)
    count = prod(scene.resolution)
    pieces = list(_pieces(count, backend.width(), threads))
    film: Film | None = None
    with (
        Progress(float(count * scene.samples), "ray", "rendering") as progress,
        Pool(backend, make, tell=progress.tell) as pool,
        closing(pool.run(pieces)) as outcomes,
    ):
        for outcome in progress.of(pool, outcomes, lambda piece: piece.pixels * scene.samples):
            part: Film = outcome.value()
            film = film or Film(scene.resolution, part.groups)
            film.put(outcome.item.start, part)
    if film is None:
        raise SceneError("no pixel was rendered")
    return film


def _pieces(count: int, workers: int, threads: int) -> Iterator[Piece]:
    least = SMALL_BAND * threads
    size = min(_MOST, max(least, -(-count // (_PIECES_A_WORKER * max(workers, 1)))))
    for start in range(0, count, size):
        yield Piece(start, min(start + size, count))


class PieceWorker(SceneWorker):
    """Renders pieces of a scene's image: see `rna_work.worker.Worker`."""

    def __init__(self, scene_file: SceneFile, files: Carried, threads: int, name: str) -> None:
        super().__init__(scene_file, files, threads)
        self._integrator: Integrator | None = None

    def run(self, piece: Piece) -> Film:
        """All samples of the piece's pixels; an image that is as wide as there are."""
        scene = self.scene_file.scene
        if self._integrator is None:
            world = self.load([scene])
            resolve = self.scene_file.resolve
            self._integrator = make_integrator(scene, world, resolve=resolve)
        pixels = np.arange(piece.start, piece.stop, dtype=np.uint32)
        samplers = (Sampler(scene.seed, number) for number in range(scene.samples))
        film, sample = Film((len(pixels), 1), self._integrator.groups), list[Layers]()
        some = SomePixels(self._integrator, pixels)
        with closing(rendered_bands(some, len(pixels), samplers)) as bands:
            for band, last in bands:
                if self.stop.is_set():
                    raise SceneError(f"{piece} was stopped")
                sample.append(band)
                if last:
                    film.add(Layers.concatenate(sample))
                    sample.clear()
        return film
