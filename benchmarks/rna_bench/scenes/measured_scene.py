"""Renders one scene all the ways that are compared; finished steps are kept."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from rna_bench.scenes.beside_cycles import Beside, CyclesScene, OurScene
from rna_bench.scenes.kept import Arrays, Kept
from rna_bench.scenes.kernel_times import kernel_times
from rna_bench.scenes.timed_images import find_denoiser, render_by_turns
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.compare.comparison_run import Timed
from rna_render.scene import Scene
from rna_sdk.kernel_threads import limit_kernel_threads

_COVERAGE_SAMPLES = 8
_HALVES = (2, 3)  # Cycles' seeds
_FLOOR_SEED = 1


@dataclass(frozen=True)
class Plan:
    """Samples per pixel of all renders.

    samples: ours whose time counts. cycles_samples: Cycles' likewise. reference_samples: of Cycles,
    half of them in each of two independent renders. floor_samples: ours, for the package's own
    error. repeats: of ours; medians count. bounces: of light in Cycles, None for the source's.
    """

    samples: Sequence[int]
    cycles_samples: Sequence[int]
    reference_samples: int
    floor_samples: int
    repeats: int
    bounces: int | None

    @property
    def shown(self) -> int:
        """Samples of our render that is shown and whose kernels are timed."""
        return self.samples[len(self.samples) // 2]


class MeasuredScene:
    """One scene's images and times, made when they are first asked for, or in an earlier run."""

    def __init__(
        self,
        name: str,
        scene: Scene,
        plan: Plan,
        references: Kept,
        measured: Kept,
        worker: Callable[[], BlenderWorker],
        say: Callable[[str], None],
    ):
        self.name, self.scene, self.plan = name, scene, plan
        self._references, self._measured = references, measured
        self._worker, self._say = worker, say

    @cached_property
    def _ours(self) -> OurScene:
        return OurScene(self.scene)

    @cached_property
    def _cycles(self) -> CyclesScene:
        return CyclesScene(self._worker(), self.scene, self.plan.bounces)

    @cached_property
    def beside(self) -> Beside:
        """The references, and the pixels that the asset covers."""
        halves = self._references.arrays(self.name, self._told("reference", self._reference))
        covered = self._measured.arrays(f"{self.name}-covered", self._covered)["covered"]
        return Beside.of(halves["halves"], covered > 0)

    @cached_property
    def floor(self) -> np.ndarray:
        """Our image with hardly any noise, RGB."""
        return self._measured.arrays(f"{self.name}-floor", self._told("floor", self._floor))["rgb"]

    @cached_property
    def images(self) -> Arrays:
        """See `render_by_turns`."""
        return self._measured.arrays(f"{self.name}-images", self._told("times", self._images))

    @cached_property
    def kernels(self) -> dict[str, Any]:
        """CPU time by kernel on one thread, and the time of one thread and of all."""
        return self._measured.record(f"{self.name}-kernels", self._told("kernels", self._kernels))

    def record(self, name: str, make: Callable[[BlenderWorker], dict[str, Any]]) -> dict[str, Any]:
        """A further measurement of this scene, kept in the same way."""
        told = self._told(name, lambda: make(self._worker()))
        return self._measured.record(f"{self.name}-{name}", told)

    def _told(self, step: str, make: Callable[[], Any]) -> Callable[[], Any]:
        def told() -> Any:
            begun = time.perf_counter()
            result = make()
            self._say(f"{self.name}: {step}, {time.perf_counter() - begun:.0f} s")
            return result

        return told

    def _reference(self) -> Arrays:
        half = self.plan.reference_samples // 2
        return {"halves": np.stack([self._cycles.render(half, seed).pixels for seed in _HALVES])}

    def _covered(self) -> Arrays:
        alone = {"ground": None, "objects": (), "lights": ()}
        alpha = OurScene(self.scene.model_copy(update=alone)).channels(_COVERAGE_SAMPLES)["A"]
        return {"covered": (alpha > 0.0).astype(np.uint8)}

    def _floor(self) -> Arrays:
        image: Timed = self._ours.render(self.plan.floor_samples, seed=_FLOOR_SEED)
        return {"rgb": image.pixels.astype(np.float32)}

    def _images(self) -> Arrays:
        plan = self.plan
        counts = plan.samples, plan.cycles_samples, plan.repeats
        return render_by_turns(self._ours, self._cycles, *counts, find_denoiser())

    def _kernels(self) -> dict[str, Any]:
        samples = self.plan.shown
        self._ours.render(1)  # compiles
        threads = limit_kernel_threads(None)
        every = self._ours.render(samples).seconds
        try:
            limit_kernel_threads(1)
            one = self._ours.render(samples).seconds
            with kernel_times() as times:
                self._ours.render(samples)
        finally:
            limit_kernel_threads(None)
        scaling = {"threads": threads, "seconds": every, "seconds_one_thread": one}
        return {"samples": samples, **times.as_json(), **scaling, "times_as_fast": one / every}
