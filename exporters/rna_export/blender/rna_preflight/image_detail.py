"""How fine the details of an image are that can be seen: where the energy of its spectrum ends."""

import bpy
import numpy as np

_SEEN = 0.1  # of the energy: what is finer than this share hardly shows
_BLOCK, _BLOCKS = 256, 4  # texels a side; blocks along each side
_LARGEST = 4096 * 4096  # texels: the spectrum of larger images is not read


def period(image: bpy.types.Image, of_slopes: bool) -> float:
    """From one detail of an image to the next, the image being 1 long; infinite without details.

    Nine tenths of the variance, of the image or of its slopes, are coarser. Two texels where
    the image cannot be read.
    """
    width, height = image.size
    if image.source == "TILED" or not 0 < width * height <= _LARGEST:
        return 2.0 / float(max(width, height, 1))
    values = np.empty(4 * width * height, np.float32)
    image.pixels.foreach_get(values)
    if image.source == "FILE" and not image.is_dirty:
        image.buffers_free()
    texels = values.reshape(height, width, 4)
    grey = texels[..., :3].mean(axis=2)
    return finest(grey if np.ptp(grey) > 0.0 else texels[..., 3], of_slopes)


def finest(grey: np.ndarray, of_slopes: bool) -> float:
    """`period` of texels (h, w)."""
    height, width = grey.shape
    high, wide = min(height, _BLOCK), min(width, _BLOCK)
    window = np.hanning(high + 2)[1:-1, None] * np.hanning(wide + 2)[1:-1]
    power = np.zeros((high, wide))
    for y in np.linspace(0, height - high, _BLOCKS).astype(int):
        for x in np.linspace(0, width - wide, _BLOCKS).astype(int):
            block = grey[y : y + high, x : x + wide].astype(np.float64)
            power += np.abs(np.fft.fft2(window * (block - block.mean()))) ** 2
    power /= _BLOCKS**2 * high * wide * (window**2).sum()  # its sum is the variance
    rows, columns = np.fft.fftfreq(high)[:, None] * height, np.fft.fftfreq(wide) * width
    waves = np.hypot(rows, columns)  # a length of the image
    total = float(grey.astype(np.float64).var())
    if of_slopes:
        power *= waves**2
        total = float(power.sum())
    if total <= 0.0:
        return np.inf
    order = np.argsort(-waves, axis=None)
    reached = np.cumsum(power.ravel()[order]) >= _SEEN * total
    wave = waves.ravel()[order[reached.argmax()]] if reached.any() else 0.0
    return float(1.0 / wave) if wave > 0.0 else np.inf
