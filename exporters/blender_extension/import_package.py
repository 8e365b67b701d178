"""File > Import > Relightable Neural Asset."""

from pathlib import Path

import bpy
from bpy_extras.io_utils import ImportHelper

from .package_data import load_package
from .properties import info_of
from .sdk import SdkError


class ImportPackage(bpy.types.Operator, ImportHelper):
    """Import a relightable neural asset: its geometry, for the viewport and the RNA engine"""

    bl_idname = "rna.import_package"
    bl_label = "Import Relightable Neural Asset"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012
    filename_ext = ".rna"
    filter_glob: bpy.props.StringProperty(default="*.rna;*.glb", options={"HIDDEN"})

    def execute(self, context):
        path = Path(bpy.path.abspath(self.filepath)).resolve()
        try:
            item = import_package(context, path)
        except SdkError as error:
            self.report({"ERROR"}, f"{path.name}: {error}")
            return {"CANCELLED"}
        self.report({"INFO"}, f"imported {path.name} as {item.name!r}")
        return {"FINISHED"}


def import_package(context, path):
    """Add an object that shows the package; parts beside the first are its children.

    A package that the file has already is not read again: objects share its data.
    """
    data = _data_in_file(path)
    if data is None:
        data, _ = load_package(path)
    first = None
    for block in data:
        item = bpy.data.objects.new(block.name, block)
        context.collection.objects.link(item)
        if first is None:
            first = item
            item.location = context.scene.cursor.location
        else:
            _fix_to(first, item)
    for item in context.selected_objects:
        item.select_set(False)
    first.select_set(True)
    context.view_layer.objects.active = first
    return first


def _fix_to(first, item):
    """Parts go where the first one goes, and nowhere else."""
    item.parent = first
    for lock in ("lock_location", "lock_rotation", "lock_scale"):
        setattr(item, lock, (True, True, True))


def _data_in_file(path):
    """Data-blocks of all parts of a package, if they are there and the file is no newer."""
    result = {}
    for block in (*bpy.data.meshes, *bpy.data.hair_curves):
        record = block.rna_package
        if record.path and Path(bpy.path.abspath(record.path)).resolve() == path:
            if record.stamp == str(path.stat().st_mtime_ns):
                result[record.part] = block
    if 0 not in result:
        return None
    parts = [result.get(part) for part in range(len(info_of(result[0])["parts"]))]
    return parts if None not in parts else None


def _menu(self, context):
    self.layout.operator(ImportPackage.bl_idname, text="Relightable Neural Asset (.rna, .glb)")


def register():
    bpy.utils.register_class(ImportPackage)
    bpy.types.TOPBAR_MT_file_import.append(_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(_menu)
    bpy.utils.unregister_class(ImportPackage)
