"""The settings of a file that a capture sets: radiance must not depend on how a picture was set up.

Not set is what belongs to the asset's look, such as the numbers of bounces and caustics, and what
changes no radiance. tests/exporters/blender_settings.py lists all properties of Blender.
"""

from typing import Any

import bpy

WORKING_SPACE = "Linear Rec.709"  # of colours in materials and in rendered files

OWNED: dict[str, dict[str, Any]] = {
    "RenderSettings": {
        "engine": "CYCLES",
        "threads_mode": "FIXED",
        "use_persistent_data": True,
        "film_transparent": True,
        "use_compositing": False,
        "use_sequencer": False,
        "use_freestyle": False,
        "use_stamp": False,
        "use_multiview": False,
        "use_single_layer": False,
        "use_motion_blur": False,
        "use_border": False,
        "use_crop_to_border": False,
        "resolution_percentage": 100,
        "pixel_aspect_x": 1.0,
        "pixel_aspect_y": 1.0,
        "use_file_extension": True,
        "use_overwrite": True,
        "use_placeholder": False,
        "use_render_cache": False,
    },
    "ImageFormatSettings": {
        "media_type": "MULTI_LAYER_IMAGE",
        "file_format": "OPEN_EXR_MULTILAYER",
        "color_mode": "RGBA",
        "color_depth": "32",
        "exr_codec": "NONE",
        "use_exr_interleave": False,
        "use_preview": False,
        "views_format": "INDIVIDUAL",
        "color_management": "FOLLOW_SCENE",
    },
    "CyclesRenderSettings": {
        "device": "CPU",
        "use_denoising": False,
        "use_adaptive_sampling": False,
        "use_sample_subset": False,
        "sample_offset": 0,
        "time_limit": 0.0,
        "sampling_pattern": "TABULATED_SOBOL",
        "scrambling_distance": 1.0,
        "auto_scrambling_distance": False,
        "transparent_max_bounces": 64,  # as many layers as a view ray of ours passes
        "use_layer_samples": "IGNORE",
        "use_animated_seed": False,
        "light_sampling_threshold": 0.0,
        "direct_light_sampling_type": "MULTIPLE_IMPORTANCE_SAMPLING",
        "use_light_tree": False,
        "use_guiding": False,
        "use_fast_gi": False,
        "film_exposure": 1.0,
        "film_transparent_glass": False,
        "use_camera_cull": False,
        "use_distance_cull": False,
        "texture_limit_render": "OFF",
        "rolling_shutter_type": "NONE",
        "debug_bvh_layout": "EMBREE",
        "debug_use_hair_bvh": True,
        "debug_bvh_type": "DYNAMIC_BVH",
        "debug_use_spatial_splits": False,
        "debug_use_compact_bvh": False,
    },
    "CyclesCurveRenderSettings": {"shape": "THICK_LINEAR"},
    "ViewLayer": {
        "use": True,
        "world_override": None,
        "samples": 0,
        "pass_alpha_threshold": 0.5,
        "use_solid": True,
        "use_strand": True,
        "use_volumes": True,
        "use_grease_pencil": False,
        "use_sky": True,
        "use_ao": True,
        "use_pass_combined": True,
        "use_pass_position": True,
    },
    "CyclesRenderLayerSettings": {"use_denoising": True, "use_pass_shadow_catcher": False},
}
"""RNA type -> property -> its value in every capture."""


def apply() -> None:
    """Set the current scene to render its active view layer as captures do."""
    scene, layer = bpy.context.scene, bpy.context.view_layer
    if bpy.data.colorspace.working_space != WORKING_SPACE:
        bpy.ops.wm.set_working_color_space(working_space=WORKING_SPACE, convert_colors=True)
    for other in list(scene.view_layers):
        if other != layer:  # a render writes all layers into one file
            scene.view_layers.remove(other)
    _clear_passes(layer)
    for owner in owners(scene, layer):
        for name, value in OWNED[owner.bl_rna.identifier].items():
            setattr(owner, name, value)


def owners(scene: bpy.types.Scene, layer: bpy.types.ViewLayer) -> list[bpy.types.bpy_struct]:
    """Owners of the properties of `OWNED`, in its order."""
    render = scene.render
    curves = scene.cycles_curves
    return [render, render.image_settings, scene.cycles, curves, layer, layer.cycles]


def _clear_passes(layer: bpy.types.ViewLayer) -> None:
    """Remove the file's passes: they cost time, and their names may clash with ours."""
    for owner in (layer, layer.cycles):
        for prop in owner.bl_rna.properties:
            is_pass = prop.identifier.startswith(("use_pass_", "pass_")) and prop.type == "BOOLEAN"
            if is_pass and prop.identifier != "use_pass_cryptomatte_accurate":
                setattr(owner, prop.identifier, False)
    for aov in list(layer.aovs):
        layer.aovs.remove(aov)
