"""A picture, judged pixel by pixel: FLIP, the object in each pixel, outlines."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rna_export.asset_flip import COVERED, ImageFlip, without_noise
from rna_export.capture.dataset.validation_view import CapturedImage
from rna_export.metrics import reduced
from rna_export.outcome.triangle_materials import TriangleMaterials
from rna_export.training.asset_error import image_flip, picture_exposures, smallest_factor


@dataclass(frozen=True)
class JudgedImage:
    """A lit picture; maps are (h, w), square, and 0 where `asset` is not.

    name: in words. exposure: that FLIP is of. asset: bool, whether a pixel shows the asset.
    material: int32, numbers of `TriangleMaterials.names`, -1 for none. ours, halves: radiance,
    (h, w, 3) and (2, h, w, 3), of the model and of two independent references. errors: FLIP against
    the mean of both, noisier: (2, h, w), against each.
    """

    name: str
    exposure: float
    asset: np.ndarray
    material: np.ndarray
    ours: np.ndarray
    halves: np.ndarray
    errors: np.ndarray
    noisier: np.ndarray

    @classmethod
    def of(
        cls,
        rows: np.ndarray,
        view: CapturedImage,
        exposure: float,
        factor: int,
        materials: TriangleMaterials,
    ) -> "JudgedImage":
        """Image of a view's shaded rows (n, 3), in pixels of `factor` x `factor` of the image's."""
        flip = image_flip(rows, view, exposure, factor)
        shown, ours, *halves = (
            reduced(view.image(of), factor) for of in (np.ones_like(rows), rows, *view.halves)
        )
        # Of strands a pixel is several rays, of which one tells the material.
        number = view.image(np.repeat(materials.of_image(view)[:, None] + 1.0, 3, axis=1))[..., 0]
        middle = number[factor // 2 :: factor, factor // 2 :: factor]
        material = middle[: len(ours), : len(ours)].astype(np.int32) - 1
        name = f"validation image {view.index}"
        return cls.of_picture(name, exposure, ours, np.stack(halves), shown[..., 0], flip, material)

    @classmethod
    def of_picture(
        cls,
        name: str,
        exposure: float,
        ours: np.ndarray,
        halves: np.ndarray,
        covered: np.ndarray,
        flip: ImageFlip,
        material: np.ndarray | None = None,
    ) -> "JudgedImage":
        """covered: (h, w), the asset's share of each pixel. flip: of the picture."""
        asset = covered >= COVERED
        return cls(
            name=name,
            exposure=exposure,
            asset=asset,
            material=np.full(asset.shape, -1)
            if material is None
            else np.where(asset, material, -1),
            ours=ours,
            halves=halves,
            errors=_map(asset, flip.errors),
            noisier=np.stack([_map(asset, half) for half in flip.noisier.reshape(2, -1)]),
        )

    @property
    def flip(self) -> ImageFlip:
        """FLIP of the asset's pixels."""
        return ImageFlip(self.errors[self.asset], self.noisier[:, self.asset].ravel())

    @property
    def reference(self) -> np.ndarray:
        """Radiance (h, w, 3) of Cycles."""
        return np.asarray(self.halves.mean(axis=0))

    @property
    def outline(self) -> np.ndarray:
        """(h, w) bool, the asset's pixels beside one that shows nothing of it."""
        padded = np.pad(self.asset, 1, constant_values=True)
        inside = padded[:-2, 1:-1] & padded[2:, 1:-1] & padded[1:-1, :-2] & padded[1:-1, 2:]
        return np.asarray(self.asset & ~inside)

    def square(self, share: float) -> int:
        """Pixels along a square of this share of the picture's side: an odd number, 3 at least."""
        return 2 * max(1, round(0.5 * share * len(self.asset) - 0.5)) + 1

    def nearby_error(self, share: float) -> np.ndarray:
        """(h, w), FLIP without noise of the asset's pixels in a square around each of them.

        0 where fewer than half of the square's pixels show the asset. share: see `square`.
        """
        side = self.square(share)
        count = box_sum(self.asset, side)
        each = [
            box_sum(error, side) / np.maximum(count, 1) for error in (self.errors, *self.noisier)
        ]
        errors = without_noise(each[0], (each[1] + each[2]) / 2.0)
        return np.where(self.asset & (2 * count >= side**2), errors, 0.0)


def judged_images(
    radiance: Sequence[np.ndarray], views: Sequence[CapturedImage], materials: TriangleMaterials
) -> list[JudgedImage]:
    """The lit ones of a set, whose shaded rows are (n, 3) each."""
    factor = smallest_factor(views)
    every = zip(radiance, views, picture_exposures(views), strict=True)
    return [JudgedImage.of(r, v, e.factor, factor, materials) for r, v, e in every if e.is_lit]


def box_sum(values: np.ndarray, side: int) -> np.ndarray:
    """Sums (h, w) over the square of `side` pixels, odd, around each pixel of (h, w); all >= 0."""
    ahead = side // 2
    padded = np.pad(values.astype(np.float64), (ahead + 1, ahead))
    sums = padded.cumsum(axis=0).cumsum(axis=1)
    of_squares = sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side]
    return np.asarray(np.maximum(of_squares + sums[:-side, :-side], 0.0))


def _map(asset: np.ndarray, values: np.ndarray) -> np.ndarray:
    result = np.zeros(asset.shape, np.float32)
    result[asset] = values
    return result
