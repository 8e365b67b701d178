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

TRAINING_RAYS = 48
"""Rays of a row: noise of 2 to 5% of the variance of nearby light (docs/decisions/model.md)."""

IMAGE_RAYS = 256
_BLOCK = 1 << 17  # rows of a file
_DIGITS = 4  # of a length

Samples = dict[str, np.ndarray]


def nearby_folder(part: DatasetPart) -> Path:
    """Folder of a part's nearby light and its verdict; it may not exist."""
    return part.folder / "nearby"


def usual_lengths(part: DatasetPart) -> tuple[float, ...]:
    """Lengths of nearby light for a part, metres."""
    diagonal = part.dataset.scene.diagonal
    return tuple(float(f"{share * diagonal:.{_DIGITS}g}") for share in OF_DIAGONAL[part.kind])


def with_nearby_light(
    samples: Samples,
    part: DatasetPart,
    lengths: tuple[float, ...],
    bars: Callable[..., tqdm] = Bar,
) -> Samples:
    """The samples with their nearby light, "nearby" (n, 3) float32."""
    blocks = _blocks(len(samples["wi"]))
    with bars(total=len(blocks), unit="block", desc="nearby light", leave=False) as bar:
        found = []
        for rows in blocks:
            found.append(_of_rows(samples, rows, part, lengths, TRAINING_RAYS))
            bar.update()
    return {**samples, "nearby": np.concatenate(found)}


def of_image(samples: Samples, part: DatasetPart, lengths: tuple[float, ...]) -> np.ndarray:
    """Nearby light of an image's rows, (n, 3) float32."""
    blocks = _blocks(len(samples["wi"]))
    return np.concatenate([_of_rows(samples, rows, part, lengths, IMAGE_RAYS) for rows in blocks])


def _blocks(count: int) -> list[slice]:
    return [slice(k, k + _BLOCK) for k in range(0, max(count, 1), _BLOCK)]


def _of_rows(
    samples: Samples, rows: slice, part: DatasetPart, lengths: tuple[float, ...], rays: int
) -> np.ndarray:
    """(n, 3) float32 by so many rays: kept, or traced and then kept."""
    x, wi = (np.ascontiguousarray(samples[name][rows]) for name in ("position", "wi"))
    digest = hashlib.sha256(f"{part.dataset.geometry_digest} {lengths} {rays}".encode())
    digest.update(x.data)
    digest.update(wi.data)
    path = nearby_folder(part) / f"{digest.hexdigest()[:32]}.safetensors"
    with suppress(OSError, KeyError, SafetensorError):
        kept = load_file(path)["nearby"]
        if kept.shape == (len(x), len(lengths)):
            return kept.astype(np.float32)
    unit = wi / np.maximum(np.linalg.norm(wi, axis=1, keepdims=True), np.float32(1e-30))
    traced = nearby_light(part.dataset.scene, lengths, x, unit, rays).astype(np.float16)
    with suppress(OSError):  # of a folder that cannot be written
        path.parent.mkdir(exist_ok=True)
        write_arrays(path, {"nearby": traced})
    return traced.astype(np.float32)
