"""Steps as CUDA graphs: recorded once, then launched as one.

A step of `small` is some 230 kernels of a few microseconds each; launched one by one they leave
the card idle for nine tenths of the time.
"""

from collections import Counter
from collections.abc import Callable, Hashable

import torch
from torch import Tensor

_EAGER = 3  # steps of a kind before it is recorded: they allocate what the later ones use

Step = Callable[[], Tensor]


class StepGraphs:
    """Runs steps on a GPU: the first of each kind one kernel at a time, the others as a graph.

    step: of a kind, from batches of rows; all else that it reads stays where it is, and its result
    is one tensor. record: makes of a step one that repeats it with the same tensors.
    """

    def __init__(
        self,
        step: Callable[..., Tensor],
        record: Callable[[Step], Step] | None = None,
    ) -> None:
        self._step, self._record = step, record or _record
        self._eager: Counter[Hashable] = Counter()
        self._graphs: dict[Hashable, Step] = {}
        self._batches: tuple[Tensor, ...] = ()

    def run(self, kind: Hashable, *batches: Tensor) -> Tensor:
        """A step, on batches that have the same sizes every time."""
        if kind not in self._graphs and self._eager[kind] < _EAGER:
            self._eager[kind] += 1
            return self._step(kind, *batches)
        if not self._batches:
            self._batches = tuple(batch.clone() for batch in batches)
        for buffer, given in zip(self._batches, batches, strict=True):
            buffer.copy_(given)
        if kind not in self._graphs:
            self._graphs[kind] = self._record(lambda: self._step(kind, *self._batches))
        return self._graphs[kind]().clone()


def _record(step: Step) -> Step:
    """A CUDA graph of a step, which recording does not run.

    Errors of other threads that use the device, as the one that loads batches, are not its own.
    """
    torch.cuda.synchronize()
    graph = torch.cuda.CUDAGraph()
    with torch.cuda.graph(graph, capture_error_mode="thread_local"):
        result = step()

    def replay() -> Tensor:
        graph.replay()
        return result

    return replay
