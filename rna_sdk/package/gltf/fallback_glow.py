"""Light that a fallback sends out: glTF has no colours of emission at vertices, but textures.

A texture holds a part's hues from dark to bright; each vertex has its place in it.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rna_sdk.files.srgb import decode_srgb, encode_srgb
from rna_sdk.package.gltf.fallback_file import FallbackFile

STRENGTH = "KHR_materials_emissive_strength"

_DARK = 1.0 / 255.0  # of radiance: none
_HUES, _STEPS = 16, 64  # rows and columns of the texture, at most
_SAMPLES = 4096  # of the light, for its hues

Array = NDArray[np.float64]


class Palette(NamedTuple):
    """Colours, and the place of each vertex among them.

    strength: radiance of 1. texels: (h, w, 3) uint8, sRGB; a row for each hue, from dark to bright.
    places: (v, 2) float64, texture coordinates.
    """

    strength: float
    texels: NDArray[np.uint8]
    places: Array


def palette_of(emission: NDArray[np.float32], triangles: NDArray[np.uint32]) -> Palette | None:
    """The palette of radiances (v, 3) at the corners of triangles (t, 3); None without light."""
    strength = float(emission.max(initial=0.0))
    if strength < _DARK:
        return None
    light = emission.astype(np.float64) / strength
    bright = light.max(axis=1)
    hues = encode_srgb(light / np.maximum(bright, 1e-9)[:, None])
    colors = _main_colors(hues, bright)
    row = np.argmin([np.abs(hues - color).sum(axis=1) for color in colors], axis=0)
    # Dark corners of a triangle have the hue of its brightest one.
    corners = np.take_along_axis(triangles, bright[triangles].argsort(axis=1)[:, ::-1], axis=1)
    dark = bright[corners] < _DARK
    row[corners[dark]] = np.broadcast_to(row[corners[:, :1]], corners.shape)[dark]
    steps = np.linspace(0.0, 1.0, _STEPS)[:, None]
    texels = encode_srgb(steps * decode_srgb(colors)[:, None])
    across = (bright * (_STEPS - 1) + 0.5) / _STEPS
    places = np.column_stack([across, (row + 0.5) / len(colors)])
    return Palette(strength, np.rint(255.0 * texels).astype(np.uint8), places)


def _main_colors(hues: Array, weights: Array) -> Array:
    """At most _HUES of the colours (n, 3), sRGB, by weight: (k, 3)."""
    from PIL import Image  # loads with the first image

    at = (np.arange(_SAMPLES) + 0.5) / _SAMPLES * weights.sum()
    chosen = hues[np.searchsorted(np.cumsum(weights), at)]
    image = Image.fromarray(np.rint(255.0 * chosen).astype(np.uint8)[None])
    found = image.quantize(_HUES, method=Image.Quantize.MEDIANCUT, kmeans=4).convert("RGB")
    return np.unique(np.asarray(found)[0], axis=0) / 255.0


def add_glow(file: FallbackFile, attributes: dict[str, int], palette: Palette) -> dict[str, Any]:
    """The members of a material that sends out this light.

    attributes: of the mesh, by accessor; takes texture coordinates.
    """
    number = int("TEXCOORD_0" in attributes)
    attributes[f"TEXCOORD_{number}"] = file.coordinates(palette.places)
    texture = {**file.texture(palette.texels, is_palette=True), "texCoord": number}
    factor = [min(palette.strength, 1.0)] * 3
    members: dict[str, Any] = {"emissiveTexture": texture, "emissiveFactor": factor}
    if palette.strength > 1.0:
        file.extensions.add(STRENGTH)
        members["extensions"] = {STRENGTH: {"emissiveStrength": palette.strength}}
    return members
