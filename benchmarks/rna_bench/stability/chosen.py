"""A part of a dataset, or one altered, that trains like a dataset of its own."""

from collections.abc import Callable

import numpy as np

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.validation_view import ValidationView

Samples = dict[str, np.ndarray]


class ChosenSamples(DatasetPart):
    """A dataset whose training samples pass through `choose`, and its views through `view`."""

    def __init__(
        self,
        dataset: DatasetPart,
        choose: Callable[[Samples], Samples],
        view: Callable[[ValidationView], ValidationView] = lambda view: view,
    ):
        super().__init__(dataset.dataset, dataset.captured)
        self._choose, self._view_as = choose, view

    def training_samples(self, shards: int | None = None) -> Samples:
        return self._choose(super().training_samples(shards))

    def validation_views(self) -> list[ValidationView]:
        return [self._view_as(view) for view in super().validation_views()]


def rows_of(samples: Samples, rows: np.ndarray) -> Samples:
    """The given rows, by index or mask, of every field."""
    return {name: values[rows] for name, values in samples.items()}


def light_numbers(samples: Samples) -> np.ndarray:
    """Number of each sample's light, (n,) int64; samples of one light are consecutive."""
    changed = np.any(samples["wi"][1:] != samples["wi"][:-1], axis=1)
    return np.concatenate([[0], np.cumsum(changed)])
