"""Runs in Blender's Python: one scene around an asset, rendered with Cycles or with our engine.

    python blender_stage.py ORDER.json

ORDER.json names the engine, the original (a script) or the package, and where images go.
"""

import json
import os
import runpy
import sys

import bpy
import mathutils


def main():
    with open(sys.argv[1]) as file:
        options = json.load(file)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    if options["engine"] == "CYCLES":
        add_original(options)
    else:
        install(options["extension"])
        bpy.ops.rna.import_package(filepath=options["package"])
    lift(scene, options["height"])
    add_light_and_ground(scene, options)
    scene.render.engine = options["engine"]
    scene.render.filepath = options["out"]
    if options["engine"] == "RNA":
        scene.rna_render.samples = options["samples"]
        scene.rna_render.auto_clamp = False
        bpy.ops.rna.export_scene(filepath=options["folder"])
    else:
        cycles = scene.cycles
        cycles.samples, cycles.use_denoising = options["samples"], False
        cycles.pixel_filter_type, cycles.filter_width = "BOX", 1.0
        cycles.sample_clamp_indirect = 0.0
    bpy.ops.render.render(write_still=True)
    sys.stdout.flush()
    os._exit(0)  # bpy may crash while it unloads


def install(extension):
    bpy.ops.extensions.package_install_files(
        filepath=extension, repo="user_default", enable_on_install=True
    )


def add_original(options):
    sys.path.append(options["hairFolder"])
    arguments, sys.argv = sys.argv, [options["original"]]
    runpy.run_path(options["original"], run_name="__main__")
    sys.argv = arguments
    for item in [item for item in bpy.data.objects if item.type in ("LIGHT", "CAMERA")]:
        bpy.data.objects.remove(item)


def lift(scene, height):
    handle = bpy.data.objects.new("handle", None)
    scene.collection.objects.link(handle)
    for item in [item for item in scene.objects if item.parent is None and item != handle]:
        item.parent = handle
    handle.location.z = height


def add_light_and_ground(scene, options):
    """A diffuse floor and wall, a lamp, a sky, a camera: what both engines know alike."""
    add_plane("floor", (0.42, 0.4, 0.37), (0, 0, 0), (0, 0, 0), 12)
    add_plane("wall", (0.55, 0.12, 0.08), (-0.35, 0.6, 0.4), (1.5708, 0, 0.35), 0.9)
    lamp = bpy.data.lights.new("lamp", "AREA")
    lamp.energy, lamp.size, lamp.color = 55.0, 0.8, (1.0, 0.93, 0.83)
    add(scene, "lamp", lamp, (1.4, -1.2, 1.8), options["target"])
    camera = bpy.data.cameras.new("camera")
    camera.lens = 60.0
    scene.camera = add(scene, "camera", camera, options["camera"], options["target"])
    world = bpy.data.worlds.new("sky")
    use_nodes(world)
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.2, 0.24, 0.32, 1)
    scene.world = world
    render = scene.render
    render.resolution_x, render.resolution_y = options["resolution"]
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth, render.image_settings.color_mode = "32", "RGBA"


def use_nodes(block):
    """Gives a world or material a node tree; newer Blender versions always have one, and warn."""
    if not block.node_tree:
        block.use_nodes = True


def add_plane(name, colour, location, turn, size):
    bpy.ops.mesh.primitive_plane_add(size=size, location=location, rotation=turn)
    material = bpy.data.materials.new(name)
    use_nodes(material)
    tree = material.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (*colour, 1)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    bpy.context.object.data.materials.append(material)


def add(scene, name, data, place, target):
    item = bpy.data.objects.new(name, data)
    item.location = place
    direction = mathutils.Vector(target) - item.location
    item.rotation_euler = direction.to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(item)
    return item


if __name__ == "__main__":
    main()
