"""Exports every mesh of the scene, as Cycles will render it, into one triangle soup."""

from collections.abc import Iterator
from typing import Any

import bpy
import numpy as np
from rna_geometry import shown_objects
from rna_geometry.attributes import read, uv_map
from rna_geometry.left_out import unrendered
from rna_geometry.shown_objects import SURFACES, top_object
from rna_materials.object_materials import materials_of
from rna_materials.udim_tiles import numbers_of
from rna_materials.uv_charts import Chart
from rna_materials.uv_dependence import IDENTITY
from rna_preflight.smooth_glass import is_left


def export_mesh(
    path: str,
    owner: str | None = None,
    charts: dict[str, Any] | None = None,
    of_hosts: bool = False,
) -> dict[str, Any]:
    """Write an .npz: `positions`, `normals` (3t, 3), `uvs` (3t, 2), `has_uv`, `material` (t,),
    `tile` (t,), `vertex` (3t,), `vertices`.

    One row a triangle corner, world space, Blender's axes, float32; materials by their place in
    the reply's list of full names, -1 for none. owner: the top object whose meshes are meant; None:
    all. charts: texture coordinates of materials (see `surface_textures.export_textures`); the rest
    has the UV map that renders use, or 0. has_uv: whether all objects have UV maps, or a chart.
    tile: int32, number of the UDIM tile (see `base_colors.Piece`).
    vertex: int32, the corners' vertices, numbered over all shown meshes, of which there are so many
    `vertices`. of_hosts: whether it is the glass that is left to hosts, else all but that.
    """
    names = [material.name_full for material in bpy.data.materials]
    charted = {name: Chart.of(chart) for name, chart in (charts or {}).items()}
    corners, vertices = [], 0
    for instance in _mesh_instances():
        if owner in (None, top_object(instance)):
            corners.append(_corners(instance, names, charted, vertices, of_hosts))
        vertices += _vertex_count(instance.object)
    if not corners:
        hidden = unrendered()
        why = f": renders do not show {hidden}, turn on its camera icon in the Outliner"
        raise ValueError(f"the scene has no mesh with faces{why if hidden else ''}")
    positions, normals, uvs, has_uv, material, tile, vertex = zip(*corners, strict=True)
    used = np.unique(np.concatenate(material))
    np.savez(
        path,
        positions=np.concatenate(positions),
        normals=np.concatenate(normals),
        uvs=np.concatenate(uvs),
        has_uv=all(has_uv) or any(names[m] in charted for m in used if m >= 0),
        material=np.concatenate(material),
        tile=np.concatenate(tile),
        vertex=np.concatenate(vertex),
        vertices=vertices,
    )
    return {"materials": names}


def owners() -> list[str]:
    """Names of the top objects that renders show as a surface, each once."""
    result = {}
    for instance in _mesh_instances():
        owner = top_object(instance)
        if owner not in result and _has_faces(instance.object):
            result[owner] = True
    return list(result)


def _has_faces(item: bpy.types.Object) -> bool:
    left = [is_left(None if m is None else m.name_full) for m in materials_of(item)]
    mesh = item.to_mesh()
    slot = read(mesh.polygons, "material_index", len(mesh.polygons), np.int32)
    item.to_mesh_clear()
    return not np.array(left)[np.clip(slot, 0, len(left) - 1)].all()


def _vertex_count(item: bpy.types.Object) -> int:
    vertices = len(item.to_mesh().vertices)
    item.to_mesh_clear()
    return vertices


def _mesh_instances() -> Iterator[bpy.types.DepsgraphObjectInstance]:
    for instance in shown_objects.seen():
        if instance.object.type in SURFACES:
            yield instance


def _corners(
    instance: bpy.types.DepsgraphObjectInstance,
    names: list[str],
    charts: dict[str, Chart],
    first: int,
    of_hosts: bool,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, bool, np.ndarray, np.ndarray, np.ndarray]:
    """See `export_mesh`. first: number of the mesh's first vertex."""
    mesh = instance.object.to_mesh()
    try:
        mesh.calc_loop_triangles()
        triangles = len(mesh.loop_triangles)
        loops = read(mesh.loop_triangles, "loops", 3 * triangles, np.int32)
        vertices = read(mesh.loop_triangles, "vertices", 3 * triangles, np.int32)
        if triangles and vertices.max() >= len(mesh.vertices):
            found = f"vertex {vertices.max()} of {len(mesh.vertices)}"
            raise ValueError(f"object {instance.object.name!r} has a face with {found}")
        positions = read(mesh.vertices, "co", 3 * len(mesh.vertices)).reshape(-1, 3)[vertices]
        normals = read(mesh.corner_normals, "vector", 3 * len(mesh.loops)).reshape(-1, 3)[loops]
        slots = [None if m is None else m.name_full for m in materials_of(instance.object)]
        slot = read(mesh.loop_triangles, "material_index", triangles, np.int32)
        slot = np.clip(slot, 0, len(slots) - 1)
        of_slots = [charts.get(name or "") for name in slots]
        uvs, tile = _stored_uvs(mesh, loops.reshape(-1, 3), of_slots, slot)
        has_uv = len(mesh.uv_layers) > 0
        matrix = np.array(instance.matrix_world, np.float32)
    finally:
        instance.object.to_mesh_clear()
    numbers = np.array([names.index(name) if name in names else -1 for name in slots])
    material = numbers[slot].astype(np.int32)
    wanted = np.array([is_left(name) == of_hosts for name in slots])[slot]
    material, tile, corner = material[wanted], tile[wanted], np.repeat(wanted, 3)
    positions, normals, uvs, vertices = (a[corner] for a in (positions, normals, uvs, vertices))
    *placed, order = _place(positions, normals, uvs, matrix, vertices[:, None] + first)
    return *placed, has_uv, material, tile, order[:, 0].astype(np.int32)


def _stored_uvs(
    mesh: bpy.types.Mesh, loops: np.ndarray, charts: list[Chart | None], slot: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(3t, 2) texture coordinates of a package, by the chart of each slot, and (t,) tiles."""
    result = np.zeros((*loops.shape, 2), np.float32)
    tile = np.zeros(len(loops), np.int32)
    for k, chart in enumerate(charts):
        uvs = uv_map(mesh, "" if chart is None else chart.layer)
        rows = slot == k
        if uvs is None and chart is not None:
            uvs = np.zeros((len(mesh.loops), 2), np.float32)  # as Cycles has a map that is missing
        if uvs is not None and rows.any():
            chart, of_rows = chart or Chart("", IDENTITY), uvs[loops[rows]].reshape(-1, 2)
            result[rows] = chart.stored(of_rows).reshape(-1, 3, 2)
            if chart.tiles is not None:
                tile[rows] = numbers_of(of_rows, chart.tiles)
    return result.reshape(-1, 2), tile


def _place(
    positions: np.ndarray,
    normals: np.ndarray,
    uvs: np.ndarray,
    matrix: np.ndarray,
    vertices: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    world = positions @ matrix[:3, :3].T + matrix[:3, 3]
    x, y, z = matrix[:3, :3].T.astype(np.float64)
    mirrored = np.dot(x, np.cross(y, z)) < 0.0
    # Cofactors, which a scale of 0 has as well: the inverse transposed, times the determinant.
    turned = normals @ np.stack([np.cross(y, z), np.cross(z, x), np.cross(x, y)])
    turned *= -1.0 if mirrored else 1.0
    turned /= np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-300)
    corners = world.astype(np.float32), turned.astype(np.float32), uvs, vertices
    if mirrored:  # such an object keeps its outside
        a, b, c, d = (a.reshape(-1, 3, a.shape[1])[:, ::-1].reshape(a.shape) for a in corners)
        return a, b, c, d
    return corners
