"""File > Export > RNA Scene: the scene file that a render would be given."""

import shlex
from pathlib import Path

import bpy
from bpy_extras.io_utils import ExportHelper

from .engine import size_of
from .scene.description import write_scene
from .sdk import SdkError


class ExportScene(bpy.types.Operator, ExportHelper):
    """Write the scene for rna-run: a folder with scene.yaml, and meshes and images beside it"""

    bl_idname = "rna.export_scene"
    bl_label = "Export RNA Scene"
    filename_ext = ""

    def execute(self, context):
        folder = Path(bpy.path.abspath(self.filepath))
        try:
            folder.mkdir(parents=True, exist_ok=True)
            depsgraph = context.evaluated_depsgraph_get()
            described = write_scene(depsgraph, folder, size_of(context.scene.render))
        except (SdkError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for line in described.notes:
            self.report({"WARNING"}, line)
        preview = shlex.join(["rna-run", str(described.path), "--preview"])
        self.report({"INFO"}, f"wrote {described.path}; next: {preview}")
        return {"FINISHED"}


def _menu(self, context):
    self.layout.operator(ExportScene.bl_idname, text="RNA Scene (folder)")


def register():
    bpy.utils.register_class(ExportScene)
    bpy.types.TOPBAR_MT_file_export.append(_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(_menu)
    bpy.utils.unregister_class(ExportScene)
