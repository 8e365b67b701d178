"""Training of lobes from a package: its transport along random directions is the target."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import torch
from torch import Tensor

from rna_export.environment.directions import even_directions, random_rotations
from rna_export.environment.lobe_model import LobeModel, densities
from rna_export.environment.lobe_queries import LobeInputs, QueryRows
from rna_export.environment.view_points import PartViews, Rows
from rna_export.training.optimization.pace import Pace
from rna_export.training.optimization.training_threads import threads_in_use, use_threads

_ROWS, _NEW = 2048, 64  # points of a step, and those of them that no step has had
_KEPT = 100_000  # points
_DIRECTIONS, _LIGHTS = 64, 32  # of a point
_KAPPA = (0.5, 30.0)  # of the lights
_STRIDE = 7  # in concentrations between neighbouring lights: none has a part of the sphere alone
_RATE, _WARMUP = 5e-3, 100  # steps
_EPSILON = 0.1  # of the relative error; radiance under a light of radiance 1


def light_weights() -> Tensor:
    """(lights, directions): weights of even directions under lights, each light's sum 1.

    Lights are von Mises-Fisher distributions about even directions of their own.
    """
    place = np.arange(_LIGHTS) * _STRIDE % _LIGHTS / (_LIGHTS - 1)
    kappa = _KAPPA[0] * (_KAPPA[1] / _KAPPA[0]) ** place
    cosine = even_directions(_LIGHTS) @ even_directions(_DIRECTIONS).T
    weights = np.exp(kappa[:, None] * (cosine - 1))
    return torch.from_numpy((weights / weights.sum(axis=1, keepdims=True)).astype(np.float32))


class _Kept:
    """The last points that were made: rows of `make_rows`."""

    def __init__(self, rows: tuple[Rows, ...]) -> None:
        self._rows = [np.empty((_KEPT, *array.shape[1:]), np.float32) for array in rows]
        self._count = self._next = 0
        self.add(rows)

    def add(self, rows: tuple[Rows, ...]) -> None:
        """Keep these, in the place of the oldest."""
        more = len(rows[0])
        start = self._next if self._next + more <= _KEPT else 0
        for kept, array in zip(self._rows, rows, strict=True):
            kept[start : start + more] = array
        self._next, self._count = start + more, max(self._count, start + more)

    def some(self, count: int, rng: np.random.Generator) -> list[Rows]:
        """`count` random points."""
        row = rng.integers(self._count, size=count)
        return [array.take(row, axis=0) for array in self._rows]


def make_rows(
    views: PartViews, queries: QueryRows, count: int, rng: np.random.Generator
) -> tuple[Rows, ...]:
    """`count` random points: the four of LobeInputs, directions and transport, (n, 3, D) each."""
    points = views.points(count, rng)
    d = even_directions(_DIRECTIONS) @ random_rotations(count, rng).transpose(0, 2, 1)
    d = np.ascontiguousarray(d, np.float32)
    row = np.repeat(np.arange(count), _DIRECTIONS)
    transport = views.transport(points, row, d.reshape(-1, 3)).reshape(d.shape)
    return *queries.of(points), d.transpose(0, 2, 1), transport.transpose(0, 2, 1)


def lobe_loss(model: LobeModel, rows: list[Rows], weights: Tensor) -> Tensor:
    """Mean squared relative error under lights: rows of `make_rows`, `light_weights`.

    Lobes and truth are taken along the same directions, so that only what the lobes do not
    explain is noise.
    """
    *inputs, directions, transport = rows
    amplitude, axis = model(LobeInputs(*inputs))
    answer = amplitude.transpose(1, 2) @ densities(axis, torch.from_numpy(directions))

    def under_lights(along: Tensor) -> Tensor:
        return along.reshape(-1, along.shape[2]) @ weights.T

    scale = under_lights(answer.detach()).clamp_min(0.0) + _EPSILON
    return ((under_lights(answer - torch.from_numpy(transport)) / scale) ** 2).mean()


def fit_lobes(
    model: LobeModel,
    views: PartViews,
    queries: QueryRows,
    paces: Sequence[Pace],
    seed: int = 0,
    advance: Callable[[float], None] = lambda share: None,
) -> int:
    """Train until the first of the paces is at its end; the number of steps that this took.

    advance: told shares of all that is done.

    Steps take one thread; a second one makes points meanwhile, in a fixed order.
    """
    rng, draw = np.random.default_rng(seed), np.random.default_rng(seed + 1)
    optimizer = torch.optim.Adam(model.parameters(), lr=_RATE)
    weights, threads = light_weights(), threads_in_use()
    kept, steps, done = _Kept(make_rows(views, queries, 4 * _ROWS, rng)), 0, 0.0
    use_threads(1)
    try:
        with ThreadPoolExecutor(1) as maker:
            coming = maker.submit(make_rows, views, queries, _NEW, rng)
            while done < 1.0:
                kept.add(coming.result())
                coming = maker.submit(make_rows, views, queries, _NEW, rng)
                steps += 1
                rate = 0.5 * (1.0 + math.cos(math.pi * done)) + 1e-3
                for group in optimizer.param_groups:
                    group["lr"] = _RATE * rate * min(1.0, steps / _WARMUP)
                optimizer.zero_grad()
                loss = lobe_loss(model, kept.some(_ROWS, draw), weights)
                loss.backward()
                optimizer.step()
                for pace in paces:
                    pace.advance()
                before, done = done, max(pace.progress for pace in paces)
                advance(done - before)
    finally:
        use_threads(threads)
    return steps
