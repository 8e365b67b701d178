"""A sample of a band of pixels on the GPU: every step handles all paths of the band.

The steps are those of rna_render.paths.integrator, which says why; each is a shader in
`wgsl/render/`.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.asset import GpuPart
from rna_gpu.device import Device, Groups
from rna_gpu.evaluator import GpuRows
from rna_gpu.records.part import ROW
from rna_gpu.records.scene import FILM, FRAME, PATH, QUERIES, SUMS
from rna_gpu.scene.bindings import STRIDE, Bindings, upload_geometry
from rna_gpu.scene.scene_tables import SceneTables
from rna_gpu.scene.steps import LISTS, Step, Steps
from rna_render import Layers
from rna_render.lights import Light
from rna_render.scene import Scene

_MOST_PATHS = 1 << 18
"""Paths of a band. More are no faster: the film of a larger band is read more slowly."""

_HEADER = 16  # bytes at the start of a list of paths, and of the count of rows
_NOTHING = 0, 0, 1, 1, 0  # no rows; from the second number on an empty list
_DIRECT_SUMS = SUMS.dtype.itemsize // 16  # vec4f a path, then two for each group of lights


class Wavefront:
    """Renders bands of pixels; made once a scene and device.

    Attributes:
        groups: names of the groups of lights.
        band: pixels that are rendered at once, at most.
        is_software: whether the device is a driver that computes on the CPU.
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
        self._device, self._parts, self.is_software = device, parts, device.is_software
        self._bindings = Bindings(device, FRAME.dtype.itemsize)
        self.groups = sorted({light.group for light in lights} - {""})
        width, height = scene.resolution
        self._sums = _DIRECT_SUMS + 2 * len(self.groups)
        self._film_record = np.dtype(
            [("own", FILM.dtype), ("groups", "<f4", (2 * len(self.groups), 4))]
        )
        largest = max(QUERIES.dtype.itemsize, self._film_record.itemsize)
        most = min(
            _MOST_PATHS, width * height, device.limits["max-storage-buffer-binding-size"] // largest
        )
        evaluators = (evaluator for part in parts for evaluator in part.transport)
        self.band = min((evaluator.short(most) for evaluator in evaluators), default=most)
        self._words = _HEADER // 4 + self.band
        self._steps = Steps(scene, tables, lights, parts, scatters)
        self._steps.fill(scene, tables, clamp, self._sums, self._words)
        self._upload(tables)
        self._compile(tables)

    def render(self, pixels: NDArray[np.uint32], samples: Sequence[int]) -> Layers:
        """The sum of these samples of the given pixels, (n,) with n at most `band`.

        Raises:
            DeviceLostError: the device went away.
        """
        device, count = self._device, len(pixels)
        device.write(self._pixels, pixels)
        size = count * self._film_record.itemsize
        with device.working():
            encoder = device.wgpu.create_command_encoder()
            encoder.clear_buffer(self._film, 0, size)
            device.wgpu.queue.submit([encoder.finish()])
        for sample in samples:
            self._add_sample(count, sample)
        return _layers(device.read(self._film, size).view(self._film_record))

    def _add_sample(self, count: int, sample: int) -> None:
        """Add a sample of the `count` pixels to the film."""
        device, frames = self._device, self._steps.frames
        frames["paths"], frames["sample"] = count, sample
        padded = np.zeros((len(frames), STRIDE), np.uint8)
        padded[:, : FRAME.dtype.itemsize] = frames.view(np.uint8).reshape(len(padded), -1)
        device.write(self._uniform, padded)
        groups = np.array([-(-count // 64), 1, 1, count], np.uint32)
        device.write(self._live, groups)
        device.write(self._groups, groups)
        with device.working():
            for stage in self._steps.stages:  # one submission each: no long work at a time
                encoder = device.wgpu.create_command_encoder()
                for step in stage:
                    self._record(encoder, step, count)
                device.wgpu.queue.submit([encoder.finish()])

    def outside_domains(self) -> NDArray[np.uint32]:
        """(parts, 4): queries of each part that is watched since the last call, those from outside
        the views and those from outside the lights that it was trained for, and those of either."""
        count = 4 * len(self._parts)
        result = self._device.read(self._counts, max(4 * count, 16)).view(np.uint32)[:count]
        self._device.write(self._counts, np.zeros(max(count, 4), np.uint32))
        return result.reshape(-1, 4)

    def _record(self, encoder: Any, step: Step, count: int) -> None:
        copy = encoder.copy_buffer_to_buffer
        if step.name == "clear":
            copy(self._nothing, 0, self._rows.count, 0, _HEADER)
        elif step.name == "keep":
            copy(self._paths, 0, self._surviving_paths, 0, count * PATH.dtype.itemsize)
        elif step.name == "restore":
            copy(self._surviving_paths, 0, self._paths, 0, count * PATH.dtype.itemsize)
        elif step.name == "gather":
            self._dispatch(encoder, step, count)
            copy(self._rows.count, 4, self._groups, _HEADER * LISTS, 12)
        elif step.name == "compact":
            after = 4 * self._words * step.after
            copy(self._nothing, 4, self._live, after, _HEADER)
            self._dispatch(encoder, step, count)
            copy(self._live, after, self._groups, _HEADER * step.after, 12)
        else:
            self._dispatch(encoder, step, count)

    def _dispatch(self, encoder: Any, step: Step, count: int) -> None:
        run = encoder.begin_compute_pass()
        if step.name in ("camera", "accumulate"):
            groups = self._device.groups(count)
        else:
            takes_rows = step.part >= 0 or step.name == "apply"
            groups = Groups(self._groups, _HEADER * (LISTS if takes_rows else step.list))
        if step.part >= 0:
            evaluator = self._parts[step.part].evaluators[step.name]
            evaluator.record(run, self._bound[step.name, step.part], groups)
        else:
            pipeline, bound = self._pipelines[step.name]
            run.set_pipeline(pipeline)
            run.set_bind_group(0, self._path_group, [step.frame * STRIDE])
            for k, group in enumerate(bound, 1):
                run.set_bind_group(k, group)
            groups.dispatch(run)
        run.end()

    def _upload(self, tables: SceneTables) -> None:
        device, count = self._device, self.band
        self._uniform = device.buffer(len(self._steps.frames) * STRIDE, "UNIFORM", what="steps")
        self._pixels = device.buffer(count * 4, "STORAGE", what="pixels")
        self._paths, self._surviving_paths = (
            device.buffer(count * PATH.dtype.itemsize, "STORAGE", what="paths") for _ in range(2)
        )
        self._film = device.buffer(count * self._film_record.itemsize, "STORAGE", what="film")
        self._live = device.buffer(4 * LISTS * self._words, "STORAGE", what="lists of paths")
        self._groups = device.buffer(_HEADER * (LISTS + 1), "INDIRECT", what="workgroups")
        self._nothing = device.upload(np.array(_NOTHING, np.uint32), what="empty lists")
        self._path_buffers = [
            self._uniform,
            self._paths,
            device.buffer(count * self._sums * 16, "STORAGE", what="sums"),
            device.buffer(count * QUERIES.dtype.itemsize, "STORAGE", what="queries"),
            device.upload(tables.table, "STORAGE", what="tables"),
            device.upload(tables.images, "STORAGE", what="images"),
            self._live,
        ]
        self._scene_buffers = upload_geometry(device, tables.geometry)
        sizes = {
            "rows": count * ROW.dtype.itemsize,
            "results": count * 32,
            "count of rows": _HEADER,
            "paths of rows": count * 4,
            "counts of queries": max(16 * len(self._parts), 16),
        }
        self._row_buffers = [
            device.buffer(size, "STORAGE", what=name) for name, size in sizes.items()
        ]
        rows, results, number, _, self._counts = self._row_buffers
        self._rows = GpuRows(rows, results, number, count)
        self._bound = {
            (name, k): evaluator.bind(self._rows)
            for k, part in enumerate(self._parts)
            for name, evaluator in part.evaluators.items()
        }

    def _compile(self, tables: SceneTables) -> None:
        made = self._bindings
        self._path_group = made.group(made.path, self._path_buffers, self._uniform)
        none = made.group(made.empty, [])
        geometry = made.group(made.scene, self._scene_buffers)
        pixels, film = made.group(made.pixels, [self._pixels]), made.group(made.film, [self._film])
        queries = made.group(made.rows, self._row_buffers)
        self._pipelines = {
            "camera": (made.pipeline("camera", made.pixels), [pixels]),
            "compact": (made.pipeline("compact"), []),
            "accumulate": (made.pipeline("accumulate", made.film), [film]),
        }
        nearby = ["nearby"] if self._steps.nearby else []
        for name in ("closest", "collect", "direct", "scatter", *nearby):
            pipeline = made.pipeline(name, made.empty, made.scene)
            self._pipelines[name] = pipeline, [none, geometry]
        for name in ("gather", "apply"):
            self._pipelines[name] = made.pipeline(name, made.rows, file="rows"), [queries]


def _layers(film: NDArray[Any]) -> Layers:
    """film: (n,) of FILM, and of vec4f, two for each group of lights."""
    direct, by_group = film["own"], film["groups"][..., :3]
    sums = direct["sums"]
    return Layers(
        beauty=sums["beauty"],
        groups=by_group[:, 0::2],
        hit=sums["hit"],
        normal_world=sums["normal"],
        position_world=sums["position"],
        motion=np.zeros((len(film), 2), np.float32),
        light_samples=sums["light_samples"],
        caught=sums["caught"],
        behind_catcher=sums["behind"],
        groups_behind=by_group[:, 1::2],
        catcher=direct["catcher"],
        clamped=np.zeros(len(film), np.float32),
        squares=direct["squares"],
        asset=sums["number"].astype(np.uint32),
    )
