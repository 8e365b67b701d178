"""Gives meshes of a USD file without normals their facets, which Blender's importer smooths."""

from pathlib import Path

import bpy
from listing import listed


def restore(path: Path) -> list[str]:
    """Shade imported meshes flat that are neither subdivided nor have normals; returns a note.

    A mesh is found by its prim's name and its numbers of points and faces.
    """
    from pxr import Usd, UsdGeom

    faceted = set()
    stage = Usd.Stage.Open(str(path))
    for prim in Usd.PrimRange.Stage(stage, Usd.TraverseInstanceProxies()):
        mesh = UsdGeom.Mesh(prim)
        if mesh and mesh.GetSubdivisionSchemeAttr().Get() == "none" and not _has_normals(mesh):
            counts = mesh.GetFaceVertexCountsAttr().Get(Usd.TimeCode.EarliestTime()) or ()
            points = mesh.GetPointsAttr().Get(Usd.TimeCode.EarliestTime()) or ()
            faceted.add((prim.GetName(), len(points), len(counts)))
    shown = [mesh for mesh in bpy.data.meshes if _key(mesh) in faceted]
    for mesh in shown:
        mesh.shade_flat()
    if not shown:
        return []
    names = listed([repr(mesh.name) for mesh in shown])
    return [f"the file has no normals, so these meshes have facets, as in USD: {names}"]


def _has_normals(mesh: object) -> bool:
    from pxr import UsdGeom

    primvar = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("normals")
    return bool(primvar.HasValue() or mesh.GetNormalsAttr().HasValue())  # type: ignore[attr-defined]


def _key(mesh: bpy.types.Mesh) -> tuple[str, int, int]:
    name, dot, number = mesh.name.rpartition(".")
    plain = name if dot and number.isdigit() else mesh.name
    return plain, len(mesh.vertices), len(mesh.polygons)
