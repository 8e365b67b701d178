"""Number of threads of training steps: one, or all, whichever is faster beside other processes.

The parallel regions of a step take some ten microseconds each. On idle cores more threads are
faster; where another process takes one of the cores, each region waits a scheduler's time slice
for the thread that lost it, and a step takes up to a hundred times as long. The load itself is
hard to see, least of all from a container, so both are timed.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import perf_counter
from typing import TypeVar

import torch
from torch import nn

from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.model.triplane import Triplane
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.optimization.product_kernels import (
    Product,
    products_repeat,
    threads_in_use,
    use_threads,
)

Result = TypeVar("Result")

_WINDOW = 0.25  # s, that a pace is measured over: many time slices
_SMOOTHED = 0.3  # weight of the last window in the pace
_CHANGE = 2.0  # of the pace, for which both are compared before it is due
_FIRST, _LONGEST = 2.0, 30.0  # s between comparisons; doubled while the same one wins
_HOPELESS = 4.0  # steps of the number in use, in which a trial has not done one
_CLEARLY = 0.95  # of the pace of the other, to replace it


class StepThreads:
    """Runs steps with one thread or with all that the caller has; a context, which restores them.

    Results do not depend on the number: kernels and matrix products give the same bits, see `of`.

    use: sets the number. now: clock, s.
    """

    def __init__(
        self,
        most: int,
        use: Callable[[int], object] = use_threads,
        now: Callable[[], float] = perf_counter,
    ) -> None:
        self._most, self._use, self._now = most, use, now
        self.count = most
        self._steps, self._seconds = 0, 0.0  # of the window
        self._pace: float | None = None  # s a step, smoothed; in a trial, of the other number
        self._compared: float | None = None  # the pace at the last comparison
        self._since, self._interval = 0.0, _FIRST
        self._is_trial, self._is_warm = False, False

    @classmethod
    def of(cls, fitting: Fitting, batches: tuple[int, int]) -> "StepThreads":
        """Threads of a model's steps, from the number that the calling thread has.

        batches: rows of a step, of transport and of emission. On a GPU, or where results would
        depend on the number, it stays as it is.
        """
        most, model = threads_in_use(), fitting.model
        kernels = isinstance(model.triplane, Triplane) and model.ceiling.device.type == "cpu"
        if most == 1 or not kernels:
            return cls(1)
        products = step_products(model, batches, fitting.lit)
        repeat = products_repeat(products, fitting.stacks(), most)
        return cls(most if repeat else 1)

    def __enter__(self) -> "StepThreads":
        self._take(1)  # the cheaper mistake
        return self

    def __exit__(self, *_: object) -> None:
        self._take(self._most)

    def run(self, step: Callable[[], Result]) -> Result:
        """A step, timed."""
        begun = self._now()
        result = step()
        if self._most > 1:
            self._steps += 1
            self._seconds += self._now() - begun
            if self._seconds >= _WINDOW or self._is_hopeless:
                self._judge(self._seconds / self._steps)
        return result

    @property
    def _is_hopeless(self) -> bool:
        """Whether a trial is lost before its window is over."""
        pace = self._pace if self._is_trial else None
        return pace is not None and self._seconds > _HOPELESS * pace * self._steps

    def _judge(self, pace: float) -> None:
        """A window is over."""
        self._since += self._seconds
        self._steps, self._seconds = 0, 0.0
        if not self._is_warm:  # kernels were compiled or loaded
            self._is_warm = True
        elif self._is_trial:
            self._end_trial(pace)
        else:
            old = pace if self._pace is None else self._pace
            self._pace = old + _SMOOTHED * (pace - old)
            if self._is_due:
                self._is_trial = True
                self._take(self._other)

    @property
    def _is_due(self) -> bool:
        """Whether to try the other number."""
        if self._pace is None or self._compared is None or self._since >= self._interval:
            return True
        slower = self._pace / self._compared
        if self.count > 1:
            return slower > _CHANGE  # load has come
        return slower < 1.0 / _CHANGE and self._since >= _FIRST  # it has gone

    def _end_trial(self, pace: float) -> None:
        assert self._pace is not None  # of the number before the trial
        self._is_trial, self._since = False, 0.0
        if pace < _CLEARLY * self._pace:
            self._pace, self._interval = pace, _FIRST
        else:
            self._interval = min(2.0 * self._interval, _LONGEST)
            self._take(self._other)
        self._compared = self._pace

    @contextmanager
    def all(self) -> Iterator[None]:
        """A context of long parallel regions, such as whole images, in which all are taken."""
        chosen = self.count
        self._take(self._most)
        yield
        self._take(chosen)

    @property
    def _other(self) -> int:
        return 1 if self.count > 1 else self._most

    def _take(self, count: int) -> None:
        if count != self.count:
            self.count = count
            self._use(count)


def step_products(
    model: NeuralAsset, batches: tuple[int, int], lit: int | None = None
) -> list[Product]:
    """Products of the model's layers in a step; only layers of visible light may be bfloat16.

    batches: rows of a step, of transport and of emission. lit: as `Fitting` has it.
    """
    visible = shadowed = batches[0]
    if lit is not None:
        visible, shadowed = lit, batches[0] - lit
    decoders = [(model.decoder, visible, torch.float32)]
    if model.multiplies_in_bfloat16:
        decoders.append((model.decoder, visible, torch.bfloat16))
    if model.shadow is not None:
        decoders.append((model.shadow.decoder, shadowed, torch.float32))
    if model.emission is not None:
        decoders.append((model.emission.decoder, batches[1], torch.float32))
    return [
        Product(rows, layer.in_features, layer.out_features, dtype)
        for decoder, rows, dtype in decoders
        for layer in decoder
        if isinstance(layer, nn.Linear)
    ]
