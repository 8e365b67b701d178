"""Properties of Blender's data about packages: a mesh's package, and an object's use of it."""

import json

import bpy


def info_of(data):
    """Facts of the package that a mesh or hair was imported from, as `sdk_side/unpack.py` told."""
    return json.loads(data.rna_package.info)


def package_of(item):
    """The record of the package that an object shows, or None."""
    record = getattr(item.data, "rna_package", None)
    return record if record is not None and record.path else None


def _tier_names(self, context, text):
    record = package_of(self.id_data)
    return [] if record is None else [tier["name"] for tier in json.loads(record.info)["tiers"]]


class RnaPackage(bpy.types.PropertyGroup):
    """Package of a mesh or hair data-block, shared by objects with the same data."""

    path: bpy.props.StringProperty(
        name="Package",
        description="The .rna file, or the .glb that carries it",
        subtype="FILE_PATH",
        options={"PATH_SUPPORTS_BLEND_RELATIVE"},
    )
    part: bpy.props.IntProperty(
        name="Part", description="Which part of the package this is; part 0 stands for all"
    )
    info: bpy.props.StringProperty(description="Facts of the package, JSON")
    stamp: bpy.props.StringProperty(description="When the file was written that was imported")


class RnaInstance(bpy.types.PropertyGroup):
    """Render settings of an object's package."""

    tier: bpy.props.StringProperty(
        name="Tier",
        description="Choice of speed and accuracy; the package's first one if left empty",
        search=_tier_names,
    )
    emission: bpy.props.FloatProperty(
        name="Emission", description="Factor on the light that it sends out", default=1.0, min=0.0
    )


class RnaRenderSettings(bpy.types.PropertyGroup):
    """Render settings of a scene."""

    samples: bpy.props.IntProperty(
        name="Samples", description="Samples a pixel", default=64, min=1, max=1 << 20
    )
    max_depth: bpy.props.IntProperty(
        name="Max Depth",
        description="Surfaces on the path of light to the camera, the visible one included; "
        "1 is direct light only",
        default=8,
        min=1,
        max=64,
    )
    auto_clamp: bpy.props.BoolProperty(
        name="Automatic Clamp",
        description="Clamp indirect light at 10 times the mean radiance of a white ball there",
        default=True,
    )
    clamp_indirect: bpy.props.FloatProperty(
        name="Clamp Indirect",
        description="Clamp on per-path indirect radiance without the automatic one; 0 for none",
        default=0.0,
        min=0.0,
    )
    seed: bpy.props.IntProperty(name="Seed", min=0)
    animate_seed: bpy.props.BoolProperty(
        name="Animate Seed", description="Add the frame's number to the seed"
    )
    denoise: bpy.props.BoolProperty(
        name="Denoise", description="With Intel Open Image Denoise, once all samples are there"
    )
    max_error: bpy.props.FloatProperty(
        name="Max Error",
        description="Largest error of an asset, as mean FLIP at its size in the image; assets "
        "without a tier of their own get the cheapest that meets it. 0 for their first tier",
        default=0.0,
        min=0.0,
        max=1.0,
    )
    threads: bpy.props.IntProperty(
        name="Threads", description="0 for one a core", default=0, min=0, max=4096
    )


class RnaPasses(bpy.types.PropertyGroup):
    """Passes of a view layer for which Blender has no option."""

    asset_index: bpy.props.BoolProperty(
        name="Asset Index", description="Number of the object in the scene, from 1; assets first"
    )
    visibility: bpy.props.BoolProperty(
        name="Visibility", description="Part of the light samples that nothing stands in the way of"
    )


CLASSES = (RnaPackage, RnaInstance, RnaRenderSettings, RnaPasses)
_register_classes, _unregister_classes = bpy.utils.register_classes_factory(CLASSES)


def register():
    _register_classes()
    bpy.types.Mesh.rna_package = bpy.props.PointerProperty(type=RnaPackage)
    bpy.types.Curves.rna_package = bpy.props.PointerProperty(type=RnaPackage)
    bpy.types.Object.rna_instance = bpy.props.PointerProperty(type=RnaInstance)
    bpy.types.Scene.rna_render = bpy.props.PointerProperty(type=RnaRenderSettings)
    bpy.types.ViewLayer.rna_passes = bpy.props.PointerProperty(type=RnaPasses)


def unregister():
    del bpy.types.ViewLayer.rna_passes
    del bpy.types.Scene.rna_render, bpy.types.Object.rna_instance
    del bpy.types.Curves.rna_package, bpy.types.Mesh.rna_package
    _unregister_classes()
