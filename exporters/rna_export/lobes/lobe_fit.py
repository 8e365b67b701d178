"""Training of lobes from a package: its transport along random directions is the target."""

import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial

import numpy as np
import torch
from numpy.typing import NDArray

from rna_export.capture.rays.capture_directions import GOLDEN
from rna_export.export.decoder import compare_answers, export_decoder
from rna_export.lobes.directions import random_rotations
from rna_export.lobes.lobe_loss import LobeLoss, Targets, even_lights
from rna_export.lobes.lobe_model import LOBES, LobeModel
from rna_export.lobes.lobe_queries import LobeInputs, QueryRows
from rna_export.lobes.view_points import PartViews, Rows, ViewPoints
from rna_export.training.model.layers import hidden_matrices
from rna_export.training.optimization.optimizers import optimizers_of_networks, set_rates
from rna_export.training.optimization.pace import Pace
from rna_export.training.optimization.product_kernels import threads_in_use, use_threads
from rna_render.world.neural_sampling import Lobe, LobeMixture
from rna_sdk.package import Lobes
from rna_trace import FiberPoints

_ROWS, _NEW = 2048, 32  # points of a step, and those of them that no step has had
_BUFFERED = 100_000  # points
_DIRECTIONS = 64  # of a point
_SURFACE = LobeMixture(mirror=(Lobe(0.4, 0.11),)).everywhere
_FIBER = LobeMixture(cone=(Lobe(0.4, 0.08),)).everywhere
_RATES, _WARMUP = (5e-3, 0.015), 100  # of Adam and Muon; steps


class _RowBuffer:
    """The last points that were made: rows of `make_rows`."""

    def __init__(self, rows: tuple[Rows, ...]) -> None:
        self._rows = [np.empty((_BUFFERED, *array.shape[1:]), np.float32) for array in rows]
        self._count = self._next = 0
        self.add(rows)

    def add(self, rows: tuple[Rows, ...]) -> None:
        """Keep these, in the place of the oldest."""
        more = len(rows[0])
        start = self._next if self._next + more <= _BUFFERED else 0
        for stored, array in zip(self._rows, rows, strict=True):
            stored[start : start + more] = array
        self._next, self._count = start + more, max(self._count, start + more)

    def some(
        self, count: int, rng: np.random.Generator
    ) -> tuple[LobeInputs, NDArray[np.int64], Targets]:
        """`count` random points: their inputs, and which of the targets are theirs."""
        row, inputs = rng.integers(self._count, size=count), len(LobeInputs._fields)
        taken = (array.take(row, axis=0) for array in self._rows[:inputs])
        return LobeInputs(*taken), row, Targets(*self._rows[inputs:])


def make_rows(
    views: PartViews, queries: QueryRows, count: int, rng: np.random.Generator
) -> tuple[Rows, ...]:
    """`count` random points: the members of LobeInputs, and those of Targets."""
    points = views.points(count, rng)
    d, share = _directions(points, rng)
    row = np.repeat(np.arange(count), _DIRECTIONS)
    transport = views.transport(points, row, d.reshape(-1, 3)).reshape(d.shape)
    d, transport = (np.ascontiguousarray(rows.transpose(0, 2, 1)) for rows in (d, transport))
    targets = Targets(d, transport, share, random_rotations(count, rng))
    return *queries.of(points), *targets


def _directions(points: ViewPoints, rng: np.random.Generator) -> tuple[Rows, Rows]:
    """All around, denser where transport may be sharp: (n, D, 3), and their shares (n, D)."""
    k, n = np.arange(_DIRECTIONS), len(points)
    spiral = np.stack([(k + 0.5) / _DIRECTIONS, k * GOLDEN], axis=1)
    u = (spiral + rng.random((n, 1, 2))) % 1.0
    mixture = _FIBER if isinstance(points.at, FiberPoints) else _SURFACE
    row = np.repeat(np.arange(n), _DIRECTIONS)
    d = mixture.sample(points.axis, points.axis, points.wo, u.reshape(-1, 2), row)
    share = np.float32(1.0) / (
        np.float32(_DIRECTIONS) * mixture.pdf(points.axis, points.axis, points.wo, d, row)
    )
    return d.reshape(n, _DIRECTIONS, 3), np.asarray(share.reshape(n, _DIRECTIONS), np.float32)


def fit_lobes(
    model: LobeModel,
    views: PartViews,
    queries: QueryRows,
    paces: Sequence[Pace],
    seed: int = 0,
    advance: Callable[[float], None] = lambda share: None,
) -> int:
    """Train until the first of the paces is at its end; the number of steps that this took.

    advance: takes shares of all that is done.

    Steps take one thread; a second one, where the caller has it, makes points meanwhile. Points
    and their order are the same either way.
    """
    rng, draw = np.random.default_rng(seed), np.random.default_rng(seed + 1)
    matrices = hidden_matrices(model.decoder)
    optimizers = optimizers_of_networks([*model.parameters()], matrices, _RATES)
    lights, threads = even_lights(), threads_in_use()
    buffer, steps, done = _RowBuffer(make_rows(views, queries, 4 * _ROWS, rng)), 0, 0.0
    use_threads(1)
    try:
        with ThreadPoolExecutor(1) as maker:
            made = partial(make_rows, views, queries, _NEW, rng)
            coming = maker.submit(made).result if threads > 1 else made
            while done < 1.0:
                buffer.add(coming())
                coming = maker.submit(made).result if threads > 1 else made
                steps += 1
                rate = 0.5 * (1.0 + math.cos(math.pi * done)) + 1e-3
                set_rates(optimizers, rate * min(1.0, steps / _WARMUP))
                inputs, *targets = buffer.some(_ROWS, draw)
                loss = LobeLoss.apply(*model(inputs), *targets, lights)  # type: ignore[no-untyped-call]
                loss.backward()
                for optimizer in optimizers:
                    optimizer.step()
                    optimizer.zero_grad()
                for pace in paces:
                    pace.advance()
                before, done = done, max(pace.progress for pace in paces)
                advance(done - before)
    finally:
        use_threads(threads)
    return steps


_COMPARED, _EXTREME, _FAR = 5000, 500, 10.0  # queries; factor on extreme ones


def exported_lobes(model: LobeModel, views: PartViews, queries: QueryRows, tier: str) -> Lobes:
    """The decoder in ONNX, compared with the trained one, and the visibility that it reads.

    Raises ExportError where they differ.
    """
    decoder = export_decoder(model)
    points = views.points(_COMPARED, np.random.default_rng(1))
    usual = torch.from_numpy(queries.of(points).queries)
    far = _FAR * usual[:_EXTREME]
    extreme = torch.cat([torch.zeros_like(usual[:1]), far, -far])
    return Lobes(
        tier=tier,
        lobes=LOBES,
        inputs=queries.inputs,
        decoder=decoder,
        harmonics=views.visibility,
        agreement=compare_answers(decoder, model, usual, extreme),
    )
