"""The options of an `rna-make` run."""

import hashlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.capture_run import CaptureWorkers
from rna_export.make.goal import Goal
from rna_export.make.plan import CAPTURE, capture_share
from rna_export.make.state import RunSettings
from rna_export.training.presets import PRESETS
from rna_render.scene import SceneFile


@dataclass(frozen=True)
class MakeOptions:
    """The options of one run."""

    source: Source
    settings: dict[str, Any]  # of the capture, that are not to be the usual ones
    for_scene: SceneFile | None
    work: Path
    presets: tuple[str, ...]
    goal: Goal | None
    minutes: float | None
    steps: int | None  # of the last phase; None: the preset's
    seed: int
    device: str
    nearby: str  # one of NEARBY_MODES
    workers: CaptureWorkers
    picture: Path | None = None  # of the model in training, rewritten
    more: float | None = None  # minutes, after those of an earlier run
    update: bool = False  # of a source whose materials changed

    @property
    def requested(self) -> RunSettings:
        """Options that must be equal for a run to resume."""
        source, scene = self.source, self.for_scene
        return RunSettings(
            source=source.path.name,
            source_sha256=hashlib.sha256(source.path.read_bytes()).hexdigest(),
            arguments=source.arguments,
            settings=self.settings,
            scene=None if scene is None else scene.path.read_text(),
            presets=self.presets,
            goal="none" if self.goal is None else str(self.goal),
            minutes=self.minutes,
            steps=self.steps,
            seed=self.seed,
        )

    @property
    def capture_share(self) -> float:
        """Share of the minutes for capture."""
        if self.goal is not None or self.minutes is None:
            return CAPTURE
        return self.share_of(60.0 * self.minutes)

    def share_of(self, seconds: float) -> float:
        """Share of so much time for capture, in a single round."""
        widths = [PRESETS["surface"][name].model.width for name in self.presets]
        return capture_share(seconds, widths, self.device)

    @property
    def overlaps(self) -> bool:
        """Whether captures and trainings go on at the same time: those of a GPU need no cores."""
        return self.device == "cuda"

    @property
    def fixes_lights(self) -> bool:
        """Whether --lights was given: all of them are captured in one round."""
        return "lights" in self.settings
