"""The triangles that show a material: their texture coordinates and attributes."""

from dataclasses import dataclass, field

import bpy
import numpy as np
from rna_geometry import shown_objects
from rna_geometry.attributes import read, uv_map
from rna_geometry.shown_objects import HAIR, SURFACES
from rna_materials.object_materials import materials_of

_KINDS = {  # data type of an attribute -> property, components
    "FLOAT": ("value", 1),
    "INT": ("value", 1),
    "BOOLEAN": ("value", 1),
    "FLOAT2": ("vector", 2),
    "FLOAT_VECTOR": ("vector", 3),
    "FLOAT_COLOR": ("color", 4),
    "BYTE_COLOR": ("color", 4),
}


@dataclass
class Use:
    """All triangles of one mesh that show a material.

    object: the name of one that has the mesh. positions: (3t, 3), object space. scale: of that in
    the world, of the first instance. layers: UV maps,
    (3t, 2) each; "" is the one that renders use by default. attributes: (3t, 4) each, 0 beyond
    their own components and 1 for a missing alpha, as Cycles has them; "" is the default colour.
    """

    object: str
    positions: np.ndarray
    scale: float = 1.0
    layers: dict[str, np.ndarray] = field(default_factory=dict)
    attributes: dict[str, np.ndarray] = field(default_factory=dict)


@dataclass
class Wanted:
    """UV maps and attributes that a material's nodes name."""

    layers: set[str] = field(default_factory=set)
    attributes: set[str] = field(default_factory=set)


def named(names: set[str]) -> list[bpy.types.Material]:
    """The materials of these full names, which tell libraries apart as plain names do not."""
    return [material for material in bpy.data.materials if material.name_full in names]


def shown_materials() -> tuple[set[str], set[str]]:
    """Full names of the materials of rendered surfaces, and of rendered hair."""
    materials: dict[bool, set[str]] = {False: set(), True: set()}
    for instance in shown_objects.seen():
        if instance.object.type in (*SURFACES, HAIR):
            names = (m.name_full for m in materials_of(instance.object) if m is not None)
            materials[instance.object.type == HAIR].update(names)
    return materials[False], materials[True]


def uses_of(wanted: dict[str, Wanted]) -> dict[str, list[Use]]:
    """Each material's uses, by its full name; a mesh counts once, whatever its instances."""
    result: dict[str, list[Use]] = {name: [] for name in wanted}
    seen = set()
    for instance in shown_objects.seen():
        if instance.object.type not in SURFACES:
            continue
        names = [None if m is None else m.name_full for m in materials_of(instance.object)]
        key = (instance.object.data.as_pointer(), instance.object.type, *names)
        if key in seen or not wanted.keys() & set(names):
            continue
        seen.add(key)
        mesh = instance.object.to_mesh()
        try:
            scale = float(np.cbrt(abs(instance.matrix_world.to_3x3().determinant())))
            _add_uses(result, wanted, Use(instance.object.name, np.empty(0), scale), mesh, names)
        finally:
            instance.object.to_mesh_clear()
    return result


def _add_uses(
    result: dict[str, list[Use]],
    wanted: dict[str, Wanted],
    of: Use,
    mesh: bpy.types.Mesh,
    materials: list[str | None],
) -> None:
    mesh.calc_loop_triangles()
    triangles = len(mesh.loop_triangles)
    slot = np.clip(
        read(mesh.loop_triangles, "material_index", triangles, np.int32), 0, len(materials) - 1
    )
    corners = {
        domain: read(mesh.loop_triangles, of, 3 * triangles, np.int32).reshape(-1, 3)
        for domain, of in (("POINT", "vertices"), ("CORNER", "loops"))
    }
    faces = read(mesh.loop_triangles, "polygon_index", triangles, np.int32)
    corners["FACE"] = np.repeat(faces[:, None], 3, axis=1)
    points = read(mesh.vertices, "co", 3 * len(mesh.vertices)).reshape(-1, 3)
    for material in wanted.keys() & set(materials):
        rows = np.isin(slot, [k for k, each in enumerate(materials) if each == material])
        if not rows.any():
            continue
        at = {domain: index[rows].ravel() for domain, index in corners.items()}
        use = Use(of.object, points[at["POINT"]], of.scale)
        for layer in wanted[material].layers | wanted[material].attributes:
            if (uvs := uv_map(mesh, layer)) is not None:
                use.layers[layer] = uvs[at["CORNER"]]
        for attribute in wanted[material].attributes - (use.layers.keys() - {""}):
            if (values := _attribute(mesh, attribute, at)) is not None:
                use.attributes[attribute] = values
        result[material].append(use)


def _attribute(mesh: bpy.types.Mesh, name: str, at: dict[str, np.ndarray]) -> np.ndarray | None:
    attribute = mesh.attributes.get(name or mesh.attributes.default_color_name)
    if attribute is None:
        return None
    if attribute.data_type not in _KINDS or attribute.domain not in at:
        return np.full((len(at["POINT"]), 4), np.nan, np.float32)  # equal to nothing
    what, components = _KINDS[attribute.data_type]
    dtype = {"INT": np.int32, "BOOLEAN": bool}.get(attribute.data_type, np.float32)
    values = read(attribute.data, what, components * len(attribute.data), dtype)
    point_values = values.reshape(-1, components)[at[attribute.domain]].astype(np.float32)
    if components == 1:
        point_values = np.repeat(point_values, 3, axis=1)
    result = np.zeros((len(point_values), 4), np.float32)
    result[:, 3] = 1.0
    result[:, : point_values.shape[1]] = point_values
    return result
