"""Evaluates the decoder of one part on the GPU: query rows in, RGB out."""

import time
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.decoder_packing import PackedDecoder
from rna_gpu.device import Device, Groups
from rna_gpu.part_buffers import weights_file
from rna_gpu.records.part import ROW
from rna_gpu.shaders import compose
from rna_sdk.package.decoder.decoder_form import EMISSION, SHADOWED, DecoderForm

_COLOUR_BYTES = 16
_WORK = 1 << 31
"""Multiply-adds of a dispatch: some 10 ms of a small GPU, so that a desktop stays usable."""

_LARGEST_BATCH = 1 << 18  # rows: 20 MiB of them

_SHORT_S = 0.02
"""Time of a dispatch that is far from disturbing a desktop."""


@dataclass(frozen=True, eq=False)
class GpuRows:
    """Queries and their results in GPU buffers.

    Attributes:
        rows: (capacity,) of dtype ROW.dtype, object space.
        results: (capacity, 2, 4) float32: visible and shadowed RGB; emission: (capacity, 1, 4).
        count: uint32 buffer; its first element is the number of rows. Shaders may write it.
        capacity: number of rows that the buffers hold.
    """

    rows: Any
    results: Any
    count: Any
    capacity: int


class Evaluator:
    """One decoder of a part, in one pipeline.

    Attributes:
        batch: rows that one dispatch should have at most.
    """

    def __init__(
        self,
        device: Device,
        decoder: PackedDecoder,
        kind: str,
        form: DecoderForm,
        buffers: list[Any],
    ) -> None:
        """buffers: uniform, weights and the three planes."""
        self._stride = 1 if form is EMISSION else 2  # colours of a row of the results
        first = 1 if form is SHADOWED else 0
        self._own = slice(first, first + len(form.results))
        self.batch = min(max(_WORK // decoder.multiply_adds // 64 * 64, 64), _LARGEST_BATCH)
        self._device = device
        constants = {
            "RNA_GROUPS": decoder.groups,
            "RNA_COLOURS": len(form.results),
            "RNA_STRIDE": self._stride,
            "RNA_FIRST": first,
        }
        source = compose(constants, weights_file(decoder), kind, "evaluate")
        self._pipeline = device.pipeline(source, "rna_evaluate")
        self._part = self._bind(0, buffers)
        self._workspace: GpuRows | None = None

    def run(self, rows: NDArray[Any]) -> NDArray[np.float32]:
        """The decoder's results, (n, colours, 3) float32, of (n,) rows of dtype ROW.dtype."""
        results = np.empty((len(rows), self._own.stop - self._own.start, 3), np.float32)
        for start in range(0, len(rows), self.batch):
            some = rows[start : start + self.batch]
            if self._workspace is None or self._workspace.capacity < len(some):
                self._workspace = self.new_rows(len(some))
            buffers = self._workspace
            self._device.write(buffers.rows, some)
            self._device.write(buffers.count, np.array([len(some)], np.uint32))
            self.dispatch(buffers, len(some))
            data = self._device.read(buffers.results, len(some) * self._stride * _COLOUR_BYTES)
            whole = data.view(np.float32).reshape(len(some), self._stride, 4)
            results[start : start + len(some)] = whole[:, self._own, :3]
        return results

    def dispatch(self, rows: GpuRows, most: int) -> None:
        """Evaluate rows that are on the GPU; most: no more of them than this, which must fit."""
        with self._device.working():
            encoder = self._device.wgpu.create_command_encoder()
            step = encoder.begin_compute_pass()
            self.record(step, self.bind(rows), self._device.groups(most))
            step.end()
            self._device.wgpu.queue.submit([encoder.finish()])

    def bind(self, rows: GpuRows) -> Any:
        """Bind group 1 of the shader, for `record`."""
        return self._bind(1, [rows.rows, rows.results, rows.count])

    def record(self, step: Any, bound: Any, groups: Groups) -> None:
        """Add the evaluation of rows to a compute pass; groups: workgroups of 64 of them."""
        step.set_pipeline(self._pipeline)
        step.set_bind_group(0, self._part)
        step.set_bind_group(1, bound)
        groups.dispatch(step)

    def short(self, most: int) -> int:
        """Rows, no more than `most`, of a dispatch that this device ends within `_SHORT_S`.

        Raises:
            GpuError: buffers for so many rows do not fit.
        """
        rows = min(self.batch, most)
        while not self._device.is_software and rows < most and 2 * self._seconds(rows) < _SHORT_S:
            rows = min(2 * rows, most)
        return rows

    def _seconds(self, count: int) -> float:
        rows = self.new_rows(count)
        numbers = np.random.default_rng(0).uniform(0.1, 1.0, (count, ROW.dtype.itemsize // 4))
        self._device.write(rows.rows, numbers.astype(np.float32))
        self._device.write(rows.count, np.array([count], np.uint32))
        for _ in range(2):  # the first one compiles
            start = time.perf_counter()
            self.dispatch(rows, count)
            self._device.read(rows.results, _COLOUR_BYTES)
            seconds = time.perf_counter() - start
        return seconds

    def new_rows(self, capacity: int) -> GpuRows:
        """Buffers for the given number of rows.

        Raises:
            GpuError: they do not fit.
        """
        sizes = capacity * ROW.dtype.itemsize, capacity * self._stride * _COLOUR_BYTES, 4
        names = "rows", "results", "count of rows"
        rows, results, number = (
            self._device.buffer(size, "STORAGE", what=name)
            for size, name in zip(sizes, names, strict=True)
        )
        return GpuRows(rows, results, number, capacity)

    def _bind(self, group: int, buffers: list[Any]) -> Any:
        entries = [{"binding": k, "resource": {"buffer": b}} for k, b in enumerate(buffers)]
        layout = self._pipeline.get_bind_group_layout(group)
        return self._device.wgpu.create_bind_group(layout=layout, entries=entries)
