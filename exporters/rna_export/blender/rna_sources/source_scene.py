"""Loads the source (a scene, model, groom or script) and removes everything but the asset."""

import contextlib
import io
import runpy
import sys
from pathlib import Path

import bpy
from listing import listed
from rna_geometry import left_out, render_only, shown_objects
from rna_geometry.shown_objects import as_rendered
from rna_materials import material_check
from rna_materials.emission import nodes_of
from rna_preflight import material_facts, missing_uvs
from rna_sources import (
    camera_visibility,
    gltf_import,
    groom_source,
    hair_scene,
    imported_colours,
    mesh_repair,
    orientation,
    scene_import,
    shown_frame,
    usd_curves,
)
from rna_sources.source_formats import SOURCE_FORMATS


def load(
    source: str, arguments: list[str], frame: int | None, front: str | None, up: str | None
) -> list[str]:
    """Replace the current scene by `source`; returns notes for the user.

    `arguments` become a script's `sys.argv[1:]`, or set what a groom does not say of its hair.
    `frame`: that is shown; None for the file's own. `front`, `up`: axes of the file, such as "-Y";
    None for the usual ones of its kind.
    """
    suffix = Path(source).suffix.lower()
    notes = _open(source, suffix, arguments, frame)
    notes += shown_frame.go_to(frame)
    notes += mesh_repair.repair()
    usual = SOURCE_FORMATS[suffix].up
    orientation.turn(front, up, usd_curves.up_is_z(source) if usual == "USD" else usual == "Z")
    return notes


def _open(source: str, suffix: str, arguments: list[str], frame: int | None) -> list[str]:
    """Returns notes of the import."""
    if suffix not in SOURCE_FORMATS:
        *kinds, last = SOURCE_FORMATS
        raise ValueError(f"cannot load {source}: expected {', '.join(kinds)} or {last}")
    if suffix == ".blend":
        bpy.ops.wm.open_mainfile(filepath=source, use_scripts=False)
        _check_libraries()
        _make_local()
        return []
    bpy.ops.wm.read_factory_settings(use_empty=True)
    notes: list[str] = []
    match SOURCE_FORMATS[suffix].reader:
        case "gltf":
            notes = gltf_import.load(source)
        case "groom":
            notes = groom_source.load(source, arguments)
        case "obj":
            bpy.ops.wm.obj_import(filepath=source)
        case "ply":
            bpy.ops.wm.ply_import(filepath=source)
        case "scene":
            notes = scene_import.load(source, arguments, frame)
        case "script":
            _run_script(source, arguments)
            mesh_repair.sort_polygons()
    if SOURCE_FORMATS[suffix].reader in ("obj", "ply", "scene"):
        imported_colours.show_on_meshes()
    return notes


def _check_libraries() -> None:
    """Refuse a file with missing libraries; Blender would show nothing in their place."""
    kinds = "objects collections meshes hair_curves curves materials node_groups images".split()
    missing = [item for kind in kinds for item in getattr(bpy.data, kind) if item.is_missing]
    if not missing:
        return
    library = missing[0].library
    path = bpy.path.abspath(library.filepath, library=library.parent)
    here = [item for item in missing if item.library == library]
    lacks = f"has no {listed([f'{item.rna_type.identifier} {item.name!r}' for item in here])}"
    what = lacks if Path(path).is_file() else "is missing"
    raise ValueError(f"the linked library {path} {what}: {material_check.FIND}")


def _make_local() -> None:
    """Linked objects and their collections cannot change; converted hair has to."""
    for kind in (bpy.data.collections, bpy.data.objects):
        for item in list(kind):
            if item.library is not None:
                item.make_local()


def _run_script(source: str, arguments: list[str]) -> None:
    sys.argv = [source, *arguments]
    sys.path.append(str(Path(source).parent))  # modules that lie beside it
    said = io.StringIO()
    try:
        with contextlib.redirect_stderr(said):
            runpy.run_path(source, run_name="__main__")
    except SystemExit as end:  # so does argparse refuse arguments
        if end.code not in (None, 0):
            line = said.getvalue().strip().rpartition("\n")[2]
            raise ValueError(f"the script ended itself: {line or end.code}") from None
    finally:
        sys.stderr.write(said.getvalue())


def keep_only_the_asset() -> list[str]:
    """Remove lights and cameras, blacken the world.

    Returns what a user should know about, one sentence each.
    """
    _show_what_is_rendered()
    notes: list[str] = []
    for item in list(bpy.data.objects):
        if item.type in ("LIGHT", "CAMERA", "LIGHT_PROBE"):
            bpy.data.objects.remove(item, do_unlink=True)
    world = bpy.data.worlds.new("black")
    world.use_nodes = True
    world.node_tree.nodes.clear()  # a world without an output is black
    bpy.context.scene.world = world
    notes += hair_scene.prepare_hair(
        [(m, list(nodes_of(m.node_tree))) for m in bpy.data.materials if m.use_nodes]
    )
    notes += [*camera_visibility.leave_out_unseen(), *_hide_what_no_package_holds()]
    as_rendered(render_only.refuse)
    as_rendered(_refuse_volumes)
    notes += [
        f"object {name!r} has curves of geometry nodes without a surface, which Cycles does not "
        "render; Curve to Mesh makes tubes of them, and in a hair curves object they are hair"
        for name in as_rendered(shown_objects.bare_curves)
    ]
    return [*notes, *as_rendered(_what_surprises)]


def _what_surprises() -> list[str]:
    """Notes on likely mistakes of an artist."""
    return [*left_out.notes(), *missing_uvs.problems(), *material_check.problems()]


_HELD_BY_NONE = {
    "VOLUME": "a volume",
    "POINTCLOUD": "a point cloud",
    "GREASEPENCIL": "a grease pencil drawing",
}
"""Types of objects that no package holds. Those that Cycles renders would shade the rest."""


def _hide_what_no_package_holds() -> list[str]:
    """A note for each such object."""
    notes = []
    for item, kind in as_rendered(_held_by_none).values():
        item.hide_render = item.hide_viewport = True
        notes.append(f"object {item.name!r} is {kind}, which no package holds, and was hidden")
    return notes


def _refuse_volumes() -> None:
    """Raise ValueError for volumes without a surface."""
    for name in material_facts.volumes_alone():
        raise ValueError(
            f"material {name!r} is a volume without a surface: an asset is the light of surfaces "
            "and strands, and nothing of it could be learnt; hide its objects in renders to "
            "capture the rest"
        )


def _held_by_none() -> dict[str, tuple[bpy.types.Object, str]]:
    """Such objects by name, and the kind of each."""
    result = {}
    for instance in shown_objects.instances():
        item = instance.object
        if item.type in _HELD_BY_NONE:
            result[item.original.name_full] = item.original, _HELD_BY_NONE[item.type]
    return result


def _show_what_is_rendered() -> None:
    """Set the viewport to the settings of renders: particle hair is converted there."""
    scene, layer = bpy.context.scene, bpy.context.view_layer
    scene.render.simplify_subdivision = scene.render.simplify_subdivision_render
    collections = [layer.layer_collection]
    for collection in collections:  # grows as it goes
        collection.hide_viewport = False
        collections += collection.children
    for item in layer.objects:
        item.hide_set(False)
    for group in bpy.data.collections:
        group.hide_viewport = group.hide_render
    for item in bpy.data.objects:
        item.hide_viewport = item.hide_render
        item.show_instancer_for_viewport = item.show_instancer_for_render
        for modifier in item.modifiers:
            modifier.show_viewport = modifier.show_render
            if modifier.type in ("SUBSURF", "MULTIRES"):
                modifier.levels = modifier.render_levels
            elif modifier.type == "SCREW":
                modifier.steps = modifier.render_steps
    for curve in bpy.data.curves:
        curve.resolution_u = curve.render_resolution_u or curve.resolution_u
        curve.resolution_v = curve.render_resolution_v or curve.resolution_v
    for ball in bpy.data.metaballs:
        ball.resolution = ball.render_resolution


def blender_version() -> str:
    return str(bpy.app.version_string)
