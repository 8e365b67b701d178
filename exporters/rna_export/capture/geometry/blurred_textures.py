"""Textures that planes learn, and that are finer than these."""

from collections.abc import Mapping

import numpy as np

from rna_export.blender.listing import listed
from rna_sdk.commands.size_note import metres

PLANE_TEXELS = 256
"""Along a part's longest side, as the usual preset has them."""
_FINER = 1.5  # times, from which it is noted


def blurred_note(
    part: str, corners: Mapping[str, np.ndarray], textures: Mapping[str, Mapping[str, float]]
) -> str | None:
    """The textures of a part that planes blur; None if none of them is finer.

    corners: see `BlenderWorker.export_corners`. textures: by material, the inputs of its shaders
    -> texels in a unit square of texture coordinates.
    """
    points = corners["positions"].reshape(-1, 3, 3).astype(np.float64)
    width = float(np.ptp(points.reshape(-1, 3), axis=0).max()) / PLANE_TEXELS
    found = []
    for material, inputs in textures.items():
        rows = corners["material"] == material
        squares = _squares(points[rows], corners["uvs"].reshape(-1, 3, 2)[rows])
        finer = {
            name: size
            for name, texels in inputs.items()
            if (size := np.sqrt(squares / texels)) * _FINER < width
        }
        if finer:
            names = ", ".join(finer)
            found.append(f"{material!r} ({names}: {metres(min(finer.values()))})")
    if not found:
        return None
    return (
        f"part {part!r}: texels of planes of {PLANE_TEXELS} are {metres(width)} wide, and blur "
        f"finer ones of {listed(found)}"
    )


def _squares(points: np.ndarray, uvs: np.ndarray) -> float:
    """Area on the surface of a unit square of UVs, the median by area; inf without any."""
    area = np.linalg.norm(
        np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]), axis=1
    )
    a, b = (uvs[:, k].astype(np.float64) - uvs[:, 0] for k in (1, 2))
    of_uv = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
    known = (of_uv > 0.0) & (area > 0.0)
    if not known.any():
        return np.inf
    ratio, weight = area[known] / of_uv[known], area[known]
    order = np.argsort(ratio)
    until = np.cumsum(weight[order])
    return float(ratio[order][np.searchsorted(until, 0.5 * until[-1])])
