"""Training batches: all samples in one table, one per row."""

from __future__ import annotations

import copy
import itertools
from collections.abc import Iterator
from functools import cached_property

import numpy as np
import torch
from torch import Tensor
from torch.utils.data import IterableDataset

_DIM = 0.02  # of the mean of what an asset emits
_GATHERED = 32  # batches at once: random rows of a large table come from memory one by one


class SampleTable(IterableDataset[Tensor]):
    """Endless random batches, each sample once an epoch; repeats for the same seed.

    `done` batches are left out at the start: a stopped run saw them.

    Yields (batch, columns) float32, the fields of `samples` side by side, in their order;
    `columns` finds them again.
    """

    def __init__(
        self,
        samples: dict[str, np.ndarray],
        batch: int = 2048,
        seed: int = 0,
        device: str = "cpu",
        done: int = 0,
    ):
        n = len(samples["position"])
        self.fields = {name: values[0].size for name, values in samples.items()}
        table = np.empty((n, sum(self.fields.values())), np.float32)
        first = 0
        for name, width in self.fields.items():
            table[:, first : first + width] = samples[name].reshape(n, width)
            first += width
        self.rows = torch.from_numpy(table).to(device)
        self._batch, self._seed, self._done = min(batch, n), seed, done

    def shuffled(self, batch: int, seed: int, done: int) -> SampleTable:
        """These rows, not copied, in batches of another size and order."""
        other = copy.copy(self)
        other._batch, other._seed, other._done = min(batch, len(self)), seed, done
        return other

    @cached_property
    def largest_radiance(self) -> float:
        """Maximum over all samples and channels."""
        return float(columns(self.rows, self.fields)["radiance"].max())

    @cached_property
    def usual_radiance(self) -> float:
        """Typical radiance of lit points: highlights are far above it, shadows below.

        The median; of scattered light, where that is told apart, the mean: most of it is 0. Of
        emission a part of the mean: what a lamp's light makes of its stand counts, too.
        """
        samples = columns(self.rows, self.fields)
        if "visible" not in samples:
            return max(_DIM * float(samples["radiance"].mean()), 1e-4)
        lit = samples["visible"].reshape(len(self), -1).mean(dim=1) > 0.5
        if not lit.any():
            return 1.0
        if "direct" not in samples:
            return max(_median(samples["radiance"][lit]), 1e-4)
        direct = samples["direct"][lit]
        scattered = samples["radiance"][lit] - direct
        return max(_median(direct) + float(scattered.mean()), 1e-4)

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[Tensor]:
        generator = torch.Generator().manual_seed(self._seed)
        whole = len(self.rows) // self._batch * self._batch  # of an epoch
        epochs, done = divmod(self._done * self._batch, whole)
        for epoch in itertools.count():
            order = torch.randperm(len(self.rows), generator=generator).to(self.rows.device)
            if epoch < epochs:
                continue
            left = order[done if epoch == epochs else 0 : whole]
            for gathered in left.split(_GATHERED * self._batch):
                yield from self.rows[gathered].split(self._batch)


def _median(values: Tensor) -> float:
    return float(np.median(values.cpu().numpy()))


def columns(rows: Tensor, fields: dict[str, int]) -> dict[str, Tensor]:
    """The named columns of a table's rows: (k, width) each, (k,) where the width is 1."""
    parts = rows.split(list(fields.values()), dim=1)
    return {
        name: part.squeeze(1) if width == 1 else part
        for (name, width), part in zip(fields.items(), parts, strict=True)
    }
