"""A sample of a band of pixels on the GPU: every step handles all paths of the band.

The steps are those of rna_render.paths.integrator, which says why; each is a shader in
`wgsl/render/`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.asset import GpuPart
from rna_gpu.device import Device
from rna_gpu.evaluator import GpuRows
from rna_gpu.records.scene import FRAME, PATH, QUERIES, SUMS
from rna_gpu.scene.bindings import STRIDE, Bindings, upload_geometry
from rna_gpu.scene.scene_tables import SceneTables
from rna_gpu.scene.steps import Step, Steps
from rna_render import Layers
from rna_render.lights import Light
from rna_render.scene import Scene

_MOST_PATHS = 1 << 17
_OWN_SUMS = SUMS.dtype.itemsize // 16  # vec4f a path, then two for each group of lights


class Wavefront:
    """Renders bands of pixels; made once a scene and device.

    Attributes:
        groups: names of the groups of lights.
        band: pixels that are rendered at once, at most.
    """

    def __init__(
        self,
        device: Device,
        scene: Scene,
        tables: SceneTables,
        parts: Sequence[GpuPart],
        lights: Sequence[Light],
        scatters: bool,
        clamp: float | None,
    ) -> None:
        """parts: those of `tables.parts`. scatters: as World.scatters. clamp: see indirect_clamp.

        Raises:
            GpuError: the scene does not fit.
        """
        self._device, self._parts = device, parts
        self._bindings = Bindings(device, FRAME.dtype.itemsize)
        self.groups = sorted({light.group for light in lights} - {""})
        batches = [part.transport.batch for part in parts]
        width, height = scene.resolution
        self.band = min(_MOST_PATHS, width * height, *batches)
        self._sums = _OWN_SUMS + 2 * len(self.groups)
        self._steps = Steps(scene, tables, lights, parts, scatters)
        self._steps.fill(scene, tables, clamp, self._sums)
        self._upload(tables)
        self._compile(tables)

    def render(self, pixels: NDArray[np.uint32], sample: int) -> Layers:
        """One sample of the given pixels, (n,) with n at most `band`.

        Raises:
            DeviceLostError: the device went away.
        """
        device, count, frames = self._device, len(pixels), self._steps.frames
        frames["paths"], frames["sample"] = count, sample
        padded = np.zeros((len(frames), STRIDE), np.uint8)
        padded[:, : FRAME.dtype.itemsize] = frames.view(np.uint8).reshape(len(padded), -1)
        device.write(self._uniform, padded)
        device.write(self._pixels, pixels)
        with device.working():
            for stage in self._steps.stages:  # one submission each: no long work at a time
                encoder = device.wgpu.create_command_encoder()
                for step in stage:
                    self._record(encoder, step, count)
                device.wgpu.queue.submit([encoder.finish()])
        data = device.read(self._path_sums, count * self._sums * 16)
        return _layers(data.view(np.float32).reshape(count, self._sums, 4))

    def outside_domains(self) -> NDArray[np.uint32]:
        """(parts, 4): queries of each part that is watched since the last call, those from outside
        the views and those from outside the lights that it was trained for, and those of either."""
        count = 4 * len(self._parts)
        found = self._device.read(self._counts, max(4 * count, 16)).view(np.uint32)[:count]
        self._device.write(self._counts, np.zeros(max(count, 4), np.uint32))
        return found.reshape(-1, 4)

    def _record(self, encoder: Any, step: Step, count: int) -> None:
        if step.name == "clear":
            encoder.clear_buffer(self._rows.count)
            return
        if step.name in ("keep", "restore"):
            ways = self._paths, self._kept_paths
            source, target = ways if step.name == "keep" else reversed(ways)
            size = count * PATH.dtype.itemsize
            encoder.copy_buffer_to_buffer(source, 0, target, 0, size)
            return
        run = encoder.begin_compute_pass()
        if step.name in ("transport", "emitter"):
            evaluator = getattr(self._parts[step.part], step.name)
            evaluator.record(run, self._bound[step.name, step.part], count)
        else:
            pipeline, groups = self._pipelines[step.name]
            run.set_pipeline(pipeline)
            run.set_bind_group(0, self._path_group, [step.frame * STRIDE])
            for k, group in enumerate(groups, 1):
                run.set_bind_group(k, group)
            run.dispatch_workgroups(*self._device.groups(count))
        run.end()

    def _upload(self, tables: SceneTables) -> None:
        device, count = self._device, self.band
        self._uniform = device.buffer(len(self._steps.frames) * STRIDE, "UNIFORM", what="steps")
        self._pixels = device.buffer(count * 4, "STORAGE", what="pixels")
        self._paths, self._kept_paths = (
            device.buffer(count * PATH.dtype.itemsize, "STORAGE", what="paths") for _ in range(2)
        )
        self._path_sums = device.buffer(count * self._sums * 16, "STORAGE", what="sums")
        self._path_buffers = [
            self._uniform,
            self._paths,
            self._path_sums,
            device.buffer(count * QUERIES.dtype.itemsize, "STORAGE", what="queries"),
            device.upload(tables.table, "STORAGE", what="tables"),
            device.upload(tables.images, "STORAGE", what="images"),
        ]
        self._scene_buffers = upload_geometry(device, tables.geometry)
        sizes = count * 64, count * 32, 4, count * 4, max(16 * len(self._parts), 16)
        names = "rows", "results", "count of rows", "paths of rows", "counts of queries"
        self._row_buffers = [
            device.buffer(size, "STORAGE", what=name)
            for size, name in zip(sizes, names, strict=True)
        ]
        rows, results, number, _, self._counts = self._row_buffers
        self._rows = GpuRows(rows, results, number, count)
        self._bound = {
            (name, k): evaluator.bind(self._rows)
            for k, part in enumerate(self._parts)
            for name, evaluator in (("transport", part.transport), ("emitter", part.emitter))
            if evaluator is not None
        }

    def _compile(self, tables: SceneTables) -> None:
        made = self._bindings
        self._path_group = made.group(made.path, self._path_buffers, self._uniform)
        nothing = made.group(made.empty, [])
        geometry = made.group(made.scene, self._scene_buffers)
        pixels = made.group(made.pixels, [self._pixels])
        queries = made.group(made.rows, self._row_buffers)
        self._pipelines = {"camera": (made.pipeline("camera", made.pixels), [pixels])}
        for name in ("closest", "collect", "direct", "scatter"):
            pipeline = made.pipeline(name, made.empty, made.scene)
            self._pipelines[name] = pipeline, [nothing, geometry]
        for name in ("gather", "apply"):
            self._pipelines[name] = made.pipeline(name, made.rows, file="rows"), [queries]


def _layers(sums: NDArray[np.float32]) -> Layers:
    """sums: (n, slots, 4), those of SUMS, then two of each group of lights."""
    own = np.ascontiguousarray(sums[:, :_OWN_SUMS]).reshape(-1).view(SUMS.dtype)
    by_group = sums[:, _OWN_SUMS:, :3]
    return Layers(
        beauty=own["beauty"],
        groups=by_group[:, 0::2],
        hit=(own["hit"] == 1.0).astype(np.float32),
        normal_world=own["normal"],
        position_world=own["position"],
        motion=np.zeros((len(own), 2), np.float32),
        light_samples=own["light_samples"],
        caught=own["caught"],
        behind_catcher=own["behind"],
        groups_behind=by_group[:, 1::2],
        catcher=(own["hit"] == 2.0).astype(np.float32),
        asset=own["number"].astype(np.uint32),
    )
