"""Pictures: PNG files, and sheets in labelled columns with FLIP in its colours and a scale."""

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path

import matplotlib
import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from rna_export.metrics import display, flip, to_png
from rna_sdk.files.atomic_file import write_atomically

Picture = NDArray[np.uint8]

COLUMNS = ("ours", "Cycles", "difference x 4", "FLIP")
_MAP = "magma"  # as FLIP's authors show it
_LEAST_WIDTH = 128  # of a picture, below which its pixels become squares
_INK, _PAPER, _QUIET = (20, 20, 20), (255, 255, 255), (90, 90, 90)


def flip_colours(error: NDArray[np.floating]) -> Picture:
    """A map of FLIP, (h, w) in [0, 1], as colours, (h, w, 3) uint8."""
    colours = matplotlib.colormaps[_MAP](np.clip(error, 0.0, 1.0))
    return np.asarray(255.0 * colours[..., :3], np.uint8)


def pictures_of(
    ours: NDArray[np.float32], cycles: NDArray[np.float32], exposure: float = 1.0
) -> list[Picture]:
    """A picture for each of COLUMNS, of images (h, w, 3) of radiance at irradiance 1."""
    difference = np.abs(display(ours, exposure) - display(cycles, exposure))
    return [
        to_png(ours, exposure),
        to_png(cycles, exposure),
        np.clip(255.0 * 4.0 * difference, 0, 255).astype(np.uint8),
        flip_colours(flip(ours, cycles, exposure)[1]),
    ]


def enlarged(picture: Picture) -> Picture:
    """The picture with each pixel as a square of them, if it is too small to look at."""
    times = -(-_LEAST_WIDTH // picture.shape[1])
    return picture.repeat(times, axis=0).repeat(times, axis=1)


def comparison_sheet(
    rows: Sequence[tuple[Sequence[Picture], str]], notes: Sequence[str] = ()
) -> Image.Image:
    """Rows of pictures of one size, (h, w, 3) uint8, each with a caption; the last one is FLIP.

    Small ones are enlarged, so that the labels have room. notes: lines below all rows, which are
    broken where they are too long.
    """
    rows = [([enlarged(picture) for picture in pictures], caption) for pictures, caption in rows]
    height, width = rows[0][0][0].shape[:2]
    size = max(11, round(width / 18))
    line = round(1.6 * size)
    font = ImageFont.load_default(size)
    across = width * len(COLUMNS)
    below = [piece for note in notes for piece in _broken(note, font, across - size)]
    down = line + len(rows) * (height + line)
    sheet = Image.new("RGB", (across, down + len(below) * line), _PAPER)
    draw = ImageDraw.Draw(sheet)
    for k, name in enumerate(COLUMNS):
        draw.text((k * width + size // 2, line // 2), name, _INK, font, anchor="lm")
    _draw_scale(sheet, draw, font, (len(COLUMNS) - 1) * width, width, line)
    for k, (pictures, caption) in enumerate(rows):
        top = line + k * (height + line)
        sheet.paste(Image.fromarray(np.concatenate(pictures, axis=1)), (0, top))
        draw.text((size // 2, top + height + line // 2), caption, _QUIET, font, anchor="lm")
    for k, piece in enumerate(below):
        draw.text((size // 2, down + k * line + line // 2), piece, _INK, font, anchor="lm")
    return sheet


def _broken(note: str, font: ImageFont.FreeTypeFont | ImageFont.ImageFont, width: int) -> list[str]:
    """The note in lines of at most so many pixels, which keep its indentation."""
    indentation = note[: len(note) - len(note.lstrip())]
    lines = [indentation]
    for word in note.split():
        longer = f"{lines[-1]}{word} "
        if font.getlength(longer.rstrip()) > width and lines[-1].strip():
            lines.append(indentation)
            longer = f"{indentation}{word} "
        lines[-1] = longer
    return lines


def _draw_scale(
    sheet: Image.Image,
    draw: ImageDraw.ImageDraw,
    font: ImageFont.FreeTypeFont | ImageFont.ImageFont,
    left: int,
    width: int,
    line: int,
) -> None:
    """The colours from 0 to 1, at the right of the last column's label."""
    right, length, height = left + width - line // 2, width // 3, line // 2
    bar = flip_colours(np.tile(np.linspace(0.0, 1.0, length), (height, 1)))
    sheet.paste(Image.fromarray(bar), (right - length, (line - height) // 2))
    draw.text((right - length - 3, line // 2), "0", _INK, font, anchor="rm")
    draw.text((right + 3, line // 2), "1", _INK, font, anchor="lm")


def png_bytes(pixels: np.ndarray) -> bytes:
    """A PNG of (h, w, 3 or 4) uint8."""
    data = BytesIO()
    Image.fromarray(pixels).save(data, format="PNG", optimize=True)
    return data.getvalue()


def write_picture(path: Path, picture: Image.Image | np.ndarray) -> None:
    """Write a PNG atomically. picture: an array is (h, w, 3) uint8, sRGB."""
    data = BytesIO()
    image = Image.fromarray(picture) if isinstance(picture, np.ndarray) else picture
    image.save(data, "PNG")
    write_atomically(path, data.getvalue())


def sheet_of(package: Path) -> Path:
    """Where the contact sheet of a package goes: beside it."""
    return package.with_name(f"{package.stem}-sheet.png")


def worst_of(package: Path) -> Path:
    """Where the picture goes of the place where a package is furthest from Cycles: beside it."""
    return package.with_name(f"{package.stem}-worst.png")


def training_picture_of(package: Path) -> Path:
    """Where the picture of the model goes that is trained for a package: beside it."""
    return package.with_name(f"{package.stem}.training.png")
