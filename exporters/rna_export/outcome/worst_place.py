"""Where a model is furthest from Cycles, and a picture of it."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_export.outcome.judged_image import JudgedImage
from rna_export.pictures import Picture, comparison_sheet, pictures_of, write_picture
from rna_render.lights import LUMINANCE

_PLACE = 9 / 64  # of an image's side: the square that is a place
_SHOWN = 0.5  # likewise: what is shown around it
_WIDTH = 256  # of each picture, about
_FRAME = (255, 0, 200)
_SAME, _MUCH = 1.25, 10.0  # ratios of light: about equal, and beyond telling


@dataclass(frozen=True)
class WorstPlace:
    """A square in a lit image, a seventh as wide.

    row, column: of its middle. name: of the material that most of it shows. flip: its mean, without
    noise. light: its luminance over Cycles'.
    """

    image: JudgedImage
    row: int
    column: int
    name: str
    flip: float
    light: float

    @classmethod
    def of(cls, images: Sequence[JudgedImage], names: Sequence[str]) -> "WorstPlace | None":
        """That of all images; None where none shows the asset. names: of materials."""
        found: list[tuple[float, JudgedImage, int, int]] = []
        for image in images:
            errors = image.nearby_error(_PLACE)
            row, column = (int(k) for k in np.unravel_index(errors.argmax(), errors.shape))
            found.append((float(errors[row, column]), image, row, column))
        worst = max(found, key=lambda one: one[0], default=None)
        if worst is None or worst[0] == 0.0:
            return None
        flip, image, row, column = worst
        square = _around(row, _PLACE, image), _around(column, _PLACE, image)
        material, asset = image.material[square], image.asset[square]
        numbers = material[asset & (material >= 0)]
        ours, cycles = (
            float((light[square] @ LUMINANCE)[asset].sum())
            for light in (image.ours, image.reference)
        )
        return cls(
            image=image,
            row=row,
            column=column,
            name=names[int(np.bincount(numbers).argmax())] if len(numbers) else "",
            flip=flip,
            light=ours / max(cycles, 1e-12),
        )

    @property
    def text(self) -> str:
        """In words."""
        on = f", {self.name!r}" if self.name else ""
        return f"worst place: {self.image.name}{on}, FLIP {self.flip:.2f}, {self._light_text}"

    @property
    def _light_text(self) -> str:
        if 1.0 / _SAME <= self.light <= _SAME:
            return "as bright as Cycles' but of another colour or pattern"
        if self.light < 1.0 / _MUCH:
            return "missing"
        if self.light < 1.0:
            return f"{self.light:.0%} of Cycles' light"
        return f"{min(self.light, _MUCH):.1f} times Cycles' light"

    def write(self, path: Path) -> None:
        """A PNG: the place, and below the image that it is in; ours, Cycles, difference, FLIP."""
        image, side = self.image, len(self.image.asset)
        rows, columns = (_around(at, _SHOWN, image) for at in (self.row, self.column))
        pictures = pictures_of(
            np.ascontiguousarray(image.ours, np.float32),
            np.ascontiguousarray(image.reference, np.float32),
            image.exposure,
        )
        each = max(1, round(_WIDTH / side))
        whole = [_framed(_scaled(p, each * side), rows, columns, side) for p in pictures]
        crops = [_scaled(picture[rows, columns], each * side) for picture in pictures]
        captions = self.text, f"{image.name}, whole"
        write_picture(path, comparison_sheet(list(zip((crops, whole), captions, strict=True))))


def _around(middle: int, share: float, image: JudgedImage) -> slice:
    """A share of the image's side around a pixel, moved into the image."""
    side, length = len(image.asset), image.square(share)
    first = min(max(middle - length // 2, 0), max(side - length, 0))
    return slice(first, min(first + length, side))


def _scaled(picture: Picture, side: int) -> Picture:
    """The square picture with so many pixels along a side, each the nearest of its own."""
    at = np.arange(side) * len(picture) // side
    return np.ascontiguousarray(picture[at][:, at])


def _framed(picture: Picture, rows: slice, columns: slice, side: int) -> Picture:
    """The picture with a frame around some of the `side` pixels that it had."""
    times = len(picture) // side
    top, bottom, left, right = (
        times * k for k in (rows.start, rows.stop, columns.start, columns.stop)
    )
    framed = picture.copy()
    framed[[top, bottom - 1], left:right] = _FRAME
    framed[top:bottom, [left, right - 1]] = _FRAME
    return framed
