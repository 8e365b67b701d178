"""Nearby light of captured rows (spec/RNA.md, 7.3), traced on the captured geometry and kept.

It depends on points and directions alone, so a capture need not know of it. Blocks of rows are
files beside the dataset, named for their content: a stopped training goes on with those that are
there, and other trainings on the same rays find them.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from safetensors import SafetensorError
from safetensors.numpy import load_file
from tqdm import tqdm

from rna_export.capture.dataset.sample_files import write_arrays
from rna_trace import nearby_light
from rna_work.bar import Bar

if TYPE_CHECKING:
    from rna_export.capture.dataset.dataset_part import DatasetPart

OF_DIAGONAL = {"surface": (0.005, 0.015, 0.045), "fiber": (0.004, 0.015, 0.05)}
"""Kind of part -> lengths, over the diagonal of the asset's box (docs/decisions/model.md)."""

TRAINING_RAYS = 12
"""Rays of each of two estimates; the product of their errors is not biased by noise."""

IMAGE_RAYS = 256
_BLOCK = 1 << 17  # rows of a file
_DIGITS = 4  # of a length
ESTIMATES = "nearby", "nearby_again"
"""Fields of samples: two independent estimates."""

Samples = dict[str, np.ndarray]


def nearby_folder(part: DatasetPart) -> Path:
    """Folder of a part's nearby light and its verdict; it may not exist."""
    return part.folder / "nearby"


def usual_lengths(part: DatasetPart) -> tuple[float, ...]:
    """Lengths of nearby light for a part, metres."""
    diagonal = part.dataset.scene.diagonal
    return tuple(float(f"{share * diagonal:.{_DIGITS}g}") for share in OF_DIAGONAL[part.kind])


def with_estimates(
    samples: Samples,
    part: DatasetPart,
    lengths: tuple[float, ...],
    bars: Callable[..., tqdm] = Bar,
) -> Samples:
    """The samples with two independent estimates of nearby light, (n, 3) float32 each."""
    blocks = _blocks(len(samples["wi"]))
    with bars(total=len(blocks), unit="block", desc="nearby light", leave=False) as bar:
        found = []
        for rows in blocks:
            found.append(_of_rows(samples, rows, part, lengths, (TRAINING_RAYS,) * len(ESTIMATES)))
            bar.update()
    every = np.concatenate(found, axis=1)
    return {**samples, **dict(zip(ESTIMATES, every, strict=True))}


def of_image(samples: Samples, part: DatasetPart, lengths: tuple[float, ...]) -> np.ndarray:
    """Nearby light of an image's rows, (n, 3) float32."""
    blocks = _blocks(len(samples["wi"]))
    found = [_of_rows(samples, rows, part, lengths, (IMAGE_RAYS,))[0] for rows in blocks]
    return np.concatenate(found)


def _blocks(count: int) -> list[slice]:
    return [slice(k, k + _BLOCK) for k in range(0, max(count, 1), _BLOCK)]


def _of_rows(
    samples: Samples,
    rows: slice,
    part: DatasetPart,
    lengths: tuple[float, ...],
    rays: tuple[int, ...],
) -> np.ndarray:
    """(estimates, n, 3) float32, each with so many rays: kept, or traced and then kept."""
    x, wi = (np.ascontiguousarray(samples[name][rows]) for name in ("position", "wi"))
    digest = hashlib.sha256(f"{part.dataset.geometry_digest} {lengths} {rays}".encode())
    digest.update(x.data)
    digest.update(wi.data)
    path = nearby_folder(part) / f"{digest.hexdigest()[:32]}.safetensors"
    with suppress(OSError, KeyError, SafetensorError):
        kept = load_file(path)["nearby"]
        if kept.shape == (len(rays), len(x), len(lengths)):
            return kept.astype(np.float32)
    scene = part.dataset.scene
    unit = wi / np.maximum(np.linalg.norm(wi, axis=1, keepdims=True), np.float32(1e-30))
    traced = np.stack(
        [nearby_light(scene, lengths, x, unit, count, seed) for seed, count in enumerate(rays)]
    ).astype(np.float16)
    with suppress(OSError):  # of a folder that cannot be written
        path.parent.mkdir(exist_ok=True)
        write_arrays(path, {"nearby": traced})
    return traced.astype(np.float32)
