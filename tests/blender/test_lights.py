"""Lamps, worlds, exposure and diffuse materials: the engine and Cycles give one picture."""

from pathlib import Path

import numpy as np
import OpenEXR
import pytest

pytestmark = pytest.mark.blender

SCENE = """
import math
import mathutils
import numpy as np

def diffuse(name, colour):
    material = bpy.data.materials.new(name)
    material.node_tree or setattr(material, "use_nodes", True)
    tree = material.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (*colour, 1)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    return material

def aim(item, place, target):
    item.location = place
    direction = mathutils.Vector(target) - item.location
    item.rotation_euler = direction.to_track_quat("-Z", "Y").to_euler()

def lamp(name, kind, place, target, energy, colour, **settings):
    data = bpy.data.lights.new(name, kind)
    data.energy, data.color = energy, colour
    for key, value in settings.items():
        setattr(data, key, value)
    item = bpy.data.objects.new(name, data)
    aim(item, place, target)
    item.lightgroup = name
    scene.view_layers[0].lightgroups.add(name=name)
    scene.collection.objects.link(item)
    return item

bpy.ops.mesh.primitive_plane_add(size=20)
floor = diffuse("floor", (0.5, 0.6, 0.7))
bpy.context.object.data.materials.append(floor)
tiles = bpy.data.images.new("tiles", 64, 64)  # 8 bits, sRGB
squares = np.ones((2, 2, 4), np.float32)
squares[..., :3] = [[(0.9, 0.5, 0.5), (0.5, 0.9, 0.5)], [(0.6, 0.6, 0.95), (0.8, 0.8, 0.8)]]
tiles.pixels.foreach_set(np.kron(squares, np.ones((32, 32, 1), np.float32)).reshape(-1))
texture = floor.node_tree.nodes.new("ShaderNodeTexImage")
texture.image = tiles
shader = next(node for node in floor.node_tree.nodes if node.type == "BSDF_DIFFUSE")
floor.node_tree.links.new(texture.outputs["Color"], shader.inputs["Color"])
bpy.ops.mesh.primitive_cube_add(size=1)
box = bpy.context.object
box.location, box.scale, box.rotation_euler = (-0.4, 0.2, 0.4), (-0.5, 0.7, 0.8), (0, 0, 0.5)
box.data.materials.append(diffuse("box", (0.8, 0.2, 0.1)))
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
aim(camera, (1.5, -2.5, 1.3), (-0.3, 0, 0.4))
scene.collection.objects.link(camera)
scene.camera = camera
ground = (0.1, 0, 0)
lamps = {
    "bare": lambda: (
        lamp("sun", "SUN", (0, 0, 3), (-0.5, 0.4, 0), 0.8, (1, 0.5, 0.25), angle=0.3),
        lamp("point", "POINT", (-0.9, -0.6, 1.1), ground, 12, (1, 1, 0.5), shadow_soft_size=0),
        lamp("spot", "SPOT", (0.9, -0.4, 1.7), (-0.4, -0.2, 0), 60, (1, 0.3, 1),
             shadow_soft_size=0, spot_size=1.2, spot_blend=0.4),
    ),
    # Without the sky, which they would stand in the way of: Cycles lets light through lamps.
    "shaped": lambda: (
        lamp("bulb", "POINT", (-1.2, -0.7, 0.5), ground, 9, (0.2, 1, 1), shadow_soft_size=0.15),
        lamp("long", "AREA", (0.3, 1.3, 0.9), (0.1, 0, 0.2), 15, (1, 0.8, 0.6),
             shape="RECTANGLE", size=0.3, size_y=0.9),
        lamp("disk", "AREA", (1.3, -0.3, 1.8), (-0.3, 0, 0), 20, (0.4, 0.6, 1),
             shape="DISK", size=0.6),
    ),
}[which]()
for item in lamps:
    item.scale = (1, 0.5, 1) if item.name == "long" else (1, 1, 1)
    item.visible_camera = item.name != "disk"
world = bpy.data.worlds.new("world")
scene.world = world
world.node_tree or setattr(world, "use_nodes", True)
background = world.node_tree.nodes["Background"]
background.inputs["Strength"].default_value = 0.7 if which == "bare" else 0.0
world.lightgroup = "sky"
scene.view_layers[0].lightgroups.add(name="sky")
image = bpy.data.images.new("sky", 64, 32, float_buffer=True)
v, u = np.mgrid[0:32, 0:64]
pixels = np.full((32, 64, 4), 0.1, np.float32)
for at, colour in (((22, 20), (4, 1, 0.5)), ((20, 45), (0.2, 0.5, 2))):
    near = np.exp(-((v - at[0]) ** 2 + (u - at[1]) ** 2) / 12)
    pixels[..., :3] += np.float32(near[..., None] * colour)
image.pixels.foreach_set(pixels.reshape(-1))
texture = world.node_tree.nodes.new("ShaderNodeTexEnvironment")
texture.image = image
mapping = world.node_tree.nodes.new("ShaderNodeMapping")
mapping.inputs["Rotation"].default_value = (0, 0, 0.8)
coordinate = world.node_tree.nodes.new("ShaderNodeTexCoord")
links = world.node_tree.links
links.new(coordinate.outputs["Generated"], mapping.inputs["Vector"])
links.new(mapping.outputs["Vector"], texture.inputs["Vector"])
links.new(texture.outputs["Color"], background.inputs["Color"])

render = scene.render
render.resolution_x, render.resolution_y = 96, 72
if bpy.app.version >= (5, 0):
    render.image_settings.media_type = "MULTI_LAYER_IMAGE"
render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
render.image_settings.color_depth = "32"
layer = scene.view_layers[0]
layer.use_pass_z = layer.use_pass_normal = layer.use_pass_object_index = True
box.pass_index = 7
scene.cycles.film_exposure = 0.5
scene.rna_render.samples, scene.rna_render.max_depth = 64, 3
scene.rna_render.auto_clamp = False
scene.cycles.samples, scene.cycles.max_bounces = 128, 2
scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
scene.cycles.sample_clamp_indirect = 0
scene.cycles.pixel_filter_type = "BOX"
scene.cycles.filter_width = 1.0
for engine in ("RNA", "CYCLES"):
    render.engine = engine
    render.filepath = f"//{engine}.exr" if bpy.data.filepath else os.path.abspath(f"{engine}.exr")
    bpy.ops.render.render(write_still=True)
"""
GROUPS = {"bare": ("sun", "point", "spot", "sky"), "shaped": ("bulb", "long", "disk")}


@pytest.mark.parametrize("which", GROUPS)
def test_both_engines_give_one_picture(run_in_blender, tmp_path, which):
    printed = run_in_blender(f"which = {which!r}\n{SCENE}")
    assert "Warning: " not in printed, printed
    ours, cycles = (read_passes(tmp_path / f"{engine}.exr") for engine in ("RNA", "CYCLES"))
    for name in ("Combined", *(f"Combined_{group}" for group in GROUPS[which])):
        a, b = (blocks(images[name][..., :3]) for images in (ours, cycles))
        assert a.mean() == pytest.approx(b.mean(), rel=0.02), name
        close = np.isclose(a, b, rtol=0.1, atol=0.1 * b.mean())
        assert close.mean() > 0.98, name  # one lamp's shadow in another one's light
    hit = (ours["Depth.Z"] < 1e9) & (cycles["Depth.Z"] < 1e9)
    assert hit.mean() > 0.8
    inside = hit & np.pad(hit[1:-1, 1:-1], 1)
    close = np.abs(ours["Depth.Z"] / cycles["Depth.Z"] - 1.0)[inside] < 0.02
    assert close.mean() > 0.97  # pixels at edges hold several depths
    normals = [np.stack([i[f"Normal.{c}"] for c in "XYZ"], axis=-1) for i in (ours, cycles)]
    aligned = np.sum(normals[0] * normals[1], axis=-1)[inside] > 0.99
    assert aligned.mean() > 0.95
    index = "Object Index.X" if "Object Index.X" in cycles else "IndexOB.X"  # 5.0, 4.5
    assert np.mean(ours[index] == cycles[index]) > 0.97
    assert set(np.unique(ours[index])) == {0.0, 7.0}


def read_passes(path: Path) -> dict[str, np.ndarray]:
    """Passes of the view layer of Blender's multilayer EXR, whose parts are passes since 5.0."""
    actual: dict[str, np.ndarray] = {}
    with OpenEXR.File(str(path)) as file:
        for part in file.parts:
            for name, channel in part.channels.items():
                actual[name.removeprefix("ViewLayer.")] = channel.pixels
    return actual


def blocks(image: np.ndarray, side: int = 12) -> np.ndarray:
    """Means of blocks of pixels."""
    height, width, channels = image.shape
    return image.reshape(height // side, side, width // side, side, channels).mean(axis=(1, 3))
