"""Whether a model counts nearby light: two short trainings tell what an asset gains by it.

Translucent assets gain; opaque ones lose, since all that it tells them is noise
(docs/decisions/model.md).
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from rna_export.capture.dataset.nearby_rows import usual_lengths
from rna_export.training.checkpoint import load_progress
from rna_export.training.presets import Preset
from rna_export.training.report import read_curves
from rna_export.training.training_run import Run, table_of, train
from rna_sdk.errors import TrainingError
from rna_sdk.files.atomic_file import write_atomically

LEAST_GAIN = 0.02
"""Part of the FLIP that an asset has to gain."""

_TRIAL_STEPS, _TRIAL_ROWS = 1500, 500_000
_KEPT = "nearby.json"


def with_nearby(run: Run, mode: str, say: Callable[[str], None] = print) -> Run:
    """The run, with the part's lengths of nearby light in its model where `mode` says so.

    mode: one of NEARBY_MODES. "auto" decides by two short trainings, once a folder of checkpoints;
    a stopped run goes on as it began. Raises `TrainingError` for "on" where rays were captured in
    several poses: rows do not say in which.
    """
    if mode == "off":
        return run
    if run.dataset.manifest.poses:
        if mode == "on":
            raise TrainingError("--nearby on: expected a capture of one pose, found several")
        say("nearby light: not counted, the capture is of several poses")
        return run
    counting = replace(run, preset=run.preset.with_model(nearby=usual_lengths(run.dataset)))
    if mode == "on":
        return counting
    last = run.out / "last.ckpt"
    if last.is_file():
        begun = load_progress(last, run.model_class)["record"]["preset"]
        return counting if Preset.model_validate(begun).model.nearby else run
    without, with_it = _flips(run, counting)
    gain = 1.0 - with_it / without
    is_better = gain >= LEAST_GAIN
    verdict = "counted" if is_better else f"not counted, {LEAST_GAIN:.0%} are expected"
    say(f"nearby light: FLIP {without:.4f} without, {with_it:.4f} with it: {verdict}")
    return counting if is_better else run


def _flips(run: Run, counting: Run) -> tuple[float, float]:
    """FLIP after short trainings without and with nearby light: found earlier, or now."""
    kept = run.out / _KEPT
    if kept.is_file():
        try:
            found = json.loads(kept.read_text())
            return float(found["without"]), float(found["with"])
        except (ValueError, KeyError, TypeError):
            raise TrainingError(f"{kept}: not a verdict of rna-train; delete it") from None
    run.out.mkdir(parents=True, exist_ok=True)
    samples = run.dataset.training_samples()
    count = len(samples["wi"])
    rows = np.random.default_rng(0).permutation(count)[:_TRIAL_ROWS]
    some = {name: values[np.sort(rows)] for name, values in samples.items()}
    without, with_it = (_flip(one, some) for one in (run, counting))
    text = json.dumps({"without": without, "with": with_it}, indent=1) + "\n"
    write_atomically(kept, text.encode())
    return without, with_it


def _flip(run: Run, samples: dict[str, np.ndarray]) -> float:
    """FLIP of a short training on these samples."""
    steps = min(run.preset.training.steps, _TRIAL_STEPS)
    preset = run.preset.with_training(steps=steps)
    with TemporaryDirectory(dir=run.out, prefix="nearby-") as folder:
        trial = replace(
            run,
            preset=preset,
            out=Path(folder),
            minutes=None,
            begun=None,
            validations=2,
            after_checkpoint=lambda: None,
        )
        train(trial, table_of(trial, samples), say=lambda _: None)
        return min(row["flip"] for row in read_curves(trial.out) if "flip" in row)
