"""An image in pieces of pixels, each with all samples, rendered by workers wherever they are.

A pixel's samples are added in the order in which one machine adds them, so the image is the same
to the bit. Finished pieces are kept in files, so an image that was stopped goes on.
"""

from collections.abc import Iterable, Iterator
from contextlib import closing
from functools import partial
from math import prod
from pathlib import Path

import numpy as np

from rna_render.command.finished_pieces import FinishedPieces, Piece, missing_pieces
from rna_render.command.frame_worker import SceneWorker
from rna_render.image.film import Film
from rna_render.paths.bands import SMALL_BAND, BandRenderer, render
from rna_render.paths.integrator_factory import CPU
from rna_render.paths.time_limit import SomePixels
from rna_render.scene.scene_file import SceneFile
from rna_render.world.scene_sources import carried_scene, scene_key
from rna_sdk.errors import SceneError
from rna_work.executors import Executor
from rna_work.pool import Pool
from rna_work.progress import Progress
from rna_work.sources import Carried

_PIECES_A_WORKER = 16  # so that none waits long for the last one, and a stop loses little
_MOST = 1 << 18  # pixels: of more, what comes back would be hundreds of megabytes


def render_pieces(
    scene_file: SceneFile, executor: Executor, threads: int | None, folder: Path, device: str = CPU
) -> tuple[Film, FinishedPieces]:
    """The finished image and its stored pieces, which the caller deletes once the image is written.

    folder: where finished pieces are kept; those of the same device that are there are not
    rendered again. device: of `devices`, on every machine. Raises
    SceneError for a scene that limits the time of its image.
    """
    scene = scene_file.scene
    if scene.quality is not None and scene.quality.seconds is not None:
        raise scene_file.error(
            ("quality", "seconds"), "limits the time of one machine, expected none with --cluster"
        )
    files = carried_scene(scene_file, executor)
    backend, threads = executor.whole_machines(threads, needs_gpu=device != CPU)
    finished = FinishedPieces(folder, f"{device} {scene_key(scene_file)}")
    count, image = prod(scene.resolution), _Image(scene.resolution)
    there = []
    for piece, film in finished.saved():
        image.put(piece, film)
        there.append(piece)
    size = _size(count, backend.width(), threads, scene.samples)
    pieces = list(_cut(missing_pieces(count, there), size))
    done = sum(piece.pixels for piece in there)
    rays = float(count * scene.samples)
    make = partial(PieceWorker, scene_file, files, threads, device)
    progress = Progress(rays, "ray", "rendering", float(done * scene.samples))
    pool: Pool[Piece, Film] = Pool(backend, make, tell=progress.tell)
    with progress, pool, closing(pool.run(pieces)) as outcomes:
        for outcome in progress.of(pool, outcomes, lambda piece: piece.pixels * scene.samples):
            finished.keep(outcome.item, outcome.value())
            image.put(outcome.item, outcome.value())
    return image.whole(), finished


class _Image:
    """A film that is put together of pieces."""

    def __init__(self, resolution: tuple[int, int]) -> None:
        self._resolution = resolution
        self._film: Film | None = None

    def put(self, piece: Piece, part: Film) -> None:
        self._film = self._film or Film(self._resolution, part.groups)
        self._film.put(piece.start, part)

    def whole(self) -> Film:
        if self._film is None:
            raise SceneError("no pixel was rendered")
        return self._film


def _size(count: int, workers: int, threads: int, samples: int) -> int:
    """Pixels of a piece: its samples, or bands of one, keep all threads busy."""
    least = SMALL_BAND * max(1, threads // samples)
    return min(_MOST, max(least, -(-count // (_PIECES_A_WORKER * max(workers, 1)))))


def _cut(pieces: Iterable[Piece], size: int) -> Iterator[Piece]:
    for piece in pieces:
        for start in range(piece.start, piece.stop, size):
            yield Piece(start, min(start + size, piece.stop))


class PieceWorker(SceneWorker):
    """Renders pieces of a scene's image: see `rna_work.workers.Worker`."""

    def __init__(
        self, scene_file: SceneFile, files: Carried, threads: int, device: str, name: str
    ) -> None:
        super().__init__(scene_file, files, threads, device)
        self._renderer: BandRenderer | None = None

    def run(self, piece: Piece) -> Film:
        """All samples of the piece's pixels; an image that is as wide as there are."""
        scene = self.scene_file.scene
        if self._renderer is None:
            world = self.load(self.scene_file, [scene])
            self._renderer = self.renderer(self.scene_file, world)
        pixels = np.arange(piece.start, piece.stop, dtype=np.uint32)
        row = scene.model_copy(update={"resolution": (len(pixels), 1)})
        film = render(row, SomePixels(self._renderer, pixels), self.stop.is_set)
        if film.samples < scene.samples:
            raise SceneError(f"{piece} was stopped")
        return film
