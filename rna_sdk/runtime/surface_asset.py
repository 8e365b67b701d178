"""A loaded surface, which evaluates transport, emission and lobes."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from rna_sdk.errors import QueryError
from rna_sdk.machine.kernel_threads import at_most
from rna_sdk.package import Mesh
from rna_sdk.package.decoder.query_arrays import Rows
from rna_sdk.runtime.asset import AssetPart
from rna_sdk.runtime.deformation import DeformedMesh, RestMesh

if TYPE_CHECKING:
    from rna_sdk.runtime.base_color import BaseColorMaps


_LEAST_BASE_COLOR = np.float32(0.02)
"""Added to both base colours of a ratio: spec/RNA.md, 12.1, Print."""


class SurfaceAsset(AssetPart):
    """An asset, or one of its parts, whose geometry is a mesh."""

    kind: Literal["surface"]
    _labels: ClassVar[Mapping[str, str]] = {"position": "positions", "axis": "normals"}

    @property
    def mesh(self) -> Mesh:
        """The geometry, object space, metres."""
        assert isinstance(self._geometry, Mesh)
        return self._geometry

    def evaluate(
        self,
        positions: Rows,
        normals: Rows,
        wo: Rows,
        wi: Rows,
        base_color: Rows | None = None,
        out: tuple[Rows, Rows] | None = None,
        nearby: Rows | None = None,
    ) -> tuple[Rows, Rows]:
        """Transport at surface points: radiance towards wo under irradiance 1 from wi.

        positions: metres. normals: of the surface. wo, wi: directions towards the viewer and
        the light, both away from the surface. All (n, 3) float32, object space; n may be 0. Vectors
        are normalised; positions outside the bounds are clamped to them. base_color: (n, 3) float32
        linear RGB, from `base_color_at` or any other; required if `uses_base_color`, ignored
        otherwise. out: two C-contiguous (n, 3) float32 arrays that receive the result and are
        returned, which avoids allocations. nearby: (n, 3) float32, the nearby light of
        `nearby_lengths` along wi (spec/RNA.md, 7.3), or an unbiased estimate of it; None for the
        part's means.

        Returns (visible, shadowed), each (n, 3) float32 linear RGB, finite and non-negative.
        `shadowed` applies where the asset itself blocks the ray from the position along wi,
        `visible` elsewhere. Both include the cosine. A row with NaN or infinity, or with a normal,
        wo or wi of length zero, returns 0. A row's result does not depend on the batch or on the
        number of threads, to the bit.

        Raises:
            QueryError: an argument is not an (n, 3) float32 array, or they differ in n; `out`
                is not writable or not contiguous.

        Examples:
            >>> asset = load("toy.rna")
            >>> x, n = asset.mesh.positions[:100], asset.mesh.normals[:100]
            >>> blue = np.tile(np.float32([0.03, 0.16, 0.65]), (100, 1))  # or of base_color_at
            >>> visible, shadowed = asset.evaluate(x, n, n, n, blue)  # seen, lit from above
            >>> visible.shape
            (100, 3)
        """
        arrays = self._lit(positions, normals, wo, wi, base_color, nearby)
        visible, shadowed = self.decode("transport", arrays, out)
        return visible, shadowed

    def transport(
        self,
        positions: Rows,
        normals: Rows,
        wo: Rows,
        wi: Rows,
        visibility: Rows | NDArray[np.bool_],
        base_color: Rows | None = None,
        nearby: Rows | None = None,
    ) -> Rows:
        """`evaluate`, for hosts that have traced the visibility v: v visible + (1 - v) shadowed.

        visibility: share of the light along wi that the asset itself lets through to the position:
        (n,) bool, or (n,) or (n, 3) float32 from 0 to 1. The others are as for `evaluate`. If the
        tier has a separate decoder for shadowed light, a row costs only the decoders of non-zero
        weight.

        Returns (n, 3) float32 linear RGB, finite and non-negative.

        Raises:
            QueryError: as `evaluate`.

        Examples:
            >>> asset = load("toy.rna")
            >>> x, n = asset.mesh.positions[:100], asset.mesh.normals[:100]
            >>> asset.transport(x, n, n, n, np.ones(100, bool), np.ones_like(x)).shape
            (100, 3)
        """
        arrays = self._lit(positions, normals, wo, wi, base_color, nearby)
        return self._transport(arrays, visibility)

    def _lit(
        self,
        positions: Rows,
        normals: Rows,
        wo: Rows,
        wi: Rows,
        base_color: Rows | None,
        nearby: Rows | None,
    ) -> dict[str, Rows | None]:
        """The arrays of transport, by name."""
        if base_color is None and self.uses_base_color:
            raise QueryError(f"base_color: {self.name} needs it; base_color_at looks it up")
        arrays = {"position": positions, "axis": normals, "wo": wo, "wi": wi}
        return {**arrays, "base_color": base_color, "nearby": nearby}

    @property
    def uses_base_color(self) -> bool:
        """Whether `evaluate` needs the base colour of its points."""
        return bool(self.tier_part.uses_base_color)

    def base_color_at(
        self, primitives: NDArray[np.integer], u: Rows, v: Rows, widths: Rows | float = 0.0
    ) -> Rows:
        """Base colour at ray hits, for `evaluate`: spec/RNA.md, 4.6.

        primitives: (n,) indices of triangles. u, v: (n,) float32, barycentric coordinates of the
        second and third corner. widths: (n,) float32 or one number: the width of a pixel at the
        hit, object space, metres; images are filtered to it, against aliasing. 0: no filter.

        Returns (n, 3) float32 linear RGB, from 0 to 1; 1 where the part has no base colour.

        Raises:
            QueryError: an argument is no such array, or a primitive is not there.
        """
        with at_most(self.threads):
            return self._base_color_maps.at(primitives, u, v, widths)

    def print_detail_at(
        self, primitives: NDArray[np.integer], u: Rows, v: Rows, widths: Rows, base_color: Rows
    ) -> Rows:
        """Factor of the amplitudes of the first half of `lobes`: spec/RNA.md, 12.1, Print.

        It restores detail finer than the texels of the lobes' planes: the base colour at ray hits
        over its mean in such a texel. base_color: (n, 3) float32, returned by `base_color_at` for
        the other arguments.

        Returns (n, 3) float32, 1 where the part has no base colour or no lobes.
        """
        if self.environment_form is None or not self.base_colors:
            return np.ones((len(u), 3), np.float32)
        sides = np.asarray(self.bounds[1]) - self.bounds[0]
        texel = np.float32(sides.max() / self.environment_form.resolution)
        blurred = self.base_color_at(primitives, u, v, np.maximum(widths, texel))
        ratio: Rows = (base_color + _LEAST_BASE_COLOR) / (blurred + _LEAST_BASE_COLOR)
        return ratio

    @cached_property
    def _base_color_maps(self) -> BaseColorMaps:
        from rna_sdk.runtime.base_color import BaseColorMaps

        return BaseColorMaps(self.mesh, self.base_colors)

    def emission(self, positions: Rows, normals: Rows, wo: Rows) -> Rows:
        """Radiance emitted by surface points towards wo, without incident light, W/(m^2 sr).

        Arguments as for `evaluate`. Returns (n, 3) float32 linear RGB, finite and non-negative: 0
        where the part does not emit, and in rows with invalid arguments, as for `evaluate`.

        Raises:
            QueryError: an argument is not an (n, 3) float32 array, or they differ in n.

        Examples:
            >>> asset = load("toy.rna")
            >>> x, n = asset.mesh.positions[:100], asset.mesh.normals[:100]
            >>> bool(asset.emission(x, n, n).any())  # the toy does not glow
            False
        """
        (radiance,) = self.decode("emission", {"position": positions, "axis": normals, "wo": wo})
        return radiance

    def lobes(
        self, positions: Rows, normals: Rows, wo: Rows, free: Rows, visibility: Rows
    ) -> tuple[Rows, Rows]:
        """Lobes at surface points, with which hosts integrate light from a whole environment.

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
        arrays = {"position": positions, "axis": normals, "wo": wo}
        return self._lobe_arguments(arrays, free, visibility)

    def deformed(self, positions: Rows) -> DeformedMesh:
        """A deformed shape of the part: a mesh to trace, which maps its hits back to rest.

        positions: (v, 3) float32, finite, one for each of `mesh.positions`, object space.

        Raises:
            QueryError: `positions` is no such array.

        Examples:
            >>> asset = load("toy.rna")
            >>> bent = asset.mesh.positions.copy()
            >>> bent[:, 0] += bent[:, 1] ** 2
            >>> shape = asset.deformed(bent)  # trace rays against shape.mesh
            >>> first, middle = np.zeros(1, np.int32), np.full(1, 1 / 3, np.float32)
            >>> rest = shape.rest_points(first, middle, middle)
            >>> wo = rest.to_rest(np.float32([[0, 1, 0]]))
            >>> color = asset.base_color_at(first, middle, middle)
            >>> visible, shadowed = asset.evaluate(rest.positions, rest.axes, wo, wo, color)
        """
        return self._rest_mesh.deformed(positions)

    @cached_property
    def _rest_mesh(self) -> RestMesh:
        return RestMesh(self.mesh, self.threads)
