"""A picture as it was rendered, and its facts, for the page."""

import io
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from rna_render.image.film import Film
from rna_render.image.view_transform import to_display
from rna_sdk.files.srgb import decode_srgb, encode_srgb

# Seen where the scene has no background: a little lighter than the page.
BACKDROP_SRGB = 0x2A / 255
# Of less than that, artefacts are seen beside the noise of a few samples.
JPEG_QUALITY = 92


@dataclass(frozen=True)
class Label:
    """Metadata of a picture.

    serial: later pictures have higher ones. revision: of the view that it shows. samples: how
    many it is the mean of, 0 for a first look, with fewer pixels. sample_ms: time of the last one.
    error: why there is no picture.
    """

    serial: int
    revision: int
    samples: int = 0
    sample_ms: float = 0.0
    error: str | None = None


@dataclass(frozen=True)
class Picture:
    """A picture, encoded on first use.

    rgba: (h, w, 4) float32, linear and premultiplied; None after an error. exposure: stops.
    view: see to_display. denoise: what is done to (h, w, 3) float32 radiance before it is shown.
    """

    label: Label
    rgba: np.ndarray | None
    exposure: float
    view: str
    denoise: Callable[[np.ndarray], np.ndarray] | None = None

    @cached_property
    def jpeg(self) -> bytes:
        """JPEG; empty after an error."""
        return self._encoded("JPEG", quality=JPEG_QUALITY, subsampling=0)

    @property
    def png(self) -> bytes:
        """A PNG."""
        return self._encoded("PNG")

    def _encoded(self, kind: str, **options: int) -> bytes:
        from PIL import Image

        if self.rgba is None:
            return b""
        file = io.BytesIO()
        Image.fromarray(self._pixels).save(file, kind, **options)
        return file.getvalue()

    @cached_property
    def _pixels(self) -> np.ndarray:
        """(h, w, 3) uint8, sRGB, over the backdrop."""
        assert self.rgba is not None
        rgb, a = self.rgba[..., :3], self.rgba[..., 3:]
        if self.denoise is not None:
            rgb = self.denoise(rgb)
        if (a == 1).all():
            encoded = to_display(rgb, self.view, self.exposure)
        else:
            # The backdrop is the page's, and goes through no view transform.
            shown = decode_srgb(to_display(rgb, self.view, self.exposure))
            encoded = encode_srgb(
                shown + (1 - a) * decode_srgb(np.asarray(BACKDROP_SRGB, np.float32))
            )
        return np.asarray(np.rint(encoded * 255).astype(np.uint8))


def rgba(film: Film) -> np.ndarray:
    """The film's picture so far, (h, w, 4) float32."""
    channels = film.channels()
    return np.stack([channels[name] for name in "RGBA"], axis=-1)
