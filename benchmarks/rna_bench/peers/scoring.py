"""Errors of rendered views."""

from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from rna_bench.peers.views import PeerCamera, Views
from rna_export.metrics import FLIP_DEFINITION, IRRADIANCE, exposure_of, flip, psnr
from rna_sdk.errors import SceneError

DEFINITIONS = {
    "psnr": "PSNR of linear radiance times the exposure, clamped to [0, 1], over pixels that the "
    "asset covers in part at least; mean over images",
    "psnr_everywhere": "the same over all pixels",
    "flip": FLIP_DEFINITION,
}


@dataclass(frozen=True)
class Scores:
    """See `DEFINITIONS`; means, and each image's PSNR."""

    psnr: float
    psnr_everywhere: float
    flip: float
    each: tuple[float, ...]

    def as_json(self) -> dict[str, Any]:
        """Rounded."""
        return {k: np.round(v, 4).tolist() for k, v in asdict(self).items()}


@dataclass(frozen=True)
class HeldOut:
    """Views that no method is trained on, and the exposure that they are scored at."""

    views: Views
    exposure: float

    @classmethod
    def of(cls, views: Views) -> "HeldOut":
        covered = [image[image[..., 3] > 0.0][:, :3] / IRRADIANCE for image in views.rgba]
        return cls(views, exposure_of(covered))

    def cameras(self) -> list[tuple[PeerCamera, np.ndarray]]:
        """Camera and light of each view."""
        return [(self.views.camera(k), self.views.lights[k]) for k in range(len(self.views))]

    def score(self, images: list[np.ndarray]) -> Scores:
        """Scores of the images (h, w, 3) of all views."""
        rows, flips = [], []
        for image, reference in zip(images, self.views.rgba, strict=True):
            ours, theirs = image / IRRADIANCE, reference[..., :3] / IRRADIANCE
            covered = reference[..., 3] > 0.0
            of_asset = psnr(ours[covered], theirs[covered], self.exposure)
            everywhere = psnr(ours.reshape(-1, 3), theirs.reshape(-1, 3), self.exposure)
            rows.append((of_asset, everywhere))
            flips.append(flip(ours, np.ascontiguousarray(theirs), self.exposure)[0])
        mean = np.mean(rows, axis=0)
        each = tuple(row[0] for row in rows)
        return Scores(float(mean[0]), float(mean[1]), float(np.mean(flips)), each)


def reduced(views: Views, size: int) -> Views:
    """Images averaged over blocks to `size` pixels a side, without depth.

    Raises SceneError where it does not divide the side.
    """
    width, height = views.size
    if width != height or width % size:
        raise SceneError(f"--size {size}: expected one that divides {width} x {height} pixels")
    blocks = views.rgba.reshape(len(views), size, width // size, size, width // size, 4)
    return replace(views, rgba=blocks.mean(axis=(2, 4), dtype=np.float32), depth=None)
