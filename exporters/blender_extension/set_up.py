"""Set Up: an environment of the SDK, made from the sources that the extension brings."""

import sys
from pathlib import Path

import bpy

from . import sdk
from .sdk_command import Command

_POLL = 1.0  # seconds
_running = None  # the Command


def last_line():
    """Last line printed by the running set-up, or None."""
    if _running is None or not _running.is_running():
        return None
    return (_running.lines() or ["starting"])[-1]


class SetUp(bpy.types.Operator):
    """Install the RNA SDK and its dependencies into a separate environment, outside of Blender"""

    bl_idname = "rna.set_up"
    bl_label = "Set Up the RNA SDK"

    bake: bpy.props.BoolProperty(
        name="For Baking, Too",
        description="PyTorch and a second Blender, as a module, which captures (gigabytes)",
    )

    def execute(self, context):
        if not sdk.version():
            self.report({"ERROR"}, f"the extension brings no SDK: {sdk.SOURCE} is missing")
            return {"CANCELLED"}
        if last_line() is not None:
            self.report({"ERROR"}, "the set-up is running")
            return {"CANCELLED"}
        _start(self.bake)
        if not bpy.app.background:
            bpy.app.timers.register(_look, first_interval=_POLL)
            return {"FINISHED"}
        _running.wait()
        return self._report_status()

    def _report_status(self):
        try:
            _running.check()
        except sdk.SdkError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.report({"INFO"}, _running.lines()[-1])
        return {"FINISHED"}


def _start(bake):
    global _running
    folder = sdk.default_folder()
    folder.parent.mkdir(parents=True, exist_ok=True)
    script = Path(__file__).with_name("environment_setup.py")
    what = ["train", "--blender"] if bake else ["render"]
    log = folder.parent / "set-up.log"
    _running = Command([script, folder, sdk.SOURCE, *what], log, python=sys.executable)


def _look():
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            area.tag_redraw()
    return _POLL if _running.is_running() else None


register, unregister = bpy.utils.register_classes_factory((SetUp,))
