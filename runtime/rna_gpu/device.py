"""An open GPU: buffers, pipelines and transfers of `wgpu`."""

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np
import wgpu
from numpy.typing import NDArray

from rna_sdk.errors import DeviceLostError, GpuError

_WANTED = (
    "max-storage-buffer-binding-size",
    "max-buffer-size",
    "max-storage-buffers-per-shader-stage",
)
"""Limits that are raised to the adapter's; all others stay at WebGPU's guaranteed values."""


@dataclass(frozen=True)
class Groups:
    """Workgroups of a dispatch, (x, y, z): where they are in a buffer of the GPU, or numbers.

    Attributes:
        source: a buffer of usage INDIRECT, or the three numbers.
        offset: bytes from the buffer's start.
    """

    source: Any
    offset: int = 0

    def dispatch(self, step: Any) -> None:
        """Dispatch them in a compute pass."""
        if isinstance(self.source, tuple):
            step.dispatch_workgroups(*self.source)
        else:
            step.dispatch_workgroups_indirect(self.source, self.offset)


class Device:
    """An open GPU, its limits and a cache of compiled pipelines.

    Attributes:
        name: readable name of the adapter and its backend.
        is_software: whether it is a driver that computes on the CPU.
        limits: limits of the device, by WebGPU's hyphenated names.
    """

    def __init__(self, adapter: Any) -> None:
        """adapter: a `wgpu.GPUAdapter`. Raises GpuError: the adapter has no device."""
        self.name = f"{adapter.info.get('device') or 'GPU'} ({adapter.info.get('backend_type')})"
        self.is_software = adapter.info.get("adapter_type") == "CPU"
        limits = {name: adapter.limits[name] for name in _WANTED}
        try:
            self._device = adapter.request_device_sync(required_limits=limits)
        except Exception as error:  # wgpu's own errors are plain exceptions
            raise GpuError(f"{self.name}: no device: {_one_line(error)}") from error
        self._process = os.getpid()
        self.limits: dict[str, int] = dict(self.wgpu.limits)
        self._pipelines: dict[tuple[Any, ...], Any] = {}
        self._layouts: dict[tuple[str, ...], Any] = {}

    @property
    def wgpu(self) -> Any:
        """The device of the `wgpu` package.

        Raises:
            GpuError: another process opened it, of which this one is a fork.
        """
        _check_process(self._process)
        return self._device

    def pipeline(self, source: str, entry: str, layouts: Sequence[Any] = ()) -> Any:
        """A compute pipeline, compiled once and cached.

        Args:
            source: the WGSL module.
            entry: name of its entry point.
            layouts: bind group layouts; derived from the module if empty.
        """
        key = source, entry, tuple(map(id, layouts))
        if key not in self._pipelines:
            module = self.wgpu.create_shader_module(code=source)
            layout = "auto"
            if layouts:
                layout = self.wgpu.create_pipeline_layout(bind_group_layouts=list(layouts))
            self._pipelines[key] = self.wgpu.create_compute_pipeline(
                layout=layout, compute={"module": module, "entry_point": entry}
            )
        return self._pipelines[key]

    def layout(self, *kinds: str) -> Any:
        """A bind group layout with one buffer binding per kind, cached.

        kinds: "uniform" (with a dynamic offset), "storage" or "read-only-storage".
        """
        if kinds not in self._layouts:
            entries = [
                {
                    "binding": k,
                    "visibility": wgpu.ShaderStage.COMPUTE,
                    "buffer": {"type": kind, "has_dynamic_offset": kind == "uniform"},
                }
                for k, kind in enumerate(kinds)
            ]
            self._layouts[kinds] = self.wgpu.create_bind_group_layout(entries=entries)
        return self._layouts[kinds]

    def buffer(self, size: int, *usages: str, what: str) -> Any:
        """A new buffer.

        Args:
            size: bytes.
            usages: names of `wgpu.BufferUsage`; the copy usages are always set.
            what: the buffer's content, for error messages.

        Raises:
            GpuError: the buffer exceeds the device's limits or its memory.
        """
        limit = self.limits["max-buffer-size"]
        if "STORAGE" in usages:
            limit = min(limit, self.limits["max-storage-buffer-binding-size"])
        if size > limit:
            raise GpuError(f"{what}: {size:,} bytes, and {self.name} takes {limit:,} in a buffer")
        usage = wgpu.BufferUsage.COPY_DST | wgpu.BufferUsage.COPY_SRC
        for name in usages:
            usage |= getattr(wgpu.BufferUsage, name)
        try:
            return self.wgpu.create_buffer(size=max(_rounded(size), 16), usage=usage)
        except Exception as error:
            raise GpuError(f"{what}: {size:,} bytes: {_one_line(error)}") from error

    def upload(self, values: NDArray[Any], *usages: str, what: str) -> Any:
        """A new buffer with the bytes of `values`; for usages, `what` and errors see `buffer`."""
        data = np.ascontiguousarray(values).reshape(-1).view(np.uint8)
        buffer = self.buffer(len(data), *usages, what=what)
        self.write(buffer, data)
        return buffer

    @contextmanager
    def working(self) -> Iterator[None]:
        """Context for calls to `wgpu`; translates its exceptions.

        Raises:
            DeviceLostError: the device was lost.
            GpuError: a call failed.
        """
        try:
            yield
        except (wgpu.GPUError, RuntimeError) as error:
            kind = DeviceLostError if "lost" in str(error).lower() else GpuError
            raise kind(f"{self.name}: {_one_line(error)}") from error

    def write(self, buffer: Any, values: NDArray[Any]) -> None:
        """Copy the bytes of `values` to the start of the buffer. For errors see `working`."""
        data = np.ascontiguousarray(values).reshape(-1).view(np.uint8)
        if len(data):
            with self.working():
                self.wgpu.queue.write_buffer(buffer, 0, np.pad(data, (0, -len(data) % 4)))

    def read(self, buffer: Any, size: int) -> NDArray[np.uint8]:
        """The first `size` bytes; waits for submitted work. For errors see `working`."""
        with self.working():
            return np.frombuffer(self.wgpu.queue.read_buffer(buffer, 0, size), np.uint8)

    def groups(self, threads: int) -> Groups:
        """Workgroups of 64 for `threads` invocations.

        Two-dimensional, because one dimension is limited (65,535 by default).
        """
        count = max(-(-threads // 64), 1)
        most = self.limits["max-compute-workgroups-per-dimension"]
        rows = -(-count // most)
        return Groups((-(-count // rows), rows, 1))


def open_device(prefer: str | None = None) -> Device:
    """Open the fastest GPU of this machine, or a software driver if there is none.

    prefer: part of the name of the adapter to open instead.

    Raises:
        GpuError: no adapter was found, or this process was forked from one that had opened a GPU.

    Example:
        >>> device = open_device()
        >>> asset = load("toy.rna", device=device)
    """
    _process.setdefault("first", os.getpid())
    _check_process(_process["first"])
    if prefer is None:
        adapter = wgpu.gpu.request_adapter_sync(power_preference="high-performance")
        candidates = [adapter] if adapter else []
    else:
        adapters = wgpu.gpu.enumerate_adapters_sync()
        candidates = [one for one in adapters if prefer.lower() in one.summary.lower()]
    if not candidates:
        raise GpuError("no GPU found; on Debian `mesa-vulkan-drivers` provides a software one")
    return Device(candidates[0])


_process: dict[str, int] = {}
"""The `first` that opened a GPU, of which this one may be a fork."""


def _check_process(opened_by: int) -> None:
    """Drivers do not live on in a forked process: a call may wait for a thread for ever."""
    if opened_by != os.getpid():
        raise GpuError(
            "this process was forked from one that had opened a GPU; start it anew instead, as "
            'multiprocessing.get_context("spawn") does, and open the GPU there'
        )


def _rounded(size: int) -> int:
    return -(-size // 4) * 4


def _one_line(error: Exception) -> str:
    return " ".join(str(error).split())[:300]
