"""Where the SDK is: the extension's preferences."""

import bpy

from . import sdk, set_up


class Preferences(bpy.types.AddonPreferences):
    """Preferences of the extension"""

    bl_idname = __package__

    sdk_python: bpy.props.StringProperty(
        name="Python of the SDK",
        description="Interpreter of the environment that the SDK is installed in; if left empty, "
        f"the interpreter of {sdk.VARIABLE}, of Set Up, or of rna-run on the PATH",
        subtype="FILE_PATH",
    )

    def draw(self, context):
        column = self.layout.column()
        column.prop(self, "sdk_python")
        try:
            column.label(text=f"Found: {sdk.find_python()}", icon="CHECKMARK")
        except sdk.SdkError as error:
            column.label(text=str(error), icon="ERROR")
        said = set_up.last_line()
        if said is not None:
            column.label(text=f"Setting up: {said}", icon="TIME")
            return
        row = column.row()
        row.operator("rna.set_up", text="Set Up for Rendering").bake = False
        row.operator("rna.set_up", text="Set Up for Baking, Too").bake = True


register, unregister = bpy.utils.register_classes_factory((Preferences,))
