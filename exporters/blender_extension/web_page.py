"""An asset as a web page: in the browser, or as a folder to upload."""

import time
from pathlib import Path

import bpy
from bpy_extras.io_utils import ExportHelper

from .properties import package_of
from .sdk import SdkError
from .sdk_command import Command, run

_COMMAND = ("-m", "rna_view.rna_view_command")
_PATIENCE = 30.0  # seconds until the page has an address
_shown = {}
"""Running servers of pages, by the package's path."""


class _OfPackage:
    @classmethod
    def poll(cls, context):
        return context.object is not None and package_of(context.object) is not None


class ShowInBrowser(_OfPackage, bpy.types.Operator):
    """Show the asset in the web browser, until Blender ends"""

    bl_idname = "rna.show_in_browser"
    bl_label = "Show in Browser"

    def execute(self, context):
        path = _path(context.object)
        _end(path)
        try:
            _shown[path] = command = Command([*_COMMAND, path], _log())
            self.report({"INFO"}, _address(command))
        except SdkError as error:
            self.report({"ERROR"}, f"{path.name}: {error}")
            return {"CANCELLED"}
        return {"FINISHED"}


class WriteWebPage(_OfPackage, bpy.types.Operator, ExportHelper):
    """Write a folder with the asset's web page, for any web server"""

    bl_idname = "rna.write_web_page"
    bl_label = "Write Web Page"
    filename_ext = ""

    def invoke(self, context, event):
        path = _path(context.object)
        self.filepath = str(path.with_name(f"{path.stem}-page"))
        return super().invoke(context, event)

    def execute(self, context):
        path, folder = _path(context.object), Path(bpy.path.abspath(self.filepath))
        try:
            run([*_COMMAND, path, "--export", folder], _log())
        except SdkError as error:
            self.report({"ERROR"}, f"{path.name}: {error}")
            return {"CANCELLED"}
        self.report({"INFO"}, f"wrote {folder}: copy this folder to a web server (HTTPS)")
        return {"FINISHED"}


def _path(item):
    return Path(bpy.path.abspath(package_of(item).path)).resolve()


def _log():
    return Path(bpy.app.tempdir) / "rna-view.log"


def _address(command):
    """The line with the page's address. Raises SdkError if the command ends before it has one."""
    end = time.monotonic() + _PATIENCE
    while command.is_running() and time.monotonic() < end:
        for line in command.lines():
            if " at http://" in line:
                return line
        time.sleep(0.05)
    command.end(1.0)
    command.check()
    raise SdkError(f"no page within {_PATIENCE:.0f} s")


def _end(path):
    command = _shown.pop(path, None)
    if command is not None:
        command.end(1.0)


register, _unregister_classes = bpy.utils.register_classes_factory((ShowInBrowser, WriteWebPage))


def unregister():
    for path in list(_shown):
        _end(path)
    _unregister_classes()
