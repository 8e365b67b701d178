"""Batches of emission samples, beside those of transport."""

from collections.abc import Iterator
from dataclasses import dataclass

from torch import Tensor

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.training.model.emission import EmissionDecoder
from rna_export.training.model.triplane import Triplane
from rna_export.training.optimization.losses import unbiased_l2
from rna_export.training.optimization.samples import SampleTable, columns

SHARE = 2  # a step has half as many samples of emission as of transport


@dataclass
class EmissionBatches:
    """Endless random batches of a part's samples of emission, on the device."""

    table: SampleTable
    rows: Iterator[Tensor]

    @classmethod
    def of(
        cls, part: DatasetPart, batch: int, seed: int, device: str, done: int
    ) -> "EmissionBatches":
        """Without the first `done`: a stopped run saw them."""
        table = SampleTable(part.emission_samples(), batch // SHARE, seed, device, done)
        return cls(table, iter(table))

    def loss(
        self, rows: Tensor, emission: EmissionDecoder, triplane: Triplane, blur: float | Tensor
    ) -> Tensor:
        """Loss of a batch; relative, so that noise does not bias it."""
        at = columns(rows, self.table.fields)
        y = emission(triplane, at, blur)
        return unbiased_l2(y, at["radiance"], emission.unit)
