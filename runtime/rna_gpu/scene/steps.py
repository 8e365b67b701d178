"""The steps of a sample of a band: which shaders run, with which numbers."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.asset import GpuPart
from rna_gpu.records import scene as records
from rna_gpu.records.part import NONE
from rna_gpu.scene.scene_tables import SceneTables
from rna_render import Camera
from rna_render.lights import AssetLight, InfiniteLight, Light
from rna_render.materials import TABLE_SIZE
from rna_render.paths.sampling import BRANCHES, LIGHTS_AT_A_VERTEX
from rna_render.scene import Scene
from rna_trace import CAMERA_RAY, INDIRECT_RAY, SHADOW_RAY

LISTS = 3
_BAND, _SEEN, _OTHER = range(LISTS)
"""Lists of paths: all of the band; those that the camera sees hit something, which every branch
starts from; and one more, since from each point to the next the paths that go on are listed in
_BAND and _OTHER by turns."""


@dataclass(frozen=True)
class Step:
    """Dispatches that are recorded together.

    name: of a pipeline; or of a decoder's form: evaluation of a part; or "clear", of the number of
        queries; or "keep", "restore": copies of the paths at the points that the camera sees.
    frame: row of the frames. list, after: lists of paths that it reads, and that "compact" writes.
    """

    name: str
    frame: int = 0
    part: int = -1
    list: int = _BAND
    after: int = _BAND


class Steps:
    """All steps of a sample.

    Attributes:
        frames: (n,) of dtype FRAME.dtype, what the steps read.
        stages: steps that are submitted together.
        nearby: the lengths of nearby light of parts that count it, by their numbers.
    """

    def __init__(
        self,
        scene: Scene,
        tables: SceneTables,
        lights: Sequence[Light],
        parts: Sequence[GpuPart],
        scatters: bool,
    ) -> None:
        """parts: those of `tables.parts`. scatters: as World.scatters."""
        self._rows: list[dict[str, Any]] = []
        self._lights = lights
        self._emitting = [k for k, part in enumerate(parts) if part.emits]
        self._apart = [k for k, part in enumerate(parts) if "shadowed" in part.evaluators]
        self._together = [k for k in range(len(parts)) if k not in self._apart]
        self.nearby = {k: p.nearby_lengths for k, p in enumerate(parts) if p.nearby_lengths}
        self._meet = not all(light.delta for light in lights)
        sky = any(isinstance(light, InfiniteLight) for light in lights)
        self._flags = (
            records.HAS_SKY * sky
            + records.RAYS_MEET_LIGHTS * self._meet
            + records.TRANSMITS * tables.transmits
        )
        self._split = {"branch": 0, "branches": 1}
        self._list = _BAND
        depth, self._branches = (scene.max_depth, BRANCHES) if scatters else (1, 1)
        self.stages = self._planned(depth, self._branches)
        self.frames: NDArray[Any] = np.zeros(len(self._rows), records.FRAME.dtype)
        for row, values in zip(self.frames, self._rows, strict=True):
            for name, value in values.items():
                row[name] = value

    def fill(
        self, scene: Scene, tables: SceneTables, clamp: float | None, sums: int, words: int
    ) -> None:
        """Write the data that all steps share. words: of a list of paths, uint32."""
        camera = Camera(scene.camera, scene.resolution, scene.samples)
        common = {
            "camera": camera.position,
            "width": camera.width,
            "corner": camera.corner,
            "step_x": camera.step_x,
            "step_y": camera.step_y,
            "spread": camera.spread,
            "lens_x": camera.lens_x,
            "lens_y": camera.lens_y,
            "focus": camera.focus if camera.has_lens else 0.0,
            "seed": scene.seed,
            "clamp": (clamp or 0.0) / self._branches,
            "light_count": len(self._lights),
            **tables.sections,
            "sums": sums,
            "table_size": TABLE_SIZE,
        }
        for name, value in common.items():
            self.frames[name] = value
        for name in ("list", "next_list"):
            self.frames[name] *= words

    def _planned(self, max_depth: int, branches: int) -> list[list[Step]]:
        first = [self._step("camera"), self._step("closest", rays=CAMERA_RAY)]
        stages = [[*first, *self._collected(0, _SEEN)]]
        stages += [self._direct(1, *chosen) for chosen in self._samples(1)]
        if branches > 1:
            stages.append([Step("keep")])
        for branch in range(branches):
            self._split = {"branch": branch, "branches": branches}
            if branch:
                stages.append([Step("restore")])
            self._list = _SEEN
            stages += self._continued(max_depth)
        self._list = _BAND
        return [*stages, [self._step("accumulate")]]

    def _continued(self, max_depth: int) -> list[list[Step]]:
        """The steps after the samples of lights at the first points."""
        stages = []
        for depth in range(1, max_depth + 1):
            if depth > 1:
                stages += [self._direct(depth, *chosen) for chosen in self._samples(depth)]
            last = depth == max_depth
            if last and not self._meet:
                break
            stage = [self._step("scatter", depth=depth)]
            stage.append(self._step("closest", depth=depth, rays=INDIRECT_RAY))
            for_beta = self._flags | records.FOR_BETA
            stage += self._transport(depth=depth, flags=for_beta)
            after = _BAND if self._list == _OTHER else _OTHER
            stages.append([*stage, *self._collected(depth, after)])
        return stages

    def _direct(self, depth: int, light: int, number: int, times: int) -> list[Step]:
        """A sample of a light at every point."""
        at = {"depth": depth, "light": light, "part": number, "parts": times}
        steps = [self._step("direct", rays=SHADOW_RAY, **at)]
        chosen = self._lights if light == NONE else [self._lights[light]]
        if any(isinstance(one, AssetLight) for one in chosen):
            flags = self._flags | records.FOR_LIGHT
            steps += self._queries("emission", self._emitting, **at, flags=flags)
        return [*steps, *self._transport(**at)]

    def _collected(self, depth: int, after: int) -> list[Step]:
        """after: the list of the paths that go on."""
        flags = self._flags | records.FOR_EMISSION
        steps = [self._step("collect", depth=depth)]
        steps += self._queries("emission", self._emitting, depth=depth, flags=flags)
        steps.append(self._step("compact", next_list=after))
        self._list = after
        return steps

    def _transport(self, **values: int) -> list[Step]:
        """Queries of all parts, by a decoder each, or by two: of visible and of shadowed light."""
        flags = values.pop("flags", self._flags)
        steps = [
            self._step("nearby", neural_part=part, lengths=lengths, **values, flags=flags)
            for part, lengths in self.nearby.items()
        ]
        steps += self._queries("transport", self._together, **values, flags=flags)
        for name, flag in (("visible", records.FOR_VISIBLE), ("shadowed", records.FOR_SHADOWED)):
            steps += self._queries(name, self._apart, **values, flags=flags | flag)
        return steps

    def _queries(self, what: str, numbers: Sequence[int], **values: int) -> list[Step]:
        steps = []
        for part in numbers:
            steps += [Step("clear"), self._step("gather", neural_part=part, **values)]
            steps += [Step(what, part=part), self._step("apply", neural_part=part, **values)]
        return steps

    def _step(self, name: str, **values: Any) -> Step:
        self._rows.append({"flags": self._flags, "list": self._list, **self._split, **values})
        after = values.get("next_list", _BAND)
        return Step(name, len(self._rows) - 1, list=self._list, after=after)

    def _samples(self, depth: int) -> list[tuple[int, int, int]]:
        """Samples of lights at a point of that depth: light, number of the sample, how many."""
        if not self._lights:
            return []
        if depth > 2 or len(self._lights) > LIGHTS_AT_A_VERTEX:
            return [(NONE, 0, 1)]
        times = [max(light.samples // depth, 1) for light in self._lights]
        return [(k, part, count) for k, count in enumerate(times) for part in range(count)]
