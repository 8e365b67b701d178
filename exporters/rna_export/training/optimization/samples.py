"""Training batches: all samples in one table, one per row."""

import copy
import itertools
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import cached_property

import numpy as np
import torch
from torch import Tensor
from torch.utils.data import IterableDataset

_DIM = 0.02  # of the mean of what an asset emits
_STRAY = 8.0  # times the 99th percentile of shadowed radiance
_HIGHLIGHT, _TERMINATOR = 0.9, -0.05  # cosines: of normal and half vector, of normal and light
_GATHERED = 32  # batches at once: random rows of a large table come from memory one by one
_MOST_GATHERED = 2**22  # rows
_MOST_ON_CARD = 0.6  # of a card's free memory, for the table; the rest is for steps


class SampleTable(IterableDataset[Tensor]):
    """Endless random batches, each sample once an epoch; repeats for the same seed.

    `done` batches are left out at the start: a stopped run saw them.

    Yields (batch, columns) float32 on the device, the fields of `samples` side by side, in their
    order; `columns` finds them again. Where each sample of a surface sees the light or does not,
    all batches have as many that do, `lit`, and these come first. A table that takes most of a
    GPU's free memory stays in the host's, and batches are loaded from there while the ones before
    are used.
    """

    def __init__(
        self,
        samples: dict[str, np.ndarray],
        batch: int = 2048,
        seed: int = 0,
        device: str = "cpu",
        done: int = 0,
    ):
        samples, n = without_stray_highlights(samples), len(samples["position"])
        self.fields = {name: values[0].size for name, values in samples.items()}
        table = np.empty((n, sum(self.fields.values())), np.float32)
        first = 0
        for name, width in self.fields.items():
            table[:, first : first + width] = samples[name].reshape(n, width)
            first += width
        self._device = torch.device(device)
        self.rows = _placed(torch.from_numpy(table), self._device)
        self._kinds = [k.to(self.rows.device) for k in _kinds(samples)]
        self._batch, self._seed, self._done = min(batch, n), seed, done

    def shuffled(self, batch: int, seed: int, done: int) -> "SampleTable":
        """These rows, not copied, in batches of another size and order."""
        other = copy.copy(self)
        other._batch, other._seed, other._done = min(batch, len(self)), seed, done
        return other

    @property
    def lit(self) -> int | None:
        """The first samples of each batch that see the light; None where they are mixed."""
        (_, first), *others = self._shares
        return first if others else None

    @property
    def _shares(self) -> list[tuple[Tensor, int]]:
        """Kinds of samples, each the numbers of its rows, and how many of it a batch has."""
        if len(self._kinds) == 1:
            return [(self._kinds[0], self._batch)]
        if self._batch == 1:
            return [(torch.cat(self._kinds), 1)]
        lit, others = self._kinds
        first = min(max(round(self._batch * len(lit) / len(self)), 1), self._batch - 1)
        return [(lit, first), (others, self._batch - first)]

    @cached_property
    def largest_radiance(self) -> float:
        """Maximum over all samples and channels."""
        return float(columns(self.rows, self.fields)["radiance"].max())

    @property
    def nearby_means(self) -> Tensor:
        """Mean nearby light where samples see the light and where they do not, (2, lengths)."""
        samples = columns(self.rows, self.fields)
        lit = samples["visible"].reshape(len(self), -1).mean(dim=1) > 0.5
        means = [samples["nearby"][k].mean(dim=0) for k in (lit, ~lit)]
        return torch.stack(means).nan_to_num().clamp(max=1.0)

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
        is_there = self.rows.device.type == self._device.type
        for rows in self._gathered() if is_there else self._loaded():
            yield from rows.split(self._batch)

    def _gathered(self) -> Iterator[Tensor]:
        return (self.rows[order] for order in self._orders())

    def _orders(self) -> Iterator[Tensor]:
        """Numbers of the rows of the next batches, on the rows' device."""
        together = max(1, min(_GATHERED, _MOST_GATHERED // self._batch))
        of_kinds = zip(*(self._orders_of(*share) for share in self._shares), strict=True)
        while True:
            yield torch.cat([x for kinds in itertools.islice(of_kinds, together) for x in kinds])

    def _orders_of(self, kind: Tensor, count: int) -> Iterator[Tensor]:
        """Batches of `count` rows of one kind."""
        whole = len(kind) // count * count  # of an epoch
        first, done = divmod(self._done * count, whole)
        generator = torch.Generator(kind.device)
        for epoch in itertools.count(first):
            (of_epoch,) = np.random.SeedSequence((self._seed, epoch)).generate_state(1)
            generator.manual_seed(int(of_epoch))
            order = torch.randperm(len(kind), generator=generator, device=kind.device)
            yield from (kind[rows] for rows in order[done:whole].split(count))
            done = 0

    def _loaded(self) -> Iterator[Tensor]:
        """Rows of the host's on the device; the next ones are on their way."""

        def load(order: Tensor) -> Tensor:
            return self.rows[order].pin_memory().to(self._device, non_blocking=True)

        orders = self._orders()
        with ThreadPoolExecutor(1) as loader:
            coming = loader.submit(load, next(orders))
            for order in orders:
                rows, coming = coming.result(), loader.submit(load, order)
                yield rows


def without_stray_highlights(samples: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The samples of a surface, direct highlights in shadow clipped at 8 times its 99th percentile.

    Near the terminator Cycles sees some highlights where our visibility ray is blocked: one
    shadowed sample in 1,000 or 10,000, as bright as a lit one, and such samples rule the fit of
    all others (docs/decisions/losses.md). What is as bright beside the mirrored direction is light
    that metal reflects into shadow. Strands, whose direct light is apart, and emission stay.
    """
    if "visible" not in samples or "direct" in samples:
        return samples
    radiance, n = samples["radiance"], len(samples["visible"])
    shadowed = samples["visible"].reshape(n, -1).max(axis=1) == 0
    if not shadowed.any():
        return samples
    most = _STRAY * np.percentile(radiance[shadowed].max(axis=1), 99.0)
    if most == 0.0:
        return samples
    is_stray = shadowed & (radiance.max(axis=1) > most)
    is_stray[is_stray] = _mirrors_the_light(*(samples[k][is_stray] for k in ("normal", "wo", "wi")))
    clipped = np.where(is_stray[:, None], np.minimum(radiance, most), radiance)
    return {**samples, "radiance": clipped}


def _mirrors_the_light(normal: np.ndarray, wo: np.ndarray, wi: np.ndarray) -> np.ndarray:
    """Whether directions (n, 3) lie in the highlight that a light makes on a surface: (n,) bool."""
    h = wi + wo
    along = np.sum(normal * h, axis=1) / np.maximum(np.linalg.norm(h, axis=1), 1e-9)
    return np.asarray((along > _HIGHLIGHT) & (np.sum(normal * wi, axis=1) > _TERMINATOR))


def _kinds(samples: dict[str, np.ndarray]) -> list[Tensor]:
    """Numbers of the rows that see the light and of those that do not; or of all rows.

    They are told apart where a decoder may need the ones alone: on surfaces of no colours of
    visibility.
    """
    visible = samples.get("visible")
    if visible is not None and visible.ndim == 1 and "direct" not in samples:
        kinds = [torch.from_numpy(np.flatnonzero(v)) for v in (visible > 0.5, visible <= 0.5)]
        if all(map(len, kinds)):
            return kinds
    return [torch.arange(len(samples["position"]))]


def _placed(table: Tensor, device: torch.device) -> Tensor:
    """The table on the device, if most of its memory stays free; else where it is."""
    if device.type == "cuda":
        free, _ = torch.cuda.mem_get_info(device)
        if table.nbytes > _MOST_ON_CARD * free:
            return table
    return table.to(device)


def _median(values: Tensor) -> float:
    return float(np.median(values.cpu().numpy()))


def columns(rows: Tensor, fields: dict[str, int]) -> dict[str, Tensor]:
    """The named columns of a table's rows: (k, width) each, (k,) where the width is 1."""
    parts = rows.split(list(fields.values()), dim=1)
    return {
        name: part.squeeze(1) if width == 1 else part
        for (name, width), part in zip(fields.items(), parts, strict=True)
    }
