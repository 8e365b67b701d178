"""Noise taken out of finished images by Intel Open Image Denoise, where it is installed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from rna_sdk.errors import SceneError

Quality = Literal["fast", "high"]

INSTALL = "pip install pyoidn"

# What Open Image Denoise calls its qualities: oidn.h, OIDNQuality.
QUALITIES: dict[Quality, int] = {"fast": 4, "high": 6}


@dataclass(frozen=True)
class Guides:
    """What tells edges and textures from noise, of each pixel.

    albedo: (height, width, 3) float32 in [0, 1]. normal: (height, width, 3) float32, world space,
    unit or 0.
    """

    albedo: np.ndarray
    normal: np.ndarray

    @classmethod
    def of(cls, channels: Mapping[str, np.ndarray]) -> Guides | None:
        """From Film.channels; None if there is no albedo, without which normals are not taken."""
        if "albedo.R" not in channels:
            return None
        albedo = np.stack([channels[f"albedo.{c}"] for c in "RGB"], axis=-1)
        normal = np.stack([channels[f"normal.{c}"] for c in "XYZ"], axis=-1)
        return cls(albedo, normal)


class Denoiser:
    """Open Image Denoise on the CPU, for linear radiance.

    name: of the filter and its version, for headers.
    """

    def __init__(self, threads: int, quality: Quality = "high") -> None:
        """threads: that it may use. quality: fast takes half the time, for previews.

        Raises SceneError if it is not installed or does not start.
        """
        try:
            import pyoidn

            self._device = pyoidn.Device()
        except ImportError as error:
            message = f"denoising needs Intel Open Image Denoise: {INSTALL}"
            raise SceneError(message) from error
        except OSError as error:
            raise SceneError(f"Intel Open Image Denoise cannot be loaded: {error}") from error
        self._oidn, self._threads, self._quality = pyoidn, threads, quality
        self._device.set_int("numThreads", threads)
        self._device.commit()
        self._check()
        version = self._device.get_int("version")  # 20501 for 2.5.1
        numbers = f"{version // 10000}.{version // 100 % 100}.{version % 100}"
        self.name = f"Intel Open Image Denoise {numbers}"

    def __reduce__(self) -> tuple[type[Denoiser], tuple[int, Quality]]:
        """Made anew in another process."""
        return type(self), (self._threads, self._quality)

    def __call__(self, rgb: np.ndarray, guides: Guides | None = None) -> np.ndarray:
        """The image without noise, (height, width, 3) float32 as `rgb` is; finite everywhere.

        guides: their noise is taken out first, so that none of it enters the image. The same
        whatever the number of threads.
        """
        images, flags = {"color": rgb}, {"hdr": True}
        if guides is not None:
            for name, guide in (("albedo", guides.albedo), ("normal", guides.normal)):
                images[name] = self._filtered({name: guide}, {})
            flags["cleanAux"] = True
        return self._filtered(images, flags)

    def _filtered(self, images: Mapping[str, np.ndarray], flags: Mapping[str, bool]) -> np.ndarray:
        """The filter's output for these images, (height, width, 3) each."""
        oidn = self._oidn
        held = {name: np.ascontiguousarray(image, np.float32) for name, image in images.items()}
        result = held["output"] = np.empty_like(next(iter(held.values())))
        ray_tracing = oidn.Filter(self._device, oidn.OIDN_FILTER_TYPE_RT)
        # No `with`: pyoidn's swallows every exception.
        try:
            for name, image in held.items():
                ray_tracing.set_image(name, image, oidn.OIDN_FORMAT_FLOAT3)
            for name, flag in flags.items():
                ray_tracing.set_bool(name, flag)
            ray_tracing.set_int("quality", QUALITIES[self._quality])
            ray_tracing.commit()
            ray_tracing.execute()
            self._check()
        finally:
            ray_tracing.release()
        return result

    def _check(self) -> None:
        message = self._device.get_error()
        if message is not None:
            raise SceneError(f"Intel Open Image Denoise: {message}")
