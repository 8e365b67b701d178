"""Error of lobes against the whole integral of transport and environment."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import torch
from numpy.typing import NDArray

from rna_export.lobes.bright_directions import cell_directions, split_environment
from rna_export.lobes.lobe_model import densities
from rna_export.lobes.view_points import Grid, LobesAt, PartViews, Rows, ViewPoints
from rna_export.metrics import IRRADIANCE, flip, psnr
from rna_sdk.package import EnvironmentValidation
from rna_sdk.runtime import FiberAsset

_VIEWERS = 4  # about the vertical
_AT_ONCE = 20  # points
_SHOWN = 0.95  # part of the values that an exposure shows below white


def generated_environments() -> dict[str, np.ndarray]:
    """Texels (64, 128, 3) float32 by name: a sky that is nowhere far brighter, and a dark studio.

    Neither has been seen by training, which knows no environment at all.
    """
    theta, phi = (np.arange(64) + 0.5) / 64 * np.pi, (np.arange(128) + 0.5) / 128 * 2 * np.pi
    y, x, z = np.broadcast_arrays(
        np.cos(theta)[:, None],
        np.sin(theta)[:, None] * np.cos(phi),
        np.sin(theta)[:, None] * np.sin(phi),
    )
    d = np.stack([x, y, z], axis=-1)

    def softbox(towards: tuple[float, float, float], sharpness: float) -> np.ndarray:
        axis = np.asarray(towards) / np.linalg.norm(towards)
        return np.asarray(np.exp(sharpness * (d @ axis - 1.0))[..., None])

    above = np.clip(y + 0.1, 0.0, 1.0)[..., None] ** 0.5
    sky = above * (0.5, 0.7, 1.0) + 1.5 * softbox((0.6, 0.5, 0.4), 8.0) * (1.0, 0.9, 0.7)
    sky += np.where(y < 0.0, 0.25, 0.0)[..., None] * (0.8, 0.7, 0.5)
    studio = 0.05 + 12.0 * softbox((0.8, 0.6, 0.3), 200.0) + 6.0 * softbox((-0.9, 0.2, 0.2), 80.0)
    studio = studio + 3.0 * softbox((0.0, 0.4, -1.0), 60.0) * (0.6, 0.8, 1.0)
    return {"generated-sky": sky.astype(np.float32), "generated-studio": studio.astype(np.float32)}


@dataclass(frozen=True, eq=False)
class LobePictures:
    """Four pictures of an asset under e environments, the lobes' beside the whole integral's.

    names: of the environments. size: pixels of a side. pixel: (n,) int64, where points are, all
    pictures one after the other. truth, lobes, both: (e, n, 3) float32, the whole integral; lobes
    alone; and lobes with what is bright evaluated by the transport.
    """

    names: list[str]
    size: int
    pixel: NDArray[np.int64]
    truth: np.ndarray
    lobes: np.ndarray
    both: np.ndarray

    def of_pixels(self) -> "LobePictures":
        """The same with the mean over each pixel in place of its points."""
        pixel, place = np.unique(self.pixel, return_inverse=True)
        order = np.argsort(place, kind="stable")
        start = np.searchsorted(place[order], np.arange(len(pixel)))
        count = np.bincount(place)[:, None]
        truth, lobes, both = (
            np.add.reduceat(result[:, order], start, axis=1) / count
            for result in (self.truth, self.lobes, self.both)
        )
        return LobePictures(self.names, self.size, pixel, truth, lobes, both)

    def errors(self) -> list[EnvironmentValidation]:
        """Errors of each environment, in order.

        Scored at the exposure that shows 95% of the values of the truth below white.
        """
        return [self._error(k) for k in range(len(self.names))]

    def _error(self, k: int) -> EnvironmentValidation:
        truth, lobes, both = self.truth[k], self.lobes[k], self.both[k]
        exposure = float(1 / max(np.quantile(truth, _SHOWN), 1e-12)) / IRRADIANCE  # white is 1
        pixels = np.zeros((2, _VIEWERS * self.size * self.size, 3), np.float32)
        pixels[:, self.pixel] = truth, both
        reference, image = pixels.reshape(2, -1, self.size, 3)
        r, g, b = (both.mean(axis=0) / np.maximum(truth.mean(axis=0), 1e-12)).tolist()
        return EnvironmentValidation(
            environment=self.names[k],
            psnr=psnr(lobes, truth, exposure),
            psnr_with_lights=psnr(both, truth, exposure),
            flip=flip(image, reference, exposure)[0],
            brightness=(r, g, b),
        )


def grid_of(parts: Sequence[tuple[PartViews, LobesAt]]) -> Grid:
    """Rays of the pictures that an asset is measured in.

    Strands are thinner than pixels, so theirs are means, of 4 x 4 points, over pixels as of a
    picture of 256 squared.
    """
    if any(isinstance(views.part, FiberAsset) for views, _ in parts):
        return Grid(10, rays=4, finest=256)
    return Grid(32)


def lobe_pictures(
    parts: Sequence[tuple[PartViews, LobesAt]],
    environments: Mapping[str, np.ndarray],
    grid: Grid,
    advance: Callable[[float], None] = lambda share: None,
) -> LobePictures:
    """Points of four small pictures of parts of an asset, under each environment.

    environments: texels (h, w, 3) by name. The whole integral is the sum over 8,192 cells of equal
    solid angle. advance: takes shares of all that is done.
    """
    splits = [split_environment(texels) for texels in environments.values()]
    cells = cell_directions().astype(np.float32)
    rest = np.stack([split.rest.reshape(-1, 3) for split in splits])
    whole = rest / np.stack([split.share.reshape(-1, 1) for split in splits])
    places, result = [], []
    for viewer in range(_VIEWERS):
        for views, lobes_at in parts:
            points, pixel = views.picture(2 * np.pi * (viewer + 0.3) / _VIEWERS, grid)
            places.append(pixel + viewer * grid.size**2)
            lobes = _lobe_light(*lobes_at(points), cells, np.stack([whole, rest]))
            lit = [_light(views, points, s.directions, s.flux[None])[0] for s in splits]
            truth = _light(views, points, cells, whole)
            result.append(np.stack([truth, lobes[0], lobes[1] + np.stack(lit)]))
            advance(1 / _VIEWERS / len(parts))
    pictures = np.concatenate(result, axis=2)
    return LobePictures(list(environments), grid.size, np.concatenate(places), *pictures)


def _light(views: PartViews, points: ViewPoints, d: np.ndarray, flux: np.ndarray) -> np.ndarray:
    """Sum of the transport along k directions, in flux (e, k, 3): (e, n, 3)."""
    result = [np.zeros((len(flux), 0, 3), np.float32)]
    for start in range(0, len(points), _AT_ONCE):
        row = np.arange(start, min(start + _AT_ONCE, len(points)))
        transport = views.transport(
            points, np.repeat(row, len(d)), np.tile(d.astype(np.float32), (len(row), 1))
        ).reshape(len(row), -1, 3)
        result.append(np.einsum("nkc,ekc->enc", transport, flux))
    return np.concatenate(result, axis=1)


def _lobe_light(amplitude: Rows, axis: Rows, d: np.ndarray, flux: np.ndarray) -> np.ndarray:
    """Light of lobes under flux (..., k, 3) along k directions: (..., n, 3)."""
    along = torch.from_numpy(d.T)[None]
    result = [np.zeros((*flux.shape[:-2], 0, 3), np.float32)]
    for start in range(0, len(axis), _AT_ONCE):
        part = slice(start, start + _AT_ONCE)
        density = densities(torch.from_numpy(axis[part]), along).numpy()
        mean = np.einsum("nlk,...kc->...nlc", density, flux, optimize=True)
        result.append(np.einsum("...nlc,nlc->...nc", mean, amplitude[part]))
    return np.concatenate(result, axis=-2)
