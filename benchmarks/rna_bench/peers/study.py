"""Trains one method in steps and measures it after each step; finished steps are kept."""

import time
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from safetensors.numpy import load_file

from rna_bench.peers.method import Budget, Method, Training
from rna_bench.peers.methods import MethodRow, Setting
from rna_bench.peers.scoring import HeldOut
from rna_bench.peers.views import Views
from rna_bench.scenes.stored import StoredResults
from rna_export.capture.dataset.sample_files import write_arrays

PARTS = (1 / 8, 1 / 4, 1 / 2, 1.0)
"""Shares of the budget after which a method is measured."""

REMEDY = "choose another --out, or --again to start anew"


@dataclass(frozen=True)
class Plan:
    """A comparison: data by split, minutes of training, steps instead for a whole schedule."""

    train: Views
    collocated: Views | None
    held_out: dict[str, HeldOut]
    minutes: float
    steps: int | None = None


def run_method(
    row: MethodRow, setting: Setting, plan: Plan, out: Path, settings: dict[str, Any], again: bool
) -> dict[str, Any]:
    """Records of the method after each part of its training, in `out/NAME-SEED`.

    settings: what the records depend on beside the method.
    """
    folder = out / f"{row.name}-{setting.seed}"
    records = StoredResults(
        folder,
        {**settings, "method": row.name, "seed": setting.seed, "full": setting.full},
        again,
        REMEDY,
    )
    if again:
        (folder / "last.ckpt").unlink(missing_ok=True)
    method = row.make(setting)
    data = plan.collocated if row.collocated else plan.train
    assert data is not None  # the command has looked
    points = []
    for part in PARTS:
        budget = _budget(plan, part)
        make = partial(_point, method, data, budget, plan, row, folder, part)
        points.append(records.record(f"point-{part:g}", make))
    return {
        "method": row.name,
        "title": row.title,
        "seed": setting.seed,
        "parameters": method.parameter_count,
        "reduced": "" if setting.full else row.reduced,
        "collocated": row.collocated,
        "points": points,
    }


def rendered(out: Path, name: str, seed: int, split: str) -> list[np.ndarray]:
    """The last images of a method, (h, w, 3) float32."""
    arrays = load_file(out / f"{name}-{seed}" / f"images-{PARTS[-1]:g}.safetensors")
    return list(arrays[split])


def _budget(plan: Plan, part: float) -> Budget:
    if plan.steps is not None:
        return Budget(np.inf, np.inf, round(part * plan.steps))
    return Budget(60.0 * plan.minutes * part, 60.0 * plan.minutes)


def _point(
    method: Method,
    data: Views,
    budget: Budget,
    plan: Plan,
    row: MethodRow,
    folder: Path,
    part: float,
) -> dict[str, Any]:
    done = method.train(data, budget, folder)
    begun = time.process_time()
    images = {split: _render(method, held) for split, held in plan.held_out.items()}
    count = sum(len(held.views) for held in plan.held_out.values())
    seconds = (time.process_time() - begun) / count
    stacked = {split: np.stack(shown).astype(np.float32) for split, shown in images.items()}
    write_arrays(folder / f"images-{part:g}.safetensors", stacked)
    scores = {split: held.score(images[split]).as_json() for split, held in plan.held_out.items()}
    return {**_spent(done, row), "frame_cpu_seconds": round(seconds, 3), "scores": scores}


def _spent(done: Training, row: MethodRow) -> dict[str, Any]:
    return {
        "cpu_minutes": round(done.seconds / 60.0, 3),
        "steps": done.steps,
        "samples": done.samples,
        "share_of_schedule": row.share(done.samples),
        "loss": done.curve[-1].loss if done.curve else None,
    }


def _render(method: Method, held: HeldOut) -> list[np.ndarray]:
    return [method.render(camera, light) for camera, light in held.cameras()]
