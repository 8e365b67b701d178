"""Queries of the form `environment` at points of a part."""

from typing import NamedTuple

import numpy as np

from rna_export.lobes.view_points import Rows, ViewPoints
from rna_sdk.package import Package, query_width
from rna_sdk.runtime.engine.batch import Batch
from rna_sdk.runtime.engine.tiles import QueryFiller


class LobeInputs(NamedTuple):
    """Inputs of lobes: queries (n, K); wide, mirror (n, 3) and free (n,), of ViewPoints."""

    queries: Rows
    wide: Rows
    mirror: Rows
    free: Rows


class QueryRows:
    """Makes the decoder's queries for a part: blocks of inputs, then the visibility.

    Attributes:
        inputs: names of the blocks: those of transport, wi being the mirror direction.
        columns: K, of blocks and visibility.
    """

    def __init__(self, package: Package, tier: str, part: int, visibility_columns: int) -> None:
        """package: open. visibility_columns: of ViewPoints.visibility, or 0 to leave it out."""
        tier_part, record = package.tier(tier).parts[part], package.manifest.parts[part]
        planes = package.planes(tier, part)
        self._filler = QueryFiller(planes, record.bounds, tier_part, record.kind, of_lobes=True)
        self._blocks = query_width(tier_part.inputs, tier_part.channels)
        self._visibility = visibility_columns
        self.inputs, self.columns = tier_part.inputs, self._blocks + visibility_columns

    def of(self, points: ViewPoints) -> LobeInputs:
        """The inputs of points."""
        arrays = {"position": points.position, "axis": points.axis, "h": points.h}
        batch = Batch.of(arrays | {"wo": points.wo, "wi": points.mirror}, ())
        blocks = np.zeros((len(points), self._blocks), np.float32)
        self._filler.fill(batch, slice(None), blocks, np.empty(len(points), np.bool_))
        queries = np.hstack([blocks, points.visibility[:, : self._visibility]])
        return LobeInputs(queries, points.wide, points.mirror, points.free)
