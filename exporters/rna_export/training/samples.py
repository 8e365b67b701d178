"""Training batches: all samples in one table of 16 columns, a cache line a row."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np
import torch
from torch import Tensor
from torch.utils.data import IterableDataset

_COLUMNS = ("position", "normal", "wo", "wi", "radiance", "visible")


class SampleTable(IterableDataset):
    """Endless random batches, each sample once an epoch; repeats for the same seed.

    `done` batches are left out at the start: a stopped run saw them.

    Yields (batch, 16) float32: position, normal, wo, wi, radiance (3 each), visible.
    """

    def __init__(
        self, samples: dict[str, np.ndarray], batch: int, seed: int, device: str, done: int = 0
    ):
        n = len(samples["visible"])
        table = np.empty((n, 16), np.float32)
        for k, name in enumerate(_COLUMNS):
            table[:, 3 * k : 3 * k + 3] = samples[name].reshape(n, -1)
        self.rows = torch.from_numpy(table).to(device)
        self._batch, self._seed, self._done = min(batch, n), seed, done

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[Tensor]:
        generator = torch.Generator().manual_seed(self._seed)
        starts = range(0, len(self.rows) - self._batch + 1, self._batch)
        epochs, batches = divmod(self._done, len(starts))
        for epoch in itertools.count():
            order = torch.randperm(len(self.rows), generator=generator).to(self.rows.device)
            if epoch < epochs:
                continue
            for first in starts[batches if epoch == epochs else 0 :]:
                yield self.rows[order[first : first + self._batch]]


def columns(rows: Tensor) -> dict[str, Tensor]:
    """The named columns of rows (k, 16); `visible` is (k,)."""
    named = {name: rows[:, 3 * k : 3 * k + 3] for k, name in enumerate(_COLUMNS[:5])}
    return named | {"visible": rows[:, 15]}
