"""Noise taken out of finished images by Intel Open Image Denoise, where it is installed."""

from collections.abc import Mapping
from typing import Literal

import numpy as np

from rna_sdk.errors import SceneError

Quality = Literal["fast", "high"]

INSTALL = "pip install pyoidn"

# Of everything that is hit, since the albedo of a neural asset is not known.
FLAT_ALBEDO = np.float32(0.5)

# Of `blended`, measured: docs/decisions/renderer.md, "Denoised pixels are blended by their errors"
# and "A filter's bias counts beyond its standard error".
_RADIUS = 3  # pixels, of the boxes that errors are averaged over, twice
_DARK = 0.01  # of the image's mean brightness, below which errors are not relative
_UNSEEN = 0.13  # of the brightness there: noise that costs little
_INDEPENDENT = 108  # pixels whose plain mean scatters as much as `_averaged`, of that radius
_CERTAIN = 2.0  # standard errors: a bias within them is taken for noise
_SPECK = 16.0  # times the variance about it, from where a pixel counts by its own
_PREFERENCE = 10.0  # squared bias over squared noise that costs as much: lost texture is seen more

# What Open Image Denoise calls its qualities: oidn.h, OIDNQuality.
QUALITIES: dict[Quality, int] = {"fast": 4, "high": 6}


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

    def __reduce__(self) -> tuple[type["Denoiser"], tuple[int, Quality]]:
        """Made anew in another process."""
        return type(self), (self._threads, self._quality)

    def __call__(
        self, rgb: np.ndarray, normal: np.ndarray | None = None, variance: np.ndarray | None = None
    ) -> np.ndarray:
        """The image without noise, (height, width, 3) float32 as `rgb` is; finite everywhere.

        normal: (height, width, 3) float32, unit, or 0 for background; keeps edges sharp. Its own
        noise is taken out first. variance: (height, width, 3) float32, of `rgb`; what the filter
        changes beyond it is put back, see `blended`. The same whatever the number of threads.
        """
        filtered = self._guided(rgb, normal)
        return filtered if variance is None else blended(rgb, filtered, variance)

    def of_channels(
        self, channels: Mapping[str, np.ndarray], variance: np.ndarray | None
    ) -> np.ndarray:
        """A film's image without noise, from its `channels` and its `variance`."""
        rgb, normal = (
            np.stack([channels[name] for name in names], axis=-1)
            for names in ("RGB", [f"normal.{c}" for c in "XYZ"])
        )
        return self(rgb, normal, variance)

    def _guided(self, rgb: np.ndarray, normal: np.ndarray | None) -> np.ndarray:
        images, flags = {"color": rgb}, {"hdr": True}
        if normal is not None:
            # The filter takes no normals without an albedo: docs/decisions/renderer.md,
            # "Denoising is guided by normals alone".
            covered = np.linalg.norm(normal, axis=-1, keepdims=True) > 0.0
            images["albedo"] = np.where(covered, FLAT_ALBEDO, np.zeros_like(normal))
            images["normal"] = self._filtered({"normal": normal}, {})
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


def blended(rgb: np.ndarray, filtered: np.ndarray, variance: np.ndarray) -> np.ndarray:
    """An image and its filtered form, weighted by their errors: (height, width, 3) float32.

    The square of their difference is the squared bias of the filter, which is lost texture, plus
    the image's variance, (height, width, 3). Both are averaged over a few pixels, and relative to
    the brightness there; a bias within two standard errors of its mean does not count. The filtered
    form counts where the variance is large beside the bias, and large enough to be seen. A speck,
    whose own variance is far above that about it, is taken out by its own.
    """
    brightness = _averaged(filtered.mean(axis=-1, dtype=np.float64))
    scale = 1.0 / (brightness + _DARK * brightness.mean() + np.finfo(np.float32).tiny)[..., None]
    of_pixel = (variance * scale * scale).sum(axis=-1)
    noise = _averaged(of_pixel)
    beyond = np.square((rgb - filtered) * scale).sum(axis=-1) - of_pixel
    lost = _averaged(beyond)
    spread = np.maximum(_averaged(np.square(beyond)) - np.square(lost), 0.0)
    lost -= _CERTAIN * np.sqrt(spread / _INDEPENDENT)
    bias = _PREFERENCE * np.maximum(lost, 0.0) + 3.0 * _UNSEEN**2
    noise = np.where(of_pixel > _SPECK * noise, of_pixel, noise)
    share = (noise / (noise + bias))[..., None]  # of the filtered form
    return np.asarray(rgb + share * (filtered - rgb), np.float32)


def _averaged(image: np.ndarray) -> np.ndarray:
    """Means of (height, width) float64 over a box about each pixel, twice."""
    size = 2 * _RADIUS + 1
    for _ in range(4):  # down, across, down, across
        sums = np.cumsum(np.pad(image, ((_RADIUS + 1, _RADIUS), (0, 0)), "edge"), axis=0)
        image = ((sums[size:] - sums[:-size]) / size).T
    return image
