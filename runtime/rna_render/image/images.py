"""Image files. Each is written beside its place and then renamed, so none is ever half there."""

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np

from rna_render.image.view_transform import to_display
from rna_sdk.errors import SceneError
from rna_sdk.files.atomic_file import atomic_file
from rna_sdk.files.regular_file import check_regular

_OPAQUE = 1.0 - 0.5 / 255.0  # alpha that 8 bits round to 1


def write_exr(path: Path, channels: Mapping[str, np.ndarray], attributes: dict[str, str]) -> None:
    """Write a scan-line EXR with lossless ZIP compression.

    channels: name to (height, width) float32 or uint32. attributes: text kept in the header.
    Raises SceneError if the file cannot be written.
    """
    import OpenEXR

    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage, **attributes}
    file = OpenEXR.File(header, dict(channels))
    _write(path, lambda temporary: file.write(str(temporary)))


def write_linear(
    path: Path, channels: Mapping[str, np.ndarray], attributes: dict[str, str]
) -> None:
    """Write channels as `write_exr` takes them to an EXR, or to an NPZ by the name's suffix.

    An NPZ, uncompressed, has an array a channel and one of text an attribute.
    """
    if path.suffix.lower() == ".npz":
        arrays = {**channels, **{name: np.array(text) for name, text in attributes.items()}}
        _write(path, lambda temporary: _save_arrays(temporary, arrays))
    else:
        write_exr(path, channels, attributes)


def _save_arrays(path: Path, arrays: Mapping[str, Any]) -> None:
    with path.open("wb") as file:
        np.savez(file, **arrays)


def read_exr(path: Path) -> tuple[dict[str, np.ndarray], dict[str, object]]:
    """The channels, each (height, width), and the header of a single-part EXR.

    Raises SceneError if the file cannot be read.
    """
    import OpenEXR

    try:
        with OpenEXR.File(str(path), separate_channels=True) as file:
            channels = {name: channel.pixels.copy() for name, channel in file.channels().items()}
            return channels, dict(file.header())
    except (OSError, RuntimeError, ValueError) as error:
        raise SceneError(f"cannot read the image: {error}", file=path) from error


def read_exr_headers(path: Path) -> list[dict[str, Any]]:
    """The headers of an EXR's parts, attributes by name; `channels` is a list.

    Raises SceneError if the file cannot be read.
    """
    import OpenEXR

    try:
        check_regular(path)
        with OpenEXR.File(str(path), header_only=True) as file:
            headers = [dict(part.header) for part in file.parts]
        # A name that is not UTF-8 raises when it is asked for: here, not later.
        _ = [channel.name for header in headers for channel in header["channels"]]
        return headers
    except OSError as error:
        reason = error.strerror or str(error)
        raise SceneError(f"cannot read the image: {reason}", file=path) from error
    except (RuntimeError, ValueError, TypeError, KeyError, AttributeError) as error:
        raise SceneError(f"cannot read the image: {error}", file=path) from error


def read_exr_part(path: Path, number: int, names: Iterable[str]) -> list[np.ndarray]:
    """Channels of one part, each (height, width). Raises SceneError if they cannot be read."""
    import OpenEXR

    try:
        with OpenEXR.File(str(path), separate_channels=True) as file:
            # A part whose pixels are broken is left out, with a line on stderr.
            channels = file.parts[number].channels
            return [channels[name].pixels.copy() for name in names]
    except (OSError, RuntimeError, ValueError, IndexError, KeyError, AttributeError) as error:
        raise SceneError("cannot read the image: its pixels are broken", file=path) from error


def write_png(
    path: Path,
    rgb: np.ndarray,
    exposure: float = 0.0,
    view: str = "srgb",
    attributes: Mapping[str, str] | None = None,
    alpha: np.ndarray | None = None,
) -> None:
    """Write an 8-bit sRGB PNG of linear radiance times 2^exposure, through a view transform.

    rgb: (height, width, 3) float, premultiplied by alpha. view: see to_display. attributes: text
    kept in the file. alpha: (height, width) float, which the PNG has where it is not all opaque;
    None for 1. Raises SceneError if the file cannot be written.
    """
    from PIL import Image, PngImagePlugin

    text = PngImagePlugin.PngInfo()
    for name, value in (attributes or {}).items():
        text.add_text(name, value)
    if alpha is not None and alpha.min() < _OPAQUE:
        straight = rgb / np.maximum(alpha, 1e-6)[..., None]
        planes = [to_display(straight, view, exposure), np.clip(alpha, 0.0, 1.0)[..., None]]
        pixels = np.concatenate(planes, axis=-1)
    else:
        pixels = to_display(rgb, view, exposure)
    image = Image.fromarray(np.rint(pixels * 255.0).astype(np.uint8))
    _write(path, lambda temporary: image.save(temporary, format="PNG", pnginfo=text))


def read_attributes(path: Path) -> dict[str, str]:
    """The `rna...` attributes that a file was written with; none if it cannot be read."""
    try:
        header = _HEADERS.get(path.suffix.lower(), _exr_header)(path)
    except (OSError, RuntimeError, ValueError, SyntaxError, BadZipFile):
        return {}
    return {name: str(value) for name, value in header.items() if name.startswith("rna")}


def _exr_header(path: Path) -> Mapping[str, object]:
    import OpenEXR

    with OpenEXR.File(str(path), header_only=True) as file:
        return dict(file.header())


def _png_text(path: Path) -> Mapping[str, object]:
    from PIL import Image

    with Image.open(path) as image:
        return {str(name): value for name, value in image.info.items()}


def _npz_text(path: Path) -> Mapping[str, object]:
    with np.load(path) as arrays:
        return {name: arrays[name].item() for name in arrays if name.startswith("rna")}


_HEADERS = {".png": _png_text, ".npz": _npz_text}


def _write(path: Path, save: Callable[[Path], object]) -> None:
    try:
        with atomic_file(path) as temporary:
            save(temporary)
    except (OSError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or error
        raise SceneError(f"cannot write the image: {reason}", file=path) from error
