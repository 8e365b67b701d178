"""Notes on a source: sizes that its numbers cannot hold, wrong units, doubled surfaces."""

from collections.abc import Mapping

import numpy as np

from rna_export.capture.geometry.mesh_cleanup import connected, repeated
from rna_sdk.commands.size_note import metres
from rna_sdk.package import Curves, Mesh
from rna_sdk.package.geometry.quantised_mesh import POSITION_STEPS

_DETAIL_STEPS = 64  # an object of fewer steps across is off by 1% of its size
_LEAST_TRIANGLES = 12  # of an object with a shape: a box
_LONGEST = 20.0  # metres; in centimetres, a helmet, a head and all furniture are longer
_FLOAT32_STEP = 2.0**-23  # of a coordinate


def size_notes(geometries: Mapping[str, Mesh | Curves]) -> list[str]:
    """Notes on the box around all parts, in metres: its place and its longest side."""
    boxes = [geometry.box() for geometry in geometries.values()]
    low = np.min([box[0] for box in boxes], axis=0).astype(np.float64)
    high = np.max([box[1] for box in boxes], axis=0).astype(np.float64)
    longest, farthest = float((high - low).max()), float(np.maximum(-low, high).max())
    notes = []
    step = farthest * _FLOAT32_STEP
    if step > longest / POSITION_STEPS and farthest > 2.0 * longest:
        notes.append(
            f"the geometry is {metres(longest)} long and {metres(farthest)} from the origin, where "
            f"float32 coordinates have steps of {metres(step)}: move it to the origin"
        )
    if longest > _LONGEST:
        notes.append(
            f"the longest side is {metres(longest)}; if the source is in centimetres, scale it by "
            "0.01 (-- --unit 0.01 for .abc and .usd; for .hair and .tfx, which are read as "
            "centimetres, -- --unit 0.0001)"
        )
    return notes


def doubled(name: str, mesh: Mesh, materials: np.ndarray) -> str | None:
    """A note if triangles lie exactly on others, or None; materials: (t,) their full names."""
    rows = repeated(mesh)
    if not rows.any():
        return None
    names, counts = np.unique(materials[rows], return_counts=True)
    most = names[counts.argmax()]
    of_material = f", most of material {str(most)!r}" if most else ""
    return (
        f"part {name!r} has {rows.sum():,} triangles that lie exactly on others{of_material}: "
        "renders show either of the two; delete one (Merge by Distance in Edit Mode, or an object "
        "that is there twice)"
    )


def too_coarse(name: str, mesh: Mesh) -> str | None:
    """A note if an object of the mesh is too small for 16 bits over the mesh's box, or None.

    Likewise if all of its triangles are.
    """
    low, high = (corner.astype(np.float64) for corner in mesh.box())
    step = float((high - low).max()) / POSITION_STEPS
    if step == 0.0:
        return None
    long = f"part {name!r} is {metres(POSITION_STEPS * step)} long, in 16 bits steps of"
    corners = np.rint((mesh.positions - low) / step)[mesh.triangles]
    if not np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]).any():
        return f"{long} {metres(step)}, where no triangle has an area: it is kept in float32"
    smallest = _smallest_island(mesh, _DETAIL_STEPS * step)
    if smallest is None:
        return None
    return (
        f"{long} {metres(step)}, but its smallest "
        f"object is {metres(smallest)}: its geometry is kept in float32; without a "
        "backdrop (hidden in renders), more view rays would meet the object"
    )


def _smallest_island(mesh: Mesh, limit: float) -> float | None:
    """Longest side of the smallest connected piece of at least 12 triangles, if below `limit`."""
    places, vertex = np.unique(mesh.positions, axis=0, return_inverse=True)
    triangles = vertex.reshape(-1)[mesh.triangles]
    small = np.ptp(places[triangles].astype(np.float64), axis=1).max(axis=1) < limit
    label = connected(len(places), triangles[small])
    tied = np.isin(label, label[triangles[~small]])
    count = np.bincount(label[triangles[small][:, 0]], minlength=len(places))
    least, most = (np.full((len(places), 3), sign * np.inf) for sign in (1.0, -1.0))
    np.minimum.at(least, label, places)
    np.maximum.at(most, label, places)
    longest = (most - least).max(axis=1)[label]
    result = longest[~tied & (count[label] >= _LEAST_TRIANGLES) & (longest < limit)]
    return float(result.min()) if len(result) else None
