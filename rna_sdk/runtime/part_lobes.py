"""The lobes of a loaded part (RNA_environment): loaded at their first use."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rna_sdk.arrays import indices, scalars, vectors
from rna_sdk.package import Curves, EnvironmentLobes, Mesh, decoder_from_bytes, query_width
from rna_sdk.package.decoder.query_arrays import Rows, in_order
from rna_sdk.package.manifest.manifest_model import Part

if TYPE_CHECKING:
    from rna_sdk.runtime.engine.tiles import TileEvaluator


class PartLobes:
    """Lobes of one part.

    Attributes:
        record: in the manifest.
        columns: of the visibility that its decoder reads, 16 or 0.
    """

    def __init__(self, lobes: EnvironmentLobes, part: Part, threads: int) -> None:
        self.record = lobes.record
        self.columns = 0 if lobes.harmonics is None else lobes.harmonics.shape[1]
        self._lobes, self._part, self._threads = lobes, part, threads
        self._corners: NDArray[np.uint32] | None = None

    def visibility_at(
        self, geometry: Mesh | Curves, primitives: NDArray[np.integer], u: Rows, v: Rows
    ) -> Rows:
        """Coefficients of the visibility at points of the geometry: (n, columns) float32."""
        from rna_sdk.runtime.kernels.lobe_kernels import mixed_harmonics

        corners = self._corners_of(geometry)
        number = indices("primitives", primitives, len(corners))
        count = len(number)
        u, v = scalars("u", u, count), scalars("v", v, count)
        result = np.empty((count, self.columns), np.float32)
        if self._lobes.harmonics is not None:
            mixed_harmonics(self._lobes.harmonics, corners, number, u, v, result)
        return result

    def _corners_of(self, geometry: Mesh | Curves) -> NDArray[np.uint32]:
        if isinstance(geometry, Mesh):
            return geometry.triangles
        if self._corners is None:
            first = geometry.segments()
            self._corners = np.stack([first, first + 1], axis=1)
        return self._corners

    def evaluate(
        self, arrays: Mapping[str, Rows], free: Rows, visibility: Rows
    ) -> tuple[Rows, Rows]:
        """Amplitudes and axes, (n, L, 3) float32 each; arrays: those of the decoder's form."""
        from rna_sdk.runtime.engine.lobe_batch import LobeBatch

        record, count = self.record, len(arrays["wo"])
        amplitudes, axes = np.empty((2, count, record.lobes, 3), np.float32)
        batch = LobeBatch(
            in_order(arrays),
            (amplitudes, axes),
            scalars("free", free, count),
            vectors("visibility", visibility, count, self.columns),
            query_width(record.inputs, record.channels),
            self._part.kind == "fiber",
        )
        self._evaluator.run(batch)
        return amplitudes, axes

    @cached_property
    def _evaluator(self) -> TileEvaluator:
        from rna_sdk.runtime.engine.decoder_sessions import Decoder
        from rna_sdk.runtime.engine.tiles import QueryFiller, TileEvaluator

        lobes = self._lobes
        filler = QueryFiller(
            lobes.planes, self._part.bounds, lobes.record, self._part.kind, of_lobes=True
        )
        chain = decoder_from_bytes(lobes.decoder, lobes.record.decoder)
        decoder = Decoder(chain, filler.largest_query)
        return TileEvaluator(filler, decoder, self._threads)
