"""Whether random view rays meet an asset at all, and the reasons if not."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from rna_export.capture.geometry.mesh_cleanup import vertex_islands
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.view_rays import outside_rays
from rna_sdk.commands.size_note import metres
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves, Mesh
from rna_sdk.package.manifest.manifest_fields import Region

_RAYS = 65536
_FEW, _TOO_FEW = 0.05, 1e-3  # of the rays through the bounding sphere meet the asset
_APART = 10.0  # times the distance of the rest from the middle
_MOST_STRAY = 0.01  # of the pieces


def check_seen(
    source: Path, scene: AssetScene, geometries: Mapping[str, Mesh | Curves], wo: Region
) -> list[str]:
    """Notes on the reason why most view rays miss; CaptureError if hardly any meets the asset.

    wo: the region of the rays' view directions.
    """
    rays = outside_rays(scene, _RAYS, wo, np.random.default_rng(0))
    share = float((scene.part_hit(rays.origins, rays.directions) >= 0).mean())
    if share >= _FEW:
        return []
    stray = _stray(geometries)
    if share == 0.0 and scene.transmits and scene.meets(rays.origins, rays.directions).any():
        raise CaptureError(
            f"{source}: nothing of it can be seen: all rays pass through its surfaces (their alpha "
            "is 0, or below the cutoff, everywhere)"
        )
    if stray is not None and share < _TOO_FEW:
        raise CaptureError(f"{source}: {stray}, and view rays meet nothing between: remove it")
    if share == 0.0:
        raise CaptureError(
            f"{source}: none of {_RAYS:,} rays through its bounding sphere of radius "
            f"{metres(scene.radius)} meets it: it is too thin to be seen"
        )
    return [] if stray is None else [f"{stray}, and most view rays meet nothing between"]


def _stray(geometries: Mapping[str, Mesh | Curves]) -> str | None:
    """Which few strands or pieces make the box ten times as large, or None."""
    names, kinds, points, pieces, start = [], [], [], [], 0
    numbers: list[int] = []
    for name, geometry in geometries.items():
        piece, place = _pieces(geometry)
        count = int(piece.max()) + 1
        names += [name] * count
        kinds += ["strand" if isinstance(geometry, Curves) else "piece"] * count
        numbers += range(count)
        points.append(place.astype(np.float64))
        pieces.append(piece + start)
        start += count
    place, piece = np.concatenate(points), np.concatenate(pieces)
    away = np.zeros(start)
    np.maximum.at(away, piece, np.linalg.norm(place - np.median(place, axis=0), axis=1))
    order = np.argsort(-away, kind="stable")
    for k in range(1, min(start, 1 + max(1, int(_MOST_STRAY * start)))):
        if away[order[k]] * _APART < away[order[0]]:
            first = order[0]
            others = f" (and {k - 1:,} more)" if k > 1 else ""
            across = metres(2.0 * away[order[k]])
            return (
                f"{kinds[first]} {numbers[first]:,}{others} of part {names[first]!r} is "
                f"{metres(away[first])} from the rest, which is {across} across"
            )
    return None


def _pieces(geometry: Mesh | Curves) -> tuple[np.ndarray, np.ndarray]:
    """(n,) the strand or connected piece of each point, counted from 0, and (n, 3) the points."""
    if isinstance(geometry, Curves):
        ends = geometry.offsets[1:].astype(np.int64)
        piece = np.searchsorted(ends, np.arange(len(geometry.points)), side="right")
        return piece, geometry.points
    used = np.unique(geometry.triangles)
    _, piece = np.unique(vertex_islands(geometry)[used], return_inverse=True)
    return piece.reshape(-1), geometry.positions[used]
