"""Whether a model counts nearby light: two short trainings tell the asset's gain by it.

Translucent assets gain; opaque ones lose, since all that it tells them is noise
(docs/decisions/model.md). Those are told by their materials, without a training.
"""

import json
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from tqdm import tqdm

from rna_export.capture.dataset.nearby_rows import nearby_folder, usual_lengths
from rna_export.training.checkpoint import load_progress
from rna_export.training.optimization.samples import SampleTable
from rna_export.training.presets import PRESETS, Preset
from rna_export.training.report import read_curves
from rna_export.training.training_run import Run, table_of, train
from rna_sdk.errors import TrainingError
from rna_sdk.files.atomic_file import write_atomically
from rna_work.bar import Bar

LEAST_GAIN = 0.02
"""Part of the FLIP that an asset has to gain."""

_PRESET = "small"
_TRIAL_STEPS, _TRIAL_ROWS = 500, 250_000
_KEPT = "verdict.json"
_NO_BAR = partial(Bar, disable=True)


def run_on(
    run: Run,
    mode: str,
    samples: dict[str, np.ndarray],
    say: Callable[[str], None] = print,
    bars: Callable[..., tqdm] = Bar,
) -> tuple[Run, SampleTable]:
    """The run of `with_nearby`, and the table of its samples, which the caller need not keep."""
    chosen = with_nearby(run, mode, samples, say)
    return chosen, table_of(chosen, samples, bars)


def with_nearby(
    run: Run,
    mode: str,
    samples: dict[str, np.ndarray],
    say: Callable[[str], None] = print,
) -> Run:
    """The run, with the part's lengths of nearby light in its model where `mode` says so.

    mode: one of NEARBY_MODES. "auto" decides by two short trainings on some of the samples, once a
    dataset; a stopped run goes on as it began, presets of the paper never have it. Raises
    `TrainingError` for "on" where rays were captured in several poses: rows do not say in which.
    """
    if mode == "off" or (mode == "auto" and not run.preset.may_count_nearby):
        return run
    if run.dataset.manifest.poses:
        if mode == "on":
            raise TrainingError("--nearby on: expected a capture of one pose, found several")
        say("nearby light: not counted, the capture is of several poses")
        return run
    counting = _counting(run)
    if mode == "on":
        return counting
    last = run.out / "last.ckpt"
    if last.is_file():
        begun = load_progress(last, run.model_class)["record"]["preset"]
        return counting if Preset.model_validate(begun).model.nearby else run
    materials = run.dataset.manifest.materials  # none: not known
    if materials and not any(material.scatters for material in materials):
        say("nearby light: not counted, light enters no material")
        return run
    say("nearby light: two short trainings tell whether it is counted")
    without, with_it = _flips(run, samples)
    gain = 1.0 - with_it / without
    is_better = gain >= LEAST_GAIN
    verdict = "counted" if is_better else f"not counted, {LEAST_GAIN:.0%} are expected"
    say(f"nearby light: FLIP {without:.4f} without, {with_it:.4f} with it: {verdict}")
    return counting if is_better else run


def _counting(run: Run) -> Run:
    return replace(run, preset=run.preset.with_model(nearby=usual_lengths(run.dataset)))


def _flips(run: Run, samples: dict[str, np.ndarray]) -> tuple[float, float]:
    """FLIP after short trainings without and with nearby light: found earlier, or now."""
    kept = nearby_folder(run.dataset) / _KEPT
    if kept.is_file():
        try:
            found = json.loads(kept.read_text())
            return float(found["without"]), float(found["with"])
        except (ValueError, KeyError, TypeError):
            raise TrainingError(f"{kept}: not a verdict of rna-train; delete it") from None
    rows = np.random.default_rng(0).permutation(len(samples["wi"]))[:_TRIAL_ROWS]
    some = {name: values[np.sort(rows)] for name, values in samples.items()}
    preset = PRESETS[run.dataset.kind][_PRESET]
    steps = min(run.preset.training.steps, _TRIAL_STEPS)
    trial = replace(run, preset=preset.with_training(steps=steps), preset_name=_PRESET)
    without, with_it = (_flip(one, some) for one in (trial, _counting(trial)))
    text = json.dumps({"without": without, "with": with_it}, indent=1) + "\n"
    with suppress(OSError):  # of a folder that cannot be written
        kept.parent.mkdir(exist_ok=True)
        write_atomically(kept, text.encode())
    return without, with_it


def _flip(run: Run, samples: dict[str, np.ndarray]) -> float:
    """FLIP of a short training on these samples."""
    with TemporaryDirectory(prefix="nearby-") as folder:
        trial = replace(
            run,
            out=Path(folder),
            minutes=None,
            begun=None,
            validations=2,
            after_checkpoint=lambda: None,
            start=None,
        )
        train(trial, table_of(trial, samples, _NO_BAR), say=lambda _: None, bars=_NO_BAR)
        return min(row["flip"] for row in read_curves(trial.out) if "flip" in row)
