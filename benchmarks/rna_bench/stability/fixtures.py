"""Makes the data of the cases, once: captures, trainings, references from Cycles, packages."""

import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any
from uuid import uuid4

import numpy as np
from safetensors.numpy import load_file

from rna_bench.one_part import OnePart, load_one_part
from rna_bench.stability.answers import Answers, of_package
from rna_export.capture.blender_process import blender_env
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.sample_files import write_arrays
from rna_export.export.package_build import build_package
from rna_export.training.checkpoint import Trained, load_checkpoint
from rna_export.training.presets import PRESETS, Preset
from rna_export.training.training_run import Run, train
from rna_sdk.errors import CaptureError

ASSETS = Path(__file__).parent / "assets"

_SHORT = 8  # times less of everything


@dataclass(frozen=True)
class Subject:
    """The asset that was given, as far as it was."""

    dataset: DatasetPart | None = None
    package: Path | None = None
    tier: str | None = None
    source: Source | None = None

    @property
    def given(self) -> set[str]:
        """Names as in `Case.needs`."""
        named = {"dataset": self.dataset, "source": self.source}
        result = {name for name, value in named.items() if value is not None}
        return result | ({"package"} if self.package or self.dataset else set())


class Fixtures:
    """A folder of captures, runs and references; finished ones are reused.

    Attributes:
        subject: the given asset.
        steps: of each training.
        short: whether cases should do less of everything.
    """

    def __init__(
        self, folder: Path, subject: Subject, steps: int, workers: int, short: bool = False
    ):
        self.subject, self.short = subject, short
        self.steps = max(10, steps // _SHORT) if short else steps
        self._folder, self._workers = folder, workers

    def some(self, number: int) -> int:
        """The number itself, or less of it in the short form."""
        return max(1, number // _SHORT) if self.short else number

    @property
    def kind(self) -> str | None:
        """Kind of the given asset, if there is one."""
        if self.subject.dataset is not None:
            return self.subject.dataset.kind
        return self.asset.kind if self.subject.package is not None else None

    @property
    def name(self) -> str:
        """Name of the given asset, or of the suite's own assets."""
        given = self.subject.package or (self.subject.dataset and self.subject.dataset.folder)
        return given.stem if given else "the suite's own assets"

    @property
    def dataset(self) -> DatasetPart:
        """The given asset's. Raises CaptureError when there is none."""
        if self.subject.dataset is None:
            raise CaptureError("found no dataset, expected ASSET.rays/")
        return self.subject.dataset

    @property
    def source(self) -> Source:
        """The given asset's. Raises CaptureError when there is none."""
        if self.subject.source is None:
            raise CaptureError("found no source, expected --source MODEL")
        return self.subject.source

    def capture_white(self) -> DatasetPart:
        """The suite's asset that takes no light away."""
        return self.capture(
            "white",
            "white.py",
            lights=self.some(600),
            rays=4096,
            samples=8,
            validation_views=4,
            validation_resolution=96,
            validation_samples=self.some(256),
        )

    def capture(self, name: str, script: str, *arguments: str, **settings: Any) -> DatasetPart:
        """The part of one of the suite's own assets; settings as in `CaptureSettings`."""
        out = self._folder / "captures" / f"{name}.rays"
        out.parent.mkdir(parents=True, exist_ok=True)
        command = [sys.executable, "-m", "rna_export.capture.rna_capture", ASSETS / script]
        command += ["--out", out, "--workers", self._workers]
        for key, value in settings.items():
            command += [f"--{key.replace('_', '-')}", value]
        ended = subprocess.run([*map(str, command), "--", *arguments])
        if ended.returncode:
            raise CaptureError(f"the capture of {name} failed, status {ended.returncode}")
        return Dataset(out).only

    def train(self, name: str, dataset: DatasetPart, preset: Preset, seed: int = 0) -> Trained:
        """The model after the last step: the best by a few views would hide overfitting."""
        out = self._folder / "runs" / dataset.folder.stem / name
        if not (out / "best.ckpt").is_file():
            train(Run(dataset, preset, "small", out, seed, validations=2))
        return load_checkpoint(out / "last.ckpt")

    def preset(self, kind: str, **model: Any) -> Preset:
        """`small` with the suite's steps; `model`: fields of ModelConfig that differ."""
        return PRESETS[kind]["small"].with_training(steps=self.steps).with_model(**model)

    def paper_inputs(self, kind: str) -> tuple[str, ...]:
        """The decoder's inputs in the paper."""
        return PRESETS[kind]["paper-small"].model.inputs

    @cached_property
    def base(self) -> Trained:
        """`small` trained on the given dataset: the base of comparison for variants."""
        return self.train("base", self.dataset, self.preset(self.dataset.kind))

    @cached_property
    def package(self) -> Path:
        """The package that was given, or one of `base`."""
        if self.subject.package is not None:
            return self.subject.package
        return self._packed(self.base, self.dataset, self.dataset.manifest.name)

    def _packed(self, trained: Trained, dataset: DatasetPart, name: str) -> Path:
        out = self._folder / f"{name}.rna"
        if not out.is_file():
            build_package([trained], dataset.dataset, out, None, "unknown", print)
        return out

    @cached_property
    def asset(self) -> OnePart:
        """The package, loaded."""
        return load_one_part(self.package, self.subject.tier, threads=1)

    def answers(self) -> Answers:
        """The package's."""
        return of_package(self.asset)

    def stored(self, name: str, make: Callable[[], dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
        """Arrays that `make` gives, or gave in an earlier run."""
        path = self._folder / "references" / f"{name}.safetensors"
        if not path.is_file():
            arrays = make()
            path.parent.mkdir(parents=True, exist_ok=True)
            write_arrays(path, arrays)
        return load_file(path)

    @contextmanager
    def cycles(self, source: Source) -> Iterator[BlenderWorker]:
        """Cycles with the source open."""
        scratch = self._folder / f"scratch-{uuid4().hex[:8]}"
        try:
            with BlenderWorker(blender_env.find_python(), source, scratch, self._workers) as worker:
                yield worker
        finally:
            shutil.rmtree(scratch, ignore_errors=True)
