"""Renders one scene all the ways that are compared; finished steps are not repeated."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from rna_bench.scenes.beside_cycles import Beside, CyclesScene, OurScene
from rna_bench.scenes.stored import Arrays, StoredResults
from rna_bench.scenes.timed_images import find_denoiser, render_by_turns
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.compare.comparison_run import Timed
from rna_render.scene import Scene

_COVERAGE_SAMPLES = 8
_HALVES = (2, 3)  # Cycles' seeds
_FLOOR_SEED = 1


@dataclass(frozen=True)
class Plan:
    """Samples per pixel of all renders.

    samples: ours whose time counts. cycles_samples: Cycles' likewise. reference_samples: of Cycles,
    half of them in each of two independent renders. floor_samples: ours, for the package's own
    error.
    """

    samples: Sequence[int]
    cycles_samples: Sequence[int]
    reference_samples: int
    floor_samples: int

    @property
    def shown(self) -> int:
        """Samples of our render that is shown next to Cycles' of equal time."""
        return self.samples[len(self.samples) // 2]


class MeasuredScene:
    """One scene's images and times, made at their first use, or in an earlier run."""

    def __init__(
        self,
        name: str,
        scene: Scene,
        plan: Plan,
        references: StoredResults,
        measured: StoredResults,
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
        return CyclesScene(self._worker(), self.scene)

    @cached_property
    def halves(self) -> np.ndarray:
        """Two independent references, (2, h, w, 3) float32."""
        made = self._references.arrays(self.name, self._announced("reference", self._reference))
        return made["halves"]

    @cached_property
    def beside(self) -> Beside:
        """The references, and the pixels that the asset covers."""
        covered = self._measured.arrays(f"{self.name}-covered", self._covered)["covered"]
        return Beside.of(self.halves, covered > 0)

    @cached_property
    def floor(self) -> np.ndarray:
        """Our image with hardly any noise, RGB."""
        return self._measured.arrays(f"{self.name}-floor", self._announced("floor", self._floor))[
            "rgb"
        ]

    @cached_property
    def images(self) -> Arrays:
        """See `render_by_turns`."""
        return self._measured.arrays(f"{self.name}-images", self._announced("times", self._images))

    def _announced(self, step: str, make: Callable[[], Any]) -> Callable[[], Any]:
        def announced() -> Any:
            begun = time.perf_counter()
            result = make()
            self._say(f"{self.name}: {step}, {time.perf_counter() - begun:.0f} s")
            return result

        return announced

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
        return render_by_turns(
            self._ours,
            self._cycles,
            samples=self.plan.samples,
            cycles_samples=self.plan.cycles_samples,
            denoiser=find_denoiser(),
        )
