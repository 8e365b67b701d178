"""Mixtures of lobes for rays that leave an asset, fitted to its transport (RNA_sampling).

The variance of one ray is the integral of T^2 / pdf less the square of what the point sends. The
integral is convex in the shares of given lobes, so that the shares of lobes of many widths are
found from evaluations of the package itself; `mixtures_by_triangle` finds the triangles that have
a mixture of their own. docs/decisions/renderer.md, "Rays leave assets in a mixture of lobes".
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rna_export.export.sampling_places import Weighted, segments_of
from rna_export.export.sampling_shares import LOBES, fitted_shares, mixture_of
from rna_export.lobes.view_points import PartViews, ViewPoints, part_views
from rna_render.world.neural_sampling import PartLobes
from rna_sdk.package.manifest.extensions import HARMONICS, USUAL_SAMPLING, Mixture, Sampling
from rna_sdk.runtime import Asset, SurfaceAsset, load

_POINTS = 2000
_DIRECTIONS = 6  # of a point, from each lobe


@dataclass(frozen=True, eq=False)
class Scattered:
    """Light that points send to their viewers, from directions that all lobes brought.

    points: n. row: (k,) int64, the directions' points. wi: (k, 3) float32. transport: (k,)
    float64, mean of RGB. densities: (k, lobes) float64, per steradian, of each lobe. sampled: (k,)
    float64, of the directions, per steradian and point.
    """

    points: ViewPoints
    row: NDArray[np.int64]
    wi: NDArray[np.float32]
    transport: NDArray[np.float64]
    densities: NDArray[np.float64]
    sampled: NDArray[np.float64]

    @classmethod
    def of(cls, views: PartViews, rng: np.random.Generator) -> "Scattered":
        """At random points that random viewers see."""
        points, lobes = views.points(_POINTS, rng), LOBES[views.part.kind]
        row = np.tile(np.repeat(np.arange(_POINTS), _DIRECTIONS), len(lobes))
        u = rng.random((len(lobes), _POINTS * _DIRECTIONS, 2))
        u[..., 0] = (u[..., 0] + np.tile(np.arange(_DIRECTIONS), _POINTS)) / _DIRECTIONS
        axis, wo, own = points.axis, points.wo, row[: _POINTS * _DIRECTIONS]
        wi = np.concatenate(
            [
                lobe.everywhere.sample(axis, axis, wo, u_lobe, own)
                for lobe, u_lobe in zip(lobes, u, strict=True)
            ]
        )
        every = [lobe.everywhere.pdf(axis, axis, wo, wi, row) for lobe in lobes]
        densities = np.stack(every, axis=1).astype(np.float64)
        transport = views.transport(points, row, wi).mean(axis=1).astype(np.float64)
        sampled = _DIRECTIONS * densities.sum(axis=1)
        return cls(points, row, wi, transport, densities, sampled)

    @property
    def sent(self) -> NDArray[np.float64]:
        """In a uniform world of radiance 1, by point: (n,)."""
        radiance = self.transport / self.sampled
        return np.bincount(self.row, radiance, len(self.points)).astype(np.float64)

    @property
    def relative(self) -> NDArray[np.float64]:
        """Factors that relate a variance to a point's brightness and to the mean of all: (n,)."""
        sent = self.sent
        relative: NDArray[np.float64] = 1.0 / np.square(sent + sent.mean() + 1e-30)
        return relative

    def noise(self, pdf: NDArray[np.float64]) -> float:
        """Variance of T / pdf of one ray in that world, times `relative`; the points' mean.

        pdf: (k,) of mixtures, in `wi`.
        """
        square = self.transport**2 / (self.sampled * pdf)
        second = np.bincount(self.row, square, len(self.points))
        return float(np.mean((second - np.square(self.sent)) * self.relative))

    def pdf(self, mixtures: tuple[Mixture, ...]) -> NDArray[np.float64]:
        """Density of mixtures of the part in `wi`: (k,)."""
        points = self.points
        lobes = PartLobes.of(mixtures).at(points.primitive)
        pdf = lobes.pdf(points.axis, points.axis, points.wo, self.wi, self.row)
        return pdf.astype(np.float64)


def fitted_sampling(package: Path, say: Callable[[str], None]) -> Sampling | None:
    """Mixtures for the parts of a package, from its default tier; None if nothing is seen of it.

    say: takes a line for each part.
    """
    asset = load(package)
    unread = [_no_visibility(asset, k) for k in range(len(asset.parts))]
    parts = [
        None if views.is_hidden else _fitted(views, say) for views in part_views(asset, unread)
    ]
    return Sampling(parts=tuple(parts)) if any(parts) else None


def _no_visibility(asset: Asset, part: int) -> NDArray[np.int8] | None:
    """In the place of harmonics, which nothing here reads."""
    one = asset.parts[part]
    if isinstance(one, SurfaceAsset):
        return np.zeros((len(one.mesh.positions), HARMONICS), np.int8)
    return None


def _fitted(views: PartViews, say: Callable[[str], None]) -> tuple[Mixture, ...]:
    rng, kind = np.random.default_rng(0), views.part.kind
    triangles = views.part.mesh.triangles if isinstance(views.part, SurfaceAsset) else None
    mixtures = mixtures_by_triangle(Scattered.of(views, rng), triangles)
    unseen, usual = Scattered.of(views, rng), (USUAL_SAMPLING[kind],)
    before, after = (unseen.noise(unseen.pdf(one)) for one in (usual, mixtures))
    say(
        f"{views.part.name}: rays in {len(mixtures)} mixtures of lobes, relative variance "
        f"{after:.3g}; in the mixture of all assets {before:.3g}"
    )
    return mixtures


def mixtures_by_triangle(scattered: Scattered, triangles: np.ndarray | None) -> tuple[Mixture, ...]:
    """Those whose rays vary least; see `Scattered.relative`.

    triangles: (t, 3), of a surface; None for fibers.
    """
    weight = scattered.transport**2 / scattered.sampled * scattered.relative[scattered.row]
    lit = weight > 0.0
    if not lit.any():
        return (Mixture(),)
    data = Weighted(
        scattered.row[lit], weight[lit], scattered.densities[lit], len(scattered.points)
    )
    if triangles is None:
        return (mixture_of("fiber", fitted_shares("fiber", data.weight, data.densities)),)
    segments = segments_of(data, scattered.points.primitive, triangles)
    return tuple(mixture_of("surface", shares, first) for first, shares in segments)
