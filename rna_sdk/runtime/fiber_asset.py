"""Loaded fibers, which evaluate transport, emission and lobes."""

from collections.abc import Mapping
from functools import cached_property
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package import Curves
from rna_sdk.package.decoder.query_arrays import Rows
from rna_sdk.runtime.asset import AssetPart
from rna_sdk.runtime.deformation import DeformedCurves, RestCurves


class FiberAsset(AssetPart):
    """An asset, or one of its parts, whose geometry is curves: hair, fur, fibers of cloth."""

    kind: Literal["fiber"]
    _labels: ClassVar[Mapping[str, str]] = {"position": "positions", "axis": "tangents"}

    @property
    def curves(self) -> Curves:
        """The geometry, object space, metres."""
        assert isinstance(self._geometry, Curves)
        return self._geometry

    def evaluate(
        self,
        positions: Rows,
        tangents: Rows,
        h: Rows,
        wo: Rows,
        wi: Rows,
        out: tuple[Rows, Rows] | None = None,
        nearby: Rows | None = None,
    ) -> tuple[Rows, Rows]:
        """Transport at points of fibers: radiance towards wo under irradiance 1 from wi.

        positions: metres. tangents: along the fiber, from root to tip. h: (n,) float32, offset
        across the fiber's width of the ray towards wo, from -1 to 1 as returned by
        `offset_across`; values outside are clamped. wo, wi: directions towards the viewer and the
        light, both away from the fiber. All but h (n, 3) float32, object space; n may be 0.
        Vectors are normalised; positions outside the bounds are clamped to them. out: two
        C-contiguous (n, 3) float32 arrays that receive the result and are returned, which avoids
        allocations. nearby: (n, 3) float32, the nearby light of `nearby_lengths`
        along wi (spec/RNA.md, 7.3), or an unbiased estimate of it; None for the part's means.

        Returns (visible, shadowed), each (n, 3) float32 linear RGB, finite and non-negative.
        `shadowed` applies where the asset itself blocks the ray from the position along wi,
        `visible` elsewhere. Both include the cosine. A row with NaN or infinity, or with a tangent,
        wo or wi of length zero, returns 0. A row's result does not depend on the batch or on the
        number of threads, to the bit.

        Raises:
            QueryError: an argument is not a float32 array of its shape, or they differ in n;
                `out` is not writable or not contiguous.

        Examples:
            >>> hair = load("curls.rna")
            >>> root = hair.curves.segments()[:100]
            >>> x, tip = hair.curves.points[root], hair.curves.points[root + 1]
            >>> wo = wi = np.tile(np.float32([0, 1, 0]), (100, 1))
            >>> h = np.zeros(100, np.float32)  # in the middle of the fiber, as seen along wo
            >>> visible, shadowed = hair.evaluate(x, tip - x, h, wo, wi)
            >>> visible.shape
            (100, 3)
        """
        arrays = self._lit(positions, tangents, h, wo, wi, nearby)
        visible, shadowed = self.decode("transport", arrays, out)
        return visible, shadowed

    def transport(
        self,
        positions: Rows,
        tangents: Rows,
        h: Rows,
        wo: Rows,
        wi: Rows,
        visibility: Rows | NDArray[np.bool_],
        nearby: Rows | None = None,
    ) -> Rows:
        """`evaluate`, for hosts that have traced the visibility v: v visible + (1 - v) shadowed.

        visibility: share of the light along wi that the asset, without the strand itself, lets
        through to the position: (n,) bool, or (n,) or (n, 3) float32 from 0 to 1. The others are as
        for `evaluate`. If the tier has a separate decoder for shadowed light, a row costs only the
        decoders of non-zero weight.

        Returns (n, 3) float32 linear RGB, finite and non-negative.

        Raises:
            QueryError: as `evaluate`.
        """
        return self._transport(self._lit(positions, tangents, h, wo, wi, nearby), visibility)

    def _lit(
        self, positions: Rows, tangents: Rows, h: Rows, wo: Rows, wi: Rows, nearby: Rows | None
    ) -> dict[str, Rows | None]:
        """The arrays of transport, by name."""
        arrays = {"position": positions, "axis": tangents, "h": h, "wo": wo, "wi": wi}
        return {**arrays, "nearby": nearby}

    def emission(self, positions: Rows, tangents: Rows, h: Rows, wo: Rows) -> Rows:
        """Radiance emitted by points of fibers towards wo, without incident light, W/(m^2 sr).

        Arguments as for `evaluate`. Returns (n, 3) float32 linear RGB, finite and non-negative: 0
        where the part does not emit, and in rows with invalid arguments, as for `evaluate`.

        Raises:
            QueryError: an argument is not a float32 array of its shape, or they differ in n.

        Examples:
            >>> hair = load("curls.rna")
            >>> root = hair.curves.segments()[:100]
            >>> x, tip = hair.curves.points[root], hair.curves.points[root + 1]
            >>> wo, h = np.tile(np.float32([0, 1, 0]), (100, 1)), np.zeros(100, np.float32)
            >>> bool(hair.emission(x, tip - x, h, wo).any())
            False
        """
        arrays = {"position": positions, "axis": tangents, "h": h, "wo": wo}
        (radiance,) = self.decode("emission", arrays)
        return radiance

    def lobes(
        self, positions: Rows, tangents: Rows, h: Rows, wo: Rows, free: Rows, visibility: Rows
    ) -> tuple[Rows, Rows]:
        """Lobes at points of fibers, with which hosts integrate light from a whole environment.

        free: (n,) float32, the asset's own visibility along `mirror`, 0 to 1 (the mean of RGB).
        visibility: from `visibility_at`. The others are as for `evaluate`.

        Returns (amplitudes, axes), (n, L, 3) float32 each. With kappa = |axis|, at least 0.01, the
        radiance towards wo is the sum over lobes of amplitude (RGB) times the mean of the
        environment under the von Mises-Fisher distribution of direction axis / kappa and
        concentration kappa. Amplitudes are finite and non-negative. Rows with NaN, infinity or a
        direction of length zero return 0.

        Raises:
            QueryError: an argument is not a float32 array of its shape, or they differ in n; the
                part has no lobes (`environment_form` is None).
        """
        arrays = {"position": positions, "axis": tangents, "h": h, "wo": wo}
        return self._lobe_arguments(arrays, free, visibility)

    def deformed(self, points: Rows) -> DeformedCurves:
        """A deformed shape of the part: strands to trace, which map their hits back to rest.

        points: (p, 3) float32, finite, one for each of `curves.points`, object space.

        Raises:
            QueryError: `points` is no such array.
        """
        return self._rest_curves.deformed(points)

    @cached_property
    def _rest_curves(self) -> RestCurves:
        return RestCurves(self.curves, self.threads)
