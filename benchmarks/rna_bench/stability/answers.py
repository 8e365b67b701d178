"""Anything that answers queries, asked in one way: a trained model or a package."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import torch

from rna_export.training.model import NeuralAsset
from rna_sdk.runtime import Asset

Queries = dict[str, np.ndarray]
"""Fields of a sample by name, in the order of `Asset.evaluate`'s arguments; float32."""

Answers = Callable[[Queries], tuple[np.ndarray, np.ndarray]]
"""Queries of n rows -> radiance where the light is visible, and where not, (n, 3) each."""

_NO_QUERY = ("radiance", "direct", "visible", "pixel", "uv")
_ROWS = 65536


def queries_of(samples: dict[str, np.ndarray]) -> Queries:
    """The part of captured samples that is asked."""
    return {name: rows for name, rows in samples.items() if name not in _NO_QUERY}


def picked(answers: Answers, samples: dict[str, np.ndarray]) -> np.ndarray:
    """Radiance (n, 3): of both answers the one that each sample's `visible` calls for."""
    visible, shadowed = answers(queries_of(samples))
    return np.where(samples["visible"].astype(bool)[:, None], visible, shadowed)


def of_package(asset: Asset) -> Answers:
    """A package's, through the runtime."""

    def ask(queries: Queries) -> tuple[np.ndarray, np.ndarray]:
        return asset.evaluate(*(np.ascontiguousarray(v, np.float32) for v in queries.values()))

    return ask


def of_model(model: NeuralAsset) -> Answers:
    """A model's, in PyTorch."""

    @torch.no_grad()
    def ask(queries: Queries) -> tuple[np.ndarray, np.ndarray]:
        count, parts = len(queries["position"]), []
        for first in range(0, count, _ROWS):
            rows = slice(first, first + _ROWS)
            at = {k: torch.from_numpy(np.ascontiguousarray(v[rows])) for k, v in queries.items()}
            parts.append(model.transport(model(at)).numpy())
        both = np.concatenate(parts) if parts else np.zeros((0, 2, 3), np.float32)
        return both[:, 0], both[:, 1]

    return ask
