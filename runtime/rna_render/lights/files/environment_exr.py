"""Environments in OpenEXR files: part and window of the picture, refused files.

`runtime/web/src/light/exr_file.js` does the same for the viewer; docs/scene.md has the table.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from rna_render.image.images import read_exr_headers, read_exr_part
from rna_render.scene.limits import MAX_IMAGE_VALUES, check_image_size
from rna_sdk.errors import SceneError

Header = Mapping[str, Any]
Window = tuple[int, int, int, int]
"""First column and row, and those behind the last."""

# OpenEXR file layout, "Predefined Attributes": type, compression, envmap, and modes of tiles.
DEEP = {"deepscanline", "deeptile"}
COMPRESSIONS = {"NO", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB"}
CHROMA = {"RY", "BY"}


def read_exr_environment(path: Path) -> np.ndarray:
    """The picture of the first part with R, G and B (or Y): (h, w, 3) float32.

    It has the size of the display window; what the data window leaves of it is 0. Raises
    SceneError for what cannot be read, is deep, a cube map, subsampled, or too large.
    """
    headers = read_exr_headers(path)
    number = _picture(path, headers)
    header = headers[number]
    names = colours_of(header)
    _check_layout(path, header, len(headers))
    data, display = (_window(path, header, name) for name in ("dataWindow", "displayWindow"))
    for window in (data, display):
        check_image_size(path, window[2] - window[0], window[3] - window[1])
    values = sum(_values(path, part) for part in headers)
    if values > MAX_IMAGE_VALUES:
        message = f"has {values} values in all its channels; at most {MAX_IMAGE_VALUES}"
        raise SceneError(message, file=path)
    if not _overlap(data, display):
        raise SceneError("its data window lies outside its display window", file=path)
    planes = read_exr_part(path, number, names)
    types = {plane.dtype.name for plane in planes}
    if len(types) > 1 or "uint32" in types:
        found = ", ".join(sorted(types))
        raise SceneError(f"has colours of type {found}, expected float16 or float32", file=path)
    texels = np.empty((*planes[0].shape, 3), np.float32)
    for channel, plane in enumerate(planes):
        texels[..., channel] = plane
    return _placed(texels, data, display)


def colours_of(header: Header) -> str:
    """The channels that are red, green and blue: "RGB", "YYY", or nothing."""
    names = {channel.name for channel in header["channels"]}
    if set("RGB") <= names:
        return "RGB"
    return "YYY" if "Y" in names and not CHROMA & names else ""


def _picture(path: Path, headers: Sequence[Header]) -> int:
    """The first part that has colours."""
    for number, header in enumerate(headers):
        if colours_of(header):
            return number
    names = sorted({channel.name for header in headers for channel in header["channels"]})
    if set(names) >= {"Y"} | CHROMA:
        message = "has luminance and chroma (Y, RY, BY): save it with R, G and B"
        raise SceneError(message, file=path)
    raise SceneError(f"has no channels R, G and B, nor Y; it has {_listed(names)}", file=path)


def _listed(names: Sequence[str]) -> str:
    shown = ", ".join(names[:12]) or "none"
    return f"{shown} and {len(names) - 12} more" if len(names) > 12 else shown


def _check_layout(path: Path, header: Header, parts: int) -> None:
    tiles = header.get("tiles")
    compression = _name(header.get("compression")).removesuffix("_COMPRESSION")
    if _name(header.get("type")) in DEEP:
        message = "is a deep image, with any number of samples a pixel: flatten it"
    elif _name(header.get("envmap")) not in ("", "ENVMAP_LATLONG"):
        message = "is a cube map: convert it to latitude and longitude"
    elif any(channel.xSampling != 1 or channel.ySampling != 1 for channel in header["channels"]):
        message = "has channels of fewer texels than others: save them all at full size"
    elif compression not in COMPRESSIONS:
        message = f"has compression {compression}, expected one of {', '.join(COMPRESSIONS)}"
    elif tiles is not None and parts > 1:
        message = "has tiles in one of several parts: save it with scan lines"
    elif tiles is not None and _name(getattr(tiles, "mode", None)) == "RIPMAP_LEVELS":
        message = "has tiles of several sizes by row and column: save it with one size"
    else:
        return
    raise SceneError(message, file=path)


def _name(value: object) -> str:
    """Name of an enumeration's value; nothing for a missing attribute or another type."""
    return str(getattr(value, "name", ""))


def _window(path: Path, header: Header, name: str) -> Window:
    try:
        (left, top), (right, bottom) = (corner.tolist() for corner in header[name])
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise SceneError(f"broken EXR image: its {name} is no window", file=path) from error
    return left, top, right + 1, bottom + 1


def _values(path: Path, header: Header) -> int:
    left, top, right, bottom = _window(path, header, "dataWindow")
    return max(right - left, 0) * max(bottom - top, 0) * len(header["channels"])


def _overlap(a: Window, b: Window) -> bool:
    return max(a[0], b[0]) < min(a[2], b[2]) and max(a[1], b[1]) < min(a[3], b[3])


def _placed(texels: np.ndarray, data: Window, display: Window) -> np.ndarray:
    """The texels of the data window where they are in the display window."""
    if data == display:
        return texels
    result = np.zeros((display[3] - display[1], display[2] - display[0], 3), np.float32)
    left, top = max(data[0], display[0]), max(data[1], display[1])
    right, bottom = min(data[2], display[2]), min(data[3], display[3])
    result[top - display[1] : bottom - display[1], left - display[0] : right - display[0]] = texels[
        top - data[1] : bottom - data[1], left - data[0] : right - data[0]
    ]
    return result
