"""A sample of a band of pixels on the GPU: every step handles all paths of the band.

The steps are those of rna_render.integrator, which says why; each is a shader in `wgsl/render/`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.asset import GpuPart
from rna_gpu.device import Device
from rna_gpu.errors import GpuError
from rna_gpu.evaluator import GpuRows
from rna_gpu.scene_tables import SceneTables
from rna_gpu.shaders import compose
from rna_render.bodies import FIBER_LOBES, SURFACE_LOBES
from rna_render.camera import Camera
from rna_render.embree.instances import CAMERA_RAY, INDIRECT_RAY, SHADOW_RAY
from rna_render.film import Layers
from rna_render.lights import InfiniteLight, Light
from rna_render.materials.ggx import TABLE_SIZE
from rna_render.path_numbers import LIGHTS_AT_A_VERTEX
from rna_render.scene_model import Scene

_FRAME = np.dtype(
    [
        *(("camera", "<f4", 3), ("width", "<u4"), ("corner", "<f4", 3), ("first_pixel", "<u4")),
        *(("step_x", "<f4", 3), ("paths", "<u4"), ("step_y", "<f4", 3), ("sample", "<u4")),
        *((name, "<u4") for name in ("seed", "depth", "light", "part", "parts", "rays")),
        *(("clamp", "<f4"), ("light_count", "<u4")),
        *((name, "<u4") for name in ("things", "surfaces", "lights", "albedo", "sums", "flags")),
        *((name, "<u4") for name in ("neural_part", "table_size")),
    ]
)
_STRIDE = 256  # bytes: what offsets of uniforms are multiples of
_NONE = 0xFFFFFFFF
_HAS_SKY, _FOR_BETA, _RAYS_MEET_LIGHTS, _FOR_EMISSION = 1, 2, 4, 8
_PATH_BYTES, _PENDING_BYTES = 96, 80
_MOST_PATHS = 1 << 17
_OWN_SUMS = 5  # vec4f a path, then two for each group of lights
_STORAGE_BUFFERS = 10  # that a step binds


@dataclass(frozen=True)
class _Step:
    """A dispatch: a pipeline and a row of the frames; or the evaluation of a part."""

    name: str
    frame: int = 0
    part: int = -1


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
        """parts: those of `tables.parts`. scatters: as World.scatters. clamp: as of indirect_clamp.

        Raises:
            GpuError: the scene does not fit.
        """
        _check_limits(device)
        self._device, self._parts = device, parts
        self.groups = sorted({light.group for light in lights} - {""})
        batches = [part.transport.batch for part in parts]
        width, height = scene.resolution
        self.band = min(_MOST_PATHS, width * height, *batches)
        self._sums = _OWN_SUMS + 2 * len(self.groups)
        self._frames, self._stages = _plan(scene, lights, parts, scatters)
        self._fill_frames(scene, tables, len(lights), clamp)
        self._upload(tables)
        self._compile()

    def render(self, first: int, count: int, sample: int) -> Layers:
        """One sample of `count` pixels from `first` on.

        Raises:
            DeviceLostError: the device went away.
        """
        device = self._device
        self._frames["first_pixel"], self._frames["paths"] = first, count
        self._frames["sample"] = sample
        padded = np.zeros((len(self._frames), _STRIDE), np.uint8)
        padded[:, : _FRAME.itemsize] = self._frames.view(np.uint8).reshape(len(padded), -1)
        device.write(self._uniform, padded)
        with device.working():
            for stage in self._stages:  # one submission each: no long work at a time
                encoder = device.wgpu.create_command_encoder()
                for step in stage:
                    self._record(encoder, step, count)
                device.wgpu.queue.submit([encoder.finish()])
        data = device.read(self._path_sums, count * self._sums * 16)
        return _layers(data.view(np.float32).reshape(count, self._sums, 4))

    def _record(self, encoder: Any, step: _Step, count: int) -> None:
        if step.name == "clear":
            encoder.clear_buffer(self._rows.count)
            return
        run = encoder.begin_compute_pass()
        if step.name in ("transport", "emitter"):
            evaluator = getattr(self._parts[step.part], step.name)
            evaluator.record(run, self._bound[step.name, step.part], count)
        else:
            pipeline, groups = self._pipelines[step.name]
            run.set_pipeline(pipeline)
            run.set_bind_group(0, self._path_group, [step.frame * _STRIDE])
            for k, group in enumerate(groups, 1):
                run.set_bind_group(k, group)
            run.dispatch_workgroups(*self._device.groups(count))
        run.end()

    def _fill_frames(
        self, scene: Scene, tables: SceneTables, lights: int, clamp: float | None
    ) -> None:
        camera = Camera(scene.camera, scene.resolution)
        common = {
            "camera": camera.position,
            "width": camera.width,
            "corner": camera.corner,
            "step_x": camera.step_x,
            "step_y": camera.step_y,
            "seed": scene.seed,
            "clamp": clamp or 0.0,
            "light_count": lights,
            "things": tables.things,
            "surfaces": tables.surfaces,
            "lights": tables.lights,
            "albedo": tables.albedo,
            "sums": self._sums,
            "table_size": TABLE_SIZE,
        }
        for name, value in common.items():
            self._frames[name] = value

    def _upload(self, tables: SceneTables) -> None:
        device, count = self._device, self.band
        self._uniform = device.buffer(len(self._frames) * _STRIDE, "UNIFORM", what="steps")
        self._path_sums = device.buffer(count * self._sums * 16, "STORAGE", what="sums")
        self._path_buffers = [
            self._uniform,
            device.buffer(count * _PATH_BYTES, "STORAGE", what="paths"),
            self._path_sums,
            device.buffer(count * _PENDING_BYTES, "STORAGE", what="queries"),
            device.upload(tables.table, "STORAGE", what="tables"),
            device.upload(tables.images, "STORAGE", what="environment images"),
        ]
        made = tables.geometry
        arrays = {
            "trees": made.nodes,
            "primitives": made.primitives,
            "points": made.points,
            "instances": made.instances,
            "normals": made.normals,
        }
        self._scene_buffers = [
            device.upload(values, "STORAGE", what=name) for name, values in arrays.items()
        ]
        sizes = count * 64, count * 32, 4, count * 4
        names = "rows", "results", "count of rows", "paths of rows"
        self._row_buffers = [
            device.buffer(size, "STORAGE", what=name)
            for size, name in zip(sizes, names, strict=True)
        ]
        self._rows = GpuRows(*self._row_buffers[:3], count)
        self._bound = {
            (name, k): evaluator.bind(self._rows)
            for k, part in enumerate(self._parts)
            for name, evaluator in (("transport", part.transport), ("emitter", part.emitter))
            if evaluator is not None
        }

    def _compile(self) -> None:
        layouts = [
            self._layout(["uniform", "storage", "storage", "storage", "read", "read"]),
            self._layout([]),
            self._layout(["read"] * 5),
            self._layout(["storage"] * 4),
        ]
        path, empty, scene, rows = layouts
        self._path_group = self._group(path, self._path_buffers)
        nothing, geometry = self._group(empty, []), self._group(scene, self._scene_buffers)
        queries = self._group(rows, self._row_buffers)
        in_scene = [path, empty, scene], [nothing, geometry]
        forms = {name: in_scene for name in ("closest", "collect", "direct", "scatter")}
        forms["camera"] = [path], []
        forms["gather"] = forms["apply"] = [path, rows], [queries]
        self._pipelines = {}
        for name, (used, groups) in forms.items():
            part = "render/rows" if name in ("gather", "apply") else f"render/{name}"
            source = _lobes() + compose({}, part)
            pipeline = self._device.pipeline(source, name, used)
            self._pipelines[name] = pipeline, groups

    def _layout(self, kinds: Sequence[str]) -> Any:
        types = {"uniform": "uniform", "storage": "storage", "read": "read-only-storage"}
        entries = [
            {
                "binding": k,
                "visibility": 4,  # compute
                "buffer": {"type": types[kind], "has_dynamic_offset": kind == "uniform"},
            }
            for k, kind in enumerate(kinds)
        ]
        return self._device.wgpu.create_bind_group_layout(entries=entries)

    def _group(self, layout: Any, buffers: Sequence[Any]) -> Any:
        entries = [
            {
                "binding": k,
                "resource": {
                    "buffer": buffer,
                    "offset": 0,
                    "size": _FRAME.itemsize if buffer is self._uniform else buffer.size,
                },
            }
            for k, buffer in enumerate(buffers)
        ]
        return self._device.wgpu.create_bind_group(layout=layout, entries=entries)


def _check_limits(device: Device) -> None:
    found = device.limits["max-storage-buffers-per-shader-stage"]
    if found < _STORAGE_BUFFERS:
        needed = f"{_STORAGE_BUFFERS} storage buffers in a shader"
        raise GpuError(f"{device.name}: rendering takes {needed}, found {found}")


def _lobes() -> str:
    """The mixtures of directions, as constants of wgsl/render/lobes.wgsl."""
    surface, fiber = SURFACE_LOBES, FIBER_LOBES
    shares = {
        "SURFACE_SHARES": (surface.uniform, surface.cosine, surface.mirror),
        "FIBER_SHARES": (fiber.uniform, fiber.cone, fiber.forward),
    }
    widths = {
        "MIRROR_KAPPA": surface.mirror_kappa,
        "CONE_SCALE": fiber.cone_scale,
        "FORWARD_KAPPA": fiber.forward_kappa,
    }
    lines = [f"const {name} = vec3f{values};\n" for name, values in shares.items()]
    lines += [f"const {name}: f32 = {value};\n" for name, value in widths.items()]
    return "".join(lines)


def _plan(
    scene: Scene, lights: Sequence[Light], parts: Sequence[GpuPart], scatters: bool
) -> tuple[NDArray[Any], list[list[_Step]]]:
    """The frames of all steps, with what differs between them, and the steps by depth."""
    frames: list[dict[str, int]] = []
    emitting = [k for k, part in enumerate(parts) if part.emits]
    meet = bool(emitting) or not all(light.delta for light in lights)
    sky = any(isinstance(light, InfiniteLight) for light in lights)
    flags = _HAS_SKY * sky + _RAYS_MEET_LIGHTS * meet

    def step(name: str, **values: int) -> _Step:
        frames.append({"flags": flags, **values})
        return _Step(name, len(frames) - 1)

    def queries(what: str, asked: Sequence[int], **values: int) -> list[_Step]:
        steps = []
        for part in asked:
            steps += [_Step("clear"), step("gather", neural_part=part, **values)]
            steps += [_Step(what, part=part), step("apply", neural_part=part, **values)]
        return steps

    def collected(depth: int) -> list[_Step]:
        emission = queries("emitter", emitting, depth=depth, flags=flags | _FOR_EMISSION)
        return [step("collect", depth=depth), *emission]

    every = range(len(parts))
    stages = [[step("camera"), step("closest", rays=CAMERA_RAY), *collected(0)]]
    for depth in range(1, scene.max_depth + 1):
        for light, number, times in _samples(lights, depth):
            at = {"depth": depth, "light": light, "part": number, "parts": times}
            stages.append(
                [step("direct", rays=SHADOW_RAY, **at), *queries("transport", every, **at)]
            )
        last = depth == scene.max_depth or not scatters
        if last and not meet:
            break
        stage = [step("scatter", depth=depth), step("closest", depth=depth, rays=INDIRECT_RAY)]
        stage += queries("transport", every, depth=depth, flags=flags | _FOR_BETA)
        stages.append([*stage, *collected(depth)])
        if last:
            break
    made = np.zeros(len(frames), _FRAME)
    for row, values in zip(made, frames, strict=True):
        for name, value in values.items():
            row[name] = value
    return made, stages


def _samples(lights: Sequence[Light], depth: int) -> list[tuple[int, int, int]]:
    """Samples of lights at a point of that depth: light, number of the sample, how many it has."""
    if not lights:
        return []
    if depth > 2 or len(lights) > LIGHTS_AT_A_VERTEX:
        return [(_NONE, 0, 1)]
    times = [max(light.samples // depth, 1) for light in lights]
    return [(k, part, count) for k, count in enumerate(times) for part in range(count)]


def _layers(sums: NDArray[np.float32]) -> Layers:
    """sums: (n, slots, 4), as Frame.sums of wgsl/render/frame.wgsl says."""
    own, by_group = sums[:, :_OWN_SUMS], sums[:, _OWN_SUMS:, :3]
    return Layers(
        beauty=own[:, 0],
        groups=by_group[:, 0::2],
        hit=(own[:, 1, 3] == 1.0).astype(np.float32),
        normal_world=own[:, 1, :3],
        position_world=own[:, 2, :3],
        light_samples=own[:, 3, :2],
        caught=own[:, 3, 2:],
        behind_catcher=own[:, 4],
        groups_behind=by_group[:, 1::2],
        catcher=(own[:, 1, 3] == 2.0).astype(np.float32),
        asset=own[:, 2, 3].astype(np.uint32),
    )
