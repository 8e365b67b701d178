"""Images of Blender as files that rna-run reads."""

import hashlib
import struct
import zlib
from pathlib import Path

import bpy
import numpy as np

_SIGNATURES = {b"\x89PNG": "image/png", b"\xff\xd8\xff": "image/jpeg"}


def pixels_of(image):
    """(h, w, 4) float32, the top row first, as the image stores them: encoded if it is 8-bit."""
    width, height = image.size
    values = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(values)
    return values.reshape(height, width, 4)[::-1]


def stored_bytes(image):
    """The file that an image is, packed or not; None for one that is generated, or changed."""
    if image.is_dirty or image.source != "FILE":
        return None
    if image.packed_file is not None:
        return bytes(image.packed_file.data)
    path = _file_of(image)
    return path.read_bytes() if path.is_file() else None


def as_png_or_jpeg(image):
    """A file of the image, for 8-bit textures, and its media type."""
    data = stored_bytes(image)
    for signature, kind in _SIGNATURES.items():
        if data is not None and data.startswith(signature):
            return data, kind
    pixels = pixels_of(image)
    if image.is_float and image.colorspace_settings.name != "Non-Color":
        pixels = np.concatenate([encode_srgb(pixels[..., :3]), pixels[..., 3:]], axis=-1)
    return png(pixels), "image/png"


def png(pixels):
    """8-bit PNG of (h, w, 3 or 4) float values in [0, 1]."""
    height, width, channels = pixels.shape
    rows = np.rint(np.clip(pixels, 0.0, 1.0) * 255.0).astype(np.uint8).reshape(height, -1)
    filtered = np.concatenate([np.zeros((height, 1), np.uint8), rows], axis=1)
    header = struct.pack(">IIBBBBB", width, height, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    chunks = (b"IHDR", header), (b"IDAT", zlib.compress(filtered.tobytes(), 6)), (b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(*chunk) for chunk in chunks)


def _chunk(name, data):
    crc = struct.pack(">I", zlib.crc32(name + data))
    return struct.pack(">I", len(data)) + name + data + crc


def save_environment(image, folder, notes):
    """The path of an .exr or .hdr file with the image's radiance."""
    path, data = _file_of(image), stored_bytes(image)
    is_linear = "linear" in image.colorspace_settings.name.lower()
    if data is not None and path.suffix.lower() in (".exr", ".hdr") and is_linear:
        if image.packed_file is None:
            return str(path)
        out = folder / f"world-{hashlib.sha256(data).hexdigest()[:12]}{path.suffix.lower()}"
        out.write_bytes(data)
        return out.name
    rgb = pixels_of(image)[..., :3]
    if not rgb.size:
        notes.add("the world's image is missing: rendered as white", image.name)
        rgb = np.ones((1, 2, 3), np.float32)
    out = folder / f"world-{hashlib.sha256(rgb.tobytes()).hexdigest()[:12]}.exr"
    out.write_bytes(exr(rgb if image.is_float else decode_srgb(rgb)))
    return out.name


def exr(rgb):
    """An uncompressed OpenEXR file of (h, w, 3) radiance: one part, scan lines, float32."""
    height, width, _ = rgb.shape
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channels = b"".join(
        name + b"\0" + struct.pack("<4i", 2, 0, 1, 1) for name in (b"B", b"G", b"R")
    )
    attributes = (
        (b"channels", b"chlist", channels + b"\0"),
        (b"compression", b"compression", b"\0"),
        (b"dataWindow", b"box2i", window),
        (b"displayWindow", b"box2i", window),
        (b"lineOrder", b"lineOrder", b"\0"),
        (b"pixelAspectRatio", b"float", struct.pack("<f", 1.0)),
        (b"screenWindowCenter", b"v2f", struct.pack("<2f", 0.0, 0.0)),
        (b"screenWindowWidth", b"float", struct.pack("<f", 1.0)),
    )
    head = struct.pack("<2i", 20000630, 2)
    for name, kind, value in attributes:
        head += name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value
    head += b"\0"
    # Of each line: its number and size, then all its blue, green and red.
    lines = np.empty((height, 2 + 3 * width), "<f4")
    numbers = lines.view("<i4")
    numbers[:, 0], numbers[:, 1] = np.arange(height), 12 * width
    lines[:, 2:] = rgb[..., ::-1].transpose(0, 2, 1).reshape(height, -1)
    first = len(head) + 8 * height
    offsets = first + lines.strides[0] * np.arange(height, dtype="<u8")
    return head + offsets.astype("<u8").tobytes() + lines.tobytes()


def encode_srgb(linear):
    """IEC 61966-2-1, of values clipped to [0, 1]."""
    x = np.clip(linear, 0.0, 1.0)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1.0 / 2.4) - 0.055)


def decode_srgb(encoded):
    """The inverse of `encode_srgb`."""
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


def _file_of(image):
    return Path(bpy.path.abspath(image.filepath, library=image.library))
