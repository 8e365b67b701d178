"""Parts of a mesh as a file holds them, and the one mesh that they make."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from rna_render.materials.material import Material
from rna_render.materials.mesh_object import MeshObject
from rna_render.scene.limits import MAX_NUMBER, MAX_TRIANGLES, MAX_VERTICES
from rna_sdk.errors import SceneError


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """Triangles of one material, where they stand in the file.

    positions: (v, 3) float. normals: the same, of any length, or None. uvs: (v, 2) float, (0, 0)
    the upper left corner of images, or None. triangles: (t, 3) integers. material: place in the
    file's list of materials. second_uvs: as uvs. tangents: (v, 4) float, colors: (v, 3) float, as
    in MeshObject, or None.
    """

    positions: np.ndarray
    normals: np.ndarray | None
    uvs: np.ndarray | None
    triangles: np.ndarray
    material: int
    second_uvs: np.ndarray | None = None
    tangents: np.ndarray | None = None
    colors: np.ndarray | None = None


@dataclass(frozen=True, slots=True, eq=False)
class MeshFile:
    """Contents of a mesh file, and unsupported features of its materials, one phrase each."""

    parts: Sequence[Part]
    materials: Sequence[Material]
    left_out: Sequence[str] = ()


def join_parts(
    path: Path, parts: Sequence[Part], materials: Sequence[Material], catches_shadows: bool = False
) -> MeshObject:
    """All parts as one mesh; a part without normals gets normals of its flat triangles.

    Raises SceneError, which names the file, where there are no triangles, numbers that are not
    finite, triangles of vertices that are not there, or textures but no texture coordinates.
    """
    check_mesh_size(
        sum(len(part.positions) for part in parts), sum(len(part.triangles) for part in parts)
    )
    parts = [_checked(path, part, materials) for part in parts if len(part.triangles)]
    if not parts:
        raise SceneError("there are no triangles in it", file=path)
    starts = np.cumsum([0] + [len(part.positions) for part in parts[:-1]])
    triangles = [part.triangles + start for part, start in zip(parts, starts, strict=True)]
    return MeshObject(
        positions=np.concatenate([part.positions for part in parts]),
        normals=np.concatenate([part.normals for part in parts]),
        uvs=_joined([part.uvs for part in parts], parts, 2),
        triangles=np.ascontiguousarray(np.concatenate(triangles), np.uint32),
        material_numbers=np.concatenate(
            [np.full(len(part.triangles), part.material, np.int32) for part in parts]
        ),
        materials=tuple(materials),
        catches_shadows=catches_shadows,
        second_uvs=_joined([part.second_uvs for part in parts], parts, 2),
        tangents=_joined([part.tangents for part in parts], parts, 4),
        colors=_joined([part.colors for part in parts], parts, 3, missing=1.0),
    )


def check_mesh_size(vertices: int, triangles: int) -> None:
    """ValueError if a mesh has more than the limits allow."""
    if vertices > MAX_VERTICES or triangles > MAX_TRIANGLES:
        raise ValueError(
            f"{vertices} vertices and {triangles} triangles; "
            f"at most {MAX_VERTICES} and {MAX_TRIANGLES}"
        )


def _joined(
    values: Sequence[np.ndarray | None], parts: Sequence[Part], width: int, missing: float = 0.0
) -> np.ndarray | None:
    """Attribute of all parts, `missing` for those without it; None if no part has it."""
    if all(value is None for value in values):
        return None
    others = (np.full((len(part.positions), width), missing, np.float32) for part in parts)
    pairs = zip(values, others, strict=True)
    return np.concatenate([other if value is None else value for value, other in pairs])


def fans(faces: np.ndarray) -> np.ndarray:
    """Convex polygons of k corners each, (n, k), cut into triangles: (n * (k - 2), 3)."""
    parts = [faces[:, [0, corner, corner + 1]] for corner in range(1, faces.shape[1] - 1)]
    return np.concatenate([np.zeros((0, 3), faces.dtype), *parts])


def flat_normals(positions: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Unit normals of triangles, (t, 3) float64; 0 where one has no area."""
    a, b, c = (positions[triangles[:, corner]].astype(np.float64) for corner in range(3))
    return _unit(np.cross(b - a, c - a))


def _checked(path: Path, part: Part, materials: Sequence[Material]) -> Part:
    """The part with the dtypes of MeshObject, and normals."""
    triangles = np.asarray(part.triangles, np.int64)
    positions = _numbers(part.positions, len(part.positions), 3, "positions")
    count = len(positions)
    if triangles.min() < 0 or triangles.max() >= count:
        raise SceneError(f"a triangle has a vertex outside [0, {count})", file=path)
    if not (np.abs(positions) <= MAX_NUMBER).all():
        raise SceneError(f"positions must be finite and at most {MAX_NUMBER:g}", file=path)
    uvs = [
        None if values is None else _checked_uvs(path, _numbers(values, count, 2, "coordinates"))
        for values in (part.uvs, part.second_uvs)
    ]
    for texture in materials[part.material].textures:
        if uvs[texture.uv_set] is None:
            raise SceneError("a texture needs texture coordinates, but there are none", file=path)
    checked = replace(
        part,
        positions=positions,
        uvs=uvs[0],
        triangles=triangles,
        second_uvs=uvs[1],
        colors=None if part.colors is None else _checked_colors(path, part.colors, count),
    )
    if part.normals is None:
        return _flat(checked)
    tangents = None
    if part.tangents is not None:
        tangents = _unit_tangents(_numbers(part.tangents, count, 4, "tangents"))
    normals = _unit(_numbers(part.normals, count, 3, "normals"))
    return replace(checked, normals=normals, tangents=tangents)


def _flat(part: Part) -> Part:
    """The part with the normals of its triangles, each of which has vertices of its own."""
    corners = part.triangles.ravel()

    def apart(values: np.ndarray | None) -> np.ndarray | None:
        return None if values is None else values[corners]

    normals = np.repeat(flat_normals(part.positions, part.triangles), 3, axis=0)
    return replace(
        part,
        positions=part.positions[corners],
        normals=normals.astype(np.float32),
        uvs=apart(part.uvs),
        triangles=np.arange(len(corners)).reshape(-1, 3),
        second_uvs=apart(part.second_uvs),
        tangents=None,
        colors=apart(part.colors),
    )


def _numbers(values: np.ndarray, count: int, width: int, name: str) -> np.ndarray:
    """An attribute as (count, width) float32; ValueError if it has another shape."""
    if np.shape(values) != (count, width):  # trimesh leaves rows of different lengths as objects
        raise ValueError(f"{name} have shape {np.shape(values)}, not {(count, width)}")
    with np.errstate(over="ignore"):
        return np.ascontiguousarray(values, np.float32)


def _checked_uvs(path: Path, uvs: np.ndarray) -> np.ndarray:
    if not (np.abs(uvs) <= MAX_NUMBER).all():
        message = f"texture coordinates must be finite and at most {MAX_NUMBER:g}"
        raise SceneError(message, file=path)
    return uvs


def _checked_colors(path: Path, colors: np.ndarray, count: int) -> np.ndarray:
    colors = _numbers(colors, count, 3, "colours")
    if not ((colors >= 0) & (colors <= 1)).all():
        raise SceneError("a vertex has a colour outside [0, 1]", file=path)
    return colors


def _unit_tangents(tangents: np.ndarray) -> np.ndarray:
    """Unit tangents with the sign of the bitangent; 0 for degenerate tangents."""
    unit = _unit(tangents[:, :3])
    sign = np.where(tangents[:, 3:] < 0, -1, 1) * unit.any(axis=1, keepdims=True)
    return np.column_stack([unit, sign]).astype(np.float32)


def _unit(vectors: np.ndarray) -> np.ndarray:
    """Unit vectors, (n, 3) float32; 0 for one that is 0 or not finite."""
    vectors = np.asarray(vectors, np.float64)
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    usable = (length > 0) & np.isfinite(length)
    with np.errstate(invalid="ignore"):
        return np.where(usable, vectors / np.where(usable, length, 1), 0).astype(np.float32)
