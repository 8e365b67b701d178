"""Panels: facts of a package, options of the engine, the bake."""

import bpy

from .bake.operators import job_of
from .engine import RnaEngine
from .properties import info_of, package_of

_SHARED = (  # panels of Blender whose settings a render with rna-run has
    "DATA_PT_camera",
    "DATA_PT_context_light",
    "DATA_PT_EEVEE_light",
    "DATA_PT_lens",
    "DATA_PT_light",
    "EEVEE_MATERIAL_PT_context_material",
    "EEVEE_MATERIAL_PT_surface",
    "EEVEE_WORLD_PT_surface",
    "RENDER_PT_color_management",
    "RENDER_PT_format",
    "RENDER_PT_frame_range",
    "RENDER_PT_output",
    "RENDER_PT_post_processing",
    "RENDER_PT_stamp",
    "VIEWLAYER_PT_layer",
    "WORLD_PT_context_world",
)


class _Properties:
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"


class PackagePanel(_Properties, bpy.types.Panel):
    bl_idname = "OBJECT_PT_rna_package"
    bl_label = "Neural Asset"
    bl_context = "object"

    @classmethod
    def poll(cls, context):
        return context.object is not None and package_of(context.object) is not None

    def draw(self, context):
        item, column = context.object, self.layout.column()
        record, info = package_of(item), info_of(item.data)
        column.prop(record, "path")
        if record.part:
            column.label(text=f"part {info['parts'][record.part]['name']!r}, goes with the first")
            return
        column.prop(item.rna_instance, "tier")
        column.prop(item.rna_instance, "emission")
        for tier in info["tiers"]:
            column.label(text=tier_line(tier))
        for name in ("source", "license", "tool", "generator"):
            column.label(text=f"{name.title()}: {info[name]}")
        row = column.row()
        row.operator("rna.show_in_browser")
        row.operator("rna.write_web_page")


def tier_line(tier):
    """`small: FLIP 0.063 (good: differences show in close-ups), 156 ns/query`."""
    facts = [
        f"FLIP {tier['flip']:.3f} ({tier['words']})" if tier["flip"] is not None else None,
        f"{tier['nsPerQuery']:.0f} ns/query" if tier["nsPerQuery"] is not None else None,
    ]
    return f"{tier['name']}: {', '.join(f for f in facts if f) or 'no figures recorded'}"


class BakePanel(_Properties, bpy.types.Panel):
    bl_idname = "OBJECT_PT_rna_bake"
    bl_label = "Bake Neural Asset"
    bl_context = "object"
    bl_options = {"DEFAULT_CLOSED"}  # noqa: RUF012

    @classmethod
    def poll(cls, context):
        return context.object is not None and package_of(context.object) is None

    def draw(self, context):
        column, settings = self.layout.column(), context.object.rna_bake
        column.use_property_split = True
        for name in ("out", "presets", "minutes", "goal", "license", "options"):
            column.prop(settings, name)
        job = job_of(context.object)
        if job is None or not job.is_begun():
            column.operator("rna.bake")
            return
        status = job.status()
        if status.state == "running":
            column.progress(factor=status.share, text=status.text)
            column.operator("rna.stop_bake")
        else:
            column.label(text=f"{status.state}: {status.text}" if status.text else status.state)
            row = column.row()
            if status.state != "finished":
                row.operator("rna.bake", text="Continue").anew = False
            row.operator("rna.bake", text="Bake Anew").anew = True
            if status.state == "finished":
                column.prop(settings, "more")
                column.operator("rna.bake_more")
        for line in job.lines(4):
            column.label(text=line)
        column.operator("rna.show_errors")
        column.operator("rna.replace")


class _OfEngine(_Properties):
    COMPAT_ENGINES = {RnaEngine.bl_idname}  # noqa: RUF012

    @classmethod
    def poll(cls, context):
        return context.engine in cls.COMPAT_ENGINES


class SamplingPanel(_OfEngine, bpy.types.Panel):
    bl_idname = "RENDER_PT_rna_sampling"
    bl_label = "RNA"
    bl_context = "render"

    def draw(self, context):
        column, scene = self.layout.column(), context.scene
        column.use_property_split = True
        for name in type(scene.rna_render).bl_rna.properties:
            if name.identifier not in ("rna_type", "name"):
                column.prop(scene.rna_render, name.identifier)
        column.prop(scene.render, "film_transparent")
        if hasattr(scene, "cycles"):
            column.prop(scene.cycles, "film_exposure")


class PassesPanel(_OfEngine, bpy.types.Panel):
    bl_idname = "VIEWLAYER_PT_rna_passes"
    bl_label = "Passes"
    bl_context = "view_layer"

    def draw(self, context):
        column, layer = self.layout.column(), context.view_layer
        for name in ("z", "normal", "position", "object_index"):
            column.prop(layer, f"use_pass_{name}")
        column.prop(layer.rna_passes, "asset_index")
        column.prop(layer.rna_passes, "visibility")


CLASSES = (PackagePanel, BakePanel, SamplingPanel, PassesPanel)
_register_classes, _unregister_classes = bpy.utils.register_classes_factory(CLASSES)


def _shared():
    result = (getattr(bpy.types, name, None) for name in _SHARED)
    return [panel for panel in result if panel is not None and hasattr(panel, "COMPAT_ENGINES")]


def register():
    _register_classes()
    for panel in _shared():
        panel.COMPAT_ENGINES.add(RnaEngine.bl_idname)


def unregister():
    for panel in _shared():
        panel.COMPAT_ENGINES.discard(RnaEngine.bl_idname)
    _unregister_classes()
